// Under the hands of a person: what is made again while somebody types, tabs or chooses keeps the focus, what is typed, what is open; and what they do is answered to those who do not see it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { circle, dxf } from '../package/support.mjs';
import { grid, sample } from './page-drawings.mjs';
import { drop, openPage, phase, plan, planned, replanned, storedWith } from './page-support.mjs';

/** Another layer gets another operation, as by a second hand: the drawing is read again, and the lists are made again. */
const readAgain = (page) => replanned(page, () => page.evaluate(() => {
  const choice = [...document.querySelectorAll('.layer select')].at(-1);
  choice.selectedIndex = 1;
  choice.dispatchEvent(new Event('change'));
}));

const focused = (page) => page.evaluate(() => document.activeElement.getAttribute('aria-label') ?? document.activeElement.textContent);

/** A page with a planned drawing, whose section is open. */
async function withDrawingOpen(t, name) {
  const { page } = await openPage(t, { hash: 'seconds=0.4&units=mm' });
  await phase(page, 'planning', 'done');
  await drop(page, name, grid(20));
  await planned(page, name, 'done');
  await page.locator('.section').first().evaluate((e) => (e.open = true));
  return page;
}

test('what is typed for a layer stays when the drawing is read again meanwhile', async (t) => {
  const page = await withDrawingOpen(t, 'layers.dxf');
  await page.getByRole('button', { name: 'Settings of layer CUT' }).click();
  await page.getByLabel('Power, layer CUT', { exact: true }).focus();
  // No number yet: a field gives no value for it.
  await page.keyboard.type('3e');
  await readAgain(page);
  assert.equal(await focused(page), 'Power, layer CUT');
  await page.keyboard.type('1');
  await replanned(page, () => page.keyboard.press('Tab'));
  assert.deepEqual((await plan(page)).options.layers.find(({ name }) => name === 'CUT').settings, { power: 0.3 });
  assert.equal(await page.getByLabel('Power, layer CUT', { exact: true }).inputValue(), '30');
  // Another drawing has its own layer of that name.
  await page.getByLabel('Power, layer CUT', { exact: true }).focus();
  await drop(page, 'another.dxf', grid(30));
  await planned(page, 'another.dxf', 'done');
  assert.equal(await page.getByLabel('Power, layer CUT', { exact: true }).inputValue(), '');
});

test('findings stay open and keep the focus when they are listed again', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4&units=mm' });
  await phase(page, 'planning', 'done');
  // Two outlines whose ends are 0.3 mm apart.
  const open = (x) => [[0, 'LWPOLYLINE'], [8, 'A'], [90, 5], [70, 0], ...[[0, 0], [90, 0], [90, 80], [0, 80], [0, 0.3]].flatMap(([dx, dy]) => [[10, x + dx], [20, dy]])];
  await drop(page, 'open.dxf', Buffer.from(dxf(open(20), open(150), circle(60, 40, 10, 'B'))));
  await planned(page, 'open.dxf', 'done');
  await page.evaluate(() => document.querySelectorAll('.section:first-of-type, .section:first-of-type details').forEach((e) => (e.open = true)));
  const second = page.locator('.finding-group button.finding').nth(1);
  await second.focus();
  const text = await focused(page);
  await readAgain(page);
  assert.equal(await page.locator('.finding-group').first().evaluate((e) => e.open), true);
  assert.deepEqual([await focused(page), await second.evaluate((e) => e === document.activeElement)], [text, true]);
});

test('a rule that is removed by keyboard leaves the focus in its list', async (t) => {
  const page = await withDrawingOpen(t, 'pins.dxf');
  for (let k = 0; k < 3; k += 1) {
    await page.keyboard.press('End');
    await replanned(page, () => page.keyboard.press('1'));
  }
  await page.keyboard.press('Escape');
  const remove = page.locator('.sortable li button:last-child');
  assert.equal(await remove.count(), 3);
  await remove.nth(1).focus();
  await replanned(page, () => page.keyboard.press('Enter'));
  assert.equal(await remove.count(), 2);
  assert.equal(await page.evaluate(() => document.activeElement.closest('.sortable') !== null), true, 'where the next key removes or shows another contour');
});

test('lists on the card of a contour stay open while the search goes on', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=600&units=mm' });
  await phase(page, 'planning', 'done');
  await drop(page, 'card.dxf', grid(300));
  await planned(page, 'card.dxf', 'planning');
  await page.waitForFunction(() => document.querySelector('.playback .whole').textContent !== '/ 0.0 s');
  await page.keyboard.press('Home');
  const choice = page.getByLabel('Joints', { exact: true });
  await choice.focus();
  await choice.evaluate((e) => (window.list = e));
  // The text of the card is another one with every report of the search.
  await page.evaluate(() => {
    window.reports = 0;
    new MutationObserver(() => (window.reports += 1)).observe(document.querySelector('.contour'), { childList: true });
  });
  await page.waitForFunction(() => window.reports >= 3);
  assert.equal(await page.evaluate(() => window.list.isConnected && window.list === document.activeElement), true);
});

test('a notice stays while its button has the focus, and then gives it to the stage', async (t) => {
  // Only the time for which a notice is shown is that long.
  const prepare = () => {
    const { setTimeout } = window;
    window.setTimeout = (act, time, ...rest) => (time === 12_000 ? (window.noticeEnds = act, 0) : setTimeout(act, time, ...rest));
  };
  const { page } = await openPage(t, { hash: 'seconds=0.4', prepare });
  await phase(page, 'planning', 'done');
  await drop(page, 'own.dxf', sample('layers.dxf'));
  await planned(page, 'own.dxf', 'done');
  await storedWith(page, 0);
  await page.reload();
  const forget = page.locator('.notice').getByRole('button');
  await forget.focus();
  await page.evaluate(() => window.noticeEnds());
  assert.equal(await forget.isVisible(), true, 'somebody is about to press it');
  await forget.press('Enter');
  await page.waitForFunction(() => document.querySelector('.notice button') === null);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'canvas');
  await page.evaluate(() => window.noticeEnds());
  assert.equal(await page.locator('.notice').isVisible(), false);
});

test('what somebody does is answered at once while a search reports, whose news go on after it', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=600&units=mm' });
  await phase(page, 'planning', 'done');
  await drop(page, 'said.dxf', grid(300));
  await planned(page, 'said.dxf', 'planning');
  await page.waitForFunction(() => /^Best so far/.test(document.querySelector('#announcer').textContent));
  await page.evaluate(() => {
    window.said = [];
    new MutationObserver(() => window.said.push(document.querySelector('#announcer').textContent)).observe(document.querySelector('#announcer'), { childList: true });
  });
  await page.keyboard.press('Home');
  await page.waitForFunction(() => window.said.some((text) => text.startsWith('No. 1 of 300')));
  await page.keyboard.press('x');
  await page.waitForFunction(() => window.said.some((text) => /skipped/.test(text)));
  await page.waitForFunction(() => /^Best so far/.test(window.said.at(-1)));
  const said = await page.evaluate(() => window.said);
  assert.deepEqual(said.filter((text, k) => text === said[k - 1]), [], 'nothing is said twice');
});
