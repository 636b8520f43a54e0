// Without a mouse, without sight, on a phone, in the dark.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid, sample } from './page-drawings.mjs';
import { changedFrom, inBothThemes, serious, shot, still } from './page-pictures.mjs';
import { drop, nextFrames, openEverything, openPage, phase, planned, replanned, SIZES, tap, until } from './page-support.mjs';

test('everything can be done by keyboard', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  const key = (name) => page.keyboard.press(name);
  await key('p');
  await phase(page, 'paused');
  await key('p');
  await phase(page, 'planning', 'done');
  await key('s');
  await phase(page, 'done');

  await key('ArrowRight');
  const card = page.getByRole('region', { name: 'Selected contour' });
  assert.match(await card.textContent(), /^No\. 1 of 500/);
  await key('ArrowRight');
  assert.match(await card.textContent(), /^No\. 2 of 500/);
  await key('End');
  assert.match(await card.textContent(), /^No\. 500 of 500/);
  await key('Escape');
  assert.equal(await card.isVisible(), false);

  await key('t');
  const table = page.getByRole('table', { name: 'Cutting order' });
  assert.equal(await table.getAttribute('aria-rowcount'), '501');
  assert.match(await table.getByRole('row').nth(1).textContent(), /^1/);
  await key('Escape');
  await key('t');
  assert.equal(await table.isVisible(), false);

  // The list of keys is loaded when somebody asks for it.
  await key('?');
  const keys = page.getByRole('dialog', { name: 'Keys' });
  await keys.waitFor();
  await key('Escape');
  assert.equal(await keys.isVisible(), false);

  // The table gave the focus back to its button, which Space would press.
  await page.evaluate(() => document.activeElement.blur());
  await key(' ');
  const slider = page.getByRole('slider', { name: 'Time in the job' });
  await page.waitForFunction(() => Number(document.querySelector('#playback input').value) > 0 && Number(document.querySelector('#playback input').value) < 9000);
  await key(' ');
  assert.match(await slider.getAttribute('aria-valuetext'), /contour \d+ of 500/);

  // Every control is reached by Tab and shows where the focus is.
  const seen = new Set();
  await page.evaluate(() => document.activeElement.blur());
  for (let i = 0; i < 60; i += 1) {
    await key('Tab');
    seen.add(await page.evaluate(() => {
      const e = document.activeElement;
      return e === document.body ? '' : `${e.tagName} ${e.getAttribute('aria-label') ?? e.textContent.trim()} ${getComputedStyle(e).outlineStyle}`;
    }));
  }
  const reached = [...seen].join('\n');
  for (const name of ['Open a DXF', 'Samples', 'Cutting order', 'theme', 'Keys and help', 'Zoom in', 'Fit the sheet', 'sheet with its cutting path', 'Time in the job', 'Keep improving', 'G-code']) {
    assert.ok(reached.includes(name), `${name} is reached by Tab:\n${reached}`);
  }
  for (const line of seen) assert.doesNotMatch(line, / none$/, 'the focus is visible');
});

test('Escape gives up the list of keys while it is still being loaded; asked for twice, it opens once', async (t) => {
  // A service worker would fetch the list itself.
  const { page } = await openPage(t, { hash: 'seconds=0.4', prepare: () => delete Navigator.prototype.serviceWorker });
  await phase(page, 'done');
  const waiting = [];
  await page.route(/later-help-/, (route) => waiting.push(route));
  const keys = page.getByRole('dialog', { name: 'Keys' });
  await page.keyboard.press('?');
  await until(page, 'the list is being loaded', () => waiting.length === 1);
  await page.keyboard.press('Escape');
  await waiting[0].continue();
  await page.waitForFunction(() => performance.getEntriesByType('resource').some(({ name, responseEnd }) => /later-help-/.test(name) && responseEnd > 0));
  await nextFrames(page, 10);
  assert.equal(await keys.isVisible(), false);
  await page.evaluate(() => ['?', '?'].forEach((key) => document.body.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }))));
  await keys.waitFor();
  assert.equal(await keys.count(), 1);
  await page.keyboard.press('Escape');
  await keys.waitFor({ state: 'hidden' });
});

