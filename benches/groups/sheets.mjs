// Sheets of parts that share their sides, as entities of DXF: grids, rows of rectangles of several sizes, bricks, triangles and
// hexagons, alone and beside parts that share nothing.

import { polyline } from '../common/dxf.mjs';
import { rectangle as corners } from '../dewil/shapes.mjs';

const outline = (points) => polyline(points.map(([x, y]) => [x, y, 0]));
const rectangle = (x, y, w, h) => outline(corners(x, y, w, h));

/** Columns and rows of places. */
const places = (columns, rows) => Array.from({ length: columns * rows }, (_, k) => [k % columns, Math.floor(k / columns)]);

/** Rectangles of `w` by `h` mm whose first corner is at (`left`, 0). */
export const grid = (columns, rows, w, h, left = 0) => places(columns, rows).flatMap(([x, y]) => rectangle(left + w * x, h * y, w, h));

/** Every other row is moved by half a brick. */
const bricks = (columns, rows, w, h) => places(columns, rows).flatMap(([x, y]) => rectangle(w * (x + (y % 2) / 2), h * y, w, h));

/** Squares that are cut along a diagonal. */
const triangles = (columns, rows, side) =>
  places(columns, rows).flatMap(([x, y]) => {
    const [a, b, c, d] = [[x, y], [x + 1, y], [x + 1, y + 1], [x, y + 1]].map((p) => p.map((v) => v * side));
    return [...outline([a, b, c]), ...outline([a, c, d])];
  });

const hexagons = (columns, rows, side) =>
  places(columns, rows).flatMap(([x, y]) => {
    const [middle, centre] = [1.5 * side * x, Math.sqrt(3) * side * (y + (x % 2) / 2)];
    return outline(Array.from({ length: 6 }, (_, k) => [middle + side * Math.cos((k * Math.PI) / 3), centre + side * Math.sin((k * Math.PI) / 3)]));
  });

/** Rows of rectangles 15 to 55 mm high and 10 to 60 mm wide, at least `width` mm long. The numbers are drawn from the seed. */
function rows(count, width, seed) {
  let state = seed;
  const draw = (below) => {
    state = (state * 1103515245 + 12345) % 2 ** 31;
    return Math.floor((state / 2 ** 31) * below);
  };
  let y = 0;
  return Array.from({ length: count }).flatMap(() => {
    const [row, h] = [[], 15 + 10 * draw(5)];
    for (let x = 0; x < width; ) {
      const w = 10 + 10 * draw(6);
      row.push(...rectangle(x, y, w, h));
      x += w;
    }
    y += h;
    return row;
  });
}

/** Squares of 8 mm that share nothing, from x = `left` on. */
const apart = (count, left) => places(10, count / 10).flatMap(([x, y]) => rectangle(left + 30 * x, 30 * y, 8, 8));

const GRIDS = [
  [4, 4, 50, 50], [5, 4, 60, 40], [6, 6, 40, 40], [8, 8, 20, 20], [10, 10, 10, 10], [10, 10, 30, 30], [12, 8, 30, 20], [15, 10, 20, 20],
  [20, 20, 10, 10], [25, 16, 30, 20], [30, 30, 10, 10], [3, 30, 40, 20], [2, 50, 30, 30], [4, 12, 30, 30], [9, 5, 70, 30], [50, 3, 10, 40],
];

/** Name and entities of each sheet. */
export const SHEETS = [
  ...GRIDS.map(([columns, rows, w, h]) => [`${columns} x ${rows} of ${w} x ${h} mm`, grid(columns, rows, w, h)]),
  ...[[5, 300], [8, 400], [15, 600], [25, 1000]].map(([count, width]) => [`${count} rows of ${width} mm`, rows(count, width, 12345)]),
  ['100 bricks', bricks(10, 10, 20, 10)],
  ['240 bricks', bricks(20, 12, 30, 20)],
  ['72 triangles', triangles(6, 6, 30)],
  ['288 triangles', triangles(12, 12, 20)],
  ['64 hexagons', hexagons(8, 8, 12)],
  ['225 hexagons', hexagons(15, 15, 10)],
  ['10 x 10 and 60 apart', [...grid(10, 10, 20, 20), ...apart(60, 250)]],
  ['20 x 20 and 40 apart', [...grid(20, 20, 10, 10), ...apart(40, 250)]],
  ['2 times 8 x 6', [0, 400].flatMap((left) => grid(8, 6, 30, 20, left))],
  ['5 times 5 x 5', [0, 150, 300, 450, 600].flatMap((left) => grid(5, 5, 25, 25, left))],
];
