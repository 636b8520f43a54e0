// Choices that follow each other while the drawing is still being read again with the first: all of them count.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dxf, square } from '../package/support.mjs';
import { drop, openPlanned, openPage, phase, plan, planned, replanned } from './page-support.mjs';

/** Six squares in a row, on two layers by turns, mm. */
const ROW = dxf(...[0, 1, 2, 3, 4, 5].map((k) => square(10 + 60 * k, 10, 40, k % 2 === 0 ? 'EVEN' : 'ODD')));

const openDrawing = (page) => page.evaluate(() => {
  const [section] = document.querySelectorAll('.section');
  for (const details of [section, ...section.querySelectorAll('details')]) details.open = true;
});

test('the operations of two layers, chosen at once, are both taken over', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'row.dxf', ROW);
  await openDrawing(page);
  await replanned(page, () => page.evaluate(() => {
    const operations = [...document.querySelectorAll('.layers select.operation')];
    operations[0].selectedIndex = 1;
    operations[1].selectedIndex = 1;
    for (const list of operations) list.dispatchEvent(new Event('change', { bubbles: true }));
  }));
  const { options } = await plan(page);
  assert.deepEqual(options.layers.map(({ name, operation }) => [name, operation]).sort(), [['0', 'cut'], ['EVEN', 'mark'], ['ODD', 'mark']]);
});

test('a contour that is moved twice in a list at once ends up two places further', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'row.dxf', ROW);
  await openDrawing(page);
  for (const stop of [1, 2, 3]) {
    await page.keyboard.press('Escape');
    await page.keyboard.press('Home');
    for (let step = 1; step < stop; step += 1) await page.keyboard.press('ArrowRight');
    await replanned(page, () => page.keyboard.press('1'));
  }
  await replanned(page, () => page.getByRole('button', { name: 'In this order' }).click());
  const names = () => page.locator('.sortable .name').allTextContents();
  const [a, b, c] = await names();
  await replanned(page, () => page.evaluate(() => {
    document.querySelector('.sortable [data-grip]').focus();
    for (const _ of [1, 2]) document.activeElement.dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowDown', bubbles: true }));
  }));
  assert.deepEqual(await names(), [b, c, a]);
  assert.equal(await page.evaluate(() => document.activeElement.dataset.grip), 'first-2', 'the handle has the focus still');
});

const path = (points, closed = 0) => [[0, 'LWPOLYLINE'], [8, '0'], [90, points.length], [70, closed], ...points.flatMap(([x, y]) => [[10, x], [20, y]])];

/** A plate with a hole, twelve letters of a one-stroke font and a line that leads from them to the hole. */
const LETTERED = dxf(path([[10, 10], [210, 10], [210, 90], [10, 90]], 1), [[0, 'CIRCLE'], [8, '0'], [10, 160], [20, 50], [40, 2]], path([[76, 32], [157, 49]]),
  ...Array.from({ length: 12 }, (_, k) => path([[0, 0], [0, 4], [2.5, 0], [2.5, 4]].map(([x, y]) => [30 + 4 * k + x, 30 + y]))));

test('what is done with lettering and with the lines that lead to it, chosen at once, is both taken over', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  await drop(page, 'lettered.dxf', LETTERED);
  await planned(page, 'lettered.dxf', 'done');
  await openDrawing(page);
  await replanned(page, () => page.evaluate(() => {
    for (const name of ['Mark: lettering', 'Ignore: lines that lead to lettering']) document.querySelector(`[aria-label="${name}"]`).click();
  }));
  const { options } = await plan(page);
  assert.deepEqual(options.groups, [{ name: 'lettering', operation: 'mark' }, { name: 'leaders', operation: 'ignore' }]);
});
