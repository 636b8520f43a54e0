// What a phone and a tablet have to show with little room: the whole order, the choices for a contour, the drawing beside a question, two sheets.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid, sample } from './page-drawings.mjs';
import { picture, still } from './page-pictures.mjs';
import { drop, openPage, openPlanned, phase, SIZES, tap, until } from './page-support.mjs';

const TABLET = { width: 768, height: 1024 };
const SMALL = { width: 360, height: 640 };
const SIDEWAYS = { width: 844, height: 390 };

const inLanguage = (language) => `localStorage.setItem('kerfway.language', '${language}')`;

/** Runs in the page: the box of the pixels of the sheet that have the colour of contours, in pixels of the window. */
const inked = () => {
  const canvas = document.querySelector('#canvas');
  const pen = document.createElement('canvas').getContext('2d');
  const color = getComputedStyle(document.body).getPropertyValue('--contour').match(/#\w+/g)[0];
  pen.fillStyle = color;
  pen.fillRect(0, 0, 1, 1);
  const ink = pen.getImageData(0, 0, 1, 1).data;
  const { data, width } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const box = { left: Infinity, right: -Infinity, top: Infinity, bottom: -Infinity };
  for (let i = 0; i < data.length; i += 4) {
    if ([0, 1, 2].some((k) => Math.abs(data[i + k] - ink[k]) > 8)) continue;
    const x = (i / 4) % width, y = Math.floor(i / 4 / width);
    Object.assign(box, { left: Math.min(box.left, x), right: Math.max(box.right, x), top: Math.min(box.top, y), bottom: Math.max(box.bottom, y) });
  }
  const { left, top } = canvas.getBoundingClientRect();
  return { left: box.left + left, right: box.right + left, top: box.top + top, bottom: box.bottom + top };
};

for (const size of [SIZES.phone, SMALL, TABLET]) {
  test(`the table of the order shows all of its columns (${size.width})`, async (t) => {
    const { page } = await openPage(t, { size, hash: 'seconds=0.4', prepare: inLanguage('de') });
    await phase(page, 'done');
    await page.keyboard.press('t');
    const row = page.locator('.rows .order-row').first();
    await row.waitFor();
    await picture(page, `table-${size.width}`);
    const { wide, cells } = await page.evaluate(() => {
      const scroller = document.querySelector('.order-scroll');
      const { left, right } = scroller.getBoundingClientRect();
      const cells = [...document.querySelectorAll('.order-row')].slice(0, 3).flatMap((r) => [...r.children].map((c) => [c.textContent, c.getBoundingClientRect(), c]));
      return { wide: scroller.scrollWidth - scroller.clientWidth, cells: cells.filter(([, b, c]) => b.left < left || b.right > right || c.scrollWidth > c.clientWidth + 1).map(([text]) => text) };
    });
    assert.deepEqual([wide, cells], [0, []]);
    assert.equal(await row.locator('> *').count(), 7);
  });
}

for (const size of [SIZES.phone, SMALL, SIDEWAYS, TABLET, SIZES.desktop]) {
  test(`a question about the drawing leaves the drawing in sight (${size.width} × ${size.height})`, async (t) => {
    const { page } = await openPage(t, { size, hash: 'seconds=0.4' });
    await phase(page, 'done');
    await drop(page, 'no-units.dxf', sample('no-units.dxf'));
    await phase(page, 'question');
    await still(page);
    await picture(page, `question-${size.width}`);
    const [ink, card] = [await page.evaluate(inked), await page.locator('.question').boundingBox()];
    assert.ok(ink.bottom < card.y || ink.right < card.x, `${JSON.stringify(ink)} is free of ${JSON.stringify(card)}`);
    assert.ok(ink.bottom - ink.top > 60, 'and is not tiny');
    // The answer gives the room back.
    await page.locator('.choices button').first().click();
    await phase(page, 'done');
    await still(page);
    assert.ok((await page.evaluate(inked)).right - ink.left > 100);
  });
}

for (const language of ['de', 'es', 'ja']) {
  test(`the choices for a contour need no scrolling on a phone (${language})`, async (t) => {
    const { page } = await openPage(t, { size: SIZES.phone, touch: true, hash: 'seconds=0.4', prepare: inLanguage(language) });
    await phase(page, 'done');
    await page.keyboard.press('Home');
    const rules = page.locator('.contour-rules');
    const room = () => rules.evaluate((r) => [r.scrollWidth - r.clientWidth, r.closest('.card').scrollWidth - r.closest('.card').clientWidth]);
    assert.deepEqual(await room(), [0, 0]);
    assert.equal(new Set(await rules.locator('> button').evaluateAll((all) => all.map((b) => b.getBoundingClientRect().top))).size, 1, 'one row of four');
    assert.equal(await rules.locator('.contour-choice').first().isVisible(), false);
    await tap(page.locator('.contour-more'));
    await rules.locator('.contour-choice').first().waitFor();
    assert.equal(await page.locator('.contour-more').getAttribute('aria-expanded'), 'true');
    await picture(page, `card-unfolded-${language}`);
    assert.deepEqual(await room(), [0, 0]);
    assert.deepEqual(await rules.locator('.contour-rest > *').evaluateAll((all) => all.filter((e) => e.getBoundingClientRect().right > innerWidth - 8).map((e) => e.textContent)), []);
  });
}

test('a phone has redo in its bar, and the theme and the help in its menu', async (t) => {
  const page = await openPlanned(t, 'co2-100w', 'own.dxf', grid(12), { size: SIZES.phone, touch: true });
  await page.keyboard.press('Home');
  await page.keyboard.press('m');
  await page.waitForFunction(() => !document.querySelector('.top .redo').previousElementSibling.disabled);
  const excluded = () => page.evaluate(() => document.querySelectorAll('.pins').length);
  await phase(page, 'done');
  assert.equal(await excluded(), 1);
  await tap(page.getByRole('button', { name: /^Undo/ }));
  await page.waitForFunction(() => document.querySelectorAll('.pins').length === 0);
  await phase(page, 'done');
  await tap(page.getByRole('button', { name: /^Redo/ }));
  await page.waitForFunction(() => document.querySelectorAll('.pins').length === 1);

  await tap(page.locator('.top .settings'));
  await tap(page.getByRole('button', { name: 'Dark theme' }));
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), 'dark');
  await tap(page.locator('.top .settings'));
  assert.equal(await page.getByRole('button', { name: 'Light theme' }).isVisible(), true);
  await tap(page.getByRole('button', { name: 'Keys and help' }));
  await page.locator('dialog.help').waitFor();
});

