// Parts instead of contours: several are selected and decided at once, lists and the table of the order are dragged, copies are counted.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { shot } from './page-pictures.mjs';
import { download, drop, openPage, phase, planned, replanned, SIZES, tap } from './page-support.mjs';

const card = (page) => page.getByRole('region', { name: 'Selected contour' });
const pins = (page) => page.evaluate(() => [...document.querySelectorAll('.pins')].map((p) => p.firstChild.textContent));
const pinned = (page, wanted) => page.waitForFunction((w) => [...document.querySelectorAll('.pins')].map((p) => p.firstChild.textContent).join() === w, wanted);
const openDrawing = (page) => page.evaluate(() => document.querySelectorAll('.section').forEach((d) => (d.open = d.textContent.startsWith('Drawing'))));

/** The contours of the plan in the order in which they are cut. */
async function order(page) {
  await page.evaluate(() => document.querySelectorAll('.section').forEach((d) => (d.open = d.textContent.startsWith('Result'))));
  const plan = JSON.parse((await download(page, () => page.getByRole('button', { name: 'Plan (JSON)' }).click())).bytes);
  return [...new Set(plan.moves.filter((m) => m.kind === 'cut').map((m) => m.contour))];
}

/** Twelve copies of a bracket with two holes, turned in steps of a right angle and every third one mirrored, and five squares of different sizes. */
function brackets() {
  const text = ['0', 'SECTION', '2', 'HEADER', '9', '$INSUNITS', '70', 4, '0', 'ENDSEC', '0', 'SECTION', '2', 'ENTITIES'];
  const polygon = (points) => text.push('0', 'LWPOLYLINE', '8', 'CUT', '90', points.length, '70', 1, ...points.flatMap(([x, y]) => ['10', x, '20', y]));
  for (let i = 0; i < 12; i += 1) {
    const at = ([x, y]) => {
      const [mx, my] = [i % 3 === 0 ? -x : x, y];
      const [tx, ty] = [[mx, my], [-my, mx], [-mx, -my], [my, -mx]][i % 4];
      return [60 + 80 * (i % 4) + tx, 60 + 80 * Math.floor(i / 4) + ty];
    };
    polygon([[-30, -20], [30, -20], [30, 0], [0, 0], [0, 20], [-30, 20]].map(at));
    for (const [hole, r] of [[[-15, 10], 5], [[15, -10], 4]]) text.push('0', 'CIRCLE', '8', 'CUT', '10', at(hole)[0], '20', at(hole)[1], '40', r);
  }
  for (let i = 0; i < 5; i += 1) polygon([[0, 0], [10 + 3 * i, 0], [10 + 3 * i, 10 + 3 * i], [0, 10 + 3 * i]].map(([x, y]) => [30 + 60 * i + x, 270 + y]));
  text.push('0', 'ENDSEC', '0', 'EOF');
  return Buffer.from(`${text.join('\n')}\n`);
}

/** Opens the brackets and waits for their plan. */
async function opened(t, options) {
  const { page } = await openPage(t, { hash: 'seconds=0.4', ...options });
  await phase(page, 'planning', 'done');
  await drop(page, 'own.dxf', brackets());
  await planned(page, 'own.dxf', 'done');
  return page;
}

/** Drags from one place to another in steps. */
async function dragMouse(page, [x0, y0], [x1, y1]) {
  await page.mouse.move(x0, y0);
  await page.mouse.down();
  for (let k = 1; k <= 6; k += 1) await page.mouse.move(x0 + ((x1 - x0) * k) / 6, y0 + ((y1 - y0) * k) / 6);
  await page.mouse.up();
}

const middle = async (locator) => {
  const box = await locator.boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};

