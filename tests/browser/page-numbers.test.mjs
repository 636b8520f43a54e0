// Number fields: what is typed or pasted counts as it is meant, what cannot be is explained at the field, and what counts is what the field shows.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid, sample } from './page-drawings.mjs';
import { drop, machineSection, openPage, openPlanned, phase, plan, planned, replanned, SIZES, storedWith } from './page-support.mjs';

/** What a field shows, whether it is marked as wrong, and the sentence at it. */
const stateOf = (field) => field.evaluate((input) => {
  const next = input.closest('.field').nextElementSibling;
  return [input.value, input.getAttribute('aria-invalid') === 'true', next?.matches('.reason.error') ? next.textContent : ''];
});

/** Types into a field in place of what is there, key by key. */
async function type(field, text) {
  await field.focus();
  await field.press('ControlOrMeta+a');
  await field.press('Delete');
  await field.pressSequentially(text);
}

const open = (page, title) => page.locator('details.section', { has: page.getByRole('heading', { name: title, exact: true }) }).evaluate((d) => (d.open = true));

test('a decimal comma was dropped: 0,15 mm became 015 mm', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4&machine=co2-100w', prepare: `localStorage.setItem('kerfway.language', 'de')` });
  await phase(page, 'done');
  await open(page, 'Maschine');
  await page.getByText('Erweiterte Einstellungen').click();
  const kerf = page.getByLabel(/^Schnittfugen/);
  await type(kerf, '0,15');
  assert.equal(await kerf.inputValue(), '0.15');
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  const speed = page.getByLabel(/^Schneid\u00ad?geschwindigkeit/);
  for (const [pasted, value] of [['1.234,5', '1234.5'], ['12,5 mm/s', '12.5'], ['12.5', '12.5']]) {
    await page.evaluate((text) => navigator.clipboard.writeText(text), pasted);
    await speed.focus();
    await speed.press('ControlOrMeta+a');
    await speed.press('ControlOrMeta+v');
    assert.equal(await speed.inputValue(), value, pasted);
  }
});

test('of a value beyond its limits the first digits counted: 150 % became 15 %, and an emptied field said "no limit"', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'grid.dxf', grid(9));
  const machine = await machineSection(page, SIZES.desktop);
  await machine.getByText('Advanced settings').click();
  const power = machine.getByLabel(/^Cutting power/);
  await type(power, '150');
  assert.deepEqual(await stateOf(power), ['150', true, 'Enter a value from 0 to 100 %.']);
  await power.press('Tab');
  assert.deepEqual(await stateOf(power), ['85', false, '']);
  const speed = machine.getByLabel(/^Cutting speed/);
  await type(speed, '');
  await speed.press('Tab');
  assert.deepEqual(await stateOf(speed), ['35', false, '']);
  await replanned(page, () => machine.getByLabel(/^Pierce time/).fill('0.3'));
  const { cut, pierce_time: pierce } = (await plan(page)).machine;
  assert.deepEqual([cut.power, cut.speed, pierce], [0.85, 35, 0.3]);
});

test('the sentence at a field went before the button below it was released, which then was not pressed', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'layers.dxf', sample('layers.dxf'));
  await open(page, 'Drawing');
  await page.getByRole('button', { name: 'Settings of layer CUT' }).click();
  const speed = page.getByLabel('Speed, layer CUT', { exact: true });
  await type(speed, '-3');
  assert.deepEqual(await stateOf(speed), ['-3', true, 'Enter a value from 0.01 to 100000 mm/s.'], 'fields of layers said nothing');
  const tolerances = page.getByText('Tolerances', { exact: true });
  await tolerances.click();
  const number = page.locator('.tolerance-field input[type=number]');
  const join = number.first();
  await join.waitFor();
  assert.deepEqual(await stateOf(speed), ['', false, '']);
  await join.fill('77');
  assert.deepEqual(await stateOf(join), ['77', true, 'Enter a value from 0.001 to 5 mm.']);
  // The sentence was below all of the fields, with the limits of the one that was changed last.
  await number.last().fill('0.01');
  assert.deepEqual(await page.locator('.tolerance-field .reason').allTextContents(), ['Enter a value from 0.001 to 5 mm.']);
});

