// What the page decides about a drawing and asks a person: the border of the sheet, lettering, pixels; and a job from an SVG file.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { shot } from './page-pictures.mjs';
import { download, drop, openPage, phase, planned, SIZES } from './page-support.mjs';

const drawing = (...entities) => Buffer.from(['0', 'SECTION', '2', 'HEADER', '9', '$INSUNITS', '70', '4', '0', 'ENDSEC', '0', 'SECTION', '2', 'ENTITIES', ...entities.flat(), '0', 'ENDSEC', '0', 'EOF', ''].join('\n'));
const path = (points, closed, layer = '0') => ['0', 'LWPOLYLINE', '8', layer, '90', points.length, '70', closed ? 1 : 0, ...points.flatMap(([x, y]) => ['10', x, '20', y])];
const box = (x, y, w, h) => path([[x, y], [x + w, y], [x + w, y + h], [x, y + h]], true);
const circle = (x, y, r) => ['0', 'CIRCLE', '8', '0', '10', x, '20', y, '40', r];

/** A picture frame with a part in its opening, of no size in which sheets are sold. */
const FRAME = drawing(box(10, 10, 310, 215), box(30, 30, 270, 175), circle(110, 110, 20));

/** A plate with a hole, twelve letters of a one-stroke font and a line that leads from them to the hole. */
const LETTERED = drawing(box(10, 10, 200, 80), circle(160, 50, 2), path([[76, 32], [157, 49]], false),
  ...Array.from({ length: 12 }, (_, k) => path([[0, 0], [0, 4], [2.5, 0], [2.5, 4]].map(([x, y]) => [30 + 4 * k + x, 30 + y]), false)));

/** Nothing says how large a pixel is. */
const PIXELS = Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="400" height="300"><rect x="10" y="10" width="380" height="280" fill="none" stroke="red"/><circle cx="60" cy="60" r="20" fill="none" stroke="red"/></svg>');

/** Opens the section of the drawing with its findings, and no other. */
const showFindings = (page) => page.evaluate(() => {
  document.querySelectorAll('.section').forEach((section, k) => (section.open = k === 0));
  document.querySelectorAll('.section:first-of-type details').forEach((details) => (details.open = true));
});
const gist = (page) => page.locator('.section').first().textContent();

for (const [name, size] of Object.entries(SIZES)) {
  test(`a frame that may be the sheet is asked about once, and the answer can be taken back (${name})`, async (t) => {
    const { page } = await openPage(t, { size, hash: 'seconds=0.4' });
    await phase(page, 'planning', 'done');
    await drop(page, 'frame.dxf', FRAME);
    await phase(page, 'question');
    const card = page.getByRole('region', { name: 'Is the rectangle around everything a cut?' });
    await card.waitFor();
    assert.match(await card.textContent(), /1 part lies inside it/);
    await shot(page, `page-border-${name}`);
    await card.getByRole('button', { name: /it is the sheet/ }).click();
    await planned(page, 'frame.dxf');
    assert.match(await gist(page), /1 part/);
    if (size === SIZES.phone) return;
    await showFindings(page);
    await page.getByRole('button', { name: 'Cut the border' }).click();
    await page.getByRole('button', { name: 'Ignore the border' }).waitFor();
    await planned(page, 'frame.dxf');
    assert.match(await gist(page), /2 parts/);
    assert.equal(await card.isVisible(), false, 'it is not asked again');
  });

  test(`lettering is one finding with its choices (${name})`, async (t) => {
    const { page } = await openPage(t, { size, hash: 'seconds=0.4' });
    await phase(page, 'planning', 'done');
    await drop(page, 'lettered.dxf', LETTERED);
    // Findings are listed again when those of the plan arrive.
    await planned(page, 'lettered.dxf', 'done');
    if (size === SIZES.phone) await page.evaluate(() => document.querySelector('.dock button[aria-expanded]')?.click());
    await showFindings(page);
    await page.locator('.finding-choice').first().scrollIntoViewIfNeeded();
    await shot(page, `page-lettering-${name}`);
    assert.match(await gist(page), /12 small strokes .*like lettering/);
    await page.getByRole('button', { name: 'Mark: lettering', exact: true }).click();
    await page.getByText('marked, as you chose').waitFor();
    await page.getByRole('button', { name: 'Ignore: lines that lead to lettering' }).click();
    await page.getByText('1 open line leads to lettering: ignored, as you chose.').waitFor();
  });

  test(`pixels of an unknown program are asked about, and the job is planned (${name})`, async (t) => {
    const { page } = await openPage(t, { size, hash: 'seconds=0.4' });
    await phase(page, 'planning', 'done');
    await drop(page, 'pixels.svg', PIXELS);
    await phase(page, 'question');
    const card = page.getByRole('region', { name: 'How large is this drawing?' });
    await card.waitFor();
    await shot(page, `page-pixels-${name}`);
    await card.getByRole('button', { name: /72 to the inch|72 dpi/ }).click();
    await planned(page, 'pixels.svg');
    await phase(page, 'done');
    assert.match(await page.locator('.units').textContent(), /72.*chosen by you/);
    await shot(page, `page-svg-${name}`);
    if (size === SIZES.phone) return;
    const { name: file, bytes } = await download(page, () => page.locator('.dock').getByRole('button', { name: /G-code/ }).click());
    assert.match(file, /^pixels-co2-100w-.*\.nc$/);
    // 380 pixels are 134.056 mm.
    const x = [...bytes.toString().matchAll(/^G1.*X(-?[\d.]+)/gm)].map((m) => Number(m[1]));
    assert.ok(Math.abs(Math.max(...x) - Math.min(...x) - 134.056) < 0.002, `${Math.min(...x)} to ${Math.max(...x)}`);
  });
}

test('one damaged entity was skipped and kept as "them"', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  // The file ends within its last circle.
  await drop(page, 'cut-off.dxf', FRAME.subarray(0, FRAME.indexOf('CIRCLE') + 25));
  await phase(page, 'question');
  const card = page.getByRole('region', { name: '1 entity in this file is damaged' });
  assert.deepEqual(await card.getByRole('button').allTextContents(), ['Skip it', 'Keep it']);
});
