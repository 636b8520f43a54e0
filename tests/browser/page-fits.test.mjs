// Words have the room they need, in the languages whose words are long and on a phone, whose text is large.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openEverything, openPage, phase, SIZES } from './page-support.mjs';

/** Runs in the page: what empty fields say, and what can be chosen, where it is wider than the field. */
const cut = () => {
  /** Pixels that the arrow of a list takes. */
  const ARROW = 20;
  const pen = document.createElement('canvas').getContext('2d');
  const found = [];
  for (const field of document.querySelectorAll('#sections select:not(.wide), #sections input')) {
    if (!field.checkVisibility()) continue;
    const style = getComputedStyle(field);
    pen.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
    const room = field.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - (field.tagName === 'SELECT' ? ARROW : 0);
    const texts = field.tagName === 'SELECT' ? [...field.options].map((o) => o.text) : [field.placeholder];
    for (const text of texts) if (pen.measureText(text).width > room + 0.5) found.push(`${text}: ${Math.round(pen.measureText(text).width)} of ${Math.round(room)}`);
  }
  return found;
};

for (const language of ['de', 'es']) {
  for (const [name, size] of Object.entries(SIZES)) {
    test(`no field cuts its words (${language}, ${name})`, async (t) => {
      const { page } = await openPage(t, { size, hash: 'seconds=0.4&machine=fibre-3kw-thin', prepare: `localStorage.setItem('kerfway.language', '${language}')` });
      await phase(page, 'done');
      await page.evaluate(() => document.body.classList.add('sheet-open'));
      await openEverything(page);
      assert.deepEqual(await page.evaluate(cut), []);
      // The names of machines are longer than the panel is wide.
      const machine = page.locator('.first-machine select');
      assert.equal(await machine.getAttribute('title'), await machine.evaluate((list) => list.selectedOptions[0].text));
    });
  }
}
