// The machine on the page: where the job lies on its bed, what each layer does, its materials, and its calibration.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { dxf, square } from '../package/support.mjs';
import { beamRuns, grid } from './page-drawings.mjs';
import { shot, still } from './page-pictures.mjs';
import { machineSection, openPage, openPlanned, output, phase, plan, replanned, SIZES, until } from './page-support.mjs';

const DRAWING = dxf(square(-20, 10, 50));

async function opened(t, options = {}) {
  const page = await openPlanned(t, 'diode-hobby', 'square.dxf', DRAWING, options);
  await page.evaluate(() => document.querySelectorAll('details.section').forEach((d) => (d.open = true)));
  return page;
}

test('a job off the bed gets no G-code, is moved to the corner, turned, and dragged', async (t) => {
  const page = await opened(t);
  const bed = page.locator('details.section', { has: page.getByRole('heading', { name: 'On the bed' }) });
  await bed.getByText('The job reaches from x -20 to 30', { exact: false }).waitFor();
  assert.equal(await page.locator('.dock').getByRole('button', { name: 'G-code' }).isVisible(), false);
  assert.equal(await bed.locator('.suggestion strong').textContent(), 'Not on the bed, so no program');
  assert.match(await bed.locator('summary').textContent(), /On the bed.*reaches beyond it/, 'the value goes with the label');
  await shot(page, 'bed-off');

  await replanned(page, () => bed.getByRole('button', { name: 'Move to the corner' }).click());
  await page.waitForFunction(() => location.hash.includes('place=lower-left%400%2C0'));
  assert.deepEqual((await plan(page)).summary.bounds, [0, 0, 50, 50]);
  assert.match(await output(page, 'G-code'), /^G1.* X50/m);

  await replanned(page, () => bed.getByRole('radio', { name: 'Centre', exact: true }).check());
  assert.equal(await bed.locator('.placement-point input[type=number]').first().inputValue(), '25');
  await replanned(page, () => bed.locator('.placement-point input[type=number]').first().fill('200'));
  await page.waitForFunction(() => location.hash.includes('place=center%40200%2C25'));
  assert.deepEqual((await plan(page)).summary.bounds, [175, 0, 225, 50]);

  await replanned(page, () => bed.getByRole('button', { name: 'Turn left' }).click());
  await page.waitForFunction(() => location.hash.includes('turn=90'));
  assert.equal((await plan(page)).options.turn, 90);

  await bed.getByRole('button', { name: 'Show the bed' }).click();
  await bed.getByRole('button', { name: 'Drag the job' }).click();
  const box = await page.locator('#canvas').boundingBox();
  await still(page);
  await page.mouse.move(box.x + 300, box.y + 300);
  await page.mouse.down();
  await page.mouse.move(box.x + 340, box.y + 280, { steps: 4 });
  await replanned(page, () => page.mouse.up());
  const [x0, y0] = (await plan(page)).summary.bounds;
  assert.ok(x0 > 176 && y0 > 1, `dragged to ${x0}, ${y0}`);
  await page.keyboard.press('Escape');
  assert.equal(await bed.getByRole('button', { name: 'Drag the job' }).getAttribute('aria-pressed'), 'false');
  await shot(page, 'bed-placed');
});

test('the table and the report named entries where they are drawn, also of a job that is placed elsewhere', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'square.dxf', DRAWING, { hash: 'machine=co2-100w&seconds=0.4&units=mm&place=lower-left@100,200' });
  const { x, y } = beamRuns(await output(page, 'G-code'))[0].from;
  await page.keyboard.press('t');
  const entry = await page.locator('.rows .order-row').first().locator('.number').last().textContent();
  assert.equal(entry, `${x.toFixed(1)}, ${y.toFixed(1)}`);
  const report = await output(page, 'Report');
  assert.equal(/<td>([\d.]+, [\d.]+)<\/td>/.exec(report.slice(report.indexOf('Entry, mm')))?.[1], `${+x.toFixed(2)}, ${+y.toFixed(2)}`);
});

