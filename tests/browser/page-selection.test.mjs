// What is selected is kept together, held by micro-joints, and given a lead; each is listed, undone and taken back.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { circle, dxf, square } from '../package/support.mjs';
import { serious, shot } from './page-pictures.mjs';
import { openPlanned, plan, replanned, SIZES } from './page-support.mjs';

// Six plates in a row, each with a hole.
const DRAWING = dxf(Array.from({ length: 6 }, (_, k) => [...square(20 + 60 * k, 20, 40), ...circle(40 + 60 * k, 40, 8)]).flat());
const card = (page) => page.getByRole('region', { name: 'Selected contour' });
const titles = (page) => page.evaluate(() => [...document.querySelectorAll('.pins')].map((p) => p.firstChild.textContent));
const outlines = ({ contours }) => contours.filter((c) => c.inside === null).map((c) => c.id);
/** The contours in the order in which they are cut, each once. */
const order = ({ moves }) => [...new Set(moves.filter((m) => m.kind === 'cut').map((m) => m.contour))];

/** Selects the parts at these places of the row, by clicks between their outlines and their holes. */
async function select(page, ...places) {
  await page.keyboard.press('Escape');
  const box = await page.locator('#canvas').boundingBox();
  // The margins that the sheet is fitted into.
  const [left, right, top, bottom] = [40, 60, 60, 40];
  const scale = 0.94 * Math.min((box.width - left - right) / 340, (box.height - top - bottom) / 40);
  const [cx, cy] = [box.x + left + (box.width - left - right) / 2, box.y + top + (box.height - top - bottom) / 2];
  for (const k of places) {
    await page.keyboard.down('Control');
    await page.mouse.click(cx + (26 + 60 * k - 190) * scale, cy);
    await page.keyboard.up('Control');
  }
}

test('selected parts are kept together, held and given a lead, and all of it is taken back', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'row.dxf', DRAWING);
  await page.evaluate(() => document.querySelectorAll('.section').forEach((d) => (d.open = true)));
  const free = await plan(page);
  const ids = outlines(free);
  const group = [ids[0], ids[5]];

  await page.keyboard.press('Home');
  await page.keyboard.press('l');
  await page.keyboard.press('w');
  assert.match(await card(page).textContent(), /^6 parts, 12 contours/);
  await replanned(page, () => card(page).getByLabel('Joints').selectOption('2'));
  assert.deepEqual(await titles(page), ['Own micro-joints: 6 contours']);
  let document = await plan(page);
  assert.deepEqual(document.options.contours, ids.map((contour) => ({ contour, joints: 2 })).sort((a, b) => a.contour - b.contour));
  assert.equal(document.summary.joints, 12, 'two on each outline, none on the holes');
  assert.equal(await card(page).getByLabel('Joints').inputValue(), '2');
  await shot(page, 'selection-joints');

  await replanned(page, () => card(page).getByLabel('Lead').selectOption('Line'));
  assert.deepEqual(await titles(page), ['Own micro-joints: 6 contours', 'Own leads: 12 contours']);
  document = await plan(page);
  const begun = document.moves.filter((m, k) => m.kind === 'cut' && document.moves[k - 1]?.kind === 'pierce' && (m.lead_in ?? 0) > 0);
  assert.equal(new Set(begun.map((m) => m.contour)).size, 12);
  await replanned(page, () => card(page).getByLabel('Joints').selectOption('by rule'));
  await replanned(page, () => page.getByRole('button', { name: /^By rule: Own leads/ }).click());
  assert.deepEqual(await titles(page), []);
  assert.deepEqual((await plan(page)).options.contours, undefined);

  // The first and the last of the row: nothing would cut them one after the other.
  await select(page, 0, 5);
  assert.match(await card(page).textContent(), /^2 parts, 4 contours/);
  await replanned(page, () => card(page).getByRole('button', { name: 'Keep together' }).click());
  assert.deepEqual(await titles(page), ['Together: 2 contours']);
  assert.equal(await card(page).getByRole('button', { name: 'Keep together' }).getAttribute('aria-pressed'), 'true');
  document = await plan(page);
  assert.deepEqual(document.options.together.map((list) => list.toSorted((a, b) => a - b)), [group.toSorted((a, b) => a - b)]);
  const inGroup = (c) => group.includes(c) || group.includes(document.contours.find((k) => k.id === c).inside);
  const places = order(document).map((c, k) => (inGroup(c) ? k : -1)).filter((k) => k >= 0);
  assert.deepEqual(places, [0, 1, 2, 3].map((k) => places[0] + k), 'four contours, one after the other');
  assert.deepEqual(await serious(page), []);
  await shot(page, 'selection-together');
  await replanned(page, () => page.keyboard.press('u'));
  assert.deepEqual(await titles(page), []);
  await page.keyboard.press('Control+z');
  await page.waitForFunction(() => document.querySelector('.pins')?.textContent.startsWith('Together: '));
});

test('a group that cannot be is refused in a sentence, and everything stays', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'row.dxf', DRAWING);
  await page.evaluate(() => document.querySelectorAll('.section').forEach((d) => (d.open = true)));
  await select(page, 0, 1);
  await replanned(page, () => card(page).getByRole('button', { name: 'Keep this order' }).click());
  await select(page, 1, 2);
  await card(page).getByRole('button', { name: 'Keep together' }).click();
  await page.locator('.notice').getByText('are in one sequence, but not in the same group').waitFor();
  assert.deepEqual((await titles(page)).map((text) => text.replace(/\d+/, 'n')), ['In this order: n contours']);
  assert.equal((await plan(page)).options.together, undefined);
});

test('on a phone the card has room for joints and leads', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'row.dxf', DRAWING, { size: SIZES.phone, touch: true });
  await page.keyboard.press('Home');
  await page.keyboard.press('l');
  await page.keyboard.press('w');
  await shot(page, 'selection-phone');
  await card(page).getByRole('button', { name: 'More choices' }).tap();
  const lead = card(page).getByLabel('Lead');
  await lead.scrollIntoViewIfNeeded();
  assert.ok((await lead.boundingBox()).height >= 43.5);
  await replanned(page, () => lead.selectOption('None'));
  assert.equal(await card(page).getByLabel('Lead').inputValue(), 'None');
  await shot(page, 'selection-phone-lead');
});

test('Escape left the selecting of several on', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'row.dxf', DRAWING);
  const several = page.getByRole('button', { name: /^Select several/ });
  const isOn = () => several.getAttribute('aria-pressed');
  await page.keyboard.press('b');
  await page.keyboard.press('Home');
  assert.equal(await isOn(), 'true');
  await page.keyboard.press('Escape');
  assert.deepEqual([await card(page).isVisible(), await isOn()], [false, 'true'], 'first it clears the selection');
  await page.keyboard.press('Escape');
  assert.equal(await isOn(), 'false');
  await page.keyboard.press('Home');
  await page.keyboard.press('ArrowRight');
  assert.match(await card(page).textContent(), /^No\. 2 of 12/);
});