test('names, headings, landmarks and contrast hold in both themes', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  await openEverything(page);
  await page.waitForFunction(() => document.querySelector('.large').textContent !== '');
  await inBothThemes(page, async (theme) => assert.deepEqual(await page.evaluate(audit), [], theme));
});

// Runs in the page: what a screen reader or weak eyes would miss.
function audit() {
  const faults = [];
  const visible = (e) => e.checkVisibility({ visibilityProperty: true }) && e.getClientRects().length > 0;
  for (const [what, selector] of [['banner', 'header'], ['main', 'main'], ['panel', 'aside[aria-label]'], ['footer', 'footer'], ['live region', '[aria-live=polite]']]) {
    if (document.querySelectorAll(selector).length !== 1) faults.push(`one ${what}`);
  }
  if (document.querySelectorAll('h1').length !== 1) faults.push('one h1');
  for (const e of document.querySelectorAll('button, input, select, canvas, [role=img]')) {
    if (e.parentElement.closest('[role=img]')) continue;
    const name = e.getAttribute('aria-label') || [...(e.labels ?? [])].map((l) => l.textContent).join('').trim() || e.textContent.trim();
    if (!name) faults.push(`no name: ${e.outerHTML.slice(0, 100)}`);
  }
  const ids = [...document.querySelectorAll('[id]')].map((e) => e.id);
  if (new Set(ids).size !== ids.length) faults.push('ids repeat');
  const pen = Object.assign(document.createElement('canvas'), { width: 1, height: 1 }).getContext('2d', { willReadFrequently: true });
  const rgba = (color) => {
    pen.clearRect(0, 0, 1, 1);
    pen.fillStyle = color;
    pen.fillRect(0, 0, 1, 1);
    return [...pen.getImageData(0, 0, 1, 1).data];
  };
  const light = ([r, g, b]) => [r, g, b].map((v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4)).reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const ground = (e) => {
    for (let at = e; at; at = at.parentElement) {
      const color = rgba(getComputedStyle(at).backgroundColor);
      if (color[3] === 255) return color;
    }
    return rgba('white');
  };
  for (const e of document.querySelectorAll('body *')) {
    const text = [...e.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim());
    if (!text || !visible(e) || e.closest('.hidden, :disabled, option')) continue;
    const [a, b] = [light(rgba(getComputedStyle(e).color)), light(ground(e))].sort((x, y) => y - x);
    const contrast = (a + 0.05) / (b + 0.05);
    if (contrast < 4.5) faults.push(`contrast ${contrast.toFixed(2)}: ${e.outerHTML.slice(0, 80)}`);
  }
  return faults;
}

test('what happens is announced politely, never more often than every two seconds', async (t) => {
  const { page } = await openPage(t, {
    prepare: () => {
      window.said = [];
      document.addEventListener('DOMContentLoaded', () => {
        const region = document.getElementById('announcer');
        new MutationObserver(() => window.said.push([performance.now(), region.textContent])).observe(region, { childList: true, characterData: true, subtree: true });
      });
    },
  });
  await phase(page, 'planning');
  await page.waitForFunction(() => window.said.length >= 2);
  await page.keyboard.press('s');
  await phase(page, 'done');
  await page.waitForFunction(() => /Stopped|Done|Optimal/.test(window.said.at(-1)[1]));
  const said = await page.evaluate(() => window.said);
  for (let i = 1; i < said.length; i += 1) assert.ok(said[i][0] - said[i - 1][0] > 1900, JSON.stringify(said));
});