test('settings that contradict each other, parts of wholes and absurd values are explained at their field', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'grid.dxf', grid(9));
  const machine = await machineSection(page, SIZES.desktop);
  await machine.getByText('Advanced settings').click();
  await machine.getByText('Micro-joints', { exact: true }).click();
  await machine.getByText('Calibrate with a stopwatch').click();
  for (const name of ['Plan', 'Quote', 'On the bed']) await open(page, name);
  await replanned(page, () => machine.getByLabel('Hold parts by micro-joints').check());
  await replanned(page, () => machine.getByLabel('Connect parts by bridges').check());
  await replanned(page, () => machine.getByLabel(/^Only contours up to/).fill('10'));
  await replanned(page, () => page.getByLabel('PositionAs drawn').selectOption({ label: 'A point of the job at' }));
  for (const [name, typed, sentence] of [
    ['Bed from x', '2000', 'Enter a value from -1000000 to 1599 mm.'], ['Bed to y', '-5', 'Enter a value from 1 to 1000000 mm.'],
    ['Only contours from', '100', 'Enter a value from 0 to 10 mm.'], ['Most parts together', '2.5', 'Enter a whole number from 2 to 1000000.'],
    ['At least, per contour', '1.5', 'Enter a whole number from 0 to 1000.'], ['Pause in corners below', '270', 'Enter a value from 0 to 180°.'],
    ['This job took', '1e308', 'Enter a value from 0.01 to 999999 s.'], ['Seed', '-5', 'Enter a whole number from 0 to 4294967295.'],
    ['Thickness', '1e308', 'Enter a value from 0.001 to 1000 mm.'], ['Density', '-1', 'Enter a value from 0.001 to 25 g/cm³.'], ['x', '1e308', 'Enter a value from -1000000 to 1000000 mm.'],
  ]) {
    const field = page.getByLabel(new RegExp(`^${name}\\s*(mm|°|s|g/cm³)?$`)).and(page.locator('input'));
    const before = await field.inputValue();
    await field.fill(typed);
    assert.deepEqual(await stateOf(field), [String(Number(typed)) === typed ? typed : '1e308', true, sentence], name);
    await field.press('Tab');
    assert.deepEqual(await stateOf(field), [before, false, ''], name);
  }
  assert.equal(await page.evaluate(() => document.body.dataset.phase), 'done', 'nothing of it was taken over');
  assert.equal(await page.locator('.notice').isVisible(), false);
});

test('the seed of the address, and that of before an undo, was not shown in its field', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'grid.dxf', grid(9));
  await open(page, 'Plan');
  const seed = page.getByLabel('Seed');
  assert.equal(await seed.inputValue(), '1');
  await replanned(page, () => seed.fill('7'));
  await seed.press('Escape');
  await page.locator('body').press('ControlOrMeta+z');
  await page.waitForFunction(() => document.querySelector('input[placeholder=random]').value === '1');
});

test('deleting a setting of the material library took two steps to undo', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'grid.dxf', grid(9));
  const machine = await machineSection(page, SIZES.desktop);
  await machine.getByText('Material library').click();
  await machine.getByLabel('Name of the material').fill('plywood');
  await replanned(page, () => machine.getByRole('button', { name: 'Save setting' }).click());
  const material = machine.locator('label.field', { hasText: 'As the machine is set' }).locator('select');
  await replanned(page, () => material.selectOption('plywood'));
  await replanned(page, () => machine.getByRole('button', { name: 'Delete setting' }).click());
  assert.equal(await material.isVisible(), false);
  await page.locator('body').press('ControlOrMeta+z');
  await page.waitForFunction(() => [...document.querySelectorAll('select')].some((s) => s.selectedOptions[0]?.text === 'plywood'));
});

test('a notice with its button stayed over the next drawing, which the button would have forgotten', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'first.dxf', grid(9));
  await storedWith(page, 0);
  await page.reload();
  await planned(page, 'first.dxf', 'done');
  const forget = page.locator('.notice').getByRole('button', { name: 'Forget it' });
  await forget.waitFor();
  await drop(page, 'second.dxf', grid(12));
  await planned(page, 'second.dxf', 'done');
  assert.equal(await forget.isVisible(), false);
});

test('an empty field of a layer showed the speed of the machine before, and not that of its material', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'layers.dxf', sample('layers.dxf'));
  await open(page, 'Drawing');
  await page.getByRole('button', { name: 'Settings of layer CUT' }).click();
  const shows = (speed, passes) => page.waitForFunction(([speed, passes]) => ['Speed', 'Passes'].map((name) => document.querySelector(`[aria-label="${name}, layer CUT"]`).placeholder).join() === `${speed},${passes}`, [speed, passes]);
  await shows(35, 1);
  const machine = await machineSection(page, SIZES.desktop);
  await machine.getByText('Advanced settings').click();
  await machine.getByText('Material library').click();
  await machine.getByLabel('Name of the material').fill('plywood');
  await replanned(page, () => machine.getByRole('button', { name: 'Save setting' }).click());
  await replanned(page, () => machine.getByLabel(/^Cutting speed/).fill('50'));
  await shows(50, 1);
  await replanned(page, () => machine.locator('label.field', { hasText: 'As the machine is set' }).locator('select').selectOption('plywood'));
  await shows(35, 1);
});
