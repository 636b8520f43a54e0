// How far the default budget of a quote is from a search ten times as long:
//
//     npm run bench -- quote [--only NAME] [--data FOLDER]
//
// Drawings are those of tests/fixtures/dxf-dev and the sheets; `--data FOLDER` names a folder with more DXF files. Air in
// seconds on the default machine, seed 1, in wasm under Node.

import { readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { build } from '../scripts/build.mjs';
import { setup } from '../scripts/setup.mjs';
import { DIST, ROOT } from '../scripts/tools.mjs';
import { drawings } from './common/drawings.mjs';
import { table } from './common/table.mjs';

const FIXTURES = ['dxf-dev', 'sheets'].map((folder) => join(ROOT, 'tests', 'fixtures', folder));
/** The longer search, in multiples of the default budget; and the budget of a quote before it grew with the contours. */
const [LONGER, BEFORE] = [10, 100_000];

export async function bench(args) {
  const { values } = parseArgs({ args, options: { only: { type: 'string' }, data: { type: 'string' } } });
  await setup();
  await build();
  const { createPlanner } = await import(pathToFileURL(join(DIST, 'sdk', 'node.js')).href);
  const { quoteBudget } = await import(pathToFileURL(join(DIST, 'sdk', 'quote-budget.js')).href);
  const planner = await createPlanner();
  const lines = [];
  const worst = { before: 0, now: 0 };
  for (const file of drawings([...FIXTURES, ...(values.data === undefined ? [] : [values.data])], values.only)) {
    const loaded = await planner.load(readFileSync(file), basename(file)).catch(() => null);
    const { moves, seed } = loaded === null ? {} : quoteBudget(loaded);
    const air = async (moves) => {
      const { progress } = await planner.plan({ moves, seed }).done;
      return [progress.summary.air_time, progress.seconds];
    };
    if (loaded === null || loaded.contours.every((c) => c.operation === 'ignore')) continue;
    const [[before], [now, seconds], [longer]] = [await air(BEFORE), await air(moves), await air(LONGER * moves)];
    const off = (value) => (longer > 0 ? (100 * (value - longer)) / longer : 0);
    worst.before = Math.max(worst.before, off(before));
    worst.now = Math.max(worst.now, off(now));
    const percent = (value) => `${off(value).toFixed(2)} %`;
    lines.push([basename(file), String(loaded.contours.length), percent(before), percent(now), String(moves), `${seconds.toFixed(1)} s`]);
  }
  planner.close();
  lines.push(['worst', '', `${worst.before.toFixed(2)} %`, `${worst.now.toFixed(2)} %`, '', '']);
  table('Air of a quote above that of a search ten times as long', ['', 'contours', `${BEFORE} moves`, 'by default', 'moves', 'takes'], lines);
}
