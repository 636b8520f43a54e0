// Small windows: a phone held upright or sideways, a tablet, a page that is enlarged. Nothing is cut off, and no control covers another.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid, sample } from './page-drawings.mjs';
import { picture } from './page-pictures.mjs';
import { drop, openEverything, openPage, phase, planned, SIZES } from './page-support.mjs';

/** A phone held sideways, and windows of 1440 × 900 and 1280 × 720 pixels in which the page is enlarged to twice its size. */
const LOW = [[667, 375], [720, 450], [640, 360], [844, 390]];

/** Phones upright and held sideways, tablets, and the narrowest window with the panel at the side. */
const NARROW = [[320, 568], [375, 667], [720, 900], [768, 1024], [834, 1112], [844, 390]];

/** Runs in the page: which of the controls outside the panel are off the screen, or lie over another, for each group of them. */
const misplaced = () => {
  const found = [];
  for (const group of document.querySelectorAll('.top, .toolbar, .playback, .dock, .drawer .dialog-head')) {
    const boxes = [...group.querySelectorAll('button, select, input, .now, .whole, .shortened, .measure')]
      .filter((e) => e.checkVisibility() && e.getClientRects().length > 0 && !e.closest('[popover]'))
      .map((e) => [(e.getAttribute('aria-label') ?? e.textContent).slice(0, 30), e.getBoundingClientRect(), e]);
    for (const [name, box, e] of boxes) {
      if (box.left < -0.5 || box.right > innerWidth + 0.5 || box.bottom > innerHeight + 0.5) found.push(`${name} is off the screen`);
      if (e.scrollWidth > e.clientWidth + 1 && e.tagName === 'BUTTON') found.push(`${name} is wider than its button`);
      for (const [other, b] of boxes) if (box.left < b.left && box.right > b.left + 1 && box.top < b.bottom - 1 && b.top < box.bottom - 1) found.push(`${name} lies over ${other}`);
    }
  }
  const [stage, toolbar] = ['.stage', '.toolbar'].map((selector) => document.querySelector(selector).getBoundingClientRect());
  if (toolbar.bottom > stage.bottom) found.push('the toolbar is higher than the stage');
  return found;
};

/** Runs in the page: which elements can be pressed once they are scrolled to. */
const pressable = (all) => all.map((element) => {
  element.scrollIntoView({ block: 'nearest' });
  const { left, top, width, height } = element.getBoundingClientRect();
  return [0.1, 0.9].every((share) => element.contains(document.elementFromPoint(left + width / 2, top + height * share)));
});

for (const [width, height] of LOW) {
  test(`every answer of the card that asks for the unit can be pressed in a low window (${width} × ${height})`, async (t) => {
    const { page } = await openPage(t, { size: { width, height }, hash: 'seconds=0.4' });
    await phase(page, 'planning', 'done');
    await drop(page, 'no-units.dxf', sample('no-units.dxf'));
    await phase(page, 'question');
    await picture(page, `low-question-${width}`);
    const answers = page.locator('.choices button');
    assert.equal(await answers.count(), 4);
    assert.deepEqual(await answers.evaluateAll(pressable), [true, true, true, true]);
  });
}

for (const [width, height] of [[390, 844], ...LOW]) {
  test(`the sizes of a drawing that has no usual size ran out of their buttons (${width} × ${height})`, async (t) => {
    const { page } = await openPage(t, { size: { width, height }, hash: 'seconds=0.4', prepare: `localStorage.setItem('kerfway.language', 'de')` });
    await phase(page, 'done');
    // In inches it is 1177.9 mm wide.
    await drop(page, 'house.dxf', grid(128, { units: 6, step: 2.95 }));
    await phase(page, 'question');
    const outside = (all) => all.filter((b) => [...b.children].some((span) => {
      const text = document.createRange();
      text.selectNodeContents(span);
      return text.getBoundingClientRect().right > b.getBoundingClientRect().right - parseFloat(getComputedStyle(b).paddingRight) + 0.5;
    })).map((b) => b.textContent);
    assert.deepEqual(await page.locator('.choices button').evaluateAll(outside), []);
  });
}