test('the time of the playback was read aloud with every frame', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  await page.keyboard.press(' ');
  const spoken = await page.evaluate(() => [...document.querySelectorAll('#playback :is([aria-live], output, [role=status], [role=log], [role=timer])')].map((e) => e.outerHTML));
  assert.deepEqual(spoken, []);
  assert.match(await page.getByRole('slider', { name: 'Time in the job' }).getAttribute('aria-valuetext'), /^0:\d\d:\d\d of 0:\d\d:\d\d, contour \d+ of 500$/);
});

test('a phone shows the whole page without scrolling sideways', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone, touch: true });
  await phase(page, 'planning');
  const wide = () => page.evaluate(() => [document.documentElement.scrollWidth, document.body.scrollWidth, innerWidth]);
  assert.deepEqual(await wide(), [390, 390, 390]);
  const stop = await page.getByRole('button', { name: 'Stop' }).boundingBox();
  assert.ok(stop.height >= 44 && stop.y + stop.height <= 844, 'stop is in reach');
  await tap(page.getByRole('button', { name: 'Drawing, machine, plan, result' }));
  await openEverything(page);
  assert.equal(await page.getByRole('heading', { name: 'Result' }).isVisible(), true);
  assert.deepEqual(await wide(), [390, 390, 390]);
  const cut = await page.evaluate(() => [...document.querySelectorAll('#sections *, #dock *')].filter((e) => e.getClientRects().length > 0 && e.getBoundingClientRect().right > innerWidth + 1 && !e.closest('.hidden')).length);
  assert.equal(cut, 0, 'nothing reaches over the edge');
});

test('two fingers zoom the sheet, one moves it', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone, touch: true });
  await phase(page, 'planning');
  await tap(page.getByRole('button', { name: 'Stop' }));
  await phase(page, 'done');
  const fingers = await page.context().newCDPSession(page);
  const touch = (type, ...points) => fingers.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  const fitted = await still(page);
  await touch('touchStart', [180, 350], [210, 350]);
  for (let i = 1; i <= 8; i += 1) await touch('touchMove', [180 - 10 * i, 350], [210 + 10 * i, 350]);
  await touch('touchEnd');
  await changedFrom(page, fitted);
  const near = await still(page);
  await touch('touchStart', [200, 300]);
  for (let i = 1; i <= 8; i += 1) await touch('touchMove', [200, 300 + 10 * i]);
  await touch('touchEnd');
  await changedFrom(page, near);
});

