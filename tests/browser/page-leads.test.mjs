// Leads on the page: switched on in the machine's panel, drawn, in the plan, and listed where they do not fit.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dxf, square } from '../package/support.mjs';
import { download, drop, openPage, phase, planned, shot, SIZES } from './page-support.mjs';

// Three squares 1.2 mm apart: the middle one has room above and below only.
const DRAWING = dxf([...square(20, 20, 40), ...square(61.2, 20, 40), ...square(102.4, 20, 40), ...square(30, 30, 15)]);

async function opened(t, options = {}) {
  const { page } = await openPage(t, { hash: 'machine=fibre-3kw-thin&seconds=1&seed=1&units=mm', ...options });
  await phase(page, 'planning', 'done');
  await drop(page, 'leads.dxf', Buffer.from(DRAWING));
  await planned(page, 'leads.dxf', 'done');
  if (options.size === SIZES.phone) await page.locator('.sheet-toggle').click();
  const machine = page.locator('details.section', { has: page.getByRole('heading', { name: 'Machine', exact: true }) });
  await machine.evaluate((d) => (d.open = true));
  const leads = machine.locator('details.more', { hasText: 'Leads and overcut' });
  await leads.evaluate((d) => (d.open = true));
  return { page, leads };
}

async function replanned(page) {
  await page.waitForTimeout(700);
  await phase(page, 'done');
}

const plan = async (page) => {
  const press = () => page.locator('.downloads').getByRole('button', { name: 'Plan (JSON)', exact: true }).click();
  return JSON.parse((await download(page, press)).bytes.toString());
};

for (const [size, theme] of [['desktop', 'light'], ['desktop', 'dark'], ['phone', 'light'], ['phone', 'dark']]) {
  test(`leads are switched on and drawn (${size}, ${theme})`, async (t) => {
    const { page, leads } = await opened(t, { size: SIZES[size], theme, touch: size === 'phone' });
    await leads.getByLabel('Lead-in').selectOption('arc');
    await replanned(page);
    await leads.getByLabel('Overcut').fill('0.5');
    await replanned(page);
    await leads.scrollIntoViewIfNeeded();
    await shot(page, `leads-${size}-${theme}`);
    if (size === 'phone') return;
    const { machine, moves, summary } = await plan(page);
    assert.equal(machine.leads.rules.at(-1).overcut, 0.5);
    const cuts = moves.filter((m) => m.kind === 'cut');
    assert.equal(cuts.length, 4);
    for (const cut of cuts) assert.deepEqual([cut.lead_in, cut.overcut], [1, 1]);
    assert.ok(Math.abs(summary.lead_length - 4 * (1.5 * Math.PI / 2 + 0.5)) < 1e-6);
    await leads.getByLabel('Lead-in').selectOption('none');
    await leads.getByLabel('Overcut').fill('0');
    await replanned(page);
    assert.equal((await plan(page)).machine.leads, undefined);
  });
}
