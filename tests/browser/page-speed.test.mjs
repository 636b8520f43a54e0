// 10,000 contours: the page's thread stays free while they are planned, and nothing is fetched once the page is there.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grid } from './page-drawings.mjs';
import { roam, tasksOf, watchFrames } from './page-frames.mjs';
import { download, drop, nextFrames, openPage, phase, planned, until } from './page-support.mjs';

/** Milliseconds: a frame longer than this is seen as a jerk. */
const FRAME = 50;

test('10,000 contours pan and zoom while planning without a frame over 50 ms', async (t) => {
  const { page } = await openPage(t, { prepare: watchFrames });
  await phase(page, 'planning');
  await drop(page, 'ten-thousand.dxf', grid(10_000));
  await planned(page, 'ten-thousand.dxf', 'planning');
  await page.waitForFunction(() => document.querySelector('.section .gist').textContent.startsWith('10,000 contours'));
  // Long enough for a busy machine to get through what follows.
  await page.getByRole('heading', { name: 'Plan', exact: true }).click();
  await page.getByLabel('Search for').selectOption('1 min');
  await phase(page, 'planning');
  await page.evaluate(() => (window.frames.length = 0));

  const tasks = await tasksOf(page, async () => {
    await roam(page);
    await nextFrames(page, 30);
  });
  assert.equal(await page.evaluate(() => document.body.dataset.phase), 'planning');

  const frames = await page.evaluate(() => window.frames.sort((a, b) => a - b));
  const at = (share) => frames[Math.floor((frames.length - 1) * share)].toFixed(1);
  t.diagnostic(`${frames.length} frames: median ${at(0.5)} ms, 95 % ${at(0.95)} ms, longest ${at(1)} ms by the clock`);
  t.diagnostic(`${tasks.length} tasks of the page's thread, the longest ${tasks.slice(0, 3).map((d) => d.toFixed(1)).join(', ')} ms of processor time`);
  // By the clock a frame is also late when the machine is busy with other things. What the page itself takes for a
  // frame is the processor time of its tasks; planning and drawing are in workers.
  assert.ok(tasks.length > 200, 'the trace holds the tasks');
  assert.ok(tasks[0] < FRAME, `the longest task took ${tasks[0]} ms`);
});

test('nothing is fetched after the page has loaded', async (t) => {
  const { page, requests, url } = await openPage(t, { hash: 'seconds=1' });
  await phase(page, 'planning', 'done');
  await page.evaluate(() => navigator.serviceWorker.ready);
  // The writers of programs are loaded when somebody uses the page for the first time, or after twelve seconds, and the file for proofs last: with the
  // first proof, ten seconds after a plan was begun.
  await page.keyboard.press('Shift');
  for (const name of ['kerfway_outputs_bg', 'kerfway_research_bg']) await until(page, `${name} is requested`, () => requests.some((r) => r.includes(name)));
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
