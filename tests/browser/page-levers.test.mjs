// Levers on the page: lifting the head is switched on in the machine's panel, and is in the plan and in the program.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dxf, square } from '../package/support.mjs';
import { openPlanned, output, plan, replanned, shot, SIZES } from './page-support.mjs';

const DRAWING = dxf([...square(20, 20, 40), ...square(80, 20, 40), ...square(30, 30, 15)]);

for (const [size, theme] of [['desktop', 'light'], ['desktop', 'dark'], ['phone', 'light'], ['phone', 'dark']]) {
  test(`lifting the head is switched on, changed and switched off (${size}, ${theme})`, async (t) => {
    const page = await openPlanned(t, 'fibre-3kw-thin', 'lift.dxf', DRAWING, { size: SIZES[size], theme, touch: size === 'phone' });
    if (size === 'phone') await page.locator('.sheet-toggle').click();
    const machine = page.locator('details.section', { has: page.getByRole('heading', { name: 'Machine', exact: true }) });
    await machine.evaluate((d) => (d.open = true));
    const lift = machine.getByLabel('Lift the head between cuts');
    await replanned(page, () => lift.check());
    await replanned(page, () => machine.getByLabel('Lift by').fill('12'));
    await lift.scrollIntoViewIfNeeded();
    await shot(page, `lift-${size}-${theme}`);
    if (size === 'phone' || theme === 'dark') return;
    const lifted = await plan(page);
    assert.deepEqual(lifted.machine.levers, { lift: { height: 12, stay_down: 10, at_rest: false } });
    assert.equal(lifted.machine.z_speed, 100);
    assert.ok(lifted.summary.lifts >= 3);
    assert.equal((await output(page, 'G-code')).match(/^G0 X\S+ Y\S+ Z12/gm).length, lifted.summary.lifts);
    await replanned(page, () => lift.uncheck());
    const { machine: after, summary } = await plan(page);
    assert.deepEqual([after.levers, summary.lifts], [undefined, undefined]);
  });
}
