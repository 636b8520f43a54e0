// Thick plate on the page: parts that share sides are cut as one, or each by itself.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { shot } from './page-pictures.mjs';
import { download, drop, openPage, phase, replanned } from './page-support.mjs';

const SHEET = readFileSync(new URL('../fixtures/plate/shared-sides.dxf', import.meta.url));

/** The finished plan, as the page hands it out. */
async function planned(page) {
  const { bytes } = await download(page, () => page.locator('.downloads').getByRole('button', { name: 'Plan (JSON)', exact: true }).click());
  return JSON.parse(bytes);
}

test('shared sides are cut once, or with the switch off each contour by itself, and a finding tells what it saves', async (t) => {
  const { page } = await openPage(t, { hash: 'machine=fibre-6kw-plate&seconds=0.4&seed=1' });
  await phase(page, 'planning', 'done');
  await drop(page, 'shared-sides.dxf', SHEET);
  await page.waitForFunction(() => document.querySelector('.file-name')?.textContent === 'shared-sides.dxf');
  await phase(page, 'done');
  const saving = page.getByText('share cuts', { exact: false });
  assert.ok((await saving.count()) > 0, 'a finding tells of shared cuts');
  const shared = await planned(page);
  await shot(page, 'plate-shared');

  await page.evaluate(() => document.querySelectorAll('details').forEach((d) => (d.open = true)));
  const box = page.getByLabel('Cut shared sides once');
  assert.ok(await box.isChecked());
  await replanned(page, () => box.uncheck());
  await page.waitForFunction(() => location.hash.includes('common-cuts=off'));
  const apart = await planned(page);
  await shot(page, 'plate-apart');
  assert.equal(apart.summary.pierces, apart.summary.contours);
  assert.ok(shared.summary.pierces < apart.summary.pierces, `${shared.summary.pierces} and ${apart.summary.pierces}`);
  assert.ok(shared.summary.total_time < apart.summary.total_time);
  // Cleaning leaves a shared side on one of two contours; either way it is cut once.
  assert.ok(Math.abs(shared.summary.cut_length - apart.summary.cut_length) < 1e-6);

  await replanned(page, () => box.check());
  await page.waitForFunction(() => !location.hash.includes('common-cuts'));
  assert.equal((await planned(page)).summary.pierces, shared.summary.pierces);
});
