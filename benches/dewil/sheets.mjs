// The 27 sheets of the bench `dewil`. Those of Dewil et al. (2014) are not published: these are made by their description
// (section 5), with their names and as many elements as table 1 says. Deterministic: `node benches/dewil/sheets.mjs`
// writes the files that stand in `sheets/`, byte for byte.
//
// Set 1: small parts far apart, or parts with many inner contours evenly spread. Set 2: large parts close together. Set
// 3: common cuts (coinciding sides of closed contours), large and small parts. How many contours the elements make up
// is chosen so that piercing and air come to about the seconds of the paper. A circle is two half circles, so two
// elements.

import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Random } from './random.mjs';
import { apart, close, perforated, Sheet } from './layout.mjs';
import { bricks, chain, frame, grid, island, single, stairs } from './touching.mjs';
import { outline } from './shapes.mjs';

const HERE = join(dirname(fileURLToPath(import.meta.url)), 'sheets');

const small = (width, elements, more = {}) => ({ fill: apart, width, side: [15, 60], gap: [40, 110], elements, holes: 0.25, ...more });
const holes = (size, columns, lines, kinds, more = {}) => ({ fill: perforated, width: 2500, size, gap: 30, columns, lines, kinds, ...more });
const large = (width, elements, more = {}) => ({ fill: close, width, side: [250, 550], gap: 8, elements, ...more });
const common = (width, scale) => ({ fill: touching, width, scale });

/** Name, set, elements, and how it is made. */
export const SHEETS = [
  ['10b', 1, 421, small(1200, [5, 11])],
  ['12', 1, 1793, small(2400, [6, 13])],
  ['13', 1, 289, holes([600, 420], 10, 7, [2, 2, 4, 8])],
  ['18', 1, 656, small(1600, [4, 10])],
  ['19', 1, 1002, small(1500, [9, 16])],
  ['20', 1, 2357, holes([700, 500], 16, 11, [4, 8, 4, 4])],
  ['21', 1, 529, holes([900, 600], 14, 10, [2, 2, 4])],
  ['25', 1, 1424, small(2000, [5, 10])],
  ['26', 1, 2810, small(2800, [8, 14])],
  ['27', 1, 2194, small(2400, [8, 14], { side: [20, 80] })],
  ['28', 1, 324, small(1300, [3, 6], { gap: [60, 160] })],
  ['30', 1, 145, small(1100, [2, 4], { gap: [60, 160] })],
  ['10', 2, 421, large(2600, [6, 12])],
  ['17', 2, 145, large(1600, [20, 28])],
  ['29', 2, 121, large(2600, [3, 4])],
  ['34', 2, 91, large(2200, [3, 4])],
  ['35', 2, 21, large(1200, [4, 4])],
  ['36', 2, 61, large(2000, [3, 4])],
  ['37', 2, 31, large(1500, [3, 4])],
  ['38', 2, 237, large(2600, [4, 6], { holes: 0.3 })],
  ['11', 3, 745, common(2400, 1)],
  ['14', 3, 230, common(1400, 1)],
  ['15', 3, 253, common(1600, 2)],
  ['16', 3, 303, common(1600, 1)],
  ['16b', 3, 123, common(1800, 2)],
  ['22', 3, 385, common(2600, 2)],
  ['23', 3, 841, common(2800, 2)],
];

/** Blocks of touching parts among single ones, large and small; `scale` makes all of it larger, `gap` are the distances between blocks. */
function touching(sheet, { width, scale, gap: distances = [10, 30] }) {
  const { random } = sheet;
  const blocks = [
    [(x, y) => grid(sheet, x, y, { columns: 3, lines: 2, w: 60 * scale, h: 40 * scale }), 24],
    [(x, y) => chain(sheet, x, y, { parts: 4, w: 40 * scale, h: 50 * scale }), 16],
    [(x, y) => bricks(sheet, x, y, { parts: 3, w: 50 * scale, h: 25 * scale }), 16],
    [(x, y) => island(sheet, x, y, { a: 90 * scale, b: 40 * scale }), 22],
    [(x, y) => stairs(sheet, x, y, { parts: 3, w: 70 * scale, h: 30 * scale }), 12],
    [(x, y) => frame(sheet, x, y, { w: 240 * scale, h: 160 * scale }), 32],
    [(x, y) => single(sheet, x, y, { w: 200 * scale, h: 90 * scale, holes: 4 }), 14],
    [(x, y) => grid(sheet, x, y, { columns: 2, lines: 4, w: 35 * scale, h: 35 * scale }), 32],
  ];
  let [x, y, high] = [10, 10, 0];
  for (let k = 0; sheet.left > 0; k++) {
    // Every block once, then at random.
    const [block, most] = blocks[k < blocks.length ? k : random.below(blocks.length)];
    let size;
    if (most + 2 <= sheet.left || most === sheet.left) {
      size = block(x, y);
    } else {
      const side = 40 * scale;
      size = [side, side];
      sheet.draw(outline(x, y, side, side, sheet.elements(4), random));
    }
    const gap = random.between(...distances);
    x += size[0] + gap;
    high = Math.max(high, size[1]);
    if (x > width) [x, y, high] = [10, y + high + gap, 0];
  }
}

/** The contours of a sheet. Of set 3 also of a variant, which is `scale` times as large, with other gaps between the blocks. */
export function contours(name, { scale = 1, gap } = {}) {
  const index = SHEETS.findIndex((s) => s[0] === name);
  const [, , elements, spec] = SHEETS[index];
  const sheet = new Sheet(elements, new Random(1000 + index));
  spec.fill(sheet, spec.fill === touching ? { ...spec, width: spec.width * scale, scale: spec.scale * scale, gap } : spec);
  return sheet.contours;
}

/** At most `digits` places behind the point. */
const number = (value, digits) => String(Number(value.toFixed(digits)));

/** A DXF file: one closed LWPOLYLINE a contour, mm. */
export function dxf(name, variant) {
  const lines = ['0', 'SECTION', '2', 'HEADER', '9', '$ACADVER', '1', 'AC1015', '9', '$INSUNITS', '70', '4', '0', 'ENDSEC'];
  lines.push('0', 'SECTION', '2', 'ENTITIES');
  for (const contour of contours(name, variant)) {
    lines.push('0', 'LWPOLYLINE', '100', 'AcDbEntity', '8', 'CUT', '100', 'AcDbPolyline', '90', String(contour.length), '70', '1');
    for (const [x, y, bulge] of contour) {
      lines.push('10', number(x, 3), '20', number(y, 3));
      if (bulge) lines.push('42', number(bulge, 6));
    }
  }
  lines.push('0', 'ENDSEC', '0', 'EOF');
  return `${lines.join('\n')}\n`;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  mkdirSync(HERE, { recursive: true });
  for (const [name] of SHEETS) writeFileSync(join(HERE, `${name}.dxf`), dxf(name));
}
