// How many drawings of a folder are planned, and why the others are not:
//
//     npm run bench -- corpus FOLDER [--moves N] [--machine NAME]
//
// Every DXF and SVG file below the folder is read, planned with seed 1 and written as G-code, in wasm under Node, wherever it lies on the bed. What the
// plan's own check or that of the program refuses is an error of ours: these files are listed. benches/repositories.txt names the public repositories
// whose drawings were looked at in November 2026; they are not stored here, as most have no licence.

import { readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { build } from '../scripts/build.mjs';
import { setup } from '../scripts/setup.mjs';
import { DIST, Stop } from '../scripts/tools.mjs';
import { table } from './common/table.mjs';

/** What no drawing should end with. */
const OURS = ['unsound-plan', 'unwritable', 'internal', 'planner-died', 'deadline'];

export async function bench(args) {
  const { values, positionals } = parseArgs({ args, allowPositionals: true, options: { moves: { type: 'string', default: '20000' }, machine: { type: 'string', default: 'co2-100w' } } });
  const [folder] = positionals;
  if (folder === undefined) throw new Stop('Which folder? npm run bench -- corpus FOLDER');
  await setup();
  await build();
  const { createPool } = await import(pathToFileURL(join(DIST, 'sdk', 'node.js')).href);
  const pool = createPool();
  const options = { machine: values.machine, moves: Number(values.moves), seed: 1, outputs: ['gcode'], allowOffBed: true };
  const ends = new Map();
  const ours = [];
  const look = async (file) => {
    const name = basename(file);
    const end = await pool.plan(() => readFileSync(file), { ...options, name }).then(() => 'planned', ({ code = 'internal', message }) => {
      if (OURS.includes(code)) ours.push(`${file}: ${message}`);
      return code;
    });
    const kind = /\.svg$/i.test(name) ? 'svg' : 'dxf';
    const counts = ends.get(end) ?? { dxf: 0, svg: 0 };
    ends.set(end, { ...counts, [kind]: counts[kind] + 1 });
  };
  const files = readdirSync(folder, { recursive: true }).filter((f) => /\.(dxf|svg)$/i.test(f)).sort();
  const running = [];
  for (const file of files) {
    await pool.room();
    running.push(look(join(folder, file)));
  }
  await Promise.all(running);
  await pool.close();
  const lines = [...ends].sort(([a], [b]) => (a < b ? -1 : 1)).map(([end, { dxf, svg }]) => [end, String(dxf), String(svg)]);
  table(`${files.length} drawings, ${values.moves} moves each`, ['end', 'DXF', 'SVG'], lines);
  for (const line of ours) console.log(line);
}
