// What a person chooses on the page: methods of papers, pins, the start, machines of one's own; undo, redo, sharing.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { dxf, square } from '../package/support.mjs';
import { grid } from './page-drawings.mjs';
import { download, openPage, openPlanned, phase, SIZES, stored } from './page-support.mjs';

/** Opens a part of the panel, which may have to be loaded first. */
const open = (page, title) =>
  page.waitForFunction((t) => {
    const part = [...document.querySelectorAll('details')].find((d) => d.querySelector('summary')?.textContent.startsWith(t));
    if (part) part.open = true;
    return part !== undefined;
  }, title);

const method = (page) => page.getByLabel('Method');
const seconds = (page) => page.evaluate(() => document.querySelector('.dock-head').textContent);

test('a method from a paper is chosen, shows its figures, takes parameters and is undone', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=300' });
  await phase(page, 'planning');
  await open(page, 'Plan');
  await method(page).selectOption({ label: 'Research methods…' });
  await page.waitForFunction(() => document.querySelectorAll('optgroup option').length >= 2);
  await method(page).selectOption({ label: 'RLSGA' });
  await page.getByText('J. Mar. Sci. Eng. 11 (2023) 652').waitFor();
  await page.waitForFunction(() => /^round \d/.test(document.querySelector('.insights')?.parentElement.querySelector('.number')?.textContent ?? ''));
  assert.equal(await page.locator('.insight-grid td.number').count(), 9, 'the Q-table');
  const charts = await page.locator('.insight figcaption').allTextContents();
  assert.deepEqual(charts, ['Length, mm', 'Diversity and reward', 'Share of each crossover', 'Share of each state']);
  // Each chart is drawn as soon as its place on the page has a width.
  await page.waitForFunction(() => document.querySelectorAll('.insight canvas').length === 4);
  await open(page, 'Parameters');
  await page.getByLabel('Population').fill('20');
  await page.waitForFunction(() => document.querySelector('.insight-grid td.now') !== null);
  await page.getByLabel('Method').focus();

  await page.getByRole('button', { name: 'Undo' }).click();
  await page.waitForFunction(() => [...document.querySelectorAll('.field')].some((f) => f.textContent === 'Population' && f.querySelector('input').value === '200'));
  await page.getByRole('button', { name: 'Undo' }).click();
  await page.waitForFunction(() => document.querySelector('[aria-label=Method]').value === 'tour-tree');
  await page.getByRole('button', { name: 'Redo' }).click();
  await page.waitForFunction(() => document.querySelector('[aria-label=Method]').value === 'rlsga');
  await page.keyboard.press('Escape');
  await page.locator('body').press('s');
  await phase(page, 'done');
  assert.match(await seconds(page), /^Stopped/);
});

test('an invalid parameter is explained in a sentence, the drawing stays, and the choice can be undone', async (t) => {
  const { page } = await openPage(t, { hash: 'method=rlsga&seconds=300' });
  await open(page, 'Plan');
  await page.waitForFunction(() => document.querySelector('[aria-label=Method]')?.value === 'rlsga');
  await open(page, 'Parameters');
  await page.getByLabel('Population').fill('-1');
  await page.waitForFunction(() => document.querySelector('.dock-head').textContent.startsWith('The parameter '));
  assert.equal(await page.locator('.file-name').textContent(), 'sheet_500.dxf');
  const dock = page.locator('.dock');
  assert.deepEqual(await dock.getByRole('button').allInnerTexts(), ['Undo'], 'another drawing would not help');
  await dock.getByRole('button', { name: 'Undo' }).click();
  await phase(page, 'planning');
  assert.equal(await page.getByLabel('Population').inputValue(), '200');
  await page.getByLabel('Population').fill('20');
  await phase(page, 'planning');
});

test('where every layer was ignored, another file was offered instead of the way back', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'grid.dxf', grid(20));
  await open(page, 'Drawing');
  const layers = page.getByLabel(/^Operation for layer/);
  for (let k = 0; k < 2; k += 1) await layers.nth(k).selectOption({ label: 'Ignore' });
  await phase(page, 'ready');
  const dock = page.locator('.dock');
  await dock.getByText('Nothing to cut: set a layer to cut or mark.').waitFor();
  assert.deepEqual(await dock.getByRole('button').allInnerTexts(), ['Undo']);
  await dock.getByRole('button', { name: 'Undo' }).click();
  await phase(page, 'planning', 'done');
});

