// Helpers of the page's tests: opens the built page in Chromium, does what people do, and waits for what follows.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { launchBrowser } from '../../scripts/browser.mjs';
import { serve } from '../../scripts/serve.mjs';
import { DIST } from '../../scripts/tools.mjs';

/** Milliseconds that anything may take on a busy machine before a test gives up. */
export const PATIENCE = 60_000;

export const SIZES = { desktop: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } };

/** The browser, while there is one, and how many pages of it are open. */
let browser = null;
let open = 0;
/** Milliseconds that the browser stays without a page: the next test of the file opens one at once. */
const STAYS = 100;

function launched() {
  open += 1;
  return (browser ??= launchBrowser());
}

function leave() {
  open -= 1;
  setTimeout(async () => {
    const left = open === 0 ? browser : null;
    if (left === null) return;
    browser = null;
    await (await left).close();
  }, STAYS);
}

/**
 * Opens the built page in a context of its own, with its own storage and service worker, and closes everything when the test ends. Errors on the page
 * fail the test, unless `broken`. `sent` lists the files whose bytes the server has sent, to the page or to its service worker, and where the bytes
 * came from.
 */
export async function openPage(t, { size = SIZES.desktop, theme = 'light', touch = false, hash = '', prepare, broken = false } = {}) {
  const sent = [];
  const server = await serve(join(DIST, 'app'), 0, {}, (file, source) => sent.push({ file, source }));
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
    leave();
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

/** Opens every section and part of one, and waits for those whose content is loaded when they are opened, and for their own parts. */
export async function openEverything(page) {
  await page.waitForFunction(() => {
    const all = [...document.querySelectorAll('details')];
    const filled = all.every((d) => d.open && d.childElementCount > 1 && d.querySelector(':scope > .section-body:empty') === null);
    all.forEach((d) => (d.open = true));
    return filled;
  });
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

/** Sets how long is searched, as a preparation: nobody presses anything, and the section with the list of times is as before. */
export async function searchFor(page, seconds) {
  const section = page.locator('details.section', { has: page.getByRole('heading', { name: 'Plan', exact: true, includeHidden: true }) });
  const before = await section.evaluate((d) => [d.open, (d.open = true)][0]);
  await section.getByLabel('Search for').evaluate((list, seconds) => {
    list.value = String(seconds);
    list.dispatchEvent(new Event('change'));
  }, seconds);
  await section.evaluate((d, open) => (d.open = open), before);
}

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

/** Waits until the browser has stored a job with this many skipped contours, in a unit if one is given, and a finished plan of it. */
export async function storedWith(page, skipped, unit = null) {
  const isStored = () => page.evaluate(async ([skipped, unit]) => {
    const request = indexedDB.open('kerfway');
    const database = await new Promise((resolve) => (request.onsuccess = () => resolve(request.result)));
    const jobs = database.transaction('jobs').objectStore('jobs').getAll();
    await new Promise((resolve) => (jobs.onsuccess = resolve));
    database.close();
    // A contour is skipped before the plan without it is there.
    return jobs.result.some(({ reading: { exclude = [], units }, plan }) => exclude.length === skipped && (unit === null || units === unit) && plan?.done === true && !exclude.some((c) => plan.path.contours.includes(c)));
  }, [skipped, unit]);
  await until(page, 'the job is stored', isStored);
}

/** The machine's section, opened, with its controls; on a phone after the settings. */
export async function machineSection(page, size) {
  if (size === SIZES.phone) await page.locator('.sheet-toggle').click();
  const machine = page.locator('details.section', { has: page.getByRole('heading', { name: 'Machine', exact: true }) });
  await machine.evaluate((d) => (d.open = true));
  await machine.getByLabel('Preset').waitFor();
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
