// What the page looks like: in both themes, for people and for axe, and whether its sheet has changed.

import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { ROOT } from '../../scripts/tools.mjs';
import { PATIENCE } from './page-support.mjs';

const SHOTS = join(ROOT, 'target', 'shots');

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

/** What axe works out: without the list of all that is right, it takes half the time. */
const VIOLATIONS = { resultTypes: ['violations'] };

/** The serious and critical violations that axe finds on the page or in one element, in either theme. */
export async function serious(page, within = 'html') {
  const isThere = await page.evaluate(() => window.axe !== undefined);
  if (!isThere) await page.evaluate(readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8'));
  const found = [];
  await inBothThemes(page, async (theme) => {
    const violations = await page.evaluate(async ([within, options]) => (await window.axe.run(within, options)).violations.map((v) => ({ id: v.id, impact: v.impact, at: v.nodes.map((n) => n.target.join(' ')) })), [within, VIOLATIONS]);
    found.push(...violations.map((v) => ({ theme, ...v })));
  });
  return found.filter((v) => v.impact === 'serious' || v.impact === 'critical');
}

/** The connections to pages over which pictures are taken. */
const connections = new WeakMap();

/** A picture of the page, or of a part of it. The screenshots of Playwright are the same, but compressed for size, for twice the time. */
async function captured(page, clip) {
  if (!connections.has(page)) connections.set(page, await page.context().newCDPSession(page));
  const { data } = await connections.get(page).send('Page.captureScreenshot', { format: 'png', optimizeForSpeed: true, ...(clip && { clip: { ...clip, scale: 1 } }) });
  return Buffer.from(data, 'base64');
}

/** Saves a screenshot in target/shots. */
export async function picture(page, name) {
  mkdirSync(SHOTS, { recursive: true });
  writeFileSync(join(SHOTS, `${name}.png`), await captured(page));
}

/** Saves screenshots in both themes in target/shots, NAME-light.png and NAME-dark.png, for people to look at. */
export const shot = (page, name) => inBothThemes(page, (theme) => picture(page, `${name}-${theme}`));

/** A picture of the sheet. */
export const canvasShot = async (page) => captured(page, await page.locator('#canvas').boundingBox());

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