test('the theme follows the system, can be switched and is kept', async (t) => {
  const { page } = await openPage(t, { theme: 'dark', hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  const ground = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const grounds = {};
  await inBothThemes(page, async (theme) => (grounds[theme] = await ground()));
  assert.notEqual(grounds.light, grounds.dark);
  assert.equal(await ground(), grounds.dark);
  await page.getByRole('button', { name: 'Light theme' }).click();
  assert.equal(await ground(), grounds.light);
  await page.reload();
  await phase(page, 'planning', 'done');
  assert.equal(await ground(), grounds.light);
});

test('axe finds nothing serious, wide and narrow, light and dark, with everything open', async (t) => {
  for (const size of [SIZES.desktop, SIZES.phone]) {
    const { page } = await openPage(t, { size });
    await phase(page, 'planning');
    await page.keyboard.press('s');
    await phase(page, 'done');
    if (size === SIZES.phone) await page.locator('.sheet-toggle').click();
    await openEverything(page);
    await page.getByLabel('Method').selectOption({ label: 'Research methods…' });
    await page.waitForFunction(() => document.querySelectorAll('optgroup option').length > 0);
    assert.deepEqual(await serious(page), [], `${size.width}`);
    await shot(page, `page-${size.width}`);
  }
});

test('Escape leaves a field, so that the next key is a shortcut', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  await page.locator('summary', { hasText: 'Plan' }).first().press('Enter');
  const seed = page.getByLabel('Seed');
  await seed.fill('7');
  await page.keyboard.press('t');
  assert.equal(await page.getByRole('table', { name: 'Cutting order' }).count(), 0, 'a field takes letters for itself');
  await page.keyboard.press('Escape');
  await page.keyboard.press('t');
  await page.getByRole('table', { name: 'Cutting order' }).waitFor();
  assert.equal(await seed.inputValue(), '7');
});

test('the focus fell to the page where the control that had it disappeared', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  const left = (what) => page.waitForFunction(() => document.activeElement.id === 'canvas', null).catch(() => assert.fail(what));
  await page.getByRole('button', { name: 'Keep this machine' }).press('Enter');
  await left('the machine is kept');
  await page.keyboard.press('ArrowRight');
  await page.locator('.contour').getByRole('button', { name: 'Close' }).press('Enter');
  await left('the card is closed');
  await page.keyboard.press('ArrowRight');
  await replanned(page, () => page.keyboard.press('1'));
  await page.locator('details.section').first().evaluate((d) => (d.open = true));
  await replanned(page, () => page.locator('.pins').getByRole('button', { name: 'Unpin' }).press('Enter'));
  await left('the last contour is unpinned');
  await drop(page, 'no-units.dxf', sample('no-units.dxf'));
  await planned(page, 'no-units.dxf', 'question');
  await page.locator('.question .choices button').last().press('Enter');
  await left('the units are chosen');
  // As metres it is larger than the bed; as inches it lies beside it once it is placed there.
  await page.getByRole('button', { name: 'Undo' }).first().press('Enter');
  await phase(page, 'question');
  await page.locator('.question .choices button').nth(1).press('Enter');
  await phase(page, 'done');
  const bed = page.locator('details.section', { has: page.getByRole('heading', { name: 'On the bed' }) });
  await bed.evaluate((d) => (d.open = true));
  await replanned(page, () => bed.getByLabel('Position').selectOption({ index: 1 }));
  await replanned(page, () => bed.getByLabel(/^x/).fill('-500'));
  await replanned(page, () => bed.getByRole('button', { name: 'Move to the corner' }).press('Enter'));
  await left('the job is on the bed');
});

test('the focus stays in the foot where the button that is pressed by keyboard goes', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=600' });
  await phase(page, 'planning');
  const focused = () => page.evaluate(() => document.activeElement.textContent);
  const foot = page.locator('.dock');
  // The next key after a tab is pressed where the focus is shown.
  await page.keyboard.press('Tab');
  await foot.getByRole('button', { name: 'Stop' }).press('Enter');
  await phase(page, 'done');
  assert.equal(await focused(), 'Keep improving');
  await page.keyboard.press('Enter');
  await phase(page, 'planning');
  assert.equal(await focused(), 'Stop');
  // After a click, Space plays.
  await page.evaluate(() => document.activeElement.blur());
  await foot.getByRole('button', { name: 'Stop' }).click();
  await phase(page, 'done');
  assert.equal(await page.evaluate(() => document.activeElement === document.body), true);
});

test('the table called contours by their place in the order, as the page calls them by their number', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  await page.keyboard.press('t');
  const row = page.locator('.rows .order-row').first();
  await row.waitFor();
  assert.deepEqual(await row.locator('button').evaluateAll((all) => all.map((b) => b.getAttribute('aria-label'))), ['No. 1, show on the sheet', 'Move no. 1 in the order: drag, or arrow keys']);
  await row.locator('.row-button').click();
  await page.locator('.contour strong', { hasText: 'No. 1 of 500' }).waitFor();
});

test('after a file that cannot be used, the focus was not on the question that waits', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  await drop(page, 'units.dxf', grid(12, { units: 6 }));
  await phase(page, 'question');
  await drop(page, 'letter.pdf', Buffer.from('%PDF-1.7 not a drawing'));
  await page.locator('.failure').waitFor();
  await page.keyboard.press('Enter');
  await page.locator('.failure').waitFor({ state: 'hidden' });
  assert.equal(await page.evaluate(() => document.activeElement.className), 'card question');
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.closest('.question') !== null), true);
});
