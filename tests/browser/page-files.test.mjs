// Several files at once, the samples, and what a click with Shift or a key does to a contour.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { SAMPLES } from '../../scripts/samples.mjs';
import { beamRuns, grid, sample } from './page-drawings.mjs';
import { serious, shot } from './page-pictures.mjs';
import { drop, dropAll, machineSection, nextFrames, openPage, phase, plan, planned, replanned, SIZES } from './page-support.mjs';

const queue = (page) => page.locator('button.queue');
const told = (page, words) => page.waitForFunction((w) => document.querySelector('button.queue').textContent.startsWith(w), words);
const items = (page) => page.locator('.menu-item:visible').evaluateAll((all) => all.map((item) => [...item.children].map((c) => c.textContent)));

test('files dropped together are planned one after the other; each can be opened, and all programs downloaded', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  const drawings = [['one.dxf', grid(20)], ['broken.dxf', Buffer.from('AC1032\0\0')], ['asks.dxf', sample('no-units.dxf')], ['two.dxf', grid(30)], ['three.dxf', grid(40)]];
  await dropAll(page, drawings);
  await told(page, '3 of 5');
  assert.equal(await page.locator('.file-name').textContent(), 'three.dxf');
  await queue(page).click();
  const listed = Object.fromEntries(await items(page));
  for (const name of ['one.dxf', 'two.dxf', 'three.dxf']) assert.match(listed[name], /^Planned: [\d.]+ (s|min)/, name);
  assert.match(listed['broken.dxf'], /DWG/);
  assert.equal(listed['asks.dxf'], 'Needs an answer from you');
  await shot(page, 'page-queue');
  assert.deepEqual(await serious(page), []);

  const saved = [];
  const all = new Promise((resolve) => page.on('download', (d) => saved.push(d) === 3 && resolve()));
  await page.getByRole('button', { name: 'G-code of 3 of 5 files' }).click();
  await all;
  assert.deepEqual(saved.map((d) => d.suggestedFilename().replace(/\d{4}-\d\d-\d\d/, 'DATE')).sort(), ['one', 'three', 'two'].map((name) => `${name}-co2-100w-DATE.nc`));
  const programs = await Promise.all(saved.map(async (d) => [d.suggestedFilename(), readFileSync(await d.path(), 'utf8')]));
  for (const [name, program] of programs) assert.match(program, /M4/, name);
  assert.equal(new Set(programs.map(([, program]) => program)).size, 3);

  await page.getByRole('button', { name: /^asks\.dxf/ }).click();
  await planned(page, 'asks.dxf', 'question');
  await page.locator('.card.question button').first().click();
  await phase(page, 'done');
  await queue(page).click();
  // The program is written after the plan is done.
  await page.locator('.menu-item:visible', { hasText: 'asks.dxf' }).filter({ hasText: 'Planned' }).waitFor();
  await page.keyboard.press('Escape');

  // One alone makes no queue.
  await drop(page, 'alone.dxf', grid(10));
  await planned(page, 'alone.dxf');
  assert.equal(await queue(page).isVisible(), false);
});

test('the list of files said that all programs are downloaded where files have none, and those looked like the others', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  await dropAll(page, [['one.dxf', grid(20)], ['broken.dxf', Buffer.from('AC1032\0\0')], ['asks.dxf', sample('no-units.dxf')], ['two.dxf', grid(30)]]);
  // One waits for an answer and one cannot be read: they were counted as done.
  await told(page, '2 of 4');
  assert.equal(await queue(page).getAttribute('aria-label'), 'Files: 2 of 4 done');
  const color = (element) => getComputedStyle(element).color;
  const amber = await page.evaluate(() => {
    const probe = document.body.appendChild(document.createElement('i'));
    probe.style.color = 'var(--amber)';
    return getComputedStyle(probe).color;
  });
  assert.equal(await queue(page).evaluate(color), amber);
  await queue(page).click();
  const all = page.locator('.menu-foot button:visible');
  assert.deepEqual([await all.textContent(), await all.isEnabled()], ['G-code of 2 of 4 files', true]);
  const colors = await page.locator('.menu-item:visible').evaluateAll((items) => items.map((item) => getComputedStyle(item.lastElementChild).color));
  assert.deepEqual(colors.map((one) => one === amber), [false, true, true, false]);
  await page.keyboard.press('Escape');
  await dropAll(page, [['one.dxf', grid(20)], ['two.dxf', grid(30)]]);
  await told(page, '2 of 2');
  assert.notEqual(await queue(page).evaluate(color), amber);
  await queue(page).click();
  await page.getByRole('button', { name: 'G-code of all files' }).waitFor();
});

