// What is on the page stays where it is while other things arrive: on a first visit, and when another drawing takes the place of the one before.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid, sample } from './page-drawings.mjs';
import { drop, nextFrames, openEverything, openPage, phase, planned, SIZES } from './page-support.mjs';

/** The sum of the shifts that still counts as standing still: 0.1 is what browsers call good. */
const STEADY = 0.02;

/** Runs in the page before anything else: records how far things move by themselves, as browsers measure it. */
const watchShifts = () => {
  window.shifts = [];
  new PerformanceObserver((list) => window.shifts.push(...list.getEntries().map((e) => e.value))).observe({ type: 'layout-shift', buffered: true });
};

/** The sum of the shifts since it was asked last. */
async function shifted(page) {
  await nextFrames(page, 10);
  return page.evaluate(() => window.shifts.splice(0).reduce((sum, shift) => sum + shift, 0));
}

/** Where the drawing is open from the start. */
const TABLET = { width: 768, height: 1024 };

test('nothing jumps on a first visit to a tablet', async (t) => {
  const { page } = await openPage(t, { size: TABLET, hash: 'seconds=0.4&seed=1', prepare: watchShifts });
  await phase(page, 'done');
  const moved = await shifted(page);
  assert.ok(moved < STEADY, String(moved));
});

for (const [name, size] of Object.entries(SIZES)) {
  test(`nothing jumps on a first visit, or when another drawing is opened (${name})`, async (t) => {
    const { page } = await openPage(t, { size, hash: 'seconds=0.4&seed=1', prepare: watchShifts });
    await phase(page, 'done');
    assert.ok((await shifted(page)) < STEADY, 'first visit');
    if (size === SIZES.phone) await page.locator('.sheet-toggle').click();
    await openEverything(page);
    await shifted(page);
    for (const file of ['layers.dxf', 'sheet_100.dxf']) {
      await drop(page, file, sample(file));
      await planned(page, file, 'done');
      const moved = await shifted(page);
      assert.ok(moved < STEADY, `${file}: ${moved}`);
    }
    // On a phone the new drawing is in sight.
    assert.equal(await page.evaluate(() => document.body.classList.contains('sheet-open')), false);
  });
}

test('a drawing that needs no attention does not close the section that a person has opened', async (t) => {
  const { page } = await openPage(t, { size: { width: 1280, height: 720 }, hash: 'seconds=0.4', prepare: watchShifts });
  await phase(page, 'done');
  const drawing = page.locator('details.section').first();
  assert.equal(await drawing.evaluate((d) => d.open), false);
  await drawing.locator('summary').first().click();
  await nextFrames(page, 60);
  await shifted(page);
  await drop(page, 'own.dxf', grid(12));
  await planned(page, 'own.dxf', 'done');
  assert.equal(await drawing.evaluate((d) => d.open), true);
  // Once the person has closed it, it is closed.
  await drawing.locator('summary').first().click();
  await drop(page, 'other.dxf', grid(9));
  await planned(page, 'other.dxf', 'done');
  assert.equal(await drawing.evaluate((d) => d.open), false);
});
