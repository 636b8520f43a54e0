// Several workers search one plan: the result is reproducible, the plan can be paused and stopped, and a worker may die.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { Worker } from 'node:worker_threads';
import { MultiSearch } from '../../dist/sdk/multi-search.js';
import { Planner } from '../../dist/sdk/planner.js';
import { bytes, circle, dxf, KEYBOARD } from './support.mjs';

const SDK = new URL('../../dist/sdk/', import.meta.url);
const module = new WebAssembly.Module(await readFile(new URL('pkg/kerfway_bg.wasm', SDK)));

/** A planner that has read a drawing, and its workers, which the test can end. `change` may change what the others than the first send. */
async function plannerWithWorkers(t, change = () => {}) {
  const workers = [];
  const start = (onMessage, onDeath) => {
    const worker = new Worker(new URL('node-worker.js', SDK));
    const isFirst = workers.push(worker) === 1;
    worker.on('message', (message) => {
      if (!isFirst) change(message);
      onMessage(message);
    });
    worker.on('exit', () => onDeath('The planner ended unexpectedly.'));
    return { post: (m) => worker.postMessage(m), close: () => void worker.terminate() };
  };
  const planner = await Planner.open({ module, start });
  t.after(() => planner.close());
  await planner.load(bytes(KEYBOARD), 'keyboard.dxf');
  return { planner, workers };
}

const never = () => assert.fail('progress was reported before the test waited for it');

describe('several workers', () => {
  it('give the same bytes each time, and a plan no worse than that of one worker', async (t) => {
    const { planner, workers } = await plannerWithWorkers(t);
    const options = { seed: 3, moves: 30_000, workers: 3 };
    const alone = await planner.plan({ ...options, workers: 1 }).done;
    const texts = [];
    for (let k = 0; k < 2; k++) {
      const { progress, reason } = await planner.plan(options).done;
      assert.equal(reason, 'budget');
      assert.equal(progress.moves, 90_000);
      assert.ok(progress.summary.total_time <= alone.progress.summary.total_time);
      texts.push(await planner.output('json'));
      assert.equal(JSON.parse(texts[k]).summary.total_time, progress.summary.total_time);
    }
    assert.ok(texts[0] === texts[1], 'the same seed, moves and workers gave two plans');
    assert.deepEqual(JSON.parse(texts[0]).budget, { moves: 30_000, seconds: null, done: 30_000, workers: 3 });
    assert.equal(workers.length, 3);
  });

  it('report a total time that never grows, and end with the best of all', async (t) => {
    const { planner } = await plannerWithWorkers(t);
    const reported = [];
    const { progress } = await planner.plan({ seed: 1, moves: 1_300_000, workers: 2 }, (p) => reported.push(p)).done;
    const times = reported.map((p) => p.summary.total_time);
    assert.ok(times.every((s, k) => k === 0 || s <= times[k - 1]), 'a worse path was reported after a better one');
    assert.equal(progress.summary.total_time, Math.min(...times, progress.summary.total_time));
    assert.equal(progress.moves, 2_600_000);
  });

  it('pause, resume and stop together', async (t) => {
    const { planner } = await plannerWithWorkers(t);
    let onProgress = never;
    const plan = planner.plan({ seed: 1, seconds: 60, workers: 2 }, (p) => onProgress(p));
    await new Promise((resolve) => (onProgress = (p) => p.moves > 1000 && resolve()));
    plan.pause();
    plan.resume();
    const more = await new Promise((resolve) => (onProgress = (p) => p.moves > 10_000 && resolve(p.moves)));
    onProgress = () => {};
    plan.stop();
    const { reason, progress } = await plan.done;
    assert.equal(reason, 'stopped');
    assert.ok(progress.moves >= more);
    assert.equal(JSON.parse(await planner.output('json')).summary.total_time, progress.summary.total_time);
  });

  it('continue for another budget', async (t) => {
    const { planner } = await plannerWithWorkers(t);
    await planner.plan({ seed: 1, moves: 5_000, workers: 2 }).done;
    const { progress } = await planner.continue({ moves: 5_000 }).done;
    assert.equal(progress.moves, 20_000);
  });

  it('continue a plan that has not begun', async (t) => {
    const { planner, workers } = await plannerWithWorkers(t);
    const plan = planner.plan({ seed: 1, moves: 300_000, workers: 2 });
    const more = planner.continue({ moves: 5_000 });
    const last = planner.continue({ moves: 5_000 });
    assert.equal((await plan.done).reason, 'stopped');
    assert.equal((await more.done).reason, 'stopped');
    const { reason, progress } = await last.done;
    assert.deepEqual([reason, workers.length], ['budget', 2]);
    // The first search may have made some moves before it heard that it goes on.
    assert.ok(progress.moves >= 10_000, `${progress.moves} moves`);
  });

  it('finish the plan when one of them dies', async (t) => {
    const { planner, workers } = await plannerWithWorkers(t);
    const plan = planner.plan({ seed: 1, seconds: 1, workers: 3 });
    await plan.started;
    await workers[1].terminate();
    const { reason } = await plan.done;
    assert.equal(reason, 'budget');
    const again = await planner.plan({ seed: 1, moves: 5_000, workers: 3 }).done;
    assert.equal(again.progress.moves, 15_000);
  });

  it('keep the best path when the first worker dies', async (t) => {
    const { planner, workers } = await plannerWithWorkers(t);
    let last = null;
    const plan = planner.plan({ seed: 1, seconds: 60, workers: 2 }, (p) => (last = p));
    await plan.started;
    await new Promise((resolve) => setTimeout(resolve, 200));
    await workers[0].terminate();
    const { reason, progress } = await plan.done;
    assert.equal(reason, 'replaced');
    assert.ok(progress.summary.total_time <= last.summary.total_time);
  });

  it('stop a running plan when another one begins', async (t) => {
    const { planner } = await plannerWithWorkers(t);
    const first = planner.plan({ seed: 1, seconds: 60, workers: 2 });
    await first.started;
    const second = planner.plan({ seed: 2, moves: 2_000, workers: 2 });
    assert.equal((await first.done).reason, 'stopped');
    assert.equal((await second.done).progress.moves, 4_000);
  });

  it('must be 1 to 64', async (t) => {
    const { planner } = await plannerWithWorkers(t);
    await assert.rejects(planner.plan({ workers: 0, moves: 1 }).done, /The option "workers" is 0\. Give a whole number from 1 to 64/);
    await assert.rejects(planner.plan({ workers: 65, moves: 1 }).done, /from 1 to 64/);
  });
});