test('a layer has settings, a material is saved and chosen, and a stopwatch fits the machine', async (t) => {
  const page = await opened(t, { hash: 'machine=diode-hobby&seconds=1&seed=1&units=mm&place=lower-left%4010%2C10' });
  const before = (await plan(page)).summary;
  await page.getByRole('button', { name: 'Settings of layer 0' }).click();
  const passes = page.getByLabel('Passes, layer 0');
  await passes.fill('3');
  await replanned(page, () => passes.press('Tab'));
  await page.getByText('3 ×', { exact: false }).first().waitFor();
  const after = (await plan(page)).summary;
  assert.ok(Math.abs(after.cut_length / before.cut_length - 3) < 1e-9, `${after.cut_length} of ${before.cut_length}`);
  await shot(page, 'layer-table');

  await page.getByText('Material library').click();
  await page.getByLabel('Name of the material').fill('3 mm birch ply');
  await replanned(page, () => page.getByRole('button', { name: 'Save setting' }).click());
  await replanned(page, () => page.locator('label.field', { hasText: 'As the machine is set' }).locator('select').selectOption('3 mm birch ply'));
  assert.equal((await plan(page)).material, '3 mm birch ply');

  await page.getByText('Calibrate with a stopwatch').click();
  await page.getByPlaceholder('measured').fill('200');
  await page.getByRole('button', { name: 'Add this job' }).click();
  await page.getByRole('button', { name: 'Fit the machine' }).click();
  await page.locator('.calibrated').getByText('square.dxf').waitFor();
  await shot(page, 'calibration');
  await replanned(page, () => page.getByRole('button', { name: 'Use the fitted values' }).click());
  assert.ok(Math.abs((await plan(page)).summary.total_time / 200 - 1) < 0.01);
});

test('a value that the machine cannot have was ignored, or replaced without a word', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'grid.dxf', grid(9));
  const machine = await machineSection(page, SIZES.desktop);
  await machine.getByText('Advanced settings').click();
  const said = () => machine.locator('.reason.error').allTextContents();
  for (const [name, usual, typed, sentence] of [
    ['Cutting speed', '35', '-5', 'Enter a value from 0.01 to 100000 mm/s.'], ['Cutting speed', '35', '0', 'Enter a value from 0.01 to 100000 mm/s.'], ['Kerf width', '0', '50', 'Enter a value from 0 to 10 mm.'],
  ]) {
    const field = machine.getByLabel(new RegExp(`^${name}`));
    assert.equal(await field.inputValue(), usual);
    await field.fill(typed);
    assert.deepEqual([await said(), await field.getAttribute('aria-invalid')], [[sentence], 'true']);
    await field.press('Tab');
    assert.deepEqual([await said(), await field.getAttribute('aria-invalid'), await field.inputValue()], [[], 'false', usual], 'the value that counts is back');
  }
  const kerf = machine.getByLabel(/^Kerf width/);
  await kerf.fill('50');
  await replanned(page, () => kerf.fill('0.2'));
  assert.deepEqual(await said(), []);
  assert.equal((await plan(page)).machine.kerf_width, 0.2);
});

test('the first visit asks for the machine, and the answer stays', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=1', size: SIZES.desktop });
  await phase(page, 'planning', 'done');
  const first = page.locator('.first-machine');
  await first.getByRole('combobox').selectOption('k40');
  await first.getByRole('button', { name: 'Keep this machine' }).click();
  assert.equal(await first.isVisible(), false);
  await page.evaluate(() => history.replaceState(null, '', '#seconds=1'));
  await page.reload();
  await phase(page, 'planning', 'done');
  assert.match(await page.evaluate(() => location.hash), /machine=k40/);
  assert.equal(await page.locator('.first-machine').isVisible(), false);
  await phase(page, 'done');
  // A K40 takes SVG, so that is what is offered first.
  assert.equal(await page.locator('.dock').getByRole('button', { name: 'SVG' }).isVisible(), true);
});

test('the controls of the machine are loaded when its section is opened, and then also without a network; its heading names the machine before', async (t) => {
  const { page, sent } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  const controls = () => sent.filter(({ file }) => file.includes('later-machine'));
  assert.deepEqual(controls(), [], 'a first visit does without them');
  const machine = page.locator('details.section', { has: page.getByRole('heading', { name: 'Machine', exact: true }) });
  assert.equal(await machine.locator('.gist').textContent(), 'CO2 laser, 100 W, GRBL, 3 mm acrylic');
  // Once somebody uses the page, it stores what it may need.
  await page.keyboard.press('Shift');
  await until(page, 'the controls are stored', () => page.evaluate(async () => {
    const lists = await Promise.all((await caches.keys()).map(async (cache) => (await caches.open(cache)).keys()));
    return lists.flat().some(({ url }) => url.includes('later-machine'));
  }));
  assert.equal(controls().length, 1);
  await page.context().setOffline(true);
  await machine.locator('> summary').focus();
  await page.keyboard.press('Enter');
  const preset = machine.getByLabel('Preset');
  await preset.waitFor();
  await page.keyboard.press('Tab');
  assert.equal(await preset.evaluate((list) => list === document.activeElement), true);
  await preset.selectOption('k40');
  await page.waitForFunction(() => location.hash.includes('machine=k40'));
  assert.equal(await machine.locator('.gist').textContent(), 'K40, CO2, 40 W, 3 mm plywood');
});
