// Several workers search one plan: the result is reproducible, the plan can be paused and stopped, and a worker may die.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { describe, it } from 'node:test';
import { Worker } from 'node:worker_threads';
import { Planner } from '../../dist/sdk/planner.js';
import { bytes, KEYBOARD } from './support.mjs';

const SDK = new URL('../../dist/sdk/', import.meta.url);
const module = new WebAssembly.Module(await readFile(new URL('pkg/kerfway_bg.wasm', SDK)));

/** A planner that has read a drawing, and its workers, which the test can end. */
async function plannerWithWorkers(t) {
  const workers = [];
  const start = (onMessage, onDeath) => {
    const worker = new Worker(new URL('node-worker.js', SDK));
    workers.push(worker);
    worker.on('message', onMessage);
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
