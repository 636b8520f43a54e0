// Instances of the bound by stops: partial cutting of the benchmark (tracks ECP and ICP), and plates whose parts share cuts.

import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { ROOT } from '../../scripts/tools.mjs';
import { asDxf } from '../../benchmark/drawing.mjs';
import { drawing, polyline } from '../common/dxf.mjs';

/** Plates: columns and rows of blocks, and the parts of a block in each direction. */
const PLATES = { 'plate 3 x 2': [3, 2, 2, 2], 'plate 4 x 3': [4, 3, 3, 2], 'plate 6 x 5': [6, 5, 2, 2] };

/** The instances of the benchmark by group, as files with the best value known and what the program `bound` is told. */
export function partial() {
  const { instances } = JSON.parse(readFileSync(join(ROOT, 'benchmark', 'instances.json'), 'utf8'));
  const folder = mkdtempSync(join(tmpdir(), 'kerfway-'));
  const groups = new Map();
  for (const { name, track, file, best } of instances.filter((i) => i.track === 'ECP' || i.track === 'ICP')) {
    const drawn = join(folder, `${name}.dxf`);
    writeFileSync(drawn, asDxf(JSON.parse(gunzipSync(readFileSync(join(ROOT, 'benchmark', file))))));
    const group = `${name.replace(/-\d+(-[ei]cp)?$/, '')}, ${track}`;
    const flags = ['--machine', 'length-partial', ...(track === 'ECP' ? ['--ends'] : [])];
    groups.set(group, [...(groups.get(group) ?? []), { file: drawn, known: best.value, flags }]);
  }
  return groups;
}

/** Plates of blocks of parts that share sides, each part with a hole. */
export function plates() {
  const folder = mkdtempSync(join(tmpdir(), 'kerfway-'));
  return Object.entries(PLATES).map(([name, [columns, rows, across, up]]) => {
    const file = join(folder, `${name.replaceAll(' ', '')}.dxf`);
    const entities = [];
    for (let k = 0; k < columns * rows; k++) {
      const [left, bottom] = [20 + 260 * (k % columns), 20 + 190 * Math.floor(k / columns)];
      for (let part = 0; part < across * up; part++) {
        const [x, y] = [left + 70 * (part % across), bottom + 60 * Math.floor(part / across)];
        entities.push(...polyline([[x, y, 0], [x + 70, y, 0], [x + 70, y + 60, 0], [x, y + 60, 0]]));
        entities.push('0', 'CIRCLE', '8', 'CUT', '10', x + 20 + ((7 * part + 11 * k) % 25), '20', y + 30, '40', 6);
      }
    }
    writeFileSync(file, drawing(entities));
    return { name, file, flags: ['--machine', 'fibre-6kw-plate'] };
  });
}
