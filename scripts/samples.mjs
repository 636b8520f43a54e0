// The page's small samples, each of one ability, written by hand: node scripts/samples.mjs

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { r2000 } from './r2000.mjs';
import { ROOT } from './tools.mjs';

const entity = (kind, layer, ...values) => [{ kind, layer, values }];
const line = (x0, y0, x1, y1, layer = 'CUT') => entity('LINE', layer, [10, x0], [20, y0], [11, x1], [21, y1]);
const circle = (x, y, r, layer = 'CUT') => entity('CIRCLE', layer, [10, x], [20, y], [40, r]);
const path = (points, layer = 'CUT', closed = true) =>
  entity('LWPOLYLINE', layer, [90, points.length], [70, closed ? 1 : 0], ...points.flatMap(([x, y, bulge = 0]) => [[10, x], [20, y], [42, bulge]]));
const box = (x, y, w, h, layer) => path([[x, y], [x + w, y], [x + w, y + h], [x, y + h]], layer);
/** A plate with round corners; the bulge of a quarter turn is tan(pi / 8). */
const plate = (x, y, w, h, r, layer) => {
  const b = Math.SQRT2 - 1;
  return path([[x + r, y], [x + w - r, y, b], [x + w, y + r], [x + w, y + h - r, b], [x + w - r, y + h], [x + r, y + h, b], [x, y + h - r], [x, y + r, b]], layer);
};
const text = (x, y, height, words, layer) => entity('TEXT', layer, [10, x], [20, y], [40, height], [1, words]);

const drawing = (units, ...entities) => r2000(units, entities.flat());

const MM = 4;
const rows = (n, make) => Array.from({ length: n }, (_, k) => make(k));

export const SAMPLES = {
  // A box of lines that miss each other by 0.03 mm, a plate drawn twice, two that share an edge, two that cross, one left open.
  'gaps-and-copies.dxf': drawing(MM,
    line(0, 0, 79.98, 0), line(80, 0.02, 80, 49.98), line(79.98, 50, 0.02, 50), line(0, 49.98, 0, 0.02), circle(40, 25, 8),
    plate(100, 0, 80, 50, 6), plate(100, 0, 80, 50, 6), circle(140, 25, 8), circle(140, 25, 8),
    box(200, 0, 40, 50), box(240, 0, 40, 50),
    circle(40, 100, 22), circle(68, 100, 22),
    path([[110, 80], [170, 80], [170, 120], [130, 120]], 'CUT', false),
    text(200, 90, 8, 'not cut', 'CUT')),
  // The names of layers say what they are for; the page suggests an operation for each.
  'layers.dxf': drawing(MM,
    box(-10, -10, 320, 180, 'SHEET'),
    ...rows(3, (k) => [...plate(100 * k, 0, 90, 60, 8, 'CUT'), ...circle(100 * k + 15, 15, 4, 'CUT'), ...circle(100 * k + 75, 15, 4, 'CUT'),
      ...path([[100 * k + 20, 40], [100 * k + 45, 50, -0.4], [100 * k + 70, 40]], 'ENGRAVE', false)]),
    ...rows(3, (k) => circle(50 + 100 * k, 110, 30, 'CUT')), ...rows(3, (k) => circle(50 + 100 * k, 110, 18, 'ENGRAVE')),
    line(-10, 80, 310, 80, 'DIMENSIONS')),
  // 8 x 5: millimetres, centimetres or inches? Nothing says.
  'no-units.dxf': drawing(null, plate(0, 0, 8, 5, 0.5), ...[[1, 1], [7, 1], [7, 4], [1, 4]].map(([x, y]) => circle(x, y, 0.25)), circle(4, 2.5, 1.2)),
  // Rings within rings, and plates in the holes of others.
  'parts-in-parts.dxf': drawing(MM,
    ...rows(3, (k) => rows(5 - k, (j) => circle(80 + 170 * k, 80, 76 - 14 * j)).flat()),
    ...rows(4, (k) => [...box(20 + 120 * k, 180, 100, 100), ...box(30 + 120 * k, 190, 80, 80), ...plate(40 + 120 * k, 200, 60, 60, 10), ...circle(70 + 120 * k, 230, 12)])),
  // A grid of round holes and one of square holes: cut on the run, line by line.
  'perforated.dxf': drawing(MM,
    plate(0, 0, 420, 220, 8),
    ...rows(14, (row) => rows(18, (k) => circle(18 + 12 * k, 30 + 12 * row, 3)).flat()),
    ...rows(11, (row) => rows(10, (k) => box(248 + 15 * k, 29 + 15 * row, 8, 8)).flat())),
  // Holes small and large, outlines with room around them and without: where leads fit, turn or shrink.
  'held-plates.dxf': drawing(MM,
    ...rows(3, (k) => [
      ...plate(20 + 130 * k, 20, 120, 80, 10), ...circle(40 + 130 * k, 40, 2.5), ...circle(120 + 130 * k, 80, 2.5), ...circle(80 + 130 * k, 60, 16),
      ...path([[100 + 130 * k, 34], [122 + 130 * k, 34, 1], [122 + 130 * k, 42], [100 + 130 * k, 42, 1]]),
    ]),
    ...rows(3, (k) => [...circle(70 + 130 * k, 170, 48), ...circle(70 + 130 * k, 170, 20), ...rows(6, (j) => circle(70 + 130 * k + 34 * Math.cos(j * Math.PI / 3), 170 + 34 * Math.sin(j * Math.PI / 3), 4)).flat()]),
    ...rows(8, (k) => box(420 + 40 * (k % 2), 20 + 55 * Math.floor(k / 2), 36, 50))),
  // Small plates that tip up between the slats, angles, and a sheet whose skeleton is cut up at the end.
  'tips-and-skeleton.dxf': drawing(MM,
    box(0, 0, 800, 500, 'SHEET'),
    ...rows(5, (k) => rows(2, (j) => [...box(25 + 105 * k, 25 + 95 * j, 80, 70), ...circle(65 + 105 * k, 60 + 95 * j, 14)]).flat()),
    ...rows(4, (k) => path([[25 + 135 * k, 230], [135 + 135 * k, 230], [135 + 135 * k, 265], [60 + 135 * k, 265], [60 + 135 * k, 345], [25 + 135 * k, 345]])),
    ...rows(3, (k) => [...circle(115 + 135 * k, 320, 32), ...circle(115 + 135 * k, 320, 12)]),
    ...rows(5, (k) => circle(70 + 115 * k, 425, 45)),
    path([[580, 30], [770, 30], [770, 120], [670, 120], [670, 210], [580, 210]])),
};

