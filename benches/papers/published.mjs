// Values that the papers print, and what their published sequences give on the printed coordinates.

/** Qu & Du, tables 5 and 7: total cutting time in s, empty path in mm, iterations; and the length of the published sequence (tables 6
 * and 8) on the printed coordinates, in mm (benches/data/qu-du-43/sequences.json). An incomplete sequence misses a contour. */
export const QU_DU = {
  fixed: {
    lpspso: { time: 622.07, length: 91928.79, iterations: 397, sequence: 3169.88 },
    pso: { time: 696.31, length: 95752.04, iterations: 589, sequence: 3502.92 },
    'aco-pso': { time: 628.06, length: 93123.41, iterations: 483, sequence: 3429.16 },
    'k-pso': { time: 632.53, length: 92476.35, iterations: 462, sequence: 3431.63, incomplete: true },
  },
  random: {
    lpspso: { time: 619.19, length: 88437.51, iterations: 406, sequence: 3580.41, incomplete: true },
    pso: { time: 746.15, length: 121785.97, iterations: 598, sequence: 7015.68 },
    'aco-pso': { time: 664.45, length: 102261.38, iterations: 501, sequence: 5625.34, incomplete: true },
    'k-pso': { time: 669.96, length: 97198.48, iterations: 488, sequence: 3948.17, incomplete: true },
  },
};

/** Liu & Chang, mean and best of table 3, seconds of table 4, by sheet and method. */
export const HULL = {
  'hull-5-20': {
    rlsga: [49.68, 49.68, 16.523],
    'hull-pso': [56.36, 55.95, 24.671],
    ofa: [54.95, 54.38, 30.587],
    woa: [53.96, 53.14, 35.641],
    sga: [53.34, 52.09, 16.003],
  },
  'hull-10-45': {
    rlsga: [84.31, 81.79, 27.714],
    'hull-pso': [97.65, 96.17, 46.529],
    ofa: [97.19, 92.51, 50.319],
    woa: [102.3, 98.78, 55.413],
    sga: [95.49, 92.32, 26.66],
  },
};
