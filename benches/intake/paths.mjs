// SVG files of paths, as large as wanted: polylines, curves as Inkscape writes letters, and rings of arcs.

const HEAD = '<svg xmlns="http://www.w3.org/2000/svg" width="1000mm" height="1000mm" viewBox="0 0 1000 1000">\n';
const STYLE = 'fill="none" stroke="#f00"';

/** Random numbers from 0 to 1 (mulberry32), the same for the same seed. */
function random(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

const fixed = (n) => n.toFixed(4);

/** A file of at least this many bytes, of paths with 60 pieces each. */
function file(bytes, seed, piece) {
  const next = random(seed);
  const parts = [HEAD];
  for (let length = HEAD.length; length < bytes; ) {
    let d = `M${fixed(50 + 900 * next())},${fixed(50 + 900 * next())}`;
    for (let k = 0; k < 60; k++) d += piece(next, k);
    const path = `<path ${STYLE} d="${d}z"/>\n`;
    parts.push(path);
    length += path.length;
  }
  return `${parts.join('')}</svg>\n`;
}

const around = (next, k, size) => {
  const angle = (2 * Math.PI * k) / 60;
  return [size * Math.cos(angle) * (0.8 + 0.4 * next()), size * Math.sin(angle) * (0.8 + 0.4 * next())];
};

export const paths = {
  'polylines': (bytes, seed) => file(bytes, seed, (next, k) => `l${around(next, k, 1).map(fixed)}`),
  'curves': (bytes, seed) => file(bytes, seed, (next, k) => {
    const [x, y] = around(next, k, 1);
    return `c${[0.3 * x - 0.05 * y, 0.3 * y + 0.05 * x, 0.7 * x - 0.05 * y, 0.7 * y + 0.05 * x, x, y].map(fixed)}`;
  }),
  'arcs': (bytes, seed) => file(bytes, seed, (next, k) => `a1.5,1.5,0,0,${k % 2},${around(next, k, 1).map(fixed)}`),
};
