// 10,000 contours: the page's thread stays free while they are planned, and nothing is fetched once the page is there.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { download, drop, grid, openPage, phase, planned } from './page-support.mjs';

/** Milliseconds: a frame longer than this is seen as a jerk. */
const FRAME = 50;

const watch = () => {
  window.tasks = [];
  window.frames = [];
  new PerformanceObserver((list) => window.tasks.push(...list.getEntries().map((e) => e.duration))).observe({ type: 'longtask' });
  let before = 0;
  const frame = (now) => {
    if (before) window.frames.push(now - before);
    before = now;
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
};

test('10,000 contours pan and zoom while planning without a frame over 50 ms', async (t) => {
  const { page } = await openPage(t, { prepare: watch });
  await phase(page, 'planning');
  await drop(page, 'ten-thousand.dxf', grid(10_000));
  await planned(page, 'ten-thousand.dxf', 'planning');
  await page.waitForFunction(() => document.querySelector('.section .gist').textContent.startsWith('10,000 contours'));
  await page.waitForTimeout(500);
  await page.evaluate(() => (window.tasks.length = window.frames.length = 0));

  await page.mouse.move(500, 450);
  await page.mouse.down();
  for (let i = 0; i < 40; i += 1) await page.mouse.move(500 + 4 * i, 450 + 30 * Math.sin(i / 5));
  await page.mouse.up();
  for (let i = 0; i < 12; i += 1) {
    await page.mouse.wheel(0, i < 6 ? -240 : 240);
    await page.waitForTimeout(60);
  }
  await page.waitForTimeout(1000);
  assert.equal(await page.evaluate(() => document.body.dataset.phase), 'planning');

  const { tasks, frames } = await page.evaluate(() => ({ tasks: window.tasks, frames: window.frames.sort((a, b) => a - b) }));
  const at = (share) => frames[Math.floor((frames.length - 1) * share)].toFixed(1);
  t.diagnostic(`frames ${frames.length}: median ${at(0.5)} ms, 95 % ${at(0.95)} ms, longest ${at(1)} ms; tasks over 50 ms: ${tasks.map((d) => d.toFixed(0)).join(', ') || 'none'}`);
  // Frames are late when the machine is busy with other things; what the page itself does at a stretch is told by the
  // tasks of its thread. The planner's and the drawing's work is in workers.
  assert.ok(Number(at(0.5)) < FRAME / 2, `median frame ${at(0.5)} ms`);
  assert.ok(tasks.length <= Math.max(1, frames.length / 100), `tasks over ${FRAME} ms: ${tasks}`);
});

test('nothing is fetched after the page has loaded', async (t) => {
  const { page, requests, url } = await openPage(t);
  await phase(page, 'planning');
  await page.waitForLoadState('networkidle');
  assert.ok(requests.every((r) => r.startsWith(url)), 'everything comes from the page’s own folder');
  requests.length = 0;
  await drop(page, 'mine.dxf', grid(60));
  await planned(page, 'mine.dxf');
  await page.keyboard.press('s');
  await phase(page, 'done');
  await download(page, () => page.locator('.dock').getByRole('button', { name: 'G-code' }).click());
  assert.deepEqual(requests.filter((r) => !r.startsWith('blob:')), []);
});

test('a strict content security policy is in force', async (t) => {
  const { page } = await openPage(t);
  await phase(page, 'planning');
  const policy = await page.locator('meta[http-equiv="Content-Security-Policy"]').getAttribute('content');
  for (const rule of ["default-src 'none'", "script-src 'self' 'wasm-unsafe-eval'", "style-src 'self'", "connect-src 'self'"]) assert.ok(policy.includes(rule), rule);
  assert.doesNotMatch(policy, /unsafe-inline|'unsafe-eval'|\*/);
});
