// Files that cannot be used: one clear sentence, in place, and the page works on.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { circle, dxf, polygon } from '../package/support.mjs';
import { grid, sample } from './page-drawings.mjs';
import { drop, openPage, phase, planned } from './page-support.mjs';

const WRONG = [
  ['photo.png', Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13, 0x49, 0x48, 0x44, 0x52]), /PNG/],
  ['part.dxf', Buffer.concat([Buffer.from('AC1027'), Buffer.alloc(200)]), /DWG.*DXF/],
  ['empty.dxf', Buffer.alloc(0), /empty/i],
  ['letter.dxf', Buffer.from('Dear Sir or Madam,\nplease find the drawing enclosed.\n'), /DXF/],
];

test('wrong files are refused with one sentence each, and a right one is planned afterwards', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  for (const [name, bytes, wanted] of WRONG) {
    await drop(page, name, bytes);
    await page.locator('.failure h2', { hasText: name }).waitFor();
    const sentence = await page.locator('.failure p').first().textContent();
    assert.match(sentence, wanted, name);
    assert.doesNotMatch(sentence, /error|exception|undefined|unwrap|panick/i, name);
    assert.ok(sentence.length < 240 && sentence.trim().endsWith('.'), `${name}: ${sentence}`);
    assert.equal(await page.locator('.failure').getAttribute('role'), 'alert');
    assert.equal(await page.locator('.file-name').textContent(), 'sheet_500.dxf', 'the drawing before stays');
  }
  await drop(page, 'right.dxf', grid(12));
  await planned(page, 'right.dxf');
  assert.equal(await page.locator('.failure').isVisible(), false);
});

test('Escape closes the card of a file that cannot be used, and keeps what is selected until it is pressed again', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=1' });
  await phase(page, 'done');
  await page.keyboard.press('Home');
  const selected = page.getByRole('region', { name: 'Selected contour' });
  await selected.waitFor();
  await drop(page, 'empty.dxf', Buffer.alloc(0));
  const failure = page.locator('.failure');
  await failure.waitFor();
  await page.keyboard.press('Escape');
  await failure.waitFor({ state: 'hidden' });
  assert.equal(await selected.isVisible(), true);
  await page.keyboard.press('Escape');
  assert.equal(await selected.isVisible(), false);
});

test('the card of an unusable file over a question: the next key closes the card and answers nothing', async (t) => {
  const { page } = await openPage(t, { hash: 'machine=diode-hobby&seconds=0.4&units=mm' });
  await phase(page, 'planning', 'done');
  const box = (x, y, w, h) => polygon([[x, y], [x + w, y], [x + w, y + h], [x, y + h]]);
  await drop(page, 'frame.dxf', Buffer.from(dxf(box(10, 10, 310, 215), box(30, 30, 270, 175), circle(110, 110, 20))));
  await planned(page, 'frame.dxf', 'question');
  await drop(page, 'empty.dxf', Buffer.alloc(0));
  const [failure, question] = [page.locator('.failure'), page.locator('.card.question')];
  await failure.waitFor();
  assert.equal(await question.isVisible(), false);
  await page.keyboard.press('Enter');
  await failure.waitFor({ state: 'hidden' });
  assert.equal(await question.isVisible(), true);
  assert.equal(await page.evaluate(() => document.body.dataset.phase), 'question');
});

test('a truncated file is planned as far as it goes, and the page says that it ends too early', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  const whole = sample('sheet_100.dxf');
  await drop(page, 'half.dxf', whole.subarray(0, Math.floor(whole.length * 0.8)));
  await planned(page, 'half.dxf', 'planning', 'done', 'question');
  const text = await page.locator('.findings').textContent();
  assert.match(text, /ends/i);
});

test('a planner that breaks down is replaced, the best path is kept, and the page says so', async (t) => {
  const { page } = await openPage(t, { broken: true });
  await phase(page, 'planning');
  await page.waitForFunction(() => document.querySelector('.large').textContent !== '');
  const planner = page.workers().find((w) => !w.url().includes('raster'));
  await planner.evaluate(() => setTimeout(() => { throw new Error('broken on purpose'); }));
  const notice = page.locator('.notice');
  await notice.waitFor({ state: 'visible' });
  assert.equal(await notice.textContent(), 'The planner broke down. It was started again and the drawing loaded again.');
  await phase(page, 'done');
  assert.match(await page.locator('.dock-head').textContent(), /best path is kept/);
  await page.getByRole('button', { name: 'Keep improving' }).click();
  await phase(page, 'planning');
});

test('a sample that could not be fetched was reported in the words of the browser', async (t) => {
  const { page } = await openPage(t, { hash: 'seconds=0.4', broken: true, prepare: () => {
    const { fetch } = window;
    window.fetch = (what, ...rest) => (String(what).includes('samples/') ? Promise.reject(new TypeError('Failed to fetch')) : fetch(what, ...rest));
  } });
  await page.locator('.failure').waitFor();
  assert.equal(await page.locator('.failure p').first().textContent(), 'The sample "Sheet, 500 contours" could not be loaded. Reload the page, or drop a DXF or SVG of your own.');
  await drop(page, 'right.dxf', grid(12));
  await planned(page, 'right.dxf');
});
