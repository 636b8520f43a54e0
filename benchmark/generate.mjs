// Instances made by seed: parts with holes, in rows on a sheet. The same seed gives the same instance everywhere.

import { polygon } from './drawing.mjs';

/** Whole numbers of 32 bits by Mulberry32, which is short enough to be written again in any language. */
export function mulberry32(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return (t ^ (t >>> 14)) >>> 0;
  };
}

/**
 * An instance of `count` contours: polygons of 3 to 8 corners in squares of 100 mm, each with up to five holes. Holes are round, and on
 * the track ECP, which knows ends of lines and arcs only, hexagons.
 */
export function generated({ seed, count = 50, track = 'CCP', cost = LENGTH }) {
  const next = mulberry32(seed);
  const draw = () => next() / 2 ** 32;
  const hole = track === 'ECP' ? hexagon : circle;
  const contours = [];
  const columns = Math.max(1, Math.ceil(Math.sqrt(count / 3)));
  for (let place = 0; contours.length < count; place++) {
    const [x, y] = [60 + 100 * (place % columns), 60 + 100 * Math.floor(place / columns)];
    const part = contours.length;
    const [corners, turn] = [3 + Math.floor(draw() * 6), draw() * Math.PI];
    const reach = 30 + draw() * 18;
    const corner = (k) => [reach, turn + (2 * Math.PI * k) / corners];
    contours.push(polygon(Array.from({ length: corners }, (_, k) => polar([x, y], ...corner(k)))));
    // Holes on a ring well inside the polygon, whose inscribed radius is the reach times this cosine.
    const inner = reach * Math.cos(Math.PI / corners);
    const holes = Math.min(Math.floor(draw() * 6), count - contours.length);
    for (let k = 0; k < holes; k++) contours.push(hole(polar([x, y], inner * 0.5, (2 * Math.PI * k) / holes), inner * (0.08 + 0.1 * draw()), part));
  }
  return { format: 'cutting-benchmark/1', name: `generated-${track.toLowerCase()}-${count}-${seed}`, track, home: [0, 0], closed: true, cost, contours };
}

export const LENGTH = { unit: 'mm', pierce: 0 };

function polar([x, y], radius, angle) {
  return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)].map((v) => Number(v.toFixed(6)));
}

function hexagon(center, radius, inside) {
  return polygon(Array.from({ length: 6 }, (_, k) => polar(center, radius, (Math.PI * k) / 3)), inside);
}

function circle(center, radius, inside) {
  const at = (across, up) => [center[0] + across * radius, center[1] + up * radius].map((v) => Number(v.toFixed(6)));
  const quarter = (across, up) => ({ arc: at(across, up), center, ccw: true });
  return { closed: true, inside, start: at(1, 0), path: [quarter(0, 1), quarter(-1, 0), quarter(0, -1), quarter(1, 0)] };
}
