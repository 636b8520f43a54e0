// Helpers of the page's tests: the built page in Chromium, dropping files on it, making drawings, reading G-code back.

import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { delimiter, dirname, isAbsolute, join } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { serve } from '../../scripts/serve.mjs';
import { findBrowser } from '../../scripts/setup.mjs';

const ROOT = dirname(dirname(dirname(fileURLToPath(import.meta.url))));

/** Milliseconds that anything may take on a busy machine before a test gives up. */
const PATIENCE = 60_000;

export const SIZES = { desktop: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } };

/** The browser of this test file, once a test needs it. */
let browser = null;
after(async () => (await browser)?.close());

const launched = () => (browser ??= chromium.launch({
  executablePath: browserPath(),
  args: ['--no-sandbox', '--disable-gpu', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--no-first-run'],
}));

/**
 * Opens the built page in a context of its own, with its own storage and service worker, and closes everything when the test ends. Errors on the page
 * fail the test, unless `broken`. `sent` lists the files whose bytes the server has sent, to the page or to its service worker, and where the bytes
 * came from.
 */
export async function openPage(t, { size = SIZES.desktop, theme = 'light', touch = false, hash = '', prepare, broken = false } = {}) {
  const sent = [];
  const server = await serve(join(ROOT, 'dist', 'app'), 0, {}, (file, source) => sent.push({ file, source }));
  const context = await (await launched()).newContext({ viewport: size, colorScheme: theme, hasTouch: touch, acceptDownloads: true });
  context.setDefaultTimeout(PATIENCE);
  await context.addInitScript(countPlansAndClicks);
  const page = await context.newPage();
  const requests = [];
  const errors = [];
  page.on('request', (request) => requests.push(request.url()));
  page.on('pageerror', (error) => errors.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && errors.push(message.text()));
  // The context is closed first, because a page that still fills its cache needs the server.
  t.after(async () => {
    await context.close();
    await server.close();
    if (!broken) assert.deepEqual(errors, []);
  });
  if (prepare) await page.addInitScript(prepare);
  await page.goto(`${server.url}${hash && `#${hash}`}`);
  return { page, requests, sent, url: server.url };
}

/**
 * Runs in the page: counts how often planning has begun, because a short plan may begin and end between two looks at the page, and the clicks, because
 * the click of a tap follows after the finger.
 */
const countPlansAndClicks = () => {
  window.plansBegun = 0;
  window.clicks = 0;
  addEventListener('click', () => (window.clicks += 1), { capture: true });
  addEventListener('DOMContentLoaded', () => {
    let before;
    new MutationObserver(() => {
      const { phase } = document.body.dataset;
      if (phase === 'planning' && before !== 'planning') window.plansBegun += 1;
      before = phase;
    }).observe(document.body, { attributeFilter: ['data-phase'] });
  });
};

/** Where the browser is: playwright wants a path, not a name. */
function browserPath() {
  const found = findBrowser();
  assert.ok(found, 'the browser tests need Chromium: npm run setup');
  if (isAbsolute(found)) return found;
  return process.env.PATH.split(delimiter).map((folder) => join(folder, found)).find(existsSync);
}

/** Frames of the page within which the click of a tap follows. */
const CLICK = 30;

/** Taps a control until it is clicked: on a busy machine the finger may rest so long that it does not tap. */
export async function tap(locator) {
  const page = locator.page();
  const before = await page.evaluate(() => window.clicks);
  await until(page, 'a tap clicks', async () => {
    await locator.tap();
    return page.evaluate(clicksWithin, [before, CLICK]);
  });
}

/** Runs in the page: whether more was clicked than before, after at most so many frames. */
const clicksWithin = ([before, frames]) => new Promise((resolve) => {
  const look = (left) => (window.clicks > before || left === 0 ? resolve(window.clicks > before) : requestAnimationFrame(() => look(left - 1)));
  look(frames);
});

/** Waits until the page is in one of these states. */
export function phase(page, ...names) {
  return page.waitForFunction((wanted) => wanted.includes(document.body.dataset.phase), names);
}

/** Opens every section and part of one, and waits for those whose content is loaded when they are opened. */
export async function openEverything(page) {
  await page.evaluate(() => document.querySelectorAll('details').forEach((d) => (d.open = true)));
  await page.waitForFunction(() => [...document.querySelectorAll('details')].every((d) => d.childElementCount > 1));
}

/** Drops a file on the page. */
export function drop(page, name, bytes) {
  return dropAll(page, [[name, bytes]]);
}

/** Drops several files at once, each given as its name and bytes. */
export async function dropAll(page, files) {
  await page.evaluate(
    (files) => {
      const data = new DataTransfer();
      for (const [name, base64] of files) data.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
      const event = (type) => new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true });
      document.body.dispatchEvent(event('dragenter'));
      document.body.dispatchEvent(event('drop'));
    },
    files.map(([name, bytes]) => [name, Buffer.from(bytes).toString('base64')]),
  );
}