test('on a phone the list of files fits beside the rest', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone, hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  await dropAll(page, [['a-plate-with-a-long-name.dxf', grid(20)], ['b.dxf', grid(30)]]);
  await told(page, '2 of 2');
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), SIZES.phone.width);
  const boxes = await page.locator('.top button:visible').evaluateAll((all) => all.map((b) => b.getBoundingClientRect()).map((r) => [r.left, r.right]));
  boxes.sort((a, b) => a[0] - b[0]);
  boxes.slice(1).forEach(([left], k) => assert.ok(left >= boxes[k][1] - 1, JSON.stringify(boxes)));
  const narrow = await page.locator('.top button:visible').evaluateAll((all) => all.filter((b) => b.scrollWidth > b.clientWidth + 1).map((b) => b.textContent));
  assert.deepEqual(narrow, [], 'nothing is wider than its button');
  await queue(page).click();
  await shot(page, 'page-queue-phone');
});

test('the samples are those of scripts/samples.mjs, and each shows what it says', async (t) => {
  for (const [file, content] of Object.entries(SAMPLES)) assert.equal(sample(file).toString(), content, `${file}: node scripts/samples.mjs`);
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  const take = async (title, file, ...phases) => {
    await page.getByRole('button', { name: 'Samples' }).click();
    await page.locator('.menu-item', { has: page.getByText(title, { exact: true }) }).click();
    await planned(page, file, ...phases);
    await page.evaluate(() => document.querySelectorAll('.section').forEach((d) => (d.open = d.textContent.startsWith('Drawing'))));
    await shot(page, `page-sample-${file.replace('.dxf', '')}`);
    return page.locator('.section').first().textContent();
  };
  const careless = await take('Gaps, copies, crossings', 'gaps-and-copies.dxf');
  for (const words of ['4 gaps in this contour were closed', 'duplicates removed', 'lies on top of other lines', 'Two contours cross', 'does not close', 'TEXT left out']) assert.ok(careless.includes(words), words);
  assert.match(await take('Layers', 'layers.dxf'), /ENGRAVE.*DIMENSIONS/);
  await take('Uncertain units', 'no-units.dxf', 'question');
  await page.locator('.card.question button').first().click();
  assert.match(await take('Parts in parts', 'parts-in-parts.dxf'), /15 parts/);
  assert.match(await take('Luggage tags, SVG', 'luggage-tags.svg'), /6 parts.*SVG 1\.1.*“Engrave” looks like a layer to mark/);
});