/** 400 circles in random places, for which two searches rarely find the same path. */
const SCATTERED = (() => {
  let state = 12345;
  const random = () => (state = (state * 1103515245 + 12345) % 2 ** 31) / 2 ** 31;
  const places = [];
  while (places.length < 400) {
    const [x, y] = [20 + 900 * random(), 20 + 900 * random()];
    if (places.every((p) => Math.hypot(p[0] - x, p[1] - y) > 5)) places.push([x, y]);
  }
  return dxf(...places.map(([x, y]) => circle(x, y, 2)));
})();

/** The result of a promise that must not take longer than some seconds. */
const soon = (promise, what) => Promise.race([promise, wait(20_000, null, { ref: false }).then(() => assert.fail(`${what} is still pending`))]);

const seconds = (progress) => progress.summary.total_time;

describe('a plan of several workers that is displaced', () => {
  /** A plan of two workers that has searched for a while, and the least total time that it has reported. */
  async function underWay(planner, seed) {
    const reported = [];
    let far;
    const isFar = new Promise((resolve) => (far = resolve));
    const plan = planner.plan({ seconds: 600, workers: 2, seed }, (p) => {
      reported.push(seconds(p));
      if (p.moves > 300_000) far();
    });
    await isFar;
    return { plan, least: () => Math.min(...reported) };
  }

  /** It ends with the best path that it has reported, or with a better one that its searches had when they were stopped. */
  async function endsWithItsBest({ plan, least }) {
    const { reason, progress } = await soon(plan.done, 'the displaced plan');
    assert.deepEqual([reason, progress.path.contours.length], ['stopped', 400]);
    assert.ok(seconds(progress) <= least(), `${seconds(progress)} s after ${least()} s`);
  }

  it('ends when another drawing is loaded, or the same one again', async (t) => {
    // The other search is always better, so that the first would have to take over its path.
    const { planner, workers } = await plannerWithWorkers(t, ({ progress }) => progress && (progress.summary.total_time /= 2));
    for (const seed of [1, 2]) {
      await planner.load(SCATTERED, 'scattered.dxf');
      const displaced = await underWay(planner, seed);
      if (seed === 1) await planner.load(bytes(KEYBOARD), 'keyboard.dxf');
      else await planner.reload({});
      await endsWithItsBest(displaced);
    }
    assert.equal(workers.length, 2);
  });

  it('does not change the plan of one worker that follows', async (t) => {
    const { planner } = await plannerWithWorkers(t);
    await planner.load(SCATTERED, 'scattered.dxf');
    const options = { moves: 200_000, seed: 7 };
    await planner.plan(options).done;
    const reference = await planner.output('json');
    for (const seed of [1, 2]) {
      const displaced = await underWay(planner, seed);
      const next = planner.plan(options);
      await endsWithItsBest(displaced);
      await soon(next.done, 'the next plan');
      assert.ok((await planner.output('json')) === reference, 'the same seed and moves gave two plans');
    }
  });

  it('by one that continues it ends, and both workers continue', async (t) => {
    const { planner } = await plannerWithWorkers(t);
    await planner.load(SCATTERED, 'scattered.dxf');
    const displaced = await underWay(planner, 1);
    const next = planner.continue({ moves: 300_000 });
    await endsWithItsBest(displaced);
    const { reason, progress } = await soon(next.done, 'the next plan');
    assert.equal(reason, 'budget');
    assert.ok(seconds(progress) <= displaced.least());
    assert.ok(progress.moves >= 900_000, `${progress.moves} moves`);
  });

  it('before it has begun leaves the next one alone', async (t) => {
    const { planner, workers } = await plannerWithWorkers(t);
    const displaced = planner.plan({ seconds: 600, workers: 2, seed: 1 });
    const { reason, progress } = await planner.plan({ moves: 5_000, seed: 1 }).done;
    assert.equal((await soon(displaced.done, 'the displaced plan')).reason, 'stopped');
    assert.deepEqual([reason, progress.moves, workers.length], ['budget', 5_000, 1]);
  });
});

