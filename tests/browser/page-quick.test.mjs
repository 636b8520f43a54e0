// Choices that follow each other while the drawing is still being read again with the first: all of them count.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dxf, square } from '../package/support.mjs';
import { grid } from './page-drawings.mjs';
import { drop, openPlanned, openPage, phase, plan, planned, replanned } from './page-support.mjs';

/** Six squares in a row, on two layers by turns, mm. */
const ROW = dxf(...[0, 1, 2, 3, 4, 5].map((k) => square(10 + 60 * k, 10, 40, k % 2 === 0 ? 'EVEN' : 'ODD')));

const openDrawing = (page) => page.evaluate(() => {
  const [section] = document.querySelectorAll('.section');
  for (const details of [section, ...section.querySelectorAll('details')]) details.open = true;
});

/**
 * Chooses what is done with the first layer, and in the same moment presses a key or buttons, drops a file or chooses what is done with the second. Returns
 * the buttons that were pressed, with what the page said then.
 */
const chooseAnd = (page, index, also) => page.evaluate(([index, { key, file, second, press = [] }]) => {
  const operations = [...document.querySelectorAll('.layers select.operation')];
  const choose = (list, index) => {
    list.selectedIndex = index;
    list.dispatchEvent(new Event('change', { bubbles: true }));
  };
  choose(operations[0], index);
  if (second !== undefined) choose(operations[1], second);
  if (key !== undefined) document.body.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true }));
  if (file !== undefined) {
    const data = new DataTransfer();
    data.items.add(new File(['%PDF-1.7'], file));
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true }));
  }
  return press.map((selector) => {
    const button = document.querySelector(selector);
    button.click();
    return { head: document.querySelector('.dock-head').textContent, text: button.textContent, disabled: button.disabled, title: button.title };
  });
}, [index, also]);

test('the operations of two layers, chosen at once, are both taken over', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'row.dxf', ROW);
  await openDrawing(page);
  await replanned(page, () => chooseAnd(page, 1, { second: 1 }));
  const { options } = await plan(page);
  assert.deepEqual(options.layers.map(({ name, operation }) => [name, operation]).sort(), [['0', 'cut'], ['EVEN', 'mark'], ['ODD', 'mark']]);
});

test('a contour that is pinned while contours get other numbers does not pin another one', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'row.dxf', ROW);
  await openDrawing(page);
  await page.keyboard.press('Home');
  await replanned(page, () => chooseAnd(page, 2, { key: '1' }));
  const { options } = await plan(page);
  assert.deepEqual([options.first ?? [], options.layers.filter(({ operation }) => operation === 'ignore').length], [[], 1]);
  assert.match(await page.locator('.notice').textContent(), /contours have changed/);
  await page.keyboard.press('Home');
  await replanned(page, () => page.keyboard.press('1'));
  assert.equal((await plan(page)).options.first.length, 1);
});

test('a choice that is being read when an unusable file is dropped is taken over', async (t) => {
  // Reading these again takes longer than finding out that the file is no drawing.
  const page = await openPlanned(t, 'co2-100w', 'many.dxf', grid(6000, { step: 6 }));
  await openDrawing(page);
  await replanned(page, () => chooseAnd(page, 2, { file: 'letter.pdf' }));
  await page.locator('.failure').getByText('letter.pdf').waitFor();
  const { options, contours } = await plan(page);
  const [ignored] = options.layers.filter(({ operation }) => operation === 'ignore');
  assert.equal(contours.length, { HOLES: 2000, CUT: 4000 }[ignored.name]);
});

test('while a choice is being read, the page says so and writes nothing that is of the drawing before', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'row.dxf', ROW);
  await openDrawing(page);
  let pressed;
  await replanned(page, async () => (pressed = await chooseAnd(page, 2, { press: ['.downloads button:nth-of-type(3)', '.dock .primary:not([hidden])'] })));
  const [download, program] = pressed;
  assert.deepEqual(download, { head: 'Applying the change…', text: 'DXF', disabled: false, title: 'Download DXF' });
  assert.deepEqual(program, { head: 'Applying the change…', text: 'G-code', disabled: true, title: 'Applying the change…' });
  assert.equal(await page.locator('.notice').textContent(), 'The change is still being applied. Try again in a moment.');
  assert.deepEqual(await page.locator('.dock .primary:not([hidden])').evaluate((b) => [b.textContent, b.disabled]), ['G-code', false]);
  assert.equal((await plan(page)).contours.length, 3);
});

test('undo after two choices at once brings back the plan of the first, not that of the drawing before', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'row.dxf', ROW);
  await openDrawing(page);
  await replanned(page, () => chooseAnd(page, 2, { second: 1 }));
  await replanned(page, () => page.keyboard.press('Control+z'));
  const { options, contours } = await plan(page);
  assert.deepEqual(options.layers.map(({ name, operation }) => [name, operation]).sort(), [['0', 'cut'], ['EVEN', 'ignore'], ['ODD', 'cut']]);
  assert.equal(contours.length, 3);
  await replanned(page, () => page.keyboard.press('Control+z'));
  assert.equal((await plan(page)).contours.length, 6);
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