/** Decimals that a sample of the first visit keeps: a nanometre matters to nobody, and every digit is transferred. */
const DECIMALS = 6;
/** The variables of the header that it keeps: the others are what ezdxf writes for CAD programs. */
const VARIABLES = ['$ACADVER', '$DWGCODEPAGE', '$HANDSEED', '$INSUNITS', '$MEASUREMENT'];

/** The tables that it keeps, and the line types. */
const TABLES = ['LTYPE', 'LAYER', 'BLOCK_RECORD'];
const LINE_TYPES = ['BYLAYER', 'BYBLOCK', 'CONTINUOUS'];

/** Handles and owners: programs give them anew where they are missing. */
const NAMES = ['5', '330'];

/** A drawing with what its entities need: without classes, objects, handles, styles and most of the header. CAD programs that insist on handles refuse it. */
function slim(text) {
  const lines = text.split('\n');
  const kept = [];
  let section = '', table = '', keeps = true;
  for (let k = 0; k + 1 < lines.length; k += 2) {
    const [code, value] = [lines[k], lines[k + 1]];
    if (code === '0') {
      if (value === 'SECTION') section = lines[k + 3];
      if (value === 'TABLE') table = lines[k + 3];
      const name = () => lines[lines.findIndex((line, j) => j > k && j % 2 === 0 && line === '2') + 1].toUpperCase();
      const isFrame = ['SECTION', 'ENDSEC', 'EOF'].includes(value);
      const isNeeded = section !== 'TABLES' || (TABLES.includes(table) && (value !== 'LTYPE' || LINE_TYPES.includes(name())));
      keeps = isFrame || (value !== 'CLASS' && section !== 'OBJECTS' && isNeeded);
    } else if (code === '9' && section === 'HEADER') {
      keeps = VARIABLES.includes(value);
    }
    const isName = ['ENTITIES', 'BLOCKS'].includes(section) && NAMES.includes(code);
    const isFlat = ['ENTITIES', 'BLOCKS'].includes(section) && ['30', '31'].includes(code) && Number(value) === 0;
    if (keeps && !isName && !isFlat) kept.push(code, value);
  }
  return `${kept.join('\n')}\n`;
}

/** A drawing of the tests as a sample: the same entities with coordinates rounded to 1e-6 mm, which is a third less to transfer. */
function rounded(text) {
  const lines = text.split('\n');
  const isCoordinate = (code) => code >= 10 && code < 60;
  return lines.map((line, k) => {
    const value = k % 2 === 1 && isCoordinate(Number(lines[k - 1])) && line.includes('.') ? String(Number(Number(line).toFixed(DECIMALS))) : line.trim();
    return value;
  }).join('\n');
}

SAMPLES['sheet_500.dxf'] = slim(rounded(readFileSync(join(ROOT, 'tests', 'fixtures', 'sheets', 'sheet_500.dxf'), 'utf8')));

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  for (const [file, content] of Object.entries(SAMPLES)) writeFileSync(join(ROOT, 'www', 'app', 'public', 'samples', file), content);
}
