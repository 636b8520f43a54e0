// Before and after: other orders on the sheet, side by side, what each decision saves; downloads and the clipboard; the chart of a new file.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid, sample } from './page-drawings.mjs';
import { changedFrom, serious, shot, still } from './page-pictures.mjs';
import { download, drop, machineSection, openPage, openPlanned, phase, planned, replanned, SIZES } from './page-support.mjs';

const total = (page) => page.locator('#playback .whole').textContent();
/** Seconds of "627 s", "1:52.1", "16:40" and "1:02:03". */
const inSeconds = (text) => (/ s$/.test(text) ? Number(text.replace(/[^\d.]/g, '')) : text.replace(/[^\d:.]/g, '').split(':').reduce((sum, n) => 60 * sum + Number(n), 0));
const row = (page, name) => page.locator('.compare tbody').filter({ hasText: name }).locator('td.number').first().textContent();

for (const [name, size] of Object.entries(SIZES)) {
  test(`the sheet shows the other orders, alone and side by side (${name})`, async (t) => {
    const narrow = size === SIZES.phone;
    const { page } = await openPage(t, { size, touch: narrow, hash: 'seconds=0.4' });
    await phase(page, 'planning', 'done');
    await drop(page, 'rings.dxf', sample('parts-in-parts.dxf'));
    await planned(page, 'rings.dxf', 'done');
    const orders = page.getByRole('group', { name: 'Before and after' });
    const now = await still(page);
    const jobs = {};
    for (const [label, line] of [['Nearest', 'Nearest first'], ['As drawn', 'As drawn'], ['Now', 'Now']]) {
      await orders.getByRole('button', { name: label, exact: true }).click();
      jobs[line] = inSeconds(await row(page, line));
      await page.waitForFunction((s) => Math.abs(document.querySelector('#playback .whole').textContent.replace(/[^\d:.]/g, '').split(':').reduce((sum, n) => 60 * sum + Number(n), 0) - s) < 1, jobs[line]);
      if (label !== 'Now') await changedFrom(page, now);
    }
    assert.ok(jobs.Now <= jobs['Nearest first'] && jobs['Nearest first'] <= jobs['As drawn'] + 60);
    await orders.getByRole('button', { name: 'Show side by side with the plan' }).click();
    await page.locator('.second').waitFor();
    await page.waitForFunction(() => /Nearest first · /.test(document.querySelector('.second-label').textContent));
    const [left, right] = await Promise.all(['#canvas', '.second'].map((c) => page.locator(c).boundingBox()));
    assert.deepEqual([left.width, left.height], [right.width, right.height], 'both have the same size');
    await page.evaluate(() => document.activeElement.blur());
    await page.keyboard.press(' ');
    await page.waitForFunction(() => { const v = Number(document.querySelector('#playback input').value); return v > 1500 && v < 9000; });
    await page.keyboard.press(' ');
    await still(page);
    await shot(page, `beside-${name}`);
    assert.deepEqual(await serious(page), []);
    await orders.getByRole('button', { name: 'Show side by side with the plan' }).click();
    await page.locator('.second').waitFor({ state: 'hidden' });
    assert.match(await total(page), /\d/);
  });
}

test('side by side, only the first sheet showed the bed', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4&machine=co2-100w&units=mm' });
  await phase(page, 'planning', 'done');
  // The bed is far larger than the job, so nothing but its lower edge reaches the right end of the sheet.
  await drop(page, 'grid.dxf', grid(12));
  await planned(page, 'grid.dxf', 'done');
  await page.getByRole('button', { name: 'Show side by side with the plan' }).click();
  await page.waitForFunction(() => /Nearest first · /.test(document.querySelector('.second-label').textContent));
  await still(page);
  const edges = () => page.evaluate(() => ['#canvas', '.second'].map((name) => {
    const canvas = document.querySelector(name);
    const { data } = canvas.getContext('2d').getImageData(canvas.width - 12, 0, 12, canvas.height);
    const ground = data.slice(0, 3);
    return data.filter((value, i) => i % 4 === 0 && value !== ground[0]).length;
  }));
  const [first, second] = await edges();
  assert.ok(first > 0, 'the bed is on the first sheet');
  assert.equal(second, first);
});

test('side by side, the name of the first sheet lay over the choice of the order while a drawing was invited', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4', size: { width: 1024, height: 768 } });
  await phase(page, 'done');
  await page.getByRole('button', { name: 'Show side by side with the plan' }).click();
  await page.waitForFunction(() => /Now · /.test(document.querySelector('.first-label').textContent));
  const [orders, label] = await Promise.all(['.orders', '.first-label'].map((name) => page.locator(name).boundingBox()));
  assert.ok(orders.y + orders.height <= label.y || orders.x + orders.width <= label.x, JSON.stringify({ orders, label }));
});

/** Most times that a search is continued. */
const SEARCHES = 40;