describe('a plan of one worker after one of several', () => {
  it('is continued without the searches of the older plan', async (t) => {
    const { planner } = await plannerWithWorkers(t);
    await planner.load(SCATTERED, 'scattered.dxf');
    await planner.plan({ moves: 5_000, workers: 2, seed: 1 }).done;
    await planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    const before = await planner.plan({ moves: 5_000, seed: 1 }).done;
    const reported = [];
    const { reason, progress } = await soon(planner.continue({ moves: 5_000 }, (p) => reported.push(p)).done, 'the continued plan');
    assert.deepEqual([reason, progress.moves, progress.path.contours.length], ['budget', 10_000, before.progress.path.contours.length]);
    for (const p of [...reported, progress]) assert.ok(seconds(p) <= seconds(before.progress) && seconds(p) > 100, `${seconds(p)} s`);
    assert.equal(JSON.parse(await planner.output('json')).summary.total_time, seconds(progress));
  });
});

describe('the searches of one plan', () => {
  /** Two searches, whose messages the test makes. One that is expected to answer counts as dead after a second. */
  function searches(t) {
    const [others, reports, toFirst] = [[], [], []];
    const start = (onMessage) => {
      others.push({ onMessage, posts: [] });
      return { post: (message) => others.at(-1).posts.push(message), close: () => (others.closed = true) };
    };
    const search = new MultiSearch({ module, start, silenceLimits: { searching: 0, working: 0 }, toFirst: (m) => toFirst.push(m), report: (m) => reports.push(m) });
    t.after(() => search.close());
    search.begin(1, { workers: 2, seconds: 60 }, { bytes: new ArrayBuffer(0), name: 'a.dxf', options: {} });
    return { search, other: others[0], others, reports, toFirst };
  }
  const progress = (total_time, path) => ({ moves: 10, seconds: 1, rate: 5, summary: { total_time, lower_bound: 0, gap: null }, path });

  it('report the best path of all when another plan takes their place', (t) => {
    const { search, other, reports } = searches(t);
    search.receive(0, { type: 'progress', id: 1, progress: progress(100, 'path of the first') });
    other.onMessage({ type: 'progress', id: 1, progress: progress(90, 'path of the other') });
    search.end();
    const { type, id, reason, progress: last } = reports.at(-1);
    assert.deepEqual([type, id, reason, last.path, seconds(last), last.moves], ['done', 1, 'stopped', 'path of the other', 90, 20]);
    // What still arrives of them concerns nobody.
    other.onMessage({ type: 'done', id: 1, reason: 'stopped', progress: progress(80, 'late') });
    assert.equal(reports.length, 3);
  });

  it('that have ended count as idle, however often they are told to stop', async (t) => {
    const { search, other, others } = searches(t);
    other.onMessage({ type: 'done', id: 1, reason: 'exhausted', progress: progress(90, 'path') });
    search.post({ type: 'stop', id: 1 });
    search.end();
    await wait(1_500);
    assert.equal(others.closed, undefined, 'a healthy worker was ended because it was silent');
  });
});
