// Room on the page: nothing is cut off or covered, nothing is too small for a finger, nothing jumps when the state changes.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dxf, square } from '../package/support.mjs';
import { grid, sample } from './page-drawings.mjs';
import { still } from './page-pictures.mjs';
import { drop, openPage, phase, planned, SIZES } from './page-support.mjs';

test('a contour that is stepped to slides up above its card', async (t) => {
  const { page } = await openPage(t, { size: { width: 1440, height: 700 }, hash: 'seconds=0.4&units=mm' });
  await phase(page, 'planning', 'done');
  // One contour is where the card will be.
  await drop(page, 'two.dxf', dxf([...square(20, 20, 20), ...square(340, 160, 20)]));
  await planned(page, 'two.dxf', 'done');
  const canvas = await page.locator('#canvas').boundingBox();
  // The margins that the sheet is fitted into.
  const [left, right, top, bottom] = [40, 62, 60, 40];
  const scale = 0.94 * Math.min((canvas.width - left - right) / 340, (canvas.height - top - bottom) / 160);
  const x = canvas.x + left + (canvas.width - left - right) / 2 - 160 * scale, y = canvas.y + top + (canvas.height - top - bottom) / 2 + 70 * scale;
  const card = page.getByRole('region', { name: 'Selected contour' });
  await page.mouse.click(x, y);
  const name = await card.locator('strong').textContent();
  assert.match(name, /^No\. [12] of 2$/);
  const box = await card.boundingBox();
  assert.ok(y > box.y && x < box.x + box.width, 'it is behind the card');
  await page.keyboard.press('Escape');

  await page.keyboard.press(name.startsWith('No. 1') ? 'Home' : 'End');
  await still(page);
  await page.keyboard.press('Escape');
  await page.mouse.click(x, box.y - 24 - 10 * scale);
  assert.equal(await card.locator('strong').textContent(), name);
});

test('the table of the cutting order shows all of its columns, and says in which unit a cut begins', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  await page.keyboard.press('t');
  await page.locator('.rows .order-row').first().waitFor();
  assert.deepEqual(await page.locator('.order-scroll').evaluate((e) => [e.scrollWidth - e.clientWidth, [...e.querySelectorAll('.order-row > :last-child')].filter((c) => c.scrollWidth > c.clientWidth).length]), [0, 0]);
  assert.deepEqual(await page.locator('.order-head').getByRole('columnheader').allTextContents(), ['No.', '', 'Layer', 'Length', 'Begins', 'Entry, mm', 'Direction']);
});

test('the heading of the drawing counts the errors and warnings that its list counts', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4&units=mm' });
  await phase(page, 'planning', 'done');
  // Wider than the bed of the machine.
  await drop(page, 'wide.dxf', grid(10, { step: 600 }));
  await planned(page, 'wide.dxf', 'done');
  await page.locator('.dock').getByText('Not on the bed, so no program').waitFor();
  const drawing = page.locator('details.section', { has: page.getByRole('heading', { name: 'Drawing', exact: true }) });
  assert.equal(await drawing.locator('.gist.error').textContent(), '10 contours, 1 error');
  assert.equal(await drawing.locator('details.more.errors > summary').textContent(), '1 error');
});

test('on a phone the sheet stays where it is while states follow each other, and answers are as high as a finger needs', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone, touch: true, hash: 'seconds=0.4' });
  const height = () => page.locator('#dock').evaluate((e) => Math.round(e.getBoundingClientRect().height));
  await phase(page, 'done');
  const done = await height();
  await drop(page, 'no-units.dxf', sample('no-units.dxf'));
  await phase(page, 'question');
  assert.equal(await height(), done);
  const answers = await page.locator('.choices button').evaluateAll((all) => all.map((e) => e.getBoundingClientRect().height));
  assert.equal(answers.length, 4);
  for (const high of answers) assert.ok(high >= 44, `${high}`);
});

test('on a phone the file is named at the foot, cut in the middle if it is long, and the open sheet covers the playback', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone, touch: true, hash: 'seconds=0.4' });
  await phase(page, 'done');
  const name = page.locator('.dock-file');
  assert.deepEqual([await name.isVisible(), await name.textContent()], [true, 'sheet_500.dxf']);
  const long = 'customer-4711_flange-plate_rev-C_3mm-stainless_final.dxf';
  await drop(page, long, sample('no-units.dxf'));
  await phase(page, 'question');
  assert.equal(await name.textContent(), long);
  const [begin, end] = await name.locator('span').evaluateAll((all) => all.map((e) => [e.textContent, e.scrollWidth > e.clientWidth, e.getBoundingClientRect().right]));
  assert.deepEqual([begin[1], end[1], end[0]], [true, false, 'ss_final.dxf'], 'only the beginning is cut');
  assert.ok(end[2] <= SIZES.phone.width - 16, `${end[2]}`);
  // There is nothing to play yet, so the controls are transparent.
  const slider = await page.locator('#playback input').boundingBox();
  await page.locator('.sheet-toggle').click();
  const covers = ([x, y]) => document.elementFromPoint(x, y).closest('#sections, #playback').id;
  assert.equal(await page.evaluate(covers, [slider.x + slider.width / 2, slider.y + slider.height / 2]), 'sections');
});
