// How smoothly the page works: its frames, its tasks, and a person who moves the sheet about.

import { nextFrames } from './page-support.mjs';

/** Runs in the page: records the time between frames. */
export const watchFrames = () => {
  window.frames = [];
  let before = 0;
  const frame = (now) => {
    if (before) window.frames.push(now - before);
    before = now;
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
};

/** Processor milliseconds of each task the page's thread ran while `act` went on, longest first. */
export async function tasksOf(page, act) {
  const browser = page.context().browser();
  await browser.startTracing(page, { categories: ['toplevel', 'devtools.timeline', 'disabled-by-default-devtools.timeline'] });
  await act();
  const { traceEvents } = JSON.parse((await browser.stopTracing()).toString());
  const main = new Set(traceEvents.filter((e) => e.name === 'thread_name' && e.args.name === 'CrRendererMain').map((e) => `${e.pid} ${e.tid}`));
  // The scheduler reports each task twice, under two names.
  const tasks = traceEvents.filter((e) => e.ph === 'X' && e.name === 'ThreadControllerImpl::RunTask' && e.tdur !== undefined && main.has(`${e.pid} ${e.tid}`));
  return tasks.map((e) => e.tdur / 1000).sort((a, b) => b - a);
}

/** Drags the sheet about, as a person would. */
export async function pan(page) {
  await page.mouse.move(500, 450);
  await page.mouse.down();
  for (let i = 0; i < 40; i += 1) await page.mouse.move(500 + 4 * i, 450 + 30 * Math.sin(i / 5));
  await page.mouse.up();
}

/** Zooms in and out with the wheel. */
export async function zoom(page) {
  for (let i = 0; i < 12; i += 1) {
    await page.mouse.wheel(0, i < 6 ? -240 : 240);
    await nextFrames(page, 4);
  }
}

/** Pans, zooms and moves the pointer over the sheet. */
export async function roam(page) {
  await pan(page);
  await zoom(page);
  for (let i = 0; i < 20; i += 1) await page.mouse.move(300 + 20 * i, 400);
}