test('parts are selected by click, by box and as copies, and decided all at once', async (t) => {
  const page = await opened(t);
  await openDrawing(page);
  // Copies are counted, and a click selects all of them.
  await page.getByText('17 parts, 6 shapes').waitFor();
  const copies = page.locator('.copies button').first();
  assert.equal(await copies.textContent(), '12 pcs, 60 × 40 mm');
  const n = 12;
  await copies.click();
  assert.match(await card(page).textContent(), new RegExp(`^${n} parts`));
  await card(page).getByRole('button', { name: 'Cut last' }).click();
  await pinned(page, `Cut last: ${n} contours`);
  await phase(page, 'done');
  await card(page).getByRole('button', { name: 'Cut last' }).click();
  await pinned(page, '');
  await phase(page, 'done');
  await page.keyboard.press('Escape');

  // From a hole to its part, and from the part to all like it.
  await page.keyboard.press('Home');
  assert.match(await card(page).textContent(), /The job begins here/);
  await page.keyboard.press('w');
  assert.match(await card(page).textContent(), /^1 part, \d+ contours/);
  // A part comes first as a whole: that is said of its outline alone, and shown for all that is selected.
  const first = card(page).getByRole('button', { name: 'Cut first' });
  assert.equal(await first.getAttribute('aria-pressed'), 'false');
  await replanned(page, () => first.click());
  assert.equal(await first.getAttribute('aria-pressed'), 'true');
  await replanned(page, () => first.click());
  assert.equal(await first.getAttribute('aria-pressed'), 'false');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Home');
  const like = card(page).getByRole('button', { name: /^All \d+ like this$/ });
  const [, many] = /All (\d+)/.exec(await like.textContent());
  await page.keyboard.press('l');
  assert.match(await card(page).textContent(), new RegExp(`^${many} contours`));
  assert.ok([12, 24].includes(Number(many)), 'all holes of that size, or all outlines');

  // A box around everything selects everything; Escape clears it.
  await page.keyboard.press('Escape');
  const stage = await page.locator('#canvas').boundingBox();
  await page.keyboard.down('Shift');
  await dragMouse(page, [stage.x + 8, stage.y + 8], [stage.x + stage.width - 60, stage.y + stage.height - 8]);
  await page.keyboard.up('Shift');
  await page.waitForFunction(() => /^\d+ (parts|contours)/.test(document.querySelector('.contour').textContent));
  assert.match(await card(page).textContent(), /^17 parts, 41 contours/);
  await shot(page, 'parts-box');
  await page.keyboard.press('Escape');

  // Whole parts are marked and skipped.
  await copies.click();
  await card(page).getByRole('button', { name: 'Mark' }).click();
  await page.waitForFunction(() => /^Marked: /.test(document.querySelector('.pins')?.textContent ?? ''));
  await phase(page, 'done');
  await page.keyboard.press('x');
  await page.waitForFunction(() => /^Skipped: /.test(document.querySelector('.pins')?.textContent ?? ''));
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => /^Marked: /.test(document.querySelector('.pins')?.textContent ?? ''));
});

