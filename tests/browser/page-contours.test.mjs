// Single contours: skipping them and taking that back. Tolerances: a preview before they are applied.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { beamRuns, grid, sample } from './page-drawings.mjs';
import { changedFrom, still } from './page-pictures.mjs';
import { download, drop, dropAll, openPage, phase, planned } from './page-support.mjs';

const open = (page) => page.evaluate(() => document.querySelectorAll('.section').forEach((d) => (d.open = d.textContent.startsWith('Drawing'))));
const listed = (page) => page.evaluate(() => [...document.querySelectorAll('.pins')].map((p) => p.firstChild.textContent).join());
const until = (page, words) => page.waitForFunction((w) => [...document.querySelectorAll('.pins')].map((p) => p.firstChild.textContent).join() === w, words);
const gist = (page, begin) => page.waitForFunction((b) => document.querySelector('.section .gist').textContent.startsWith(b), begin);
const gcode = async (page) => (await download(page, () => page.locator('.dock').getByRole('button', { name: 'G-code' }).click())).bytes.toString();

test('a contour is skipped by card, key and Alt with a click, stays visible, and is cut again', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  await drop(page, 'rings.dxf', sample('parts-in-parts.dxf'));
  await planned(page, 'rings.dxf', 'done');
  await open(page);
  await gist(page, '28 contours');

  await page.keyboard.press('End');
  const card = page.getByRole('region', { name: 'Selected contour' });
  await card.getByRole('button', { name: 'Skip' }).click();
  await gist(page, '27 contours');
  await until(page, 'Skipped: 1 contour');
  // The selected contour stays, with its description.
  assert.match(await card.textContent(), /^Contour \d+.*skipped, not cut/);
  assert.equal(await card.getByRole('button', { name: 'Skip' }).getAttribute('aria-pressed'), 'true');
  await phase(page, 'done');
  assert.equal(beamRuns(await gcode(page)).length, 27);
  assert.match(await page.locator('.findings').textContent(), /1 contour left out by choice/);

  await page.keyboard.press('Home');
  await page.keyboard.press('x');
  await until(page, 'Skipped: 2 contours');
  await page.keyboard.press('Control+z');
  await until(page, 'Skipped: 1 contour');
  await page.keyboard.press('Control+Shift+z');
  await until(page, 'Skipped: 2 contours');
  // From the list to the contour, and back into the cut.
  await page.locator('.pinned button').first().click();
  await card.getByRole('button', { name: 'Cut first' }).click();
  await until(page, 'Cut first: 1 contour,Skipped: 1 contour');
  await page.getByRole('button', { name: 'Cut again: skipped contours' }).click();
  await until(page, 'Cut first: 1 contour');
  await gist(page, '28 contours');

  await page.keyboard.press('Escape');
  const box = await page.locator('#canvas').boundingBox();
  let at = null;
  for (let x = 60; x < box.width - 60 && at === null; x += 3) {
    await page.mouse.move(box.x + x, box.y + box.height / 2);
    if (await page.locator('#canvas.over').count()) at = [box.x + x, box.y + box.height / 2];
  }
  await page.keyboard.down('Alt');
  await page.mouse.click(...at);
  await page.keyboard.up('Alt');
  await until(page, 'Cut first: 1 contour,Skipped: 1 contour');
  // It is still there to be pointed at, and to be taken back.
  await page.keyboard.down('Alt');
  await page.mouse.click(...at);
  await page.keyboard.up('Alt');
  await until(page, 'Cut first: 1 contour');
});

test('contours skipped in a file are still skipped when it is opened again', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  await dropAll(page, [['one.dxf', grid(12)], ['two.dxf', grid(20)]]);
  await page.waitForFunction(() => document.querySelector('.queue').textContent === '2 of 2');
  await open(page);
  await page.keyboard.press('End');
  await page.keyboard.press('x');
  await until(page, 'Skipped: 1 contour');
  await phase(page, 'done');
  const go = async (name) => {
    await page.locator('.queue').click();
    await page.getByRole('button', { name: new RegExp(`^${name}`) }).click();
    await planned(page, name, 'done');
  };
  await go('one.dxf');
  assert.equal(await listed(page), '');
  await go('two.dxf');
  await until(page, 'Skipped: 1 contour');
});

test('the sheet shows what another tolerance would join or part before it is applied', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=300' });
  await phase(page, 'planning', 'done');
  await drop(page, 'careless.dxf', sample('gaps-and-copies.dxf'));
  await planned(page, 'careless.dxf', 'planning');
  await open(page);
  await page.locator('summary', { hasText: 'Tolerances' }).click();
  const told = page.locator('.comparison');
  const says = (words) => page.waitForFunction((w) => document.querySelector('.comparison').textContent.includes(w), words);
  const before = await page.locator('.section .gist').first().textContent();
  await page.keyboard.press('a');
  const plain = await still(page);
  const join = page.getByRole('slider', { name: 'Join ends closer than' });
  const turn = (value) => join.evaluate((slider, v) => {
    slider.value = v;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  }, value);

  // A slider that is dragged sends many changes; the plan continues, and the page's thread stays free.
  for (let value = 90; value >= 40; value -= 1) await turn(value);
  await says('4 joints would open');
  assert.match(await told.textContent(), /12 contours instead of 9/);
  assert.equal(await page.evaluate(() => document.body.dataset.phase), 'planning');
  assert.equal(await page.locator('.section .gist').first().textContent(), before, 'nothing is applied yet');
  await changedFrom(page, plain);
  await page.getByRole('button', { name: 'Cancel' }).click();
  assert.equal(await told.textContent(), '');
  assert.equal(await page.getByLabel('Join ends closer than').first().inputValue(), '0.05');

  const number = page.locator('.tolerance-field input[type=number]').first();
  await number.fill('0.01');
  await says('4 joints would open');
  await number.press('Enter');
  await gist(page, '12 contours');
  await number.fill('0.05');
  await says('4 gaps would close');
  assert.match(await told.textContent(), /9 contours instead of 12/);
  await number.fill('9');
  await page.locator('.tolerance-field').first().getByText('from 0.001 to 5 mm').waitFor();
  assert.equal(await page.getByRole('button', { name: 'Apply' }).isDisabled(), true);
  await number.press('Escape');
  assert.equal(await number.inputValue(), '0.01');
  await gist(page, '12 contours');
});

test('while a tolerance was changed, what it would do and the buttons were below the end of the panel', async (t) => {
  const { page } = await openPage(t, { size: { width: 1440, height: 700 }, hash: 'seconds=0.4' });
  await phase(page, 'done');
  await drop(page, 'careless.dxf', sample('gaps-and-copies.dxf'));
  await planned(page, 'careless.dxf', 'done');
  await open(page);
  await page.locator('summary', { hasText: 'Tolerances' }).click();
  const field = page.getByLabel('Join ends closer than').first();
  // At the lower end of the panel, where it was scrolled to.
  await field.evaluate((input) => input.scrollIntoView({ block: 'end' }));
  await field.fill('2');
  await page.waitForFunction(() => /would/.test(document.querySelector('.comparison').textContent));
  const [button, outcome] = await Promise.all([page.getByRole('button', { name: 'Apply' }), page.locator('.comparison')].map((l) => l.boundingBox()));
  const end = (await page.locator('.dock').boundingBox()).y;
  assert.ok(button.y + button.height <= end + 1 && outcome.y > 48, `${JSON.stringify(button)}, ${JSON.stringify(outcome)}, ${end}`);
});
