// Perforated sheets: round holes in a square grid, in staggered rows, and slots. Each drawing comes with the length of the path that
// a person would lay through it.

import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { drawing, polyline } from '../common/dxf.mjs';

/** Holes in a row, and rows. */
export const SIDES = [50, 100, 200];

/** mm: distance of columns and of rows, half the size of a hole, and how far every second row is shifted. */
export const PATTERNS = {
  round: { pitch: [10, 10], half: [1.5, 1.5], shift: 0 },
  staggered: { pitch: [10, 8.66], half: [1.5, 1.5], shift: 5 },
  slots: { pitch: [25, 10], half: [12, 2], shift: 0 },
};

/** Where a column and a row meet. */
function center({ pitch, shift }, column, row) {
  return [20 + pitch[0] * column + shift * (row % 2), 10 + pitch[1] * row];
}

/** Writes the drawing of a pattern, with the outline of its sheet, and returns its file. */
export function drawn(name, side) {
  const pattern = PATTERNS[name];
  const [right, top] = pattern.pitch.map((pitch) => pitch * side + 20);
  const entities = polyline([[0, 0], [right, 0], [right, top], [0, top]].map(([x, y]) => [x, y, 0]));
  for (let row = 0; row < side; row++) {
    for (let column = 0; column < side; column++) entities.push(...hole(pattern, center(pattern, column, row)));
  }
  const file = join(mkdtempSync(join(tmpdir(), 'kerfway-')), `${name}_${side * side}.dxf`);
  writeFileSync(file, drawing(entities));
  return file;
}

function hole({ half }, [x, y]) {
  const [length, radius] = [half[0] - half[1], half[1]];
  if (length === 0) return ['0', 'CIRCLE', '8', 'CUT', '10', x, '20', y, '40', radius];
  const ends = [[-1, -1, 0], [1, -1, 1], [1, 1, 0], [-1, 1, 1]];
  return polyline(ends.map(([across, up, bulge]) => [x + across * length, y + up * radius, bulge]));
}

/** Length of the shortest path that a person would lay, mm: along rows or columns, one or two at a time, forwards and backwards in turn. */
export function byHand(name, side) {
  return Math.min(...[0, 1].flatMap((along) => [1, 2].map((width) => laid(PATTERNS[name], side, along, width))));
}

/** A path along one axis. In a band of two lines it crosses between the sides that face each other. */
function laid(pattern, side, along, width) {
  const across = 1 - along;
  const way = [[0, 0]];
  for (let band = 0; band < side; band += width) {
    const places = [];
    for (let line = band; line < Math.min(band + width, side); line++) {
      for (let k = 0; k < side; k++) {
        const place = center(pattern, ...(along === 0 ? [k, line] : [line, k]));
        place[across] += width === 1 ? 0 : (line === band ? 1 : -1) * pattern.half[across];
        // Of two places side by side every second pair is taken the other way round.
        places.push({ place, tie: line === band === (k % 2 === 0) ? 0 : 1 });
      }
    }
    places.sort((a, b) => a.place[along] - b.place[along] || a.tie - b.tie);
    if ((band / width) % 2 === 1) places.reverse();
    way.push(...places.map(({ place }) => place));
  }
  way.push([0, 0]);
  return way.slice(1).reduce((sum, [x, y], k) => sum + Math.hypot(x - way[k][0], y - way[k][1]), 0);
}
