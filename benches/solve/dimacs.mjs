// The random instances of the Eighth DIMACS Implementation Challenge (the travelling salesman problem, 2000), written again from what
// their generators compute: D. S. Johnson and L. A. McGeoch, "Experimental analysis of heuristics for the STSP", in The Traveling
// Salesman Problem and Its Variations (2002), section 2. E: points chosen uniformly in a square. C: points at normally distributed
// distances from centres, one for a hundred points, that are chosen uniformly. The seed of the first instance of a size is its number
// of points. A test compares the bytes with those that the programs of the challenge wrote (portgen, portcgen).

/** Coordinates of uniform points and of centres are below this. */
const SQUARE = 1_000_000;
/** Random numbers are below this. */
const RANGE = 1_000_000_000;
const POINTS_OF_A_CENTRE = 100;

/** The instances that GTSPLIB's large ones are made of, by name: kind, and number of points, which is the seed. */
export const RANDOM = { 'E1k.0': ['E', 1000], 'C1k.0': ['C', 1000], 'E3k.0': ['E', 3162], 'C3k.0': ['C', 3162], 'E10k.0': ['E', 10000], 'C10k.0': ['C', 10000], 'E31k.0': ['E', 31623], 'C31k.0': ['C', 31623] };

/**
 * Whole numbers from 0 to `RANGE` by Knuth's subtractive generator (The Art of Computer Programming 2, section 3.2.2): each is the
 * difference of those 55 and 24 before it. The first ones are spread over the list of 55, and three rounds are thrown away.
 */
function subtractive(seed) {
  const LAGS = [55, 24];
  const [SPREAD, ROUNDS] = [21, 3];
  const difference = (a, b) => (a < b ? a - b + RANGE : a - b);
  const list = [seed];
  for (let k = 1, last = seed, next = 1; k < LAGS[0]; k++) {
    const place = (SPREAD * k) % LAGS[0];
    [list[place], last, next] = [next, next, difference(last, next)];
  }
  // The list is walked backwards.
  let [here, there] = [0, LAGS[1]];
  const before = (place) => (place === 0 ? LAGS[0] - 1 : place - 1);
  const draw = () => {
    [here, there] = [before(here), before(there)];
    return (list[here] = difference(list[here], list[there]));
  };
  for (let k = 0; k < ROUNDS * LAGS[0]; k++) draw();
  return draw;
}

/** Standard normal numbers by the polar method (section 3.4.1, algorithm P), which makes two at a time; the second comes first. */
function normals(draw) {
  let kept;
  const inside = () => (2 * draw()) / RANGE - 1;
  return () => {
    if (kept !== undefined) {
      const next = kept;
      kept = undefined;
      return next;
    }
    let [u, v, square] = [0, 0, 1];
    while (square >= 1) {
      [u, v] = [inside(), inside()];
      square = u * u + v * v;
    }
    const scale = Math.sqrt((-2 * Math.log(square)) / square);
    kept = u * scale;
    return v * scale;
  };
}

function uniform(count, draw) {
  const along = () => Math.floor(draw() / (RANGE / SQUARE));
  return Array.from({ length: count }, () => [along(), along()]);
}

function clustered(count, draw) {
  const below = (most) => Math.trunc((draw() / RANGE) * most);
  const centres = Array.from({ length: Math.floor(count / POINTS_OF_A_CENTRE) }, () => [below(SQUARE), below(SQUARE)]);
  const [normal, deviation] = [normals(draw), 1 / Math.sqrt(count)];
  const off = () => Math.trunc(normal() * deviation * SQUARE);
  return Array.from({ length: count }, () => centres[below(centres.length)].map((place) => place + off()));
}

/** An instance of this name as the text of a file of TSPLIB. */
export function random(name) {
  const [kind, count] = RANDOM[name];
  const draw = subtractive(count);
  const points = (kind === 'E' ? uniform : clustered)(count, draw);
  const program = kind === 'E' ? 'portgen' : 'portcgen';
  return [
    `NAME : ${program}-${count}-${count}`, `COMMENT : ${program} N=${count}, seed=${count}`, 'TYPE : TSP', `DIMENSION : ${count}`,
    'EDGE_WEIGHT_TYPE : EUC_2D', 'NODE_COORD_SECTION', ...points.map(([x, y], k) => `${k + 1} ${x} ${y}`), '',
  ].join('\n');
}
