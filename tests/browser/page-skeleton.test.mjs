// Skeleton cuts on the page: switched on in the machine's panel, drawn, in the plan, and the remainder as a download.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { circle, dxf, square } from '../package/support.mjs';
import { shot, still } from './page-pictures.mjs';
import { download, machineSection, openPlanned, plan, replanned, SIZES } from './page-support.mjs';

// The border of the sheet is clear, and ignored.
const DRAWING = dxf(square(0, 0, 300, 'SHEET'), square(20, 20, 60), circle(50, 50, 20), circle(150, 100, 30), square(20, 120, 60), circle(50, 150, 20));

for (const size of ['desktop', 'phone']) {
  test(`the skeleton is cut up, drawn, and a strip is kept (${size})`, async (t) => {
    const page = await openPlanned(t, 'fibre-3kw-thin', 'skeleton.dxf', DRAWING, { size: SIZES[size], touch: size === 'phone' });
    const before = await still(page);
    const machine = await machineSection(page, SIZES[size]);
    const on = machine.getByLabel('Cut up the skeleton');
    await replanned(page, () => on.check());
    await replanned(page, () => machine.getByLabel('Greatest width of pieces').fill('100'));
    await replanned(page, () => machine.getByLabel('Greatest height of pieces').fill(''));
    await on.scrollIntoViewIfNeeded();
    await shot(page, `skeleton-panel-${size}`);
    if (size === 'phone') await page.locator('.sheet-toggle').click();
    assert.notDeepEqual(await still(page), before);
    await shot(page, `skeleton-${size}`);
    if (size === 'phone') return;

    const { machine: profile, summary } = await plan(page);
    assert.deepEqual(profile.skeleton, { spacing_x: 100, clearance: 2, joint_spacing: 500, joint_width: 1 });
    // Two lines of 300 mm, both beside the disk or through waste.
    assert.deepEqual([summary.skeleton_cuts, Math.round(summary.skeleton_length)], [2, 600]);
    const shown = await page.locator('dd.number').evaluateAll((all) => all.map((e) => [e.previousElementSibling.textContent, e.textContent]));
    assert.match(shown.find(([term]) => term === 'Skeleton')[1], /s\u00a0· 0\.6\d*\u00a0m\u00a0· 2\u00a0cuts$/);

    // Steps through the order end at a skeleton cut: it says what it is, and has no rules.
    await page.locator('canvas').first().focus();
    await page.keyboard.press('End');
    const card = page.getByLabel('Selected contour');
    await card.getByText('Skeleton cuts come after everything else.').waitFor();
    assert.equal(await card.locator('.contour-rules button, .contour-rules select').count(), 0);
    await page.keyboard.press('1');
    assert.deepEqual((await plan(page)).options.first, []);
    await shot(page, 'skeleton-card');
    await page.keyboard.press('Escape');

    // A strip without parts is kept whole: the disk ends at x 180, and the squares at y 180.
    await replanned(page, () => machine.getByLabel('Keep a strip of the sheet').check());
    await replanned(page, () => machine.getByLabel('At least this wide').fill('100'));
    assert.equal((await plan(page)).machine.skeleton.remainder, 100);
    const { name, bytes } = await download(page, () => page.locator('.downloads').getByRole('button', { name: 'Remainder (DXF)', exact: true }).click());
    assert.match(name, /^skeleton.*-remainder\.dxf$/);
    assert.match(bytes.toString('utf8'), /\nSHEET\n/);
    assert.doesNotMatch(bytes.toString('utf8'), /LWPOLYLINE[\s\S]*\nCUT OUT\n/);
    await shot(page, 'skeleton-strip');

    await replanned(page, () => on.uncheck());
    const after = await plan(page);
    assert.deepEqual([after.machine.skeleton, after.summary.skeleton_cuts], [undefined, undefined]);
  });
}

test('a layer of which nothing is left is not asked about', async (t) => {
  const page = await openPlanned(t, 'fibre-3kw-thin', 'skeleton.dxf', DRAWING);
  const sheet = await page.locator('.layers .layer', { hasText: 'SHEET' }).evaluate((row) => row.querySelector('.number').textContent);
  assert.equal(sheet, '0', 'its only contour is the border of the sheet, which is ignored already');
  assert.equal(await page.getByRole('button', { name: 'Ignore it' }).count(), 0);
});
