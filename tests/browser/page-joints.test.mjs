// Micro-joints on the page: switched on in the machine's panel, drawn, placed by clicking a contour, in the plan.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { circle, dxf, square } from '../package/support.mjs';
import { shot } from './page-pictures.mjs';
import { openMachinePart, plan, replanned, SIZES, tap } from './page-support.mjs';

const DRAWING = dxf([...square(20, 20, 40), ...square(75, 20, 40), ...circle(40, 40, 8), ...circle(95, 40, 12)]);

for (const size of ['desktop', 'phone']) {
  test(`micro-joints are switched on, drawn and placed by hand (${size})`, async (t) => {
    const { page, opened: joints } = await openMachinePart(t, 'Micro-joints', 'joints.dxf', DRAWING, { size: SIZES[size], touch: size === 'phone' });
    await replanned(page, () => joints.getByLabel('Hold parts by micro-joints').check());
    await replanned(page, () => joints.getByLabel('Width that holds').fill('1'));
    await joints.scrollIntoViewIfNeeded();
    await shot(page, `joints-${size}`);
    if (size === 'phone') return;
    const { machine, summary } = await plan(page);
    assert.deepEqual(machine.joints.rules, [{ side: 'outer', width: 1, count: 2, corner_clearance: 2, kind: 'stop', test: 'and' }]);
    assert.equal(summary.joints, 4);

    // A click near the middle of a side of the first square places a joint there, and a second click removes it.
    await joints.getByRole('button', { name: 'Place by hand' }).click();
    const canvas = page.locator('canvas').first();
    const box = await canvas.boundingBox();
    // The drawing is fitted, so that some column of pixels left of the middle crosses the lower side of the first square.
    let at = null;
    for (let y = box.y + box.height - 40; y > box.y + 40 && at === null; y -= 6) {
      await page.mouse.move(box.x + box.width * 0.62, y);
      if (await canvas.evaluate((c) => c.classList.contains('over'))) at = [box.x + box.width * 0.62, y];
    }
    assert.ok(at, 'a contour under the pointer');
    await replanned(page, () => page.mouse.click(...at));
    await joints.getByText('1 joint by hand').waitFor();
    await shot(page, `joints-by-hand-${size}`);
    const placed = await plan(page);
    assert.equal(placed.options.joints.length, 1);
    assert.equal(placed.summary.joints, 3);
    await replanned(page, () => page.mouse.click(...at));
    assert.equal((await plan(page)).options.joints, undefined);
    await page.keyboard.press('Escape');

    await replanned(page, () => joints.getByLabel('Hold parts by micro-joints').uncheck());
    assert.equal((await plan(page)).machine.joints, undefined);
  });
}

test('placing by hand is ended by the button that began it, which fingers can press', async (t) => {
  const { page, opened: joints } = await openMachinePart(t, 'Micro-joints', 'joints.dxf', DRAWING, { size: SIZES.phone, touch: true });
  const place = joints.getByRole('button', { name: 'Place by hand' });
  const state = async () => [await place.getAttribute('aria-pressed'), await page.locator('#canvas').evaluate((c) => c.classList.contains('placing'))];
  assert.deepEqual(await state(), ['false', false]);
  await tap(place);
  assert.deepEqual(await state(), ['true', true]);
  await tap(place);
  assert.deepEqual(await state(), ['false', false]);
  await tap(place);
  await page.keyboard.press('Escape');
  assert.deepEqual(await state(), ['false', false]);
});
