// How the page feels: what Lighthouse asks of a first visit, in Chromium, nothing cached, on this machine and on one four
// times slower; and the page's thread under 10,000 contours that are being planned. Medians of several visits.

import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { chromium } from 'playwright-core';
import { build } from '../scripts/build.mjs';
import { serve } from '../scripts/serve.mjs';
import { findBrowser, setup } from '../scripts/setup.mjs';
import { DIST } from '../scripts/tools.mjs';
import { grid, planned, roam, SIZES, tasksOf, watchFrames } from '../tests/browser/page-support.mjs';
import { median, ms, table } from './common/table.mjs';

const VISITS = 5;
/** How much slower the second machine is: Lighthouse's measure of a phone. */
const SLOWER = 4;
/** Milliseconds from which a task is long, as everybody counts. */
const LONG = 50;
/** Milliseconds without a long task after which the page counts as quiet. */
const QUIET = 2_000;
/** Milliseconds anything may take on a busy machine. */
const PATIENCE = 120_000;
const TARGETS = { interactive: 1000, task: 50 };

export async function bench() {
  await setup({ tests: true });
  await build();
  const server = await serve(join(DIST, 'app'));
  const browser = await chromium.launch({ executablePath: findBrowser(), args: ['--no-sandbox', '--disable-gpu', '--disable-background-networking', '--no-first-run'] });
  try {
    const machines = [['this machine', 1], [`${SLOWER} times slower`, SLOWER]];
    const lines = [];
    for (const [name, slower] of machines) {
      const visits = [];
      for (let k = 0; k < VISITS; k += 1) visits.push(await visit(browser, server.url, slower));
      const of = (key) => median(visits.map((v) => v[key]));
      lines.push([name, ...['paint', 'largest', 'interactive', 'blocked', 'planned'].map((key) => ms(of(key))), of('shift').toFixed(3), String(of('requests')), kB(of('raw')), kB(of('gzip'))]);
    }
    const columns = ['first paint', 'largest paint', 'interactive', 'blocked', 'first path', 'shift', 'requests', 'raw', 'gzip'];
    table(`A first visit, medians of ${VISITS}; interactive should be below ${ms(TARGETS.interactive)}`, ['', ...columns], lines);
    await crowded(browser, server.url);
  } finally {
    await browser.close();
    await server.close();
  }
}

const sum = (values) => values.reduce((all, v) => all + v, 0);
const kB = (bytes) => `${(bytes / 1e3).toFixed(0)} kB`;

async function opened(browser, prepare) {
  const context = await browser.newContext({ viewport: SIZES.desktop });
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  await page.addInitScript(prepare);
  return { context, page };
}

/** Runs in the page: notes paints, shifts, long tasks, and when the sample has its first path. */
const observe = () => {
  const seen = (window.seen = { paint: 0, largest: 0, shift: 0, tasks: [], planned: 0 });
  const on = (type, note) => new PerformanceObserver((list) => list.getEntries().forEach(note)).observe({ type, buffered: true });
  on('paint', (e) => e.name === 'first-contentful-paint' && (seen.paint = e.startTime));
  on('largest-contentful-paint', (e) => (seen.largest = e.startTime));
  on('layout-shift', (e) => !e.hadRecentInput && (seen.shift += e.value));
  on('longtask', (e) => seen.tasks.push([e.startTime, e.duration]));
  const look = () => {
    if (document.body?.dataset.phase === 'planning' || document.body?.dataset.phase === 'done') seen.planned = performance.now();
    else requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
};

async function visit(browser, url, slower) {
  const { context, page } = await opened(browser, observe);
  if (slower > 1) await (await context.newCDPSession(page)).send('Emulation.setCPUThrottlingRate', { rate: slower });
  const bodies = [];
  context.on('response', (response) => bodies.push(response.body().catch(() => Buffer.alloc(0))));
  await page.goto(url);
  await page.waitForFunction((quiet) => {
    const last = window.seen.tasks.at(-1) ?? [0, 0];
    return window.seen.planned > 0 && performance.now() - Math.max(last[0] + last[1], window.seen.planned) > quiet;
  }, QUIET);
  const { tasks, ...seen } = await page.evaluate(() => window.seen);
  // What loads while the page is used (the file for working offline) is no part of the way to using it.
  const early = tasks.filter(([start]) => start < seen.planned);
  const files = await Promise.all(bodies);
  await context.close();
  return {
    ...seen,
    interactive: Math.max(seen.paint, ...early.map(([start, length]) => start + length)),
    blocked: early.reduce((sum, [, length]) => sum + length - LONG, 0),
    requests: files.length,
    raw: files.reduce((sum, f) => sum + f.length, 0),
    gzip: files.reduce((sum, f) => sum + gzipSync(f).length, 0),
  };
}

/** Processor time of the page's thread from nothing to the first path, which other work on the machine changes little. */
async function arriving(browser, url) {
  const { context, page } = await opened(browser, observe);
  const tasks = await tasksOf(page, async () => {
    await page.goto(url);
    await page.waitForFunction(() => window.seen.planned > 0);
  });
  await context.close();
  return tasks;
}

async function crowded(browser, url) {
  const folder = mkdtempSync(join(tmpdir(), 'kerfway-bench-'));
  const file = join(folder, 'ten-thousand.dxf');
  writeFileSync(file, grid(10_000));
  const { context, page } = await opened(browser, watchFrames);
  await page.goto(`${url}#seconds=60`);
  await page.waitForFunction(() => document.body.dataset.phase === 'planning');
  const loading = await tasksOf(page, async () => {
    // From disk, as a person does: handing over bytes would count the test's own making of the file.
    const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.getByRole('button', { name: 'Open a DXF file' }).click()]);
    await chooser.setFiles(file);
    await planned(page, 'ten-thousand.dxf', 'planning');
    await page.waitForTimeout(1_000);
  });
  await page.evaluate(() => (window.frames.length = 0));
  const roaming = await tasksOf(page, () => roam(page));
  rmSync(folder, { recursive: true });
  const frames = (await page.evaluate(() => window.frames)).sort((a, b) => a - b);
  await context.close();
  const one = (value) => `${value.toFixed(1)} ms`;
  const at = (share) => one(frames[Math.floor((frames.length - 1) * share)]);
  const first = await arriving(browser, url);
  table(`The page's thread, processor time; with 10,000 contours no task should take ${ms(TARGETS.task)}`, ['', 'longest task', 'second', 'all', 'frames: median', '95 %', 'longest, by the clock'], [
    ['to the first path of a first visit', one(first[0]), one(first[1]), one(sum(first)), '', '', ''],
    ['opening 10,000 contours', one(loading[0]), one(loading[1]), one(sum(loading)), '', '', ''],
    ['panning and zooming while they are planned', one(roaming[0]), one(roaming[1]), one(sum(roaming)), at(0.5), at(0.95), at(1)],
  ]);
}