test('a sample of an ability comes with a machine that has it, and the next drawing has the own one again', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  const open = async (title, file) => {
    await page.getByRole('button', { name: 'Samples' }).click();
    await page.locator('.menu-item', { has: page.getByText(title, { exact: true }) }).click();
    await planned(page, file, 'done');
    await shot(page, `page-sample-${file.replace('.dxf', '')}`);
    return plan(page);
  };
  const own = (await plan(page)).machine;
  const perforated = await open('Perforated plate', 'perforated.dxf');
  assert.equal(perforated.machine.name, 'fibre-3kw-thin');
  // All but the first of 18 holes in a row follow on the run, and sides of square holes line by line.
  assert.ok(perforated.summary.fly_cuts >= 14 * 17, String(perforated.summary.fly_cuts));
  const held = await open('Leads and joints', 'held-plates.dxf');
  assert.equal(held.machine.levers, undefined);
  assert.ok(held.summary.lead_length > 0 && held.summary.joints > 0, JSON.stringify(held.summary));
  const tips = await open('Pieces that tip', 'tips-and-skeleton.dxf');
  assert.ok(tips.summary.lifts + tips.summary.detours > 0 && tips.summary.skeleton_cuts > 0, JSON.stringify(tips.summary));
  assert.equal(tips.summary.crossings ?? 0, 0);
  assert.deepEqual((await open('Parts in parts', 'parts-in-parts.dxf')).machine, own);
  // A change makes the machine the person's own.
  await open('Perforated plate', 'perforated.dxf');
  const machine = await machineSection(page, SIZES.desktop);
  await replanned(page, () => machine.getByLabel('Longest way between two cuts').fill('30'));
  assert.deepEqual((await open('Parts in parts', 'parts-in-parts.dxf')).machine.levers, { fly: { reach: 30, overcut: 0 } });
});

test('a click with Shift or a key pins a contour; the list unpins it, undo pins it again', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  await drop(page, 'rings.dxf', sample('parts-in-parts.dxf'));
  await planned(page, 'rings.dxf', 'done');
  await page.evaluate(() => document.querySelectorAll('.section').forEach((d) => (d.open = d.textContent.startsWith('Drawing'))));
  const until = (words) => page.waitForFunction((w) => [...document.querySelectorAll('.pins')].map((p) => p.firstChild.textContent).join() === w, words);

  await page.keyboard.press('End');
  // With the new order there, the last one is another.
  await replanned(page, () => page.keyboard.press('1'));
  await until('Cut first: 1 contour');
  await page.keyboard.press('End');
  await page.keyboard.press('0');
  await until('Cut first: 1 contour,Cut last: 1 contour');
  await page.getByRole('button', { name: 'Unpin contours that are cut first' }).click();
  await until('Cut last: 1 contour');
  await page.keyboard.press('Escape');
  await page.locator('body').press('Control+z');
  await until('Cut first: 1 contour,Cut last: 1 contour');
  await page.locator('body').press('Control+Shift+z');
  await until('Cut last: 1 contour');

  // The pointer finds where a contour is on the screen.
  const box = await page.locator('#canvas').boundingBox();
  let at = null;
  for (let x = 60; x < box.width - 60 && at === null; x += 3) {
    await page.mouse.move(box.x + x, box.y + box.height / 2);
    if (await page.locator('#canvas.over').count()) at = [box.x + x, box.y + box.height / 2];
  }
  assert.ok(at, 'a contour under the pointer');
  await page.keyboard.down('Shift');
  await page.mouse.click(...at);
  await page.keyboard.up('Shift');
  await page.waitForFunction(() => document.querySelector('.pins')?.textContent.startsWith('Cut first: 1 contour'));
  await shot(page, 'page-pins');
});

/** Runs in the page: a file whose name begins with "slow" is read when the test releases it, each time that it is read. */
const slowly = () => {
  window.reads = [];
  const { arrayBuffer } = Blob.prototype;
  Blob.prototype.arrayBuffer = async function () {
    if (this.name?.startsWith('slow')) await new Promise((release) => window.reads.push(release));
    return arrayBuffer.call(this);
  };
};

/** Waits until a slow file is being read for so many times. */
const readings = (page, count) => page.waitForFunction((n) => window.reads.length === n, count);

/** Lets one of the readings of slow files end, and gives the page time to go on with it. */
async function release(page, index) {
  await page.evaluate((k) => window.reads[k](), index);
  await nextFrames(page, 10);
}

const shown = (page) => page.evaluate(() => [document.querySelector('.file-name').textContent, document.body.dataset.phase]);

