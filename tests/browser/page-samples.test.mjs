// A sample stays open in its tab, with what was decided about it, until another drawing is opened.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openPage, phase, planned, replanned } from './page-support.mjs';

/** How each layer is cut. */
const operations = (page) => page.locator('.layer').evaluateAll((all) => all.map((row) => [row.querySelector('.layer-name').textContent, row.querySelector('select').value]));

test('a reload and another language bring back the sample and how it is read', async (t) => {
  const { page, url } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  await page.getByRole('button', { name: 'Samples' }).click();
  await page.locator('.menu-item', { has: page.getByText('Layers', { exact: true }) }).click();
  await planned(page, 'layers.dxf', 'done');
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