for (const width of [320, 360]) {
  for (const locale of ['en', 'de', 'es']) {
    test(`at ${width} pixels the times of the result are not cut off, and a guessed unit does not look like a stated one (${locale})`, async (t) => {
      const prepare = `localStorage.setItem('kerfway.language', '${locale}')`;
      const { page } = await openPage(t, { size: { width, height: 640 }, hash: 'seconds=0.4', prepare });
      await phase(page, 'done');
      const signed = () => page.locator('.units .source').evaluate((e) => e.checkVisibility() && getComputedStyle(e, '::after').content);
      assert.equal(await signed(), false);
      await page.locator('.sheet-toggle').click();
      const [table, room] = await page.evaluate(() => ['.compare', '.section-body > .stack:has(> .compare)'].map((name) => document.querySelector(name).getBoundingClientRect().right));
      assert.ok(table <= room + 0.5, `${table} of ${room}`);
      assert.equal(await page.locator('.compare .solid td.number:visible').count(), 2);
      await drop(page, 'no-units.dxf', sample('no-units.dxf'));
      await planned(page, 'no-units.dxf', 'question');
      assert.equal(await signed(), '"?"');
      assert.deepEqual(await page.evaluate(misplaced), []);
      const [mark, next] = await page.evaluate(() => ['.units', '.tools button'].map((name) => document.querySelector(name).getBoundingClientRect()));
      assert.ok(mark.right <= next.left + 0.5);
    });
  }
}

test('the card of a contour leaves more than half of the sheet free in a low window', async (t) => {
  const { page } = await openPage(t, { size: { width: 720, height: 450 }, hash: 'seconds=0.4' });
  await phase(page, 'done');
  await page.keyboard.press('ArrowRight');
  const card = page.locator('.card.contour');
  await card.waitFor();
  const [stage, { height }] = [await page.locator('.stage').boundingBox(), await card.boundingBox()];
  assert.ok(height < stage.height / 2, `${height} of ${stage.height}`);
  await page.getByRole('button', { name: 'More choices' }).click();
  await card.getByLabel('Lead').waitFor();
});

