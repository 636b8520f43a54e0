// Seconds before the search begins where parts share cuts:
//
//     npm run bench -- groups [--most N]
//
// Grids of squares that touch, from 10 by 10 up to `--most` parts (default 10,000): cut one by one, together on the best path that is
// found through them, and on that of the insertion heuristic, which is not used for larger groups. The machine is fibre-6kw-thick with
// pre-cuts of 0.3 s, the job that of the first path. In wasm under Node, one thread, seconds of the clock: compare them within a row.

import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { build } from '../scripts/build.mjs';
import { setup } from '../scripts/setup.mjs';
import { DIST } from '../scripts/tools.mjs';
import { drawing, polyline } from './common/dxf.mjs';
import { table } from './common/table.mjs';

/** Squares along each side of the grids. */
const SIDES = [10, 20, 30, 60, 100, 140, 200];
/** Side of a square, mm. */
const SIDE = 10;

export async function bench(args) {
  const { values } = parseArgs({ args, options: { most: { type: 'string', default: '10000' } } });
  await setup();
  await build();
  const { createPlanner } = await import(pathToFileURL(join(DIST, 'sdk', 'node.js')).href);
  const lines = [];
  for (const side of SIDES.filter((n) => n * n <= Number(values.most))) {
    const [off, best, insertion] = [await first(createPlanner, side, 'off'), await first(createPlanner, side, 'best'), await first(createPlanner, side, 'insertion')];
    const [[offTakes, offJob], [bestTakes, bestJob]] = [off, best].map(written);
    const [insertionTakes, insertionJob] = insertion.isLeftOut ? ['not used', ''] : written(insertion);
    lines.push([`${side} x ${side}`, offTakes, bestTakes, (best.seconds / off.seconds).toFixed(1), insertionTakes, offJob, bestJob, insertionJob]);
  }
  const columns = ['', 'one by one', 'together', 'ratio', 'insertion', 'job: one by one', 'together', 'insertion'];
  table('Seconds before the search begins, of squares that share their sides', columns, lines);
}

/** The first path of a grid: the seconds until it is there, and those of its job. */
async function first(createPlanner, side, commonCuts) {
  const planner = await createPlanner();
  const options = { moves: 1, machine: { ...planner.machines.find((m) => m.name === 'fibre-6kw-thick'), pre_cut_time: 0.3 }, allowOffBed: true };
  // The first plan also loads the wasm file that it needs.
  await planner.load(grid(2), 'grid.dxf', { commonCuts });
  await planner.plan(options).done;
  await planner.load(grid(side), 'grid.dxf', { commonCuts });
  const start = performance.now();
  const run = planner.plan(options);
  const { findings } = await run.started;
  const seconds = (performance.now() - start) / 1000;
  const { progress } = await run.done;
  planner.close();
  return { seconds, job: progress.summary.total_time, isLeftOut: findings.some((f) => f.message.startsWith('The insertion heuristic')) };
}

const written = ({ seconds, job }) => [seconds, job].map((value) => `${value.toFixed(1)} s`);

/** Squares that touch, as DXF. */
function grid(side) {
  const at = (x, y) => [SIDE * x, SIDE * y, 0];
  const squares = Array.from({ length: side * side }, (_, k) => {
    const [x, y] = [k % side, Math.floor(k / side)];
    return polyline([at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)]);
  });
  return new TextEncoder().encode(drawing(squares.flat()));
}
