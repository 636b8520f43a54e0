// Levers on the page: lifting the head is switched on in the machine's panel, and is in the plan and in the program.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { circle, dxf, polygon, square } from '../package/support.mjs';
import { shot, still } from './page-pictures.mjs';
import { machineSection, openPlanned, output, plan, replanned, SIZES } from './page-support.mjs';

const DRAWING = dxf([...square(20, 20, 40), ...square(80, 20, 40), ...square(30, 30, 15)]);

for (const size of ['desktop', 'phone']) {
  test(`lifting the head is switched on, changed and switched off (${size})`, async (t) => {
    const page = await openPlanned(t, 'fibre-3kw-thin', 'lift.dxf', DRAWING, { size: SIZES[size], touch: size === 'phone' });
    const machine = await machineSection(page, SIZES[size]);
    const lift = machine.getByLabel('Lift the head between cuts');
    await replanned(page, () => lift.check());
    await replanned(page, () => machine.getByLabel('Lift by').fill('12'));
    await lift.scrollIntoViewIfNeeded();
    await shot(page, `lift-${size}`);
    if (size === 'phone') return;
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

test('a row of holes is cut on the run, and its settings are in the plan', async (t) => {
  const row = dxf(...[20, 30, 40, 50].map((x) => circle(x, 30, 3)), square(10, 10, 60));
  const page = await openPlanned(t, 'fibre-3kw-thin', 'row.dxf', row);
  const machine = await machineSection(page, SIZES.desktop);
  const fly = machine.getByLabel('Cut rows and grids on the run');
  await replanned(page, () => fly.check());
  await replanned(page, () => machine.getByLabel('Longest way between two cuts').fill('12'));
  await fly.scrollIntoViewIfNeeded();
  await shot(page, 'fly-desktop');
  const flown = await plan(page);
  assert.deepEqual(flown.machine.levers, { fly: { reach: 12, overcut: 0 } });
  assert.equal(flown.summary.fly_cuts, 3);
  await page.evaluate(() => [...document.querySelectorAll('details.more')].find((d) => d.textContent.startsWith('What saves what')).setAttribute('open', ''));
  await page.getByRole('button', { name: 'Work it out' }).click();
  await page.getByText('Plans without a decision were searched').waitFor();
  const lines = await page.locator('.savings').evaluate((list) => [...list.children].map((e) => e.textContent));
  assert.equal(lines[2], 'Cuts on the run');
  assert.match(lines[3], /^saves [\d.:]+/);
  await shot(page, 'savings-levers');
  await replanned(page, () => fly.uncheck());
  assert.equal((await plan(page)).summary.fly_cuts, undefined);
});

const ROW = dxf(Array.from({ length: 5 }, (_, k) => square(50 + 50 * k, 50, 40)).flat());

for (const size of ['desktop', 'phone']) {
  test(`pieces that tip are marked, and moves over them ignored or avoided (${size})`, async (t) => {
    const page = await openPlanned(t, 'fibre-3kw-thin', 'row.dxf', ROW, { size: SIZES[size], touch: size === 'phone' });
    const machine = await machineSection(page, SIZES[size]);
    const tips = machine.getByLabel('Mind pieces that tip');
    await replanned(page, () => tips.check());
    await replanned(page, () => machine.getByLabel('Pieces drop below').fill('10'));
    await tips.scrollIntoViewIfNeeded();
    await shot(page, `tips-${size}`);
    if (size === 'phone') return;
    const avoided = await plan(page);
    assert.equal(avoided.machine.levers.tips.risky_moves, 'avoid');
    assert.equal(avoided.summary.crossings, undefined);
    await replanned(page, () => machine.getByLabel('Moves over them').selectOption({ label: 'Only mark them' }));
    await replanned(page, () => machine.getByLabel('Lift the head between cuts').uncheck());
    await shot(page, `tips-ignored-${size}`);
    const ignored = await plan(page);
    assert.ok(ignored.summary.crossings > 0);
    assert.equal(ignored.moves.filter((m) => m.way === 'crosses').length, ignored.summary.crossings);
    await page.getByText('Risky moves', { exact: true }).waitFor();
    await replanned(page, () => tips.uncheck());
    assert.equal((await plan(page)).machine.levers, undefined);
  });
}

const HOLES = dxf(Array.from({ length: 16 }, (_, k) => square(30 + 20 * (k % 4), 30 + 20 * Math.floor(k / 4), 10)).flat());

for (const size of ['desktop', 'phone']) {
  test(`cuts near each other wait for each other, or have a charge (${size})`, async (t) => {
    const page = await openPlanned(t, 'fibre-3kw-thin', 'holes.dxf', HOLES, { size: SIZES[size], touch: size === 'phone' });
    const machine = await machineSection(page, SIZES[size]);
    const heat = machine.getByLabel('Let cuts cool');
    await replanned(page, () => heat.check());
    await replanned(page, () => machine.getByLabel('Plate thickness').fill('8'));
    await heat.scrollIntoViewIfNeeded();
    await shot(page, `heat-${size}`);
    if (size === 'phone') return;
    const waiting = await plan(page);
    assert.deepEqual(waiting.machine.levers.heat, { distance: 20, seconds: 5, small_holes: { thickness: 8, ratio: 1 } });
    assert.ok(waiting.summary.waits > 0);
    await page.locator('dt.waits').waitFor();
    assert.ok(await machine.getByLabel('Cut rows and grids on the run').isDisabled());
    assert.ok(await machine.getByLabel('Join contours through waste').isEnabled(), 'both at once');
    await replanned(page, () => machine.getByLabel('Charge for a pair').fill('0.01'));
    const charged = await plan(page);
    assert.deepEqual([charged.summary.waits, charged.summary.hot_pairs > 0], [undefined, true]);
    await page.locator('dt.hot-pairs').waitFor();
    await replanned(page, () => heat.uncheck());
    assert.equal((await plan(page)).machine.levers, undefined);
  });
}

for (const size of ['desktop', 'phone']) {
  test(`parts are joined through waste, and it is drawn, ${size}`, async (t) => {
    const nest = dxf(...[[0, 0], [28, 0], [0, 28], [28, 28]].map(([x, y]) => square(10 + x, 10 + y, 20)));
    const page = await openPlanned(t, 'fibre-6kw-thick', 'nest.dxf', nest, { size: SIZES[size], touch: size === 'phone' });
    const machine = await machineSection(page, SIZES[size]);
    const chains = machine.getByLabel('Join contours through waste');
    await replanned(page, () => chains.check());
    await replanned(page, () => machine.getByLabel('Longest cut through waste').fill('25'));
    await chains.scrollIntoViewIfNeeded();
    await shot(page, `chains-${size}`);
    if (size === 'phone') return;
    const joined = await plan(page);
    assert.deepEqual(joined.machine.levers, { chains: { reach: 25, clearance: 1 } });
    assert.deepEqual([joined.summary.chains, joined.summary.pierces], [3, 1]);
    assert.ok(await machine.getByLabel('Begin cuts moving').isEnabled(), 'both at once');
    await replanned(page, () => chains.uncheck());
    assert.equal((await plan(page)).summary.chains, undefined);
  });
}

for (const size of ['desktop', 'phone']) {
  test(`parts are connected by bridges, which are drawn, ${size}`, async (t) => {
    const nest = dxf(...[[0, 0], [28, 0], [0, 28], [28, 28]].map(([x, y]) => square(10 + x, 10 + y, 20)));
    const page = await openPlanned(t, 'fibre-6kw-thick', 'nest.dxf', nest, { size: SIZES[size], touch: size === 'phone' });
    const machine = await machineSection(page, SIZES[size]);
    const bridges = machine.getByLabel('Connect parts by bridges');
    await replanned(page, () => bridges.check());
    await replanned(page, () => machine.getByLabel('Longest bridge').fill('25'));
    const right = async (label) => (await machine.getByLabel(label).boundingBox()).x;
    assert.equal(await right('Most parts together'), await right('Longest bridge'), 'fields stand below each other');
    await bridges.scrollIntoViewIfNeeded();
    await shot(page, `bridges-${size}`);
    if (size === 'phone') return;
    const connected = await plan(page);
    assert.deepEqual(connected.machine.levers, { bridges: { width: 2, reach: 25, clearance: 1 } });
    assert.deepEqual([connected.summary.bridges, connected.summary.pierces], [3, 1]);
    assert.ok(await machine.getByLabel('Cut rows and grids on the run').isDisabled(), 'connected parts are cut in one go');
    await replanned(page, () => machine.getByLabel('Cut them later').check());
    assert.equal((await plan(page)).machine.levers.bridges.cut_later, true);
    await replanned(page, () => bridges.uncheck());
    assert.equal((await plan(page)).summary.pierces, 4);
  });
}

/** Four parts on a machine that connects them by bridges. */
async function connected(t) {
  const plate = dxf(square(10, 10, 60), square(78, 30, 20), square(106, 30, 20), square(160, 10, 12));
  const page = await openPlanned(t, 'fibre-6kw-thick', 'plate.dxf', plate);
  const machine = await machineSection(page, SIZES.desktop);
  await machine.getByText('Advanced settings', { exact: true }).click();
  await replanned(page, () => machine.getByLabel('Pierce time').fill('3'));
  await replanned(page, () => machine.getByLabel('Connect parts by bridges').check());
  return { page, machine };
}

/** Cuts the bridges later, and small pieces drop. */
async function dropping(page, machine) {
  await replanned(page, () => machine.getByLabel('Cut them later').check());
  await replanned(page, () => machine.getByLabel('Mind pieces that tip').check());
  await replanned(page, () => machine.getByLabel('Pieces drop below').fill('5'));
}

test('parts that come off their bridges may tip, and are marked', async (t) => {
  const { page, machine } = await connected(t);
  await dropping(page, machine);
  assert.equal((await plan(page)).summary.bridges, undefined, 'no part stays');
  await replanned(page, () => machine.getByLabel('Pieces tip below').fill('40'));
  await shot(page, 'bridges-tips-desktop');
  const { summary, machine: { levers } } = await plan(page);
  assert.deepEqual([summary.bridges, summary.crossings, levers.bridges.cut_later, levers.tips.risky_moves], [2, undefined, true, 'avoid']);
});

test('strips that may tip were not painted, and the number of parts that bridges connect had an empty field', async (t) => {
  const { page, machine } = await connected(t);
  assert.equal(await machine.getByLabel('Most parts together').getAttribute('placeholder'), 'no limit');
  await dropping(page, machine);
  await replanned(page, () => machine.getByLabel('Pieces tip below').fill('40'));
  await still(page);
  await shot(page, 'strips-tip');
  // The drawing is 162 mm wide and 60 high, and fitted into the stage between margins. Strips of 2 mm lead from the plate to the parts.
  const shades = await page.evaluate(() => {
    const canvas = document.querySelector('#canvas');
    const { clientWidth, clientHeight } = canvas;
    const tools = document.querySelector('.toolbar').offsetWidth;
    const [width, height] = [clientWidth - 40 - 24 - tools, clientHeight - 100];
    const scale = 0.94 * Math.min(width / 162, height / 60);
    const shade = (x, y) => [...canvas.getContext('2d').getImageData(Math.round(40 + width / 2 + (x - 91) * scale), Math.round(60 + height / 2 - (y - 40) * scale), 1, 1).data].join();
    const around = (x) => Array.from({ length: 41 }, (_, k) => shade(x, 38 + k / 10));
    return { part: shade(82, 46), waste: shade(74, 55), strips: [around(73), around(101)] };
  });
  assert.notEqual(shades.part, shades.waste);
  for (const strip of shades.strips) assert.ok(strip.filter((shade) => shade === shades.part).length > 5, `${shades.part}: ${strip.join(' ')}`);
});

const WEDGES = dxf(...[20, 70, 120].map((x) => polygon([[x, 20], [x + 30, 20], [x + 15, 46]])));

for (const size of ['desktop', 'phone']) {
  test(`corners are cut in loops or rounded, by rule and by hand, ${size}`, async (t) => {
    const page = await openPlanned(t, 'fibre-6kw-plate', 'wedges.dxf', WEDGES, { size: SIZES[size], touch: size === 'phone' });
    const machine = await machineSection(page, SIZES[size]);
    const corners = machine.getByLabel('Do not stop in corners');
    await replanned(page, () => corners.check());
    await replanned(page, () => machine.getByLabel('Radius of loops').fill('1'));
    await corners.scrollIntoViewIfNeeded();
    await shot(page, `corners-${size}`);
    if (size === 'phone') return;
    const looped = await plan(page);
    assert.deepEqual(looped.machine.levers.corners, { outer: 'loop', hole: 'stop', loop_radius: 1, clearance: 1, round_radius: 1, deviation: 0.1 });
    assert.equal(looped.summary.loops, 6);
    await page.locator('dt.loops').waitFor();
    await replanned(page, () => machine.getByLabel('Corners of parts').selectOption({ label: 'rounded' }));
    const rounded = await plan(page);
    assert.ok(rounded.summary.rounded_corners >= 6 && rounded.summary.loops === undefined, JSON.stringify(rounded.summary));
    await page.locator('dt.rounded').waitFor();
    await replanned(page, () => corners.uncheck());
    assert.equal((await plan(page)).machine.levers, undefined);
  });
}

for (const size of ['desktop', 'phone']) {
  test(`parts that share sides are cut together, ${size}`, async (t) => {
    const nest = dxf(...[[0, 0], [20, 0], [0, 20], [20, 20]].map(([x, y]) => square(10 + x, 10 + y, 20)));
    const page = await openPlanned(t, 'fibre-6kw-thick', 'nest.dxf', nest, { size: SIZES[size], touch: size === 'phone' });
    const machine = await machineSection(page, SIZES[size]);
    const shared = machine.getByLabel('Cut shared sides together');
    await replanned(page, () => shared.check());
    await shared.scrollIntoViewIfNeeded();
    await shot(page, `common-cuts-${size}`);
    if (size === 'phone') return;
    const joined = await plan(page);
    assert.deepEqual([joined.machine.levers, joined.summary.pierces], [{ common_cuts: {} }, 1]);
    // What may tip, and what has to cool, is not planned with them.
    for (const other of ['Mind pieces that tip', 'Let cuts cool']) assert.ok(await machine.getByLabel(other).isDisabled(), other);
    await replanned(page, () => shared.uncheck());
    const apart = await plan(page);
    assert.deepEqual([apart.machine.levers, apart.summary.pierces], [undefined, 4]);
  });
}

test('a machine that joins contours through waste offers no pauses in corners, which it cannot have', async (t) => {
  const page = await openPlanned(t, 'fibre-3kw-thin', 'two.dxf', dxf([...square(20, 20, 40), ...square(62, 20, 40)]));
  const machine = await machineSection(page, SIZES.desktop);
  const pausing = machine.getByLabel('Pause in sharp corners');
  const chains = machine.getByLabel('Join contours through waste');
  await replanned(page, () => chains.check());
  assert.equal(await pausing.isDisabled(), true);
  await replanned(page, () => chains.uncheck());
  assert.equal(await pausing.isDisabled(), false);
});

test('two switches within a second are two choices, which are undone one by one', async (t) => {
  const page = await openPlanned(t, 'fibre-3kw-thin', 'lift.dxf', DRAWING);
  const machine = await machineSection(page, SIZES.desktop);
  const [moving, fly] = ['Begin cuts moving', 'Cut rows and grids on the run'].map((label) => machine.getByLabel(label, { exact: true }));
  await Promise.all([moving, fly].map((control) => control.evaluate((input) => input.click())));
  const states = async () => [await moving.isChecked(), await fly.isChecked()];
  assert.deepEqual(await states(), [true, true]);
  await page.keyboard.press('Control+z');
  assert.deepEqual(await states(), [true, false]);
  await page.keyboard.press('Control+z');
  assert.deepEqual(await states(), [false, false]);
});

for (const size of ['desktop', 'phone']) {
  test(`a switch says what else it changes, and why others are off, ${size}`, async (t) => {
    const page = await openPlanned(t, 'fibre-3kw-thin', 'lift.dxf', DRAWING, { size: SIZES[size], touch: size === 'phone' });
    const machine = await machineSection(page, SIZES[size]);
    const box = (label) => machine.getByLabel(label, { exact: true });
    const [partial, moving, fly, lift, tips] = ['Allow partial cuts', 'Begin cuts moving', 'Cut rows and grids on the run', 'Lift the head between cuts', 'Mind pieces that tip'].map(box);
    const note = machine.locator('.reason[role=status]');
    const below = (control) => control.locator('xpath=../following-sibling::*[1]').textContent();
    await replanned(page, () => moving.check());
    await replanned(page, () => fly.check());
    assert.equal(await note.count(), 0, 'these change nothing else');
    await replanned(page, () => tips.check());
    assert.equal(await below(tips), 'Also changed: Lift the head between cuts (on).');
    await replanned(page, () => partial.check());
    assert.equal(await below(partial), 'Also changed: Begin cuts moving (off), Cut rows and grids on the run (off), Moves over them (Only mark them).');
    assert.deepEqual([await lift.isChecked(), await tips.isChecked()], [true, true], 'what goes with partial cuts stays');
    assert.deepEqual([await moving.isDisabled(), await lift.isDisabled()], [true, false]);
    assert.equal(await moving.getAttribute('aria-description'), 'First switch off: Allow partial cuts.');
    assert.equal(await moving.locator('xpath=../following-sibling::*[1]').isVisible(), true, 'and says so without a pointer');
    assert.equal(await machine.getByLabel('Moves over them').isDisabled(), true);
    await partial.scrollIntoViewIfNeeded();
    await shot(page, `partial-${size}`);
    if (size === 'desktop') assert.deepEqual(Object.keys((await plan(page)).machine.levers).sort(), ['lift', 'tips']);
    await partial.focus();
    await page.keyboard.press('Control+z');
    await note.waitFor({ state: 'detached' });
    assert.deepEqual([await moving.isChecked(), await moving.isDisabled(), await moving.getAttribute('aria-description')], [true, false, '']);
  });
}