/** Frames of the page after which a sheet that never rests, because its plan is still searched, counts as drawn in another theme. */
const REPAINT = 30;

/** Sets the theme of the system, and waits until the page has followed. */
async function setTheme(page, theme) {
  await page.emulateMedia({ colorScheme: theme });
  await page.evaluate(followed, REPAINT);
}

/** Runs in the page: the first frame brings the change of the theme, the second draws what the workers are not needed for. */
const followed = (most) => new Promise((resolve) => {
  const look = (frames) => {
    const isDrawn = [...document.querySelectorAll('canvas')].every((canvas) => canvas.ariaBusy !== 'true');
    if (frames >= 2 && (isDrawn || (frames >= most && document.body.dataset.phase === 'planning'))) resolve();
    else requestAnimationFrame(() => look(frames + 1));
  };
  look(0);
});

/** Does something with the page in its theme and then in the other one, and puts the theme back. A theme chosen on the page itself stays. */
export async function inBothThemes(page, work) {
  const own = await page.evaluate(() => (matchMedia('(prefers-color-scheme: dark)').matches ? 'dark' : 'light'));
  const other = own === 'dark' ? 'light' : 'dark';
  await work(own);
  await setTheme(page, other);
  await work(other);
  await setTheme(page, own);
}

/** The serious and critical violations that axe finds on the page or in one element, in either theme. */
export async function serious(page, within = 'html') {
  await page.evaluate(readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8'));
  const found = [];
  await inBothThemes(page, async (theme) => {
    const violations = await page.evaluate(async (within) => (await window.axe.run(within)).violations.map((v) => ({ id: v.id, impact: v.impact, at: v.nodes.map((n) => n.target.join(' ')) })), within);
    found.push(...violations.map((v) => ({ theme, ...v })));
  });
  return found.filter((v) => v.impact === 'serious' || v.impact === 'critical');
}

/** Saves a screenshot in target/shots. */
export const picture = (page, name) => page.screenshot({ path: join(ROOT, 'target', 'shots', `${name}.png`) });

/** Saves screenshots in both themes in target/shots, NAME-light.png and NAME-dark.png, for people to look at. */
export const shot = (page, name) => inBothThemes(page, (theme) => picture(page, `${name}-${theme}`));

const canvasShot = (page) => page.locator('#canvas').screenshot();

/** How often the picture must be the same in a row to count as still. */
const STILL = 3;

/** Waits until the sheet does not change any more, and nothing more is being drawn; returns its picture. */
export async function still(page) {
  let last = await canvasShot(page);
  for (let same = 1; same < STILL; ) {
    await page.waitForFunction(() => document.querySelector('#canvas').ariaBusy !== 'true');
    const next = await canvasShot(page);
    same = next.equals(last) ? same + 1 : 1;
    last = next;
  }
  return last;
}

/** Waits until the sheet looks different from a picture. */
export async function changedFrom(page, picture) {
  const end = Date.now() + PATIENCE;
  while ((await canvasShot(page)).equals(picture)) assert.ok(Date.now() < end, 'the sheet changes');
}

/** Waits until the text of an element has stayed the same for so many frames of the page. */
export function steady(page, selector, frames = 40) {
  return page.evaluate(([selector, frames]) => new Promise((resolve) => {
    let [text, same] = [null, 0];
    const look = () => {
      const now = document.querySelector(selector).textContent;
      same = now === text ? same + 1 : 0;
      text = now;
      if (same >= frames) resolve(text);
      else requestAnimationFrame(look);
    };
    look();
  }), [selector, frames]);
}

/** Sets how long is searched, as a preparation: nobody presses anything. */
export const searchFor = (page, seconds) => page.getByLabel('Search for').evaluate((list, seconds) => {
  list.value = String(seconds);
  list.dispatchEvent(new Event('change'));
}, seconds);

/** Waits for so many frames of the page. */
export function nextFrames(page, count) {
  return page.evaluate((count) => new Promise((resolve) => {
    const next = (left) => (left > 0 ? requestAnimationFrame(() => next(left - 1)) : resolve());
    next(count);
  }), count);
}

/** Waits until the page shows a drawing of that name that is being planned or is done. */
export async function planned(page, name, ...phases) {
  await page.waitForFunction((n) => document.querySelector('.file-name')?.textContent === n, name);
  await phase(page, ...(phases.length > 0 ? phases : ['planning', 'done']));
}

/** The file that the page downloads when a button is pressed. */
export async function download(page, press) {
  const [file] = await Promise.all([page.waitForEvent('download'), press()]);
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

/** Asks again until the answer is yes. `waitForFunction` takes the promise of an asynchronous function for its result. */
export async function until(page, what, ask) {
  const end = Date.now() + PATIENCE;
  while (!(await ask())) {
    assert.ok(Date.now() < end, what);
    await nextFrames(page, 6);
  }
}

/** Waits until the service worker controls the page and has stored the JavaScript and the wasm of one of the wasm files. */
export function stored(page, name) {
  return until(page, `${name} is stored`, () => page.evaluate(isStored, name));
}

const isStored = async (name) => {
  const lists = await Promise.all((await caches.keys()).map(async (cache) => (await caches.open(cache)).keys()));
  const all = lists.flat().map(({ url }) => url).filter((url) => url.includes(name));
  return navigator.serviceWorker.controller !== null && ['.js', '.wasm'].every((end) => all.some((url) => url.endsWith(end)));
};

/** The text of one of the downloads, by the name on its button. */
export async function output(page, name) {
  const press = () => page.locator('.downloads').getByRole('button', { name, exact: true }).click();
  return (await download(page, press)).bytes.toString();
}

/** The plan document. */
export const plan = async (page) => JSON.parse(await output(page, 'Plan (JSON)'));

/** Does something and waits for the plan that follows, which does not begin at once: typing waits for more keys, and a drawing is read again first. */
export async function replanned(page, act) {
  const before = await page.evaluate(() => window.plansBegun);
  await act();
  await page.waitForFunction((n) => window.plansBegun > n && document.body.dataset.phase === 'done', before);
}

/** Waits until the browser has stored a job with this many skipped contours and a finished plan of it. */
export async function storedWith(page, skipped) {
  const isStored = () => page.evaluate(async (skipped) => {
    const request = indexedDB.open('kerfway');
    const database = await new Promise((resolve) => (request.onsuccess = () => resolve(request.result)));
    const jobs = database.transaction('jobs').objectStore('jobs').getAll();
    await new Promise((resolve) => (jobs.onsuccess = resolve));
    database.close();
    // A contour is skipped before the plan without it is there.
    return jobs.result.some(({ reading: { exclude = [] }, plan }) => exclude.length === skipped && plan?.done === true && !exclude.some((c) => plan.path.contours.includes(c)));
  }, skipped);
  await until(page, 'the job is stored', isStored);
}

/** The machine's section, opened; on a phone after the settings. */
export async function machineSection(page, size) {
  if (size === SIZES.phone) await page.locator('.sheet-toggle').click();
  const machine = page.locator('details.section', { has: page.getByRole('heading', { name: 'Machine', exact: true }) });
  await machine.evaluate((d) => (d.open = true));
  return machine;
}

/** Opens the page with a machine and a drawing in millimetres that is planned, the same with the same seed. */
export async function openPlanned(t, machine, name, bytes, options = {}) {
  const { page } = await openPage(t, { hash: `machine=${machine}&seconds=0.4&seed=1&units=mm`, ...options });
  await phase(page, 'planning', 'done');
  await drop(page, name, Buffer.from(bytes));
  await planned(page, name, 'done');
  return page;
}

/** The same with a sheet for a fibre laser, and a part of the machine's section open. */
export async function openMachinePart(t, part, name, bytes, options = {}) {
  const page = await openPlanned(t, 'fibre-3kw-thin', name, bytes, options);
  const machine = await machineSection(page, options.size);
  const opened = machine.locator('details.more', { hasText: part });
  await opened.evaluate((d) => (d.open = true));
  return { page, opened };
}

/** A file of the page's own samples. */
export const sample = (name) => readFileSync(join(ROOT, 'www', 'app', 'public', 'samples', name));

/** A DXF of circles and squares on a grid, `count` contours in all, mm; above and right of the origin, so on every bed. */
export function grid(count, { units = 4, step = 12 } = {}) {
  const columns = Math.ceil(Math.sqrt(count * 2));
  const text = ['0', 'SECTION', '2', 'HEADER', ...(units === null ? [] : ['9', '$INSUNITS', '70', units]), '0', 'ENDSEC', '0', 'SECTION', '2', 'ENTITIES'];
  for (let i = 0; i < count; i += 1) {
    const x = (i % columns + 0.5) * step, y = (Math.floor(i / columns) + 0.5) * step;
    if (i % 3 > 0) text.push('0', 'CIRCLE', '8', 'HOLES', '10', x, '20', y, '40', step * (0.2 + (i % 5) * 0.04));
    else {
      text.push('0', 'LWPOLYLINE', '8', 'CUT', '90', 4, '70', 1);
      for (const [dx, dy] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) text.push('10', x + dx * step * 0.3, '20', y + dy * step * 0.3);
    }
  }
  text.push('0', 'ENDSEC', '0', 'EOF');
  return Buffer.from(`${text.join('\n')}\n`);
}

/**
 * Runs a G-code program as a controller would. Returns each unbroken stretch with the beam on: where it begins and
 * ends and its length, mm. Fails when the beam is on during a rapid.
 */
export function beamRuns(program) {
  const runs = [];
  let at = { x: 0, y: 0 };
  let motion = 0, power = 0, mode = 5, run = null;
  for (const line of program.split('\n')) {
    const words = [...line.replace(/;.*|\(.*?\)/g, '').matchAll(/([A-Z])\s*(-?[\d.]+)/g)].map(([, letter, value]) => [letter, Number(value)]);
    const word = Object.fromEntries(words);
    for (const [letter, value] of words) {
      if (letter === 'G' && value <= 3) motion = value;
      if (letter === 'M' && value >= 3 && value <= 5) mode = value;
      if (letter === 'S') power = value;
    }
    if (word.X === undefined && word.Y === undefined) continue;
    const to = { x: word.X ?? at.x, y: word.Y ?? at.y };
    const on = mode !== 5 && power > 0;
    if (motion === 0) {
      assert.ok(!on, `the beam is on during a rapid: ${line}`);
      run = null;
    } else if (on) {
      if (!run) runs.push((run = { from: at, to, length: 0 }));
      run.to = to;
      run.length += motion === 1 ? Math.hypot(to.x - at.x, to.y - at.y) : arcLength(at, to, { x: at.x + (word.I ?? 0), y: at.y + (word.J ?? 0) }, motion === 3);
    }
    at = to;
  }
  return runs;
}

function arcLength(from, to, center, ccw) {
  const a = Math.atan2(from.y - center.y, from.x - center.x), b = Math.atan2(to.y - center.y, to.x - center.x);
  const turn = (ccw ? b - a : a - b) % (2 * Math.PI);
  return Math.hypot(from.x - center.x, from.y - center.y) * (turn <= 1e-9 ? turn + 2 * Math.PI : turn);
}

/** Runs in the page: records the time between frames. */
export const watchFrames = () => {
  window.frames = [];
  let before = 0;
  const frame = (now) => {
    if (before) window.frames.push(now - before);
    before = now;
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
};

/** Processor milliseconds of each task the page's thread ran while `act` went on, longest first. */
export async function tasksOf(page, act) {
  const browser = page.context().browser();
  await browser.startTracing(page, { categories: ['toplevel', 'devtools.timeline', 'disabled-by-default-devtools.timeline'] });
  await act();
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  const main = new Set(traceEvents.filter((e) => e.name === 'thread_name' && e.args.name === 'CrRendererMain').map((e) => `${e.pid} ${e.tid}`));
  // The scheduler reports each task twice, under two names.
  const tasks = traceEvents.filter((e) => e.ph === 'X' && e.name === 'ThreadControllerImpl::RunTask' && e.tdur !== undefined && main.has(`${e.pid} ${e.tid}`));
  return tasks.map((e) => e.tdur / 1000).sort((a, b) => b - a);
}

/** Drags the sheet about, as a person would. */
export async function pan(page) {
  await page.mouse.move(500, 450);
  await page.mouse.down();
  for (let i = 0; i < 40; i += 1) await page.mouse.move(500 + 4 * i, 450 + 30 * Math.sin(i / 5));
  await page.mouse.up();
}

/** Zooms in and out with the wheel. */
export async function zoom(page) {
  for (let i = 0; i < 12; i += 1) {
    await page.mouse.wheel(0, i < 6 ? -240 : 240);
    await nextFrames(page, 4);
  }
}

/** Pans, zooms and moves the pointer over the sheet. */
export async function roam(page) {
  await pan(page);
  await zoom(page);
  for (let i = 0; i < 20; i += 1) await page.mouse.move(300 + 20 * i, 400);
}