test('lists of what is cut first and the table of the order are dragged, by mouse and by keyboard, and the plan keeps them', async (t) => {
  const page = await opened(t);
  await openDrawing(page);
  const copies = page.locator('.copies button').first();
  await copies.click();
  await page.keyboard.press('1');
  await page.locator('.sortable').waitFor();
  await phase(page, 'done');
  await page.keyboard.press('Escape');
  const names = () => page.locator('.sortable .name').allTextContents();
  const first = await names();
  await dragMouse(page, await middle(page.locator('.sortable .grip').first()), (([x, y]) => [x, y + 4])(await middle(page.locator('.sortable li').nth(1))));
  const swapped = [first[1], first[0], ...first.slice(2)];
  await page.waitForFunction((w) => [...document.querySelectorAll('.sortable .name')].map((e) => e.textContent).join() === w, swapped.join());
  await phase(page, 'done');
  assert.equal(await page.getByRole('button', { name: 'In this order' }).getAttribute('aria-pressed'), 'true');
  // By keyboard: the handle keeps the focus while its row moves.
  await page.locator('.sortable .grip').first().focus();
  await page.keyboard.press('ArrowDown');
  await page.waitForFunction((w) => [...document.querySelectorAll('.sortable .name')].map((e) => e.textContent).join() === w, first.join());
  await page.waitForFunction(() => document.activeElement?.dataset.grip === 'first-1');
  await shot(page, 'parts-first');
  await phase(page, 'done');
  const ids = await page.locator('.sortable .name').evaluateAll((list) => list.map((e) => Number(e.getAttribute('aria-label').match(/\d+/)[0])));
  const cut = await order(page);
  assert.deepEqual(cut.filter((c) => ids.includes(c)), ids, 'they are cut in the order of the list');
  await openDrawing(page);
  await page.getByRole('button', { name: 'Unpin contours that are cut first' }).click();
  await pinned(page, '');
  await phase(page, 'done');

  // A row of the table, from the end to the third place.
  await page.keyboard.press('t');
  const rows = page.locator('.rows .order-row');
  const at = async (row) => Number(await rows.nth(row).getAttribute('data-stop'));
  assert.equal(await at(0), 0);
  const before = await order(page);
  await dragMouse(page, await middle(rows.nth(9).locator('.grip')), (([x, y]) => [x, y - 14])(await middle(rows.nth(2).locator('.grip'))));
  await openDrawing(page);
  await page.waitForFunction(() => /^In this order: /.test(document.querySelector('.pins')?.textContent ?? ''));
  assert.deepEqual((await pins(page)).map((p) => p.replace(/\d+/, 'n')), ['In this order: n contours']);
  await shot(page, 'parts-table');
  await phase(page, 'done');
  const after = await order(page);
  const place = (list, c) => list.indexOf(c);
  assert.ok(place(after, before[1]) < place(after, before[9]) && place(after, before[9]) < place(after, before[2]), 'it is cut between its new neighbours');
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => document.querySelector('.pins') === null);
});

test('on a phone several parts are selected by touch, and their list is dragged by finger', async (t) => {
  const page = await opened(t, { size: SIZES.phone, touch: true });
  const client = await page.context().newCDPSession(page);
  const touch = (type, points) => client.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y]) => ({ x, y })) });
  const drag = async ([x0, y0], [x1, y1]) => {
    await touch('touchStart', [[x0, y0]]);
    for (let k = 1; k <= 6; k += 1) await touch('touchMove', [[x0 + ((x1 - x0) * k) / 6, y0 + ((y1 - y0) * k) / 6]]);
    await touch('touchEnd', []);
  };
  await tap(page.getByRole('button', { name: /^Select several/ }));
  const stage = await page.locator('#canvas').boundingBox();
  await drag([stage.x + 4, stage.y + 4], [stage.x + stage.width - 4, stage.y + stage.height - 70]);
  await page.waitForFunction(() => /^\d+ (parts|contours)/.test(document.querySelector('.contour').textContent));
  await shot(page, 'parts-phone');
  await tap(page.getByRole('button', { name: /^Select several/ }));
  // The drawing is read again first: until then, the phase is still that of the plan before.
  await replanned(page, () => tap(card(page).getByRole('button', { name: 'Cut first' })));
  await tap(card(page).getByRole('button', { name: 'Close' }));
  await tap(page.locator('.sheet-toggle'));
  await openDrawing(page);
  await page.locator('.sortable .grip').first().evaluate((grip) => grip.scrollIntoView({ block: 'center' }));
  const names = () => page.locator('.sortable .name').allTextContents();
  const first = await names();
  await drag(await middle(page.locator('.sortable .grip').nth(0)), (([x, y]) => [x, y + 6])(await middle(page.locator('.sortable .grip').nth(1))));
  await page.waitForFunction((w) => document.querySelector('.sortable .name').textContent === w, first[1]);
  await shot(page, 'parts-phone-list');
});