test('a file that is read slowly does not replace a file or a sample that was chosen later', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4', prepare: slowly });
  await phase(page, 'done');
  await drop(page, 'slow.dxf', grid(20));
  await readings(page, 1);
  await drop(page, 'later.dxf', grid(9));
  await planned(page, 'later.dxf', 'done');
  await release(page, 0);
  assert.deepEqual(await shown(page), ['later.dxf', 'done']);

  await drop(page, 'slow.dxf', Buffer.from('no drawing'));
  await readings(page, 2);
  await page.getByRole('button', { name: 'Samples' }).click();
  await page.locator('.menu-item', { has: page.getByText('Layers', { exact: true }) }).click();
  await planned(page, 'layers.dxf', 'done');
  await release(page, 1);
  assert.deepEqual(await shown(page), ['layers.dxf', 'done']);
  assert.equal(await page.locator('.failure').isVisible(), false, 'nor is it refused over the drawing chosen later');
});

/** Runs in the page: the sample of a first visit arrives when the test sends it. */
const lateSample = () => {
  const { fetch } = window;
  window.fetch = async (what, ...others) => {
    if (String(what).includes('sheet_500')) await new Promise((send) => (window.sendSample = send));
    return fetch(what, ...others);
  };
};

test('what the page begins with does not replace a file that was dropped before and is read slowly', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4', prepare: `(${slowly})(); (${lateSample})();` });
  await page.waitForFunction(() => window.sendSample !== undefined && document.querySelector('.dock') !== null);
  await drop(page, 'slow.dxf', grid(20));
  await readings(page, 1);
  await page.evaluate(() => window.sendSample());
  await nextFrames(page, 20);
  await release(page, 0);
  await planned(page, 'slow.dxf', 'done');
});

test('in a queue, a file that is read slowly is not planned under the name of another that was opened meanwhile', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=2', prepare: slowly });
  await phase(page, 'done');
  await dropAll(page, [['slow.dxf', grid(20)], ['other.dxf', grid(30)]]);
  await readings(page, 1);
  await queue(page).click();
  // Opened again while it is being read: the first reading says nothing any more.
  await page.getByRole('button', { name: /^slow/ }).click();
  await readings(page, 2);
  await release(page, 0);
  assert.deepEqual(await shown(page), ['sheet_500.dxf', 'done']);
  await queue(page).click();
  assert.equal(Object.fromEntries(await items(page))['slow.dxf'], 'Planning');
  await page.getByRole('button', { name: /^other/ }).click();
  await planned(page, 'other.dxf', 'planning');
  await release(page, 1);
  await readings(page, 3);
  await release(page, 2);
  await told(page, '2 of 2');
  await queue(page).click();
  const saved = [];
  const both = new Promise((resolve) => page.on('download', (d) => saved.push(d) === 2 && resolve()));
  await page.getByRole('button', { name: 'G-code of all files' }).click();
  await both;
  const cuts = await Promise.all(saved.map(async (d) => [d.suggestedFilename().split('-')[0], beamRuns(readFileSync(await d.path(), 'utf8')).length]));
  assert.deepEqual(Object.fromEntries(cuts), { slow: 20, other: 30 });
});

test('a file that cannot be used leaves the one before it open: its question is answered, and it counts as planned', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  await dropAll(page, [['asks.dxf', sample('no-units.dxf')], ['broken.dxf', Buffer.from('AC1032\0\0')]]);
  await page.locator('.failure').getByRole('button', { name: 'Close' }).click();
  await queue(page).click();
  assert.match(await page.locator('.menu-item[aria-current]:visible').textContent(), /^asks\.dxf/);
  await page.keyboard.press('Escape');
  await page.locator('.card.question .choices button').first().click();
  await phase(page, 'done');
  await queue(page).click();
  await page.locator('.menu-item:visible', { hasText: 'asks.dxf' }).filter({ hasText: 'Planned' }).waitFor();
  assert.match(Object.fromEntries(await items(page))['broken.dxf'], /DWG/);
});