test('a contour is pinned, the start is chosen on the sheet, and the address holds the settings', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  // There is an order to step through once there is a path.
  await page.waitForFunction(() => document.querySelector('.large').textContent !== '');
  await page.locator('body').press('ArrowRight');
  await page.getByRole('button', { name: 'Cut last' }).click();
  await page.waitForFunction(() => document.querySelector('.card.contour [aria-pressed=true]')?.textContent === 'Cut last' || document.querySelector('.card.contour').hidden);
  await phase(page, 'planning', 'done');
  await open(page, 'Machine');
  await open(page, 'Advanced settings');
  await page.getByRole('button', { name: 'Choose the start on the sheet' }).click();
  const box = await page.locator('#canvas').boundingBox();
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await page.waitForFunction(() => [...document.querySelectorAll('.field')].some((f) => f.textContent.startsWith('Home, x') && Number(f.querySelector('input').value) > 100));
  await open(page, 'Plan');
  await page.getByLabel('Seed').fill('77');
  await page.waitForFunction(() => location.hash.includes('seed=77'));
  assert.ok(!(await page.evaluate(() => location.href)).includes('sheet_500'), 'never the drawing');
});

test('the address holds all tolerances', async (t) => {
  const shared = 'seconds=0.4&units=mm&join=0.2&copies=0.03&curves=0.004';
  const { page } = await openPage(t, { hash: shared });
  await phase(page, 'done');
  await open(page, 'Drawing');
  await open(page, 'Tolerances');
  const fields = page.locator('.tolerance-field input[type=number]');
  await fields.nth(2).waitFor();
  assert.deepEqual(await fields.evaluateAll((all) => all.map((f) => f.value)), ['0.2', '0.03', '0.004']);
  const written = await page.evaluate(() => Object.fromEntries(new URLSearchParams(location.hash.slice(1))));
  assert.deepEqual(written, Object.fromEntries(new URLSearchParams(shared)));
});

test('machines with names in any script are saved beside each other', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  await open(page, 'Machine');
  await open(page, 'Your machines');
  const titles = ['激光切割机', 'レーザー', '레이저', 'Laser 1.5', 'Laser 1-5', '★', '☆'];
  for (const title of titles) {
    await page.getByLabel('Name of your machine').fill(title);
    await page.getByRole('button', { name: 'Save', exact: true }).click();
    await page.waitForFunction((t) => document.querySelector('[aria-label=Preset]').selectedOptions[0].textContent === t, title);
  }
  const saved = await page.evaluate(() => JSON.parse(localStorage.getItem('kerfway.machines')).map(({ name, title }) => [name, title]));
  assert.deepEqual(saved, [
    ['my-激光切割机', '激光切割机'], ['my-レーザー', 'レーザー'], ['my-레이저', '레이저'], ['my-laser-1-5', 'Laser 1.5'], ['my-laser-1-5-2', 'Laser 1-5'], ['my-machine', '★'], ['my-machine-2', '☆'],
  ]);
  await phase(page, 'planning', 'done');
  await page.getByLabel('Name of your machine').fill('レーザー');
  await page.getByRole('button', { name: 'Save', exact: true }).click();
  assert.equal(await page.evaluate(() => JSON.parse(localStorage.getItem('kerfway.machines')).length), titles.length, 'the same name takes its place');
});

