// The kerf width on the page: a setting of the machine that changes the cut; both lines are shown.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { shot, still } from './page-pictures.mjs';
import { download, drop, openEverything, openPage, phase, replanned, SIZES } from './page-support.mjs';

const SHEET = readFileSync(new URL('../fixtures/plate/one-kerf-apart.dxf', import.meta.url));
const HASH = 'machine=fibre-6kw-plate&seconds=0.4&seed=1';

async function planned(page) {
  const { bytes } = await download(page, () => page.locator('.downloads').getByRole('button', { name: 'Plan (JSON)', exact: true }).click());
  return JSON.parse(bytes);
}

async function opened(t, options = {}) {
  const { page } = await openPage(t, { hash: HASH, ...options });
  await phase(page, 'planning', 'done');
  await drop(page, 'one-kerf-apart.dxf', SHEET);
  await page.waitForFunction(() => document.querySelector('.file-name')?.textContent === 'one-kerf-apart.dxf');
  await phase(page, 'done');
  return page;
}

/** Types a width and waits for the plan with it. */
async function setKerf(page, width) {
  await page.evaluate(() => document.body.classList.add('sheet-open'));
  await openEverything(page);
  await replanned(page, () => page.getByLabel('Kerf width').fill(String(width)));
}

test('a kerf width set in the machine changes what is cut, is reported, and can be undone', async (t) => {
  const page = await opened(t);
  const drawn = await planned(page);
  const legend = page.getByText('shared by two parts');
  assert.ok(!(await legend.isVisible()), 'nothing is shared as drawn');

  await setKerf(page, 0.4);
  assert.ok(await legend.isVisible());
  assert.ok((await page.getByText('narrower here than the kerf', { exact: false }).count()) > 0, 'what keeps its line is told');
  const beam = await planned(page);
  assert.equal(beam.machine.kerf_width, 0.4);
  // Sides in common are cut once.
  assert.ok(beam.summary.cut_length < drawn.summary.cut_length - 350, `${beam.summary.cut_length} ${drawn.summary.cut_length}`);
  assert.ok(beam.summary.pierces < drawn.summary.pierces);
  assert.equal(beam.summary.parts, drawn.summary.parts);
  const [x0, y0, x1] = beam.summary.bounds, before = drawn.summary.bounds;
  for (const [a, b] of [[x0, before[0] - 0.2], [y0, before[1] - 0.2], [x1, before[2]]]) assert.ok(Math.abs(a - b) < 0.21, `${a} ${b}`);

  await page.keyboard.press('Escape');
  await page.locator('#canvas').focus().catch(() => {});
  await page.evaluate(() => document.activeElement?.blur());
  await page.keyboard.press('Control+z');
  await phase(page, 'planning', 'done');
  await page.waitForFunction(() => document.querySelector('.legend')?.hidden);
  await phase(page, 'done');
  assert.ok(Math.abs((await planned(page)).summary.cut_length - drawn.summary.cut_length) < 1e-6);
});

for (const size of ['desktop', 'phone']) {
  test(`looks: the beam beside the outlines, ${size}`, async (t) => {
    const page = await opened(t, { size: SIZES[size], touch: size === 'phone' });
    await setKerf(page, 0.4);
    await shot(page, `kerf-${size}-panel`);
    if (size === 'phone') await page.evaluate(() => document.body.classList.remove('sheet-open'));
    await page.keyboard.press('f');
    await still(page);
    await shot(page, `kerf-${size}`);
    // Shown near: the corner of a part, its outline beneath the beam.
    await page.evaluate(() => document.body.classList.add('sheet-open'));
    await page.getByRole('button', { name: 'Parts one kerf apart' }).click();
    await still(page);
    await shot(page, `kerf-${size}-near`);
    assert.ok(await page.getByText('shared by two parts').isVisible());
  });
}