test('a long name in Persian lost its beginning, and is read from the right now', async (t) => {
  const { page } = await openPage(t, { size: SIZES.phone, hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  const name = 'یک فایل بسیار طولانی برای برش لیزر با نام فارسی plate-v12-rev-b.dxf';
  await drop(page, name, grid(20));
  await page.waitForFunction((n) => document.querySelector('.dock-file').textContent === n, name);
  await picture(page, 'narrow-persian');
  const { begins, ends, root } = await page.locator('.dock-file').evaluate((root) => {
    const box = (node, from, to) => {
      const range = document.createRange();
      range.setStart(node.firstChild, from);
      range.setEnd(node.firstChild, to);
      const { left, right } = range.getBoundingClientRect();
      return { left, right };
    };
    const [begin, end] = root.children;
    return { begins: box(begin, 0, 2), ends: box(end, 0, end.textContent.length), root: { left: root.getBoundingClientRect().left, right: root.getBoundingClientRect().right } };
  });
  assert.ok(begins.right <= root.right + 1 && begins.left > ends.right, `${JSON.stringify(begins)} is right of ${JSON.stringify(ends)}, within ${JSON.stringify(root)}`);
  assert.ok(Math.abs(ends.left - root.left) < 1, 'it stands below the other lines, at the left');
});

for (const [width, height, language] of [[1024, 768, 'en'], [390, 844, 'de']]) {
  test(`"Keep improving" took two lines (${width} × ${height}, ${language})`, async (t) => {
    const { page } = await openPage(t, { size: { width, height }, hash: 'seconds=0.4&machine=co2-100w', prepare: `localStorage.setItem('kerfway.language', '${language}')` });
    await phase(page, 'done');
    const lines = () => page.evaluate(() => [...document.querySelectorAll('.dock-actions button:not([hidden]) span')].map((label) => label.getClientRects()[0].height));
    for (const name of ['sheet_500.dxf', 'off-the-bed.dxf']) {
      if (name === 'off-the-bed.dxf') {
        await drop(page, name, sample('lumberjack-polaris.dxf'));
        await planned(page, name, 'done');
      }
      const heights = await lines();
      assert.equal(heights.length, 2, name);
      if (language === 'en' || name === 'sheet_500.dxf') assert.ok(heights.every((height) => height < 25), `${name}: ${heights}`);
    }
  });
}

for (const [width, height] of NARROW) {
  // In German, whose words are long.
  test(`no control is off the screen or over another (${width} × ${height})`, async (t) => {
    const { page } = await openPage(t, { size: { width, height }, hash: 'seconds=600', prepare: "localStorage.setItem('kerfway.language', 'de')" });
    await phase(page, 'planning');
    await drop(page, 'bracket-with-a-rather-long-name.dxf', grid(200));
    await planned(page, 'bracket-with-a-rather-long-name.dxf', 'planning');
    await page.keyboard.press('p');
    await phase(page, 'paused');
    assert.deepEqual(await page.evaluate(misplaced), [], 'paused');
    await page.keyboard.press('s');
    await phase(page, 'done');
    assert.deepEqual(await page.evaluate(misplaced), [], 'done');
    await picture(page, `narrow-${width}`);
    await page.keyboard.press('t');
    await page.locator('.order-row').nth(1).waitFor();
    assert.deepEqual(await page.evaluate(misplaced), [], 'with the table');
  });
}

test('long German names of fields were broken without a hyphen where the browser has no dictionary', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4', prepare: `localStorage.setItem('kerfway.language', 'de')` });
  await phase(page, 'done');
  await openEverything(page);
  const broken = await page.locator('.field-label').evaluateAll((all) => all.flatMap((label) => [...label.firstChild.data.matchAll(/[^\s\u00ad]+/g)].filter(({ 0: part, index }) => {
    const letters = document.createRange();
    // Before the first letter there may be a hyphen, on the line above.
    letters.setStart(label.firstChild, index + 1);
    letters.setEnd(label.firstChild, index + part.length);
    return new Set([...letters.getClientRects()].filter((line) => line.width > 0).map((line) => line.top)).size > 1;
  }).map(({ 0: part }) => part)));
  assert.deepEqual(broken, []);
});

for (const [width, height] of [[640, 360], [667, 375], [568, 320]]) {
  test(`the foot of a low and narrow window took half of it (${width} × ${height})`, async (t) => {
    const { page } = await openPage(t, { size: { width, height }, hash: 'seconds=0.4' });
    await phase(page, 'done');
    const { height: foot } = await page.locator('#dock').boundingBox();
    assert.ok(foot < 0.25 * height, `${foot} of ${height}`);
    const [stage, toolbar, orders] = await Promise.all(['.stage', '.toolbar', '.orders'].map((name) => page.locator(name).boundingBox()));
    assert.ok(orders.y + orders.height < toolbar.y && toolbar.y + toolbar.height < stage.y + stage.height, 'the controls on the stage lay over each other');
    await picture(page, `low-foot-${width}`);
  });
}

test('on a phone the names of layers that are cut in order were cut off, with their last button, and so were the fields of a place', async (t) => {
  for (const size of [SIZES.phone, { width: 320, height: 568 }]) {
    const { page } = await openPage(t, { size, hash: 'seconds=0.4&by-layer=1&place=lower-left%4010%2C10' });
    await phase(page, 'planning', 'done');
    await drop(page, 'layers.dxf', sample('layers.dxf'));
    await planned(page, 'layers.dxf', 'done');
    await page.evaluate(() => document.body.classList.add('sheet-open'));
    await openEverything(page);
    const found = await page.evaluate(() => {
      const { scrollWidth, clientWidth } = document.getElementById('sections');
      const names = [...document.querySelectorAll('.layer-name')].filter((name) => name.scrollWidth > name.clientWidth).map((name) => name.textContent);
      return [scrollWidth - clientWidth, names, [...document.querySelectorAll('.placement-point input[type=number]')].every((input) => input.checkVisibility() && input.getBoundingClientRect().right < innerWidth - 16)];
    });
    assert.deepEqual(found, [0, [], true], size.width);
  }
});

test('a word that was searched for in the page scrolled the whole page out of its window', async (t) => {
  const { page } = await openPage(t, { size: { width: 720, height: 450 }, hash: 'seconds=0.4' });
  await phase(page, 'planning', 'done');
  await drop(page, 'gaps.dxf', sample('gaps-and-copies.dxf'));
  await planned(page, 'gaps.dxf', 'done');
  await openEverything(page);
  // What is written for screen readers only.
  assert.equal(await page.evaluate(() => window.find('Note:')), true);
  assert.deepEqual(await page.evaluate(() => [scrollY, document.documentElement.scrollHeight]), [0, 450]);
});