test('a machine is saved under a name, exported, deleted and imported', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  await open(page, 'Machine');
  await open(page, 'Your machines');
  await page.getByLabel('Name of your machine').fill('Shop laser');
  await page.getByRole('button', { name: 'Save', exact: true }).click();
  await page.waitForFunction(() => document.querySelector('[aria-label=Preset]').value === 'my-shop-laser');
  const { name, bytes } = await download(page, () => page.getByRole('button', { name: 'Export' }).click());
  assert.equal(name, 'my-shop-laser.machine.json');
  assert.equal(JSON.parse(bytes).schema, 'kerfway.machine/1');
  await page.getByRole('button', { name: 'Delete' }).click();
  await page.waitForFunction(() => ![...document.querySelectorAll('[aria-label=Preset] option')].some((o) => o.value === 'my-shop-laser'));
  const give = async (content, label) => {
    const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.getByRole('button', { name: 'Import' }).click()]);
    await chooser.setFiles({ name: label, mimeType: 'application/json', buffer: Buffer.from(content) });
  };
  await give(bytes, name);
  await page.waitForFunction(() => document.querySelector('[aria-label=Preset]').value === 'my-shop-laser');
  await give(readFileSync(new URL('../../package.json', import.meta.url)), 'package.json');
  await page.getByText('This file is not a machine profile').waitFor();
});

test('on a phone nothing in the top bar lies over something else', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone });
  await phase(page, 'planning', 'done');
  const boxes = await page.locator('.top button:visible').evaluateAll((all) => all.map((b) => b.getBoundingClientRect()).map((r) => [r.left, r.right]));
  boxes.sort((a, b) => a[0] - b[0]);
  boxes.slice(1).forEach(([left], k) => assert.ok(left >= boxes[k][1] - 1, JSON.stringify(boxes)));
});

test('after a first visit the page works without a network, with the methods of papers and pictures that were used', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  const useAll = async () => {
    await page.reload();
    await phase(page, 'planning', 'done');
    await open(page, 'Plan');
    await method(page).selectOption({ label: 'Research methods…' });
    await page.waitForFunction(() => document.querySelectorAll('optgroup option').length >= 2);
    const { bytes } = await download(page, () => page.getByRole('button', { name: 'PNG' }).click());
    assert.deepEqual([...bytes.subarray(1, 4)], [...Buffer.from('PNG')]);
  };
  await useAll();
  await page.context().setOffline(true);
  await useAll();
});

test('once the page is used, programs are written without a network, also in the next visit', async (t) => {
  const { page } = await openPage(t);
  const done = async () => {
    await phase(page, 'planning', 'done');
    const stop = page.getByRole('button', { name: 'Stop' });
    if (await stop.isVisible()) await stop.click();
    await phase(page, 'done');
  };
  await done();
  // The stop was a press of the pointer, so the writers are fetched and stored.
  await stored(page, 'kerfway_outputs');
  await page.context().setOffline(true);
  for (const visit of ['first', 'next']) {
    if (visit === 'next') {
      await page.reload();
      await done();
    }
    const { bytes } = await download(page, () => page.locator('.dock').getByRole('button', { name: 'G-code' }).click());
    assert.match(bytes.toString().slice(0, 20), /^; Kerfway/, visit);
  }
});

test('a finished plan gives a quote that can be downloaded', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  await open(page, 'Quote');
  await page.getByLabel(/^Thickness/).fill('3');
  await page.getByLabel('Density').fill('7.85');
  await page.keyboard.press('Escape');
  await page.getByRole('button', { name: 'Stop' }).click();
  await phase(page, 'done');
  await page.getByText('Narrowest web').waitFor();
  assert.match(await page.locator('.section-body').first().textContent(), /98 parts/, 'as the drawing says');
  assert.match(await page.locator('details', { hasText: 'Density' }).last().textContent(), /Parts98, \d+ different.* kg/);
  const { name, bytes } = await download(page, () => page.getByRole('button', { name: 'Download the report' }).click());
  assert.match(name, /^sheet_500-co2-100w-[\d-]+\.quote\.json$/);
  const report = JSON.parse(bytes);
  assert.deepEqual([report.schema, report.material.thickness, report.part_count], ['kerfway.quote/2', 3, 98]);
});

test('the parts of a quote are listed in one unit', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'two-sizes.dxf', dxf(square(0, 0, 50), square(100, 0, 200)));
  await open(page, 'Quote');
  const listed = page.locator('dl.parts dt', { hasText: /^\d+ × / });
  await listed.first().waitFor();
  assert.deepEqual((await listed.allTextContents()).sort(), ['1 × 2,500 mm²', '1 × 40,000 mm²']);
});
