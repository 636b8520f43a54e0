// Leads on the page: switched on in the machine's panel, drawn, in the plan, and listed where they do not fit.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dxf, square } from '../package/support.mjs';
import { shot } from './page-pictures.mjs';
import { openMachinePart, plan, replanned, SIZES } from './page-support.mjs';

// Three squares 1.2 mm apart: the middle one has room above and below only.
const DRAWING = dxf([...square(20, 20, 40), ...square(61.2, 20, 40), ...square(102.4, 20, 40), ...square(30, 30, 15)]);

for (const size of ['desktop', 'phone']) {
  test(`leads are switched on and drawn (${size})`, async (t) => {
    const { page, opened: leads } = await openMachinePart(t, 'Leads and overcut', 'leads.dxf', DRAWING, { size: SIZES[size], touch: size === 'phone' });
    await replanned(page, () => leads.getByLabel('Lead-in').selectOption('arc'));
    await replanned(page, () => leads.getByLabel('Overcut').fill('0.5'));
    await leads.scrollIntoViewIfNeeded();
    await shot(page, `leads-${size}`);
    if (size === 'phone') return;
    const { machine, moves, summary } = await plan(page);
    assert.equal(machine.leads.rules.at(-1).overcut, 0.5);
    const cuts = moves.filter((m) => m.kind === 'cut');
    assert.equal(cuts.length, 4);
    for (const cut of cuts) assert.deepEqual([cut.lead_in, cut.overcut], [1, 1]);
    assert.ok(Math.abs(summary.lead_length - 4 * (1.5 * Math.PI / 2 + 0.5)) < 1e-6);
    await replanned(page, () => leads.getByLabel('Lead-in').selectOption('none'));
    await replanned(page, () => leads.getByLabel('Overcut').fill('0'));
    assert.equal((await plan(page)).machine.leads, undefined);
  });
}
