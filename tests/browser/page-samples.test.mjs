// A sample stays open in its tab, with what was decided about it, until another drawing is opened.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { machineSection, openPage, phase, plan, planned, replanned } from './page-support.mjs';

/** How each layer is cut. */
const operations = (page) => page.locator('.layer').evaluateAll((all) => all.map((row) => [row.querySelector('.layer-name').textContent, row.querySelector('select').value]));

/** Opens a sample from the menu. */
async function choose(page, title, file) {
  await page.getByRole('button', { name: 'Samples' }).click();
  await page.locator('.menu-item', { has: page.getByText(title, { exact: true }) }).click();
  await planned(page, file, 'done');
}

test('a reload and another language bring back the sample and how it is read', async (t) => {
  const { page, url } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  await choose(page, 'Layers', 'layers.dxf');
  const layer = page.locator('.layer', { hasText: 'ENGRAVE' }).locator('select');
  await page.evaluate(() => document.querySelectorAll('.section').forEach((s) => (s.open = true)));
  await replanned(page, () => layer.selectOption({ label: 'Mark' }));
  const chosen = await operations(page);
  assert.ok(chosen.some(([name, operation]) => name === 'ENGRAVE' && operation === 'mark'), JSON.stringify(chosen));

  await page.reload();
  await planned(page, 'layers.dxf', 'done');
  assert.deepEqual(await operations(page), chosen);

  await page.locator('.top .settings').click();
  await Promise.all([page.waitForEvent('load'), page.getByRole('button', { name: 'Deutsch' }).click()]);
  await planned(page, 'layers.dxf', 'done');
  assert.equal(await page.evaluate(() => document.documentElement.lang), 'de');
  assert.deepEqual(await operations(page), chosen);

  // Another tab begins as on a first visit.
  const other = await page.context().newPage();
  await other.goto(`${url}#seconds=0.4`);
  await planned(other, 'sheet_500.dxf');
});

test('a machine that is changed for a sample is still changed after a reload, also where the sample has a machine of its own', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  for (const [title, file, preset] of [['Layers', 'layers.dxf', 'co2-100w'], ['Perforated plate', 'perforated.dxf', 'fibre-3kw-thin']]) {
    await choose(page, title, file);
    const machine = await machineSection(page);
    await machine.locator('details.more', { hasText: 'Advanced settings' }).evaluate((d) => (d.open = true));
    await replanned(page, () => machine.getByLabel('Pierce time').fill('0.75'));
    await page.reload();
    await planned(page, file, 'done');
    const { name, pierce_time } = (await plan(page)).machine;
    assert.deepEqual([name, pierce_time], [preset, 0.75]);
    // What was chosen instead of the sample's machine is there as well.
    await machineSection(page);
    await replanned(page, () => page.getByLabel('Preset').selectOption('k40'));
    await page.reload();
    await planned(page, file, 'done');
    assert.equal((await plan(page)).machine.name, 'k40');
    await choose(page, 'Sheet, 100 contours', 'sheet_100.dxf');
    await replanned(page, () => machineSection(page).then((m) => m.getByLabel('Preset').selectOption('co2-100w')));
  }
});

test('an answer to what the name of one layer suggests leaves the other suggestions', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  await choose(page, 'Layers', 'layers.dxf');
  await page.evaluate(() => document.querySelectorAll('.section').forEach((s) => (s.open = true)));
  const asked = () => page.locator('#drawing button, .section button').filter({ hasText: /^(Mark|Ignore) it$/ });
  const before = await asked().count();
  assert.ok(before >= 2, `${before} suggestions`);
  await replanned(page, () => page.getByRole('button', { name: 'Mark it' }).first().click());
  assert.equal(await asked().count(), before - 1);
  const now = Object.fromEntries(await operations(page));
  assert.equal(now.ENGRAVE, 'mark');
  assert.equal(now.SHEET, 'cut');
  await replanned(page, () => page.getByRole('button', { name: 'Ignore it' }).first().click());
  assert.equal(Object.fromEntries(await operations(page)).ENGRAVE, 'mark');
});
