// How the page feels: what Lighthouse asks of a first visit, in Chromium, nothing cached, on this machine and on one four
// times slower (medians of several visits); and what the page's thread does when 10,000 and 100,000 contours are opened and handled while they
// are being planned; and how soon junk is refused.

import { randomBytes } from 'node:crypto';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { launchBrowser } from '../scripts/browser.mjs';
import { build } from '../scripts/build.mjs';
import { serve } from '../scripts/serve.mjs';
import { setup } from '../scripts/setup.mjs';
import { DIST } from '../scripts/tools.mjs';
import { grid } from '../tests/browser/page-drawings.mjs';
import { pan, tasksOf, watchFrames, zoom } from '../tests/browser/page-frames.mjs';
import { planned, SIZES } from '../tests/browser/page-support.mjs';
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
const TARGETS = { interactive: 1000, task: 50, refused: 2000 };

export async function bench() {
  await setup({ tests: true });
  await build();
  const server = await serve(join(DIST, 'app'));
  const browser = await launchBrowser();
  try {
    const machines = [['this machine', 1], [`${SLOWER} times slower`, SLOWER]];
    const lines = [];
    for (const [name, slower] of machines) {
      const visits = [];
      for (let k = 0; k < VISITS; k += 1) visits.push(await visit(browser, server.url, slower));
      const of = (key) => median(visits.map((v) => v[key]));
      lines.push([name, ...['paint', 'largest', 'interactive', 'blocked', 'planned'].map((key) => ms(of(key))), of('shift').toFixed(3), String(of('requests')), kB(of('raw')), kB(of('gzip')), kB(of('brotli'))]);
    }
    const columns = ['first paint', 'largest paint', 'interactive', 'blocked', 'first path', 'shift', 'requests', 'raw', 'gzip', 'Brotli'];
    table(`A first visit, medians of ${VISITS}; interactive should be below ${ms(TARGETS.interactive)}`, ['', ...columns], lines);
    const first = await arriving(browser, server.url);
    table("The page's thread to the first path of a first visit, processor time", ['longest task', 'second', 'all'], [[one(first[0]), one(first[1]), one(sum(first))]]);
    for (const count of CROWDS) await handling(browser, server.url, count);
    await junk(browser, server.url);
  } finally {
    await browser.close();
    await server.close();
  }
}

const sum = (values) => values.reduce((all, v) => all + v, 0);
const one = (value) => `${value.toFixed(1)} ms`;
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
    brotli: files.reduce((sum, f) => sum + brotliCompressSync(f).length, 0),
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

/** Sizes of the drawings whose handling is measured. */
const CROWDS = [10_000, 100_000];

/** What a person does with a drawing that is being planned, by name. Each is followed by half a second, in which its work ends. */
const ACTIONS = {
  pan: (page) => pan(page),
  zoom: (page) => zoom(page),
  'cut first': async (page) => {
    await page.keyboard.press('Home');
    await page.keyboard.press('1');
    await page.waitForFunction(() => /Cut first: 1 contour/.test(document.querySelector('#sections').textContent) && document.body.dataset.phase === 'planning');
    await page.waitForFunction(() => document.querySelector('.compare tbody:last-of-type td')?.textContent !== '');
  },
  'colours by order': (page) => page.keyboard.press('c'),
  'table of the order': (page) => page.keyboard.press('t'),
};

/** Milliseconds after an action in which its work is counted. */
const AFTER = 500;

async function handling(browser, url, count) {
  const folder = mkdtempSync(join(tmpdir(), 'kerfway-bench-'));
  const file = join(folder, `${count}.dxf`);
  writeFileSync(file, grid(count));
  const { context, page } = await opened(browser, watchFrames);
  await page.goto(`${url}#seconds=300`);
  await page.waitForFunction(() => document.body.dataset.phase === 'planning');
  // From disk, as a person does: handing over bytes would count the test's own making of the file.
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.getByRole('button', { name: 'Open a DXF' }).click()]);
  const begun = Date.now();
  let path = 0;
  const rows = [];
  const measure = async (name, act) => {
    await page.evaluate(() => (window.frames.length = 0));
    const tasks = await tasksOf(page, async () => {
      await act(page);
      await page.waitForTimeout(AFTER);
    });
    const frames = (await page.evaluate(() => window.frames)).sort((a, b) => a - b);
    const at = (share) => frames[Math.floor((frames.length - 1) * share)] ?? 0;
    rows.push([name, one(tasks[0] ?? 0), String(tasks.filter((t) => t > TARGETS.task).length), one(sum(tasks)), one(at(0.5)), one(at(0.95)), one(at(1))]);
  };
  await measure('open', async () => {
    await chooser.setFiles(file);
    await planned(page, `${count}.dxf`, 'planning');
    await page.waitForFunction(() => document.querySelector('.compare tbody:last-of-type td')?.textContent !== '');
    path = Date.now() - begun;
  });
  for (const [name, act] of Object.entries(ACTIONS)) await measure(name, act);
  const memory = await memoryOf(browser);
  await context.close();
  rmSync(folder, { recursive: true });
  table(`${count.toLocaleString('en')} contours: first path after ${ms(path)}, memory of the page with its workers ${(memory / 1e6).toFixed(0)} MB; tasks of the page's thread, processor time`,
    ['', 'longest task', `over ${ms(TARGETS.task)}`, 'all', 'frames: median', '95 %', 'longest, by the clock'], rows);
}

/** Resident memory of the renderers, bytes; 0 where the system does not tell. */
async function memoryOf(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send('SystemInfo.getProcessInfo');
  const resident = ({ id }) => {
    try {
      return 1024 * Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${id}/status`, 'utf8'))?.[1] ?? 0);
    } catch {
      return 0;
    }
  };
  return sum(processInfo.filter((p) => p.type === 'renderer').map(resident));
}

/** How long the page takes to refuse files of junk. */
async function junk(browser, url) {
  const folder = mkdtempSync(join(tmpdir(), 'kerfway-bench-'));
  const { context, page } = await opened(browser, observe);
  await page.goto(url);
  await page.waitForFunction(() => window.seen.planned > 0);
  const lines = [];
  for (const [what, bytes] of JUNK()) {
    const file = join(folder, `${what}.dxf`);
    writeFileSync(file, bytes);
    const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.getByRole('button', { name: 'Open a DXF' }).click()]);
    const begun = Date.now();
    await chooser.setFiles(file);
    await page.locator('.failure').waitFor();
    lines.push([what, ms(Date.now() - begun), (await page.locator('.failure p').first().textContent()).slice(0, 90)]);
    await page.locator('.failure button').click();
  }
  await context.close();
  rmSync(folder, { recursive: true });
  table(`100 MB of junk; refused within ${ms(TARGETS.refused)}`, ['', 'refused after', ''], lines);
}

/** Junk of 100 MB: bytes of every value, one letter, lines that look like a DXF file, tags that look like SVG. */
function* JUNK() {
  const size = 100e6;
  const repeated = (text) => Buffer.alloc(size, text);
  yield ['noise', randomBytes(size)];
  yield ['letters', repeated('a')];
  yield ['lines', repeated('0\nJUNK\n')];
  yield ['tags', repeated('<svg><g>')];
}