test('the resolutions of an SVG keep their numbers and units together in Japanese', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone, hash: 'seconds=0.4', prepare: inLanguage('ja') });
  await phase(page, 'done');
  await drop(page, 'pixels.svg', Buffer.from('<svg xmlns="http://www.w3.org/2000/svg" width="380" height="280"><rect x="1" y="1" width="300" height="200"/></svg>'));
  await phase(page, 'question');
  const choices = page.locator('.choices button');
  assert.deepEqual(await choices.evaluateAll((all) => all.slice(0, 3).map((b) => /\d+\u00a0ピクセル/.exec(b.textContent)?.[0])), ['96\u00a0ピクセル', '90\u00a0ピクセル', '72\u00a0ピクセル']);
  // Each word of it is on one line, and so is the size.
  const broken = await choices.evaluateAll((all) => all.flatMap((b) => [...b.querySelectorAll('span')].flatMap((span) => {
    const text = span.firstChild;
    return [...text.data.matchAll(/\d+(?:\.\d+)?(?: ×)? \d[\d.]* mm|\d+\u00a0\S+/g)].filter(({ index, 0: word }) => {
      const range = document.createRange();
      range.setStart(text, index);
      range.setEnd(text, index + word.length);
      return new Set([...range.getClientRects()].map((r) => r.top)).size > 1;
    }).map(([word]) => word);
  })));
  assert.deepEqual(broken, []);
});

for (const size of [SIZES.desktop, TABLET, SIZES.phone]) {
  test(`two orders are compared as a whole, and each has its name (${size.width})`, async (t) => {
    const { page } = await openPage(t, { size, hash: 'seconds=0.4' });
    await phase(page, 'done');
    // As after stepping through the plan and looking closely.
    await page.keyboard.press('Home');
    for (let k = 0; k < 4; k += 1) await page.keyboard.press('+');
    await still(page);
    await page.locator('.split-toggle').click();
    await page.waitForFunction(() => /^Nearest first · /.test(document.querySelector('.second-label').textContent));
    await still(page);
    await picture(page, `compare-${size.width}`);
    assert.match(await page.locator('.first-label').textContent(), /^Now · /);
    assert.deepEqual([await page.locator('.first-label').isVisible(), await page.locator('.second-label').isVisible(), await page.locator('.card.contour').isVisible()], [true, true, false]);
    const [ink, half] = [await page.evaluate(inked), await page.locator('#canvas').boundingBox()];
    assert.ok(ink.left > half.x + 8 && ink.right < half.x + half.width - 8 && ink.top > half.y + 8 && ink.bottom < half.y + half.height - 8, JSON.stringify({ ink, half }));
  });
}

