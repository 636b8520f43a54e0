// Small windows: a phone held upright or sideways, a tablet, a page that is enlarged. Nothing is cut off.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sample } from './page-drawings.mjs';
import { picture } from './page-pictures.mjs';
import { drop, openPage, phase } from './page-support.mjs';

/** A phone held sideways, and windows of 1440 × 900 and 1280 × 720 pixels in which the page is enlarged to twice its size. */
const LOW = [[667, 375], [720, 450], [640, 360]];

/** Runs in the page: whether an element can be pressed once it is scrolled to. */
const canBePressed = (element) => {
  element.scrollIntoView({ block: 'nearest' });
  const { left, top, width, height } = element.getBoundingClientRect();
  return [0.1, 0.9].every((share) => element.contains(document.elementFromPoint(left + width / 2, top + height * share)));
};

for (const [width, height] of LOW) {
  test(`every answer of the card that asks for the unit can be pressed in a low window (${width} × ${height})`, async (t) => {
    const { page } = await openPage(t, { size: { width, height }, hash: 'seconds=0.4' });
    await phase(page, 'planning', 'done');
    await drop(page, 'no-units.dxf', sample('no-units.dxf'));
    await phase(page, 'question');
    await picture(page, `low-question-${width}`);
    const answers = page.locator('.choices button');
    assert.equal(await answers.count(), 4);
    assert.deepEqual(await answers.evaluateAll((all, can) => all.map((e) => new Function(`return (${can})`)()(e)), String(canBePressed)), [true, true, true, true]);
  });
}
