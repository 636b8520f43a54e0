// Blocks of parts that share edges exactly: drawn as closed contours whose sides coincide, all in whole millimetres.
// Each block draws itself with its lower left corner at a place and gives the box it takes.

import { circle, rectangle, slot } from './shapes.mjs';

/** m x n equal rectangles. */
export function grid(sheet, x, y, { columns, lines, w, h }) {
  for (let k = 0; k < columns * lines; k++) {
    sheet.draw(rectangle(x + w * (k % columns), y + h * Math.floor(k / columns), w, h));
  }
  return [columns * w, lines * h];
}

/** Parts in a row on one base, of different heights: neighbours share as much of their sides as the lower one has. */
export function chain(sheet, x, y, { parts, w, h }) {
  let [at, highest] = [x, 0];
  for (let k = 0; k < parts; k++) {
    const [own, high] = [w + 5 * sheet.random.below(4), h + 10 * sheet.random.below(4)];
    sheet.draw(rectangle(at, y, own, high));
    at += own;
    highest = Math.max(highest, high);
  }
  return [at - x, highest];
}

/** A long part under two or three short ones: T-junctions where two of these meet on it. */
export function bricks(sheet, x, y, { parts, w, h }) {
  sheet.draw(rectangle(x, y, parts * w, h));
  for (let k = 0; k < parts; k++) sheet.draw(rectangle(x + k * w, y + h, w, 2 * h));
  return [parts * w, 3 * h];
}

/** Parts that touch along a piece of one side only, each shifted against the one below. */
export function stairs(sheet, x, y, { parts, w, h }) {
  for (let k = 0; k < parts; k++) sheet.draw(rectangle(x + 10 * k, y + h * k, w, h));
  return [w + 10 * (parts - 1), parts * h];
}

/** Four parts like a pinwheel around an area that they close in, with small parts in it. */
export function island(sheet, x, y, { a, b }) {
  // Each part is a long by b wide; the area closed in is a square of side a - b.
  const side = a + b;
  sheet.draw(rectangle(x, y, a, b));
  sheet.draw(rectangle(x + a, y, b, a));
  sheet.draw(rectangle(x + b, y + a, a, b));
  sheet.draw(rectangle(x, y + b, b, a));
  const inner = a - b;
  sheet.draw(circle(x + b + inner * 0.3, y + b + inner * 0.35, inner * 0.2));
  sheet.draw(rectangle(x + b + inner * 0.6, y + b + inner * 0.2, inner * 0.25, inner * 0.6));
  return [side, side];
}

/** A large frame with parts that touch in its hole. */
export function frame(sheet, x, y, { w, h }) {
  sheet.draw(rectangle(x, y, w, h));
  sheet.draw(rectangle(x + 20, y + 20, w - 40, h - 40));
  const [pw, ph] = [Math.floor((w - 60) / 3), Math.floor((h - 60) / 2)];
  grid(sheet, x + 30, y + 30, { columns: 3, lines: 2, w: pw, h: ph });
  return [w, h];
}

/** A part alone, with holes. */
export function single(sheet, x, y, { w, h, holes }) {
  sheet.draw(rectangle(x, y, w, h));
  for (let k = 0; k < holes; k++) {
    const [cx, cy] = [x + (w * (k + 0.5)) / holes, y + h / 2];
    sheet.draw(k % 3 === 2 ? slot(cx - w / (4 * holes), cy - h / 4, w / (2 * holes), h / 2) : circle(cx, cy, h / 8));
  }
  return [w, h];
}
