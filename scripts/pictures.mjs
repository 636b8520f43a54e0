// Makes pictures of README and docs with the built package and page: `node scripts/pictures.mjs` after a build. docs/corners.png and
// docs/kerf-starts.png, docs/bridges.png and docs/bridges-cut.png are written by the command line; docs/tips.png is what the page shows of pieces that tip and of the ways past them;
// www/screenshot.png is the page as a newcomer has it after a minute.

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { dxf, polygon } from '../tests/package/support.mjs';
import { still } from '../tests/browser/page-pictures.mjs';
import { machineSection, openPage, openPlanned, phase, replanned, SIZES } from '../tests/browser/page-support.mjs';
import { createPlanner } from '../dist/sdk/node.js';
import { main, ROOT, run } from './tools.mjs';

/** A star with five tips, and a window with three notches that point inwards. */
function star() {
  const at = (radius, turns) => [70 + radius * Math.sin(2 * Math.PI * turns), 70 + radius * Math.cos(2 * Math.PI * turns)];
  const outline = Array.from({ length: 10 }, (_, k) => at(k % 2 ? 30 : 60, k / 10));
  const window = Array.from({ length: 6 }, (_, k) => at(k % 2 ? 7 : 18, k / 6));
  return dxf(polygon(outline), polygon(window));
}

/** The star in plate, with loops. */
function corners(folder) {
  const file = join(folder, 'star.dxf');
  writeFileSync(file, star());
  const options = ['--machine', 'fibre-6kw-plate', '--corners', 'loop', '--hole-corners', 'loop', '--loop-radius', '1.5'];
  run(process.execPath, [join(ROOT, 'dist', 'sdk', 'cli.js'), 'plan', file, ...options, '--moves', '50000', '--seed', '1', '--png', join(ROOT, 'docs', 'corners.png'), '--quiet']);
}

/** A bar with four parts above it and three below: each begins on the kerf of the bar. */
function kerfStarts(folder) {
  const file = join(folder, 'bar.dxf');
  const part = (x, y, width, height) => polygon([[x, y], [x + width, y], [x + width, y + height], [x, y + height]]);
  writeFileSync(file, dxf(part(10, 10, 180, 20), ...[0, 1, 2, 3].map((k) => part(20 + 45 * k, 38, 25, 25)), ...[0, 1, 2].map((k) => part(20 + 60 * k, -18, 30, 20))));
  const options = ['--machine', 'fibre-6kw-thick', '--chains', '15', '--chain-clearance', '1', '--edge-starts'];
  run(process.execPath, [join(ROOT, 'dist', 'sdk', 'cli.js'), 'plan', file, ...options, '--moves', '100000', '--seed', '1', '--png', join(ROOT, 'docs', 'kerf-starts.png'), '--quiet']);
}

/** Two rows of brackets with a hole each, connected to one piece: left so, and cut apart later in plate that takes 3 s to pierce. */
function bridges(folder, planner) {
  const file = join(folder, 'brackets.dxf');
  const bracket = (x, y) => polygon([[x, y], [x + 50, y], [x + 50, y + 14], [x + 14, y + 14], [x + 14, y + 40], [x, y + 40]]);
  const window = (x, y) => polygon([[x + 24, y + 4], [x + 42, y + 4], [x + 42, y + 10], [x + 24, y + 10]]);
  const places = [0, 1, 2].flatMap((k) => [[10 + 62 * k, 10], [10 + 62 * k, 62]]);
  writeFileSync(file, dxf(...places.flatMap(([x, y]) => [bracket(x, y), window(x, y)])));
  const slow = join(folder, 'slow.json');
  writeFileSync(slow, JSON.stringify({ ...planner.machines.find((m) => m.name === 'fibre-6kw-thick'), name: 'slow', pierce_time: 3 }));
  for (const [machine, name, ...more] of [['fibre-6kw-thick', 'bridges.png'], [slow, 'bridges-cut.png', '--cut-bridges']]) {
    const options = ['--machine', machine, '--bridges', '15', '--bridge-width', '4', ...more];
    run(process.execPath, [join(ROOT, 'dist', 'sdk', 'cli.js'), 'plan', file, ...options, '--moves', '100000', '--seed', '1', '--png', join(ROOT, 'docs', name), '--quiet']);
  }
}

/** Milliseconds after which most of what is left to gain is proven. */
const PROVEN = 45_000;

/** The whole page with its first sheet, planned. */
async function screenshot() {
  const after = [];
  const { page } = await openPage({ after: (end) => after.push(end) }, { hash: 'seed=1' });
  await page.getByRole('button', { name: 'Keep this machine' }).click();
  await phase(page, 'done');
  await page.waitForTimeout(PROVEN);
  await page.screenshot({ path: join(ROOT, 'www', 'screenshot.png') });
  for (const end of after) await end();
}

/** A sheet of 100 contours on the page: pieces that tip in amber, moves around them, and over them with the head lifted. */
async function tips() {
  const drawing = readFileSync(join(ROOT, 'tests', 'fixtures', 'sheets', 'sheet_100.dxf'));
  const after = [];
  const page = await openPlanned({ after: (end) => after.push(end) }, 'fibre-3kw-thin', 'sheet_100.dxf', drawing, { size: SIZES.desktop });
  const machine = await machineSection(page, SIZES.desktop);
  await replanned(page, () => machine.getByLabel('Mind pieces that tip').check());
  await replanned(page, () => machine.getByLabel('Lift before moving, lower after it').check());
  writeFileSync(join(ROOT, 'docs', 'tips.png'), await still(page));
  for (const end of after) await end();
}

await main(async () => {
  const folder = mkdtempSync(join(tmpdir(), 'kerfway-'));
  corners(folder);
  kerfStarts(folder);
  const planner = await createPlanner();
  bridges(folder, planner);
  planner.close();
  rmSync(folder, { recursive: true });
  await tips();
  await screenshot();
});
