// Every ability of the page as people see it: wide and narrow, light and dark. The pictures are kept in target/shots for
// people to look at; what a program can see is asserted: nothing reaches over an edge, axe finds nothing serious.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid, sample } from './page-drawings.mjs';
import { serious, shot, still } from './page-pictures.mjs';
import { drop, dropAll, nextFrames, openPage, phase, planned, replanned, searchFor, SIZES } from './page-support.mjs';

for (const [name, size] of Object.entries(SIZES)) {
  test(`every ability, ${name}`, async (t) => {
    const narrow = size === SIZES.phone;
    const { page } = await openPage(t, { size, touch: narrow, hash: 'seconds=0.4' });
    await phase(page, 'done');
    const keep = async (what) => {
      const over = await page.evaluate(() => [document.documentElement.scrollWidth - innerWidth, ...[...document.querySelectorAll('#sections *, #dock *, .top *, .card *')]
        .filter((e) => e.getClientRects().length > 0 && e.getBoundingClientRect().right > innerWidth + 1 && !e.closest('.hidden, [popover]')).map((e) => e.outerHTML.slice(0, 80))].filter(Boolean));
      assert.deepEqual(over, [], `${what}: nothing reaches over the edge`);
      await shot(page, `look-${what}-${name}`);
    };
    /** Shows one section of the panel, with these of its parts open. */
    const panel = async (title, ...parts) => {
      if (narrow && !(await page.evaluate(() => document.body.classList.contains('sheet-open')))) await page.locator('.sheet-toggle').click();
      await page.evaluate((title) => {
        for (const s of document.querySelectorAll('.section')) s.open = s.querySelector('h2').textContent === title;
      }, title);
      // The content of some is loaded when they are opened.
      await page.waitForFunction(() => document.querySelector('.section[open] > .section-body:not(:empty)') !== null);
      await page.evaluate((parts) => {
        for (const d of document.querySelectorAll('.section details')) d.open = parts.includes(d.querySelector('summary').textContent);
        document.querySelector('.section[open]').scrollIntoView({ block: 'start' });
      }, parts);
    };
    const sheet = async () => {
      if (narrow && (await page.evaluate(() => document.body.classList.contains('sheet-open')))) await page.locator('.sheet-toggle').click();
    };
    const clean = async (what) => assert.deepEqual(await serious(page), [], what);

    await keep('result');
    // A search that lasts longer than its pictures take.
    await searchFor(page, 60);
    await page.waitForFunction(() => /moves\/s/.test(document.querySelector('.dock-state').textContent));
    await keep('live');
    await page.keyboard.press('s');
    await phase(page, 'done');
    await page.keyboard.press('Control+z');
    await page.waitForFunction(() => location.hash.includes('seconds=0.4') && document.body.dataset.phase === 'done');
    await page.keyboard.press('c');
    await page.locator('#playback input').evaluate((slider) => {
      slider.value = 5000;
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    });
    await still(page);
    await keep('playback');
    await page.keyboard.press('c');
    await page.keyboard.press('t');
    await page.locator('.order-row').nth(1).waitFor();
    await keep('table');
    await page.keyboard.press('t');
    await page.keyboard.press('?');
    await keep('help');
    await clean('help');
    await page.keyboard.press('Escape');

    await drop(page, 'rings.dxf', sample('parts-in-parts.dxf'));
    await planned(page, 'rings.dxf', 'done');
    for (const [step, key, pins] of [['Home', '1', 1], ['End', '0', 2], ['ArrowLeft', 'x', 3]]) {
      await page.keyboard.press(step);
      await replanned(page, () => page.keyboard.press(key));
      await page.waitForFunction((n) => document.querySelectorAll('.pins').length === n, pins);
    }
    await still(page);
    await keep('contour');
    await panel('Drawing');
    await keep('pins');
    await clean('pins');
    await page.keyboard.press('Escape');

    await drop(page, 'careless.dxf', sample('gaps-and-copies.dxf'));
    await planned(page, 'careless.dxf', 'done');
    await panel('Drawing', 'Tolerances');
    await page.locator('.tolerance-field input[type=number]').first().fill('0.01');
    await page.waitForFunction(() => document.querySelector('.comparison').textContent.includes('joints'));
    await page.locator('.comparison').scrollIntoViewIfNeeded();
    await keep('preview');
    await clean('preview');
    await sheet();
    await still(page);
    await keep('preview-sheet');
    await panel('Machine', 'Advanced settings', 'Your machines');
    await keep('machine');
    await panel('Plan');
    const method = page.getByLabel('Method');
    await method.selectOption({ label: 'Research methods…' });
    await page.waitForFunction(() => document.querySelectorAll('optgroup option').length > 0);
    await method.selectOption({ label: 'RLSGA' });
    await phase(page, 'done');
    await panel('Plan', 'Parameters');
    await keep('plan');
    await method.selectOption({ index: 0 });
    await phase(page, 'done');
    await panel('Quote');
    await page.getByLabel(/^Thickness/).fill('3');
    await page.getByLabel('Density').fill('7.85');
    await page.keyboard.press('Tab');
    await page.waitForFunction(() => document.querySelector('.section[open]').textContent.includes('Weight'));
    await keep('quote');
    await clean('quote');
    await sheet();

    await dropAll(page, [['one.dxf', grid(30)], ['broken.dxf', Buffer.from('AC1032\0\0')], ['a-plate-with-a-long-name.dxf', sample('no-units.dxf')], ['four.dxf', grid(12)]]);
    await page.waitForFunction(() => document.querySelector('.queue').textContent === '2 of 4');
    await page.locator('.queue').click();
    await keep('queue');
    await clean('queue');
    await page.getByRole('button', { name: /^a-plate/ }).click();
    await phase(page, 'question');
    await keep('question');
    await drop(page, 'broken.dxf', Buffer.from('AC1032\0\0'));
    await page.locator('.failure').waitFor();
    await keep('failed');
  });
}

