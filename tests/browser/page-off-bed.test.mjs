// A job that is not on the bed has no program, and the page says so with the same words everywhere, and leads to where that is decided.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid } from './page-drawings.mjs';
import { picture } from './page-pictures.mjs';
import { download, drop, dropAll, machineSection, openPage, phase, planned, replanned, SIZES } from './page-support.mjs';

const REFUSED = 'Not on the bed, so no program';

/** A sheet of 24 × 24 mm whose circles lie left of the bed. */
const LEFT_OF_BED = Buffer.from(grid(4).toString().replace(/\n10\n([\d.]+)/g, (_all, x) => `\n10\n${Number(x) - 100}`));

/** The page with a job that is off the bed where it is drawn, and fits elsewhere. */
async function openOffBed(t, hash, size) {
  const { page } = await openPage(t, { size, hash: `seconds=0.4&${hash}` });
  await phase(page, 'planning', 'done');
  await drop(page, 'off.dxf', LEFT_OF_BED);
  await planned(page, 'off.dxf', 'done');
  return page;
}

/** The downloads that are refused, each with its reason. */
const refused = (page) => page.locator('.downloads button:disabled').evaluateAll((all) => all.map((b) => [b.textContent, b.title]));

for (const [name, size] of Object.entries(SIZES)) {
  test(`a job off the bed has no program, and the page leads to its place (${name})`, async (t) => {
    const page = await openOffBed(t, 'machine=co2-100w', size);
    const dock = page.locator('.dock');
    await dock.getByText(REFUSED).waitFor();
    assert.equal(await dock.getByRole('button', { name: 'G-code' }).isVisible(), false);
    assert.deepEqual(await refused(page), ['G-code', 'Copy', 'LightBurn', 'Ruida (experimental)'].map((program) => [program, REFUSED]));
    assert.equal(await page.locator('.preflight').evaluate((e) => e.textContent), REFUSED);

    await dock.getByRole('button', { name: 'Place the job' }).click();
    const bed = page.locator('details.section', { has: page.getByRole('heading', { name: 'On the bed' }) });
    assert.equal(await bed.evaluate((d) => d.open), true);
    assert.equal(await bed.locator('.suggestion strong').textContent(), REFUSED);
    const corner = bed.getByRole('button', { name: 'Move to the corner' });
    assert.equal(await corner.evaluate((b) => b === document.activeElement), true);
    assert.equal(await page.evaluate(() => document.scrollingElement.scrollTop), 0, 'the page itself stays where it is');
    // Both ways out are in sight.
    for (const way of [corner, page.getByLabel('Write programs that leave the bed')]) assert.ok((await way.boundingBox()).y < (await page.locator('#dock').boundingBox()).y - 20);
    await picture(page, `off-bed-${name}`);
    await replanned(page, () => corner.press('Enter'));
    assert.deepEqual(await refused(page), []);
    const program = await download(page, () => dock.getByRole('button', { name: 'G-code' }).click());
    assert.match(program.name, /\.nc$/);
  });
}

test('the key for the program leads to the place as well, and a program that leaves the bed can be allowed', async (t) => {
  const page = await openOffBed(t, 'machine=co2-100w');
  await page.locator('.dock').getByText(REFUSED).waitFor();
  await page.keyboard.press('g');
  const allow = page.getByLabel('Write programs that leave the bed');
  await replanned(page, () => allow.check());
  assert.equal(await page.getByText(REFUSED).filter({ visible: true }).count(), 0);
  await page.locator('.preflight').getByText('off the bed').waitFor();
  const program = await download(page, () => page.locator('.dock').getByRole('button', { name: 'G-code' }).click());
  assert.match(program.bytes.toString(), /^; Kerfway/);
});

test('a machine that takes a drawing gets it wherever the job is', async (t) => {
  const page = await openOffBed(t, 'machine=fibre-3kw-thin');
  const { name } = await download(page, () => page.locator('.dock').getByRole('button', { name: 'DXF' }).click());
  assert.match(name, /^off-fibre-3kw-thin-.*-ordered\.dxf$/);
  assert.equal((await refused(page)).length, 4);
});

test('in a list of files, the same words say that a file has no program', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone, hash: 'seconds=0.4&machine=co2-100w' });
  await phase(page, 'planning', 'done');
  await dropAll(page, [['off.dxf', LEFT_OF_BED], ['on.dxf', grid(4)]]);
  await page.waitForFunction(() => document.querySelector('.queue').textContent === '1 of 2');
  await page.locator('.queue').click();
  assert.match(await page.getByRole('button', { name: /^off\.dxf/ }).textContent(), new RegExp(`${REFUSED}$`));
});

test('a notice on a phone lies above the toolbar', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone, hash: 'seconds=0.4' });
  await phase(page, 'done');
  await page.keyboard.press('d');
  const [notice, tools] = [await page.locator('.notice').boundingBox(), await page.locator('.toolbar').boundingBox()];
  assert.ok(notice.y + notice.height <= tools.y, JSON.stringify({ notice, tools }));
});

test('a job with a kerf was moved half the kerf beyond the corner of the bed, and the page named the place of its drawn lines', async (t) => {
  const page = await openOffBed(t, 'machine=co2-100w');
  const machine = await machineSection(page, SIZES.desktop);
  await machine.locator('summary', { hasText: 'Advanced settings' }).click();
  await replanned(page, () => machine.getByLabel('Kerf width').fill('0.3'));
  await page.locator('.dock').getByRole('button', { name: 'Place the job' }).click();
  const bed = page.locator('details.section', { has: page.getByRole('heading', { name: 'On the bed' }) });
  await bed.getByText('The job reaches from x -97.75', { exact: false }).waitFor();
  await bed.getByText('x -97.8 to', { exact: false }).waitFor();
  await replanned(page, () => bed.getByRole('button', { name: 'Move to the corner' }).click());
  assert.equal(await page.getByText(REFUSED).filter({ visible: true }).count(), 0);
  await bed.getByText('x 0 to', { exact: false }).waitFor();
  assert.match(await page.evaluate(() => location.hash), /place=lower-left%400\.15%2C0\.15/);
});