test('side by side, the times of the drawing before and of an older plan were shown', async (t) => {
  // On this machine the job takes so short that tenths of a second are shown, and so brief a search leaves something to find.
  const { page } = await openPage(t, { hash: 'machine=fibre-3kw-thin&seconds=0.05&seed=1' });
  await phase(page, 'done');
  const split = page.getByRole('button', { name: 'Show side by side with the plan' });
  const labels = () => ['.first-label', '.second-label'].map((name) => document.querySelector(name).textContent);
  await split.click();
  await page.waitForFunction(() => /Nearest first · /.test(document.querySelector('.second-label').textContent));
  const now = () => row(page, 'Now');
  const before = await now();
  await page.evaluate(() => document.activeElement.blur());
  for (let more = 0; more < SEARCHES && (await now()) === before; more++) {
    await replanned(page, () => page.keyboard.press('k'));
  }
  assert.notEqual(await now(), before, 'a better path was found');
  assert.equal(await page.locator('.first-label').textContent(), `Now · ${await now()}`);
  await drop(page, 'grid.dxf', grid(20));
  await planned(page, 'grid.dxf', 'done');
  const [first, second] = await page.evaluate(`(() => { document.querySelector('.split-toggle').click(); return (${labels})(); })()`);
  assert.deepEqual([first, second], ['', '']);
  await page.waitForFunction(() => /Nearest first · \d[\d.]* s/.test(document.querySelector('.second-label').textContent));
  assert.equal(await page.locator('.first-label').textContent(), `Now · ${await now()}`);
});

test('the table of the cutting order and two sheets side by side end each other; together they left the stage blank', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  const split = page.getByRole('button', { name: 'Show side by side with the plan' });
  const table = page.getByRole('table', { name: 'Cutting order' });
  const pressed = () => page.evaluate(() => ['.split-toggle', '.tools [title="Cutting order"]'].map((name) => document.querySelector(name).getAttribute('aria-pressed')));
  await page.keyboard.press('t');
  await table.waitFor();
  await split.click();
  await page.locator('.second').waitFor();
  assert.equal(await table.isVisible(), false);
  assert.deepEqual(await pressed(), ['true', 'false']);
  assert.equal(await split.evaluate((e) => e === document.activeElement), true, 'the focus stays on the button');
  const beside = await still(page);
  await page.keyboard.press('t');
  await table.waitFor();
  await page.locator('.second').waitFor({ state: 'hidden' });
  assert.deepEqual(await pressed(), ['false', 'true']);
  await changedFrom(page, beside);
  await page.getByRole('button', { name: 'Close the table' }).click();
  assert.equal(await page.evaluate(() => document.activeElement.title), 'Cutting order');
});

test('what each kind of decision saves is worked out by leaving it out', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'done');
  await page.evaluate(() => [...document.querySelectorAll('details.more')].find((d) => d.textContent.startsWith('What saves what')).setAttribute('open', ''));
  await page.getByRole('button', { name: 'Work it out' }).click();
  await page.getByText('Plans without a decision were searched').waitFor();
  const lines = await page.locator('.savings').evaluate((list) => [...list.children].map((e) => e.textContent));
  assert.equal(lines[0], 'Order, instead of nearest first');
  assert.match(lines[1], /^saves [\d.:]+/);
  assert.equal(lines[2], 'Entries, instead of where lines begin');
  assert.match(lines[3], /^saves [\d.:]+/);
  const gain = inSeconds(await row(page, 'Nearest first')) - inSeconds(await row(page, 'Now'));
  assert.ok(Math.abs(inSeconds(lines[1].replace('saves ', '')) - gain) < 2, 'the order saves what the headline says');
  await shot(page, 'savings');
});

test('the program is copied, its download carries file, machine and date, and a new file starts the chart anew', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write']);
  await phase(page, 'done');
  const begun = Date.now();
  await drop(page, 'plate.dxf', grid(40));
  await planned(page, 'plate.dxf', 'done');
  const most = (Date.now() - begun) / 1000;
  const copy = page.getByRole('button', { name: 'Copy', exact: true });
  await page.waitForFunction(() => !document.querySelector('.preflight').hidden);
  await copy.click();
  await page.getByText('on the clipboard').waitFor();
  const file = await download(page, () => page.locator('.dock').getByRole('button', { name: 'G-code' }).click());
  assert.match(file.name, /^plate-co2-100w-\d{4}-\d\d-\d\d\.nc$/);
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), file.bytes.toString());
  const label = await page.locator('.chart').getAttribute('aria-label');
  const [, first, seconds, nearest] = /from (.+) to .+ in ([\d.]+) s\..* nearest first (.+)\.$/.exec(label);
  assert.equal(first, nearest, 'the chart begins with the first path of this drawing');
  // The search before took a second as well; a busy machine may take longer than asked for.
  assert.ok(Number(seconds) < Math.min(most, Math.max(1.9, most - 1)) + 0.1, `the chart counts the seconds of this search only: ${seconds} of ${most}`);
});

test('what a decision saves is searched for its whole time, also when another order is asked for meanwhile', async (t) => {
  const page = await openPlanned(t, 'fibre-3kw-thin', 'holes.dxf', grid(150), { hash: 'machine=fibre-3kw-thin&seconds=4&seed=1&units=mm' });
  const machine = await machineSection(page, SIZES.desktop);
  await replanned(page, () => machine.getByLabel('Cut rows and grids on the run').check());
  await page.evaluate(() => [...document.querySelectorAll('details.more')].find((d) => d.textContent.startsWith('What saves what')).setAttribute('open', ''));
  await page.getByRole('button', { name: 'Work it out' }).click();
  // The first line needs no search; the next one has begun by then.
  await page.locator('.savings dd').first().waitFor();
  const begun = Date.now();
  await page.getByRole('group', { name: 'Before and after' }).getByRole('button', { name: 'Nearest', exact: true }).click();
  await page.getByText('Plans without a decision were searched').waitFor();
  assert.ok(Date.now() - begun > 3500, `4 seconds of search took ${Date.now() - begun} ms`);
  assert.equal(await page.locator('.savings dt').nth(1).textContent(), 'Cuts on the run');
});