test('on paper there is the sheet in its own shape and what the sections say, without controls, on one page', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4', theme: 'dark' });
  await phase(page, 'done');
  // A4 at 96 pixels per inch, without its margins.
  await page.setViewportSize({ width: 718, height: 1047 });
  await page.emulateMedia({ media: 'print' });
  const shown = await page.evaluate(() => [...document.querySelectorAll('button, select, input, .playback')].filter((e) => e.checkVisibility()).map((e) => e.outerHTML.slice(0, 80)));
  assert.deepEqual(shown, []);
  assert.equal(await page.locator('.file-name').isVisible(), true);
  assert.match(await page.locator('.sections').innerText(), /As drawn[\s\S]*Nearest first[\s\S]*Now/);
  assert.doesNotMatch(await page.locator('.sections').innerText(), /Kept in this browser/);
  const [fit, scheme, high] = await page.evaluate(() => [getComputedStyle(document.querySelector('#canvas')).objectFit, getComputedStyle(document.documentElement).colorScheme, document.querySelector('.panel').getBoundingClientRect().bottom]);
  assert.deepEqual([fit, scheme], ['contain', 'light']);
  assert.ok(high <= 1047, String(high));
  await shot(page, 'look-print');
});

/** Runs in the page: the share of the pixels of a picture, a PNG in base64, that are light. */
const lightShare = async (png) => {
  const image = await createImageBitmap(new Blob([Uint8Array.from(atob(png), (c) => c.charCodeAt(0))], { type: 'image/png' }));
  const pen = new OffscreenCanvas(image.width, image.height).getContext('2d');
  pen.drawImage(image, 0, 0);
  const { data } = pen.getImageData(0, 0, image.width, image.height);
  let light = 0;
  for (let i = 0; i < data.length; i += 4) if (Math.min(data[i], data[i + 1], data[i + 2]) > 200) light += 1;
  return light / (data.length / 4);
};

test('the sheet was one black area where the system forces its colours', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4' });
  await page.emulateMedia({ forcedColors: 'active', colorScheme: 'light' });
  await page.reload();
  await phase(page, 'done');
  await still(page);
  const share = await page.evaluate(lightShare, (await page.locator('#canvas').screenshot()).toString('base64'));
  assert.ok(share > 0.8, String(share));
  const colors = await page.evaluate(() => ['.bar .cut', '.bar .air', '.toolbar [aria-pressed=true]', '.toolbar [aria-pressed=false]'].map((name) => getComputedStyle(document.querySelector(name)).backgroundColor));
  assert.equal(new Set(colors).size, 4, `bars and pressed buttons are told apart: ${colors}`);
  await shot(page, 'look-forced-colors');
});

for (const theme of ['dark', 'light']) {
  test(`the ${theme} theme prints a light sheet and a light chart`, async (t) => {
    const { page } = await openPage(t, { hash: 'seconds=0.4', theme });
    await phase(page, 'done');
    await still(page);
    await page.emulateMedia({ media: 'print' });
    await nextFrames(page, 4);
    for (const painted of ['#canvas', '.chart canvas']) {
      const share = await page.evaluate(lightShare, (await page.locator(painted).screenshot()).toString('base64'));
      assert.ok(share > 0.8, `${painted}: ${share}`);
    }
  });
}
