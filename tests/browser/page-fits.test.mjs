// Words have the room they need, in the languages whose words are long and on a phone, whose text is large.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { wordsOf } from '../package/page-words.mjs';
import { sample } from './page-drawings.mjs';
import { drop, openEverything, openPage, phase, planned, SIZES } from './page-support.mjs';

/** Runs in the page: what empty fields say, and what can be chosen, where it is wider than the field. */
const cut = () => {
  /** Pixels that the arrow of a list takes. */
  const ARROW = 20;
  const pen = document.createElement('canvas').getContext('2d');
  const found = [];
  for (const field of document.querySelectorAll('#sections :not(.wide) > select, #sections input')) {
    if (!field.checkVisibility()) continue;
    const style = getComputedStyle(field);
    pen.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
    const room = field.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - (field.tagName === 'SELECT' ? ARROW : 0);
    const texts = field.tagName === 'SELECT' ? [...field.options].map((o) => o.text) : [field.placeholder];
    for (const text of texts) if (pen.measureText(text).width > room + 0.5) found.push(`${text}: ${Math.round(pen.measureText(text).width)} of ${Math.round(room)}`);
  }
  return found;
};

/** Runs in the page: the chosen name as it is written over its list, and in how many lines, if the list has room for all of them. */
const namesLines = (wide) => {
  const [list, name] = wide.children;
  const text = document.createRange();
  text.selectNodeContents(name);
  const [frame, box] = [list.getBoundingClientRect(), text.getBoundingClientRect()];
  const isInside = box.top >= frame.top && box.bottom <= frame.bottom && box.right < frame.right;
  return [name.textContent, isInside && text.getClientRects().length];
};

for (const language of ['de', 'es']) {
  for (const [name, size] of Object.entries(SIZES)) {
    test(`no field cuts its words (${language}, ${name})`, async (t) => {
      const { page } = await openPage(t, { size, hash: 'seconds=0.4&machine=fibre-3kw-thin', prepare: `localStorage.setItem('kerfway.language', '${language}')` });
      await phase(page, 'done');
      await page.evaluate(() => document.body.classList.add('sheet-open'));
      await openEverything(page);
      assert.deepEqual(await page.evaluate(cut), []);
      // Leads and joints have lists that are shown once they are on.
      const words = await wordsOf(language);
      await page.getByLabel(words.leads.kind).selectOption('line');
      await page.getByLabel(words.joints.on).check();
      await page.locator('label.field', { hasText: words.joints.kinds.flying }).waitFor();
      assert.deepEqual(await page.evaluate(cut), [], 'with leads and joints');
      // The name of this machine is longer than the panel is wide.
      assert.deepEqual(await page.locator('.first-machine .wide').evaluate(namesLines), ['Fibre laser, 3 kW, 1 mm stainless steel, nitrogen', 2]);
      const [gist, shown] = await page.locator('.section .gist', { hasText: 'Fibre laser' }).evaluate((gist) => [gist.scrollHeight, gist.clientHeight]);
      assert.equal(gist, shown, 'the heading names it in full');
    });
  }
}

/** Runs in the page: the numbers in figures that end a line, with what they count in the next one. */
const parted = () => [...document.querySelectorAll('.parts dd')].flatMap(({ firstChild: text }) => [...text.data.matchAll(/\d\s\S+/g)].filter(({ index, 0: { length } }) => {
  const range = document.createRange();
  range.setStart(text, index);
  range.setEnd(text, index + length);
  return new Set([...range.getClientRects()].map(({ top }) => Math.round(top))).size > 1;
}).map(([found]) => found));

/** Runs in the page: the words of the elements that are shown, and in how many lines. */
const inLines = (all) => all.filter((element) => element.checkVisibility()).map((element) => {
  const words = document.createRange();
  words.selectNodeContents(element.querySelector('span') ?? element);
  return [element.textContent, new Set([...words.getClientRects()].map(({ bottom }) => Math.round(bottom))).size];
});

for (const width of [1024, 1440]) {
  test(`in German, the actions at the foot took two lines, the mark of travel stood above its word, and lines ended after a number (${width})`, async (t) => {
    const { page } = await openPage(t, { size: { width, height: 900 }, hash: 'seconds=0.4', prepare: `localStorage.setItem('kerfway.language', 'de')` });
    await phase(page, 'done');
    await drop(page, 'plates.dxf', sample('held-plates.dxf'));
    await planned(page, 'plates.dxf', 'done');
    await openEverything(page);
    await page.locator('dl.parts dd', { hasText: 'Löcher' }).first().waitFor();
    assert.deepEqual(await page.locator('.dock-actions button').evaluateAll(inLines), [['Weiter verbessern', 1], ['G-Code', 1]]);
    assert.deepEqual(await page.locator('.compare th.air').evaluateAll(inLines), [['Leerfahrt', 1]]);
    const head = await page.locator('.compare th.air').evaluate((th) => th.clientHeight / parseFloat(getComputedStyle(th).lineHeight));
    assert.ok(head < 1.5, `${head} lines with the mark`);
    assert.deepEqual(await page.evaluate(parted), []);
  });
}

test('the list of materials cut off what is chosen', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4&machine=co2-100w' });
  await phase(page, 'done');
  await openEverything(page);
  const long = 'Birch plywood 3 mm, from the supplier in the next village';
  await page.getByLabel('Name of the material').fill(long);
  await page.getByRole('button', { name: 'Save setting' }).click();
  const wide = page.locator('label.field .wide', { has: page.locator('option', { hasText: 'As the machine is set' }) });
  const material = wide.locator('select');
  await material.waitFor();
  const shown = () => wide.evaluate(namesLines);
  assert.deepEqual(await shown(), ['As the machine is set', 1]);
  await material.selectOption(long);
  await page.waitForFunction((name) => [...document.querySelectorAll('.wide > span')].some((span) => span.textContent === name), long);
  assert.deepEqual(await shown(), [long, 2]);
});
