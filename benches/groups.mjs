// Parts that share cuts: how long their path is looked for before the search begins, and what it saves.
//
//     npm run bench -- groups [--most N]
//     npm run bench -- groups --sheets
//
// The first makes grids of squares that touch, from 10 by 10 up to `--most` parts (default 10,000): cut one by one, together on the best
// path that is found through them, and on that of the insertion heuristic, which is not used for larger groups. The machine is
// fibre-6kw-thick with pre-cuts of 0.3 s, the job that of the first path. In wasm under Node, one thread, seconds of the clock: compare
// them within a row.
//
// The second has the job of the first path of 30 sheets on four machines, cut together against one by one; no clock.

import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { build } from '../scripts/build.mjs';
import { setup } from '../scripts/setup.mjs';
import { DIST } from '../scripts/tools.mjs';
import { drawing } from './common/dxf.mjs';
import { table } from './common/table.mjs';
import { grid, SHEETS } from './groups/sheets.mjs';

/** Squares along each side of the grids. */
const SIDES = [10, 20, 30, 60, 100, 140, 200];
/** Side of a square, mm. */
const SIDE = 10;
/** Machines with the seconds of their pre-cuts, the first for the grids. */
const MACHINES = [['fibre-6kw-thick', 0.3], ['fibre-6kw-plate', 0.6], ['fibre-3kw-thin', 0.1], ['co2-100w', 0.2]];

export async function bench(args) {
  const { values } = parseArgs({ args, options: { most: { type: 'string', default: '10000' }, sheets: { type: 'boolean', default: false } } });
  await setup();
  await build();
  const { createPlanner } = await import(pathToFileURL(join(DIST, 'sdk', 'node.js')).href);
  await (values.sheets ? sheets(createPlanner) : grids(createPlanner, Number(values.most)));
}

async function grids(createPlanner, most) {
  const lines = [];
  for (const side of SIDES.filter((n) => n * n <= most)) {
    const squares = grid(side, side, SIDE, SIDE);
    const [off, best, insertion] = [
      await first(createPlanner, squares, 'off'), await first(createPlanner, squares, 'best'), await first(createPlanner, squares, 'insertion'),
    ];
    const [[offTakes, offJob], [bestTakes, bestJob]] = [off, best].map(written);
    const [insertionTakes, insertionJob] = insertion.isLeftOut ? ['not used', ''] : written(insertion);
    lines.push([`${side} x ${side}`, offTakes, bestTakes, (best.seconds / off.seconds).toFixed(1), insertionTakes, offJob, bestJob, insertionJob]);
  }
  const columns = ['', 'one by one', 'together', 'ratio', 'insertion', 'job: one by one', 'together', 'insertion'];
  table('Seconds before the search begins, of squares that share their sides', columns, lines);
}

async function sheets(createPlanner) {
  const lines = [];
  const ratios = MACHINES.map(() => []);
  for (const [name, entities] of SHEETS) {
    const cells = [];
    for (const [k, machine] of MACHINES.entries()) {
      const [off, best] = [await first(createPlanner, entities, 'off', machine), await first(createPlanner, entities, 'best', machine)];
      ratios[k].push(best.job / off.job);
      cells.push(`${best.job.toFixed(1)} s`, (best.job / off.job).toFixed(3));
    }
    lines.push([name, ...cells]);
  }
  lines.push(['mean', ...ratios.flatMap((list) => ['', geometricMean(list).toFixed(3)])]);
  const columns = ['', ...MACHINES.flatMap(([name, preCut]) => [`${name}, ${preCut} s`, 'of one by one'])];
  table('Seconds of the job on the first path, cut together, and their ratio to one by one', columns, lines);
}

/** The first path of a sheet: the seconds until it is there, and those of its job. */
async function first(createPlanner, entities, commonCuts, [machine, preCut] = MACHINES[0]) {
  const planner = await createPlanner();
  const options = { moves: 1, seed: 1, machine: { ...planner.machines.find((m) => m.name === machine), pre_cut_time: preCut }, allowOffBed: true };
  // The first plan also loads the wasm file that it needs.
  await planner.load(dxf(grid(2, 2, SIDE, SIDE)), 'grid.dxf', { commonCuts });
  await planner.plan(options).done;
  await planner.load(dxf(entities), 'sheet.dxf', { commonCuts });
  const start = performance.now();
  const run = planner.plan(options);
  const { findings } = await run.started;
  const seconds = (performance.now() - start) / 1000;
  const { progress } = await run.done;
  planner.close();
  return { seconds, job: progress.summary.total_time, isLeftOut: findings.some((f) => f.message.startsWith('The insertion heuristic')) };
}

const written = ({ seconds, job }) => [seconds, job].map((value) => `${value.toFixed(1)} s`);

const geometricMean = (list) => Math.exp(list.reduce((sum, v) => sum + Math.log(v), 0) / list.length);

const dxf = (entities) => new TextEncoder().encode(drawing(entities));