test('where two sheets have no room, they are not offered', async (t) => {
  const { page } = await openPage(t, { size: { width: 320, height: 568 }, hash: 'seconds=0.4' });
  await phase(page, 'done');
  const offered = () => page.locator('.split-toggle').isVisible();
  assert.equal(await offered(), false);
  await page.setViewportSize(SIZES.phone);
  await page.waitForFunction(() => document.querySelector('#stage').dataset.division === 'down');
  assert.equal(await offered(), true);
  // A window that is wider than high, with a stage that is higher than wide: below each other.
  await page.setViewportSize({ width: 900, height: 860 });
  await page.waitForFunction(() => document.querySelector('#stage').clientWidth < 600);
  await page.locator('.split-toggle').click();
  await page.locator('canvas.second').waitFor();
  const [first, second] = [await page.locator('#canvas').boundingBox(), await page.locator('canvas.second').boundingBox()];
  assert.deepEqual([first.width, first.y + first.height], [second.width, second.y]);
});

test('the card of a contour leaves the sheet of a small phone in sight, and its four choices are in one row (de)', async (t) => {
  const { page } = await openPage(t, { size: SMALL, touch: true, hash: 'seconds=0.4', prepare: inLanguage('de') });
  await phase(page, 'done');
  await page.keyboard.press('Home');
  await still(page);
  await picture(page, 'card-small-de');
  const [ink, card] = [await page.evaluate(inked), await page.locator('.card.contour').boundingBox()];
  assert.ok(ink.bottom < card.y && ink.bottom - ink.top > 40, `${JSON.stringify(ink)} is free of ${JSON.stringify(card)}`);
  const tops = await page.locator('.contour-rules > button').evaluateAll((all) => all.map((b) => b.getBoundingClientRect().top));
  assert.deepEqual([tops.length, new Set(tops).size], [4, 1]);
});

// The words that were too long: German for a search that was still improving, Spanish for its figures.
for (const [language, bound] of [['de', /höchstens/], ['es', /como mucho/]]) {
  test(`the foot of a small phone stays as high as it is when the figures of the proof arrive, and its words fit its buttons (${language})`, async (t) => {
    const { page } = await openPage(t, { size: SMALL, touch: true, hash: 'seconds=60&seed=1', prepare: inLanguage(language) });
    await phase(page, 'planning');
    const foot = page.locator('#dock');
    const measure = async () => ({ high: (await foot.boundingBox()).height, cut: await foot.locator('button:visible').evaluateAll((all) => all.filter((b) => b.scrollWidth > b.clientWidth).map((b) => b.textContent)) });
    const { high } = await measure();
    await until(page, 'the bound is shown', async () => bound.test(await foot.textContent()));
    await picture(page, `foot-${language}`);
    assert.deepEqual(await measure(), { high, cut: [] }, 'while planning');
    await page.keyboard.press('p');
    await phase(page, 'paused');
    assert.deepEqual(await measure(), { high, cut: [] }, 'paused');
    await page.keyboard.press('s');
    await phase(page, 'done');
    assert.deepEqual(await measure(), { high, cut: [] }, 'stopped');
  });
}

test('the list of keys was cut off at the right in German', async (t) => {
  for (const language of ['en', 'de', 'es', 'zh', 'ja']) {
    const { page } = await openPage(t, { size: { width: 320, height: 640 }, hash: 'seconds=0.4', prepare: inLanguage(language) });
    await phase(page, 'done');
    await page.keyboard.press('?');
    await page.locator('dialog[open]').waitFor();
    assert.deepEqual(await page.locator('dialog').evaluate((d) => [d.scrollWidth, ...[...d.querySelectorAll('dt, dd')].filter((e) => e.scrollWidth > e.clientWidth).map((e) => e.textContent)]), [await page.locator('dialog').evaluate((d) => d.clientWidth)], language);
    if (language === 'de') await picture(page, 'keys-phone');
  }
});
