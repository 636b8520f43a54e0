// Several workers on one plan: reproducible, steerable, and no worse off when one of them dies.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { describe, it } from 'node:test';
import { Worker } from 'node:worker_threads';
import { Planner } from '../../dist/sdk/planner.js';
import { bytes, KEYBOARD } from './support.mjs';

const SDK = new URL('../../dist/sdk/', import.meta.url);
const module = new WebAssembly.Module(await readFile(new URL('pkg/kerfway_bg.wasm', SDK)));

/** A planner with a drawing, its workers in the test's hands. */
async function crewed(t) {
  const workers = [];
  const start = (heard, died) => {
    const worker = new Worker(new URL('node-worker.js', SDK));
    workers.push(worker);
    worker.on('message', heard);
    worker.on('exit', () => died('The planner ended unexpectedly.'));
    return { post: (m) => worker.postMessage(m), close: () => void worker.terminate() };
  };
  const planner = await Planner.open({ module, start });
  t.after(() => planner.close());
  await planner.load(bytes(KEYBOARD), 'keyboard.dxf');
  return { planner, workers };
}

const never = () => assert.fail('not asked for');

describe('several workers', () => {
  it('give the same bytes again, and more than the first alone has', async (t) => {
    const { planner, workers } = await crewed(t);
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

  it('tell nothing but improvements, and the best of all', async (t) => {
    const { planner } = await crewed(t);
    const told = [];
    const { progress } = await planner.plan({ seed: 1, moves: 1_300_000, workers: 2 }, (p) => told.push(p)).done;
    const times = told.map((p) => p.summary.total_time);
    assert.ok(times.every((s, k) => k === 0 || s <= times[k - 1]), 'a worse path was told after a better one');
    assert.equal(progress.summary.total_time, Math.min(...times, progress.summary.total_time));
    assert.equal(progress.moves, 2_600_000);
  });

  it('pause, go on and stop together', async (t) => {
    const { planner } = await crewed(t);
    let heard = never;
    const plan = planner.plan({ seed: 1, seconds: 60, workers: 2 }, (p) => heard(p));
    await new Promise((resolve) => (heard = (p) => p.moves > 1000 && resolve()));
    plan.pause();
    plan.resume();
    const more = await new Promise((resolve) => (heard = (p) => p.moves > 10_000 && resolve(p.moves)));
    heard = () => {};
    plan.stop();
    const { reason, progress } = await plan.done;
    assert.equal(reason, 'stopped');
    assert.ok(progress.moves >= more);
    assert.equal(JSON.parse(await planner.output('json')).summary.total_time, progress.summary.total_time);
  });

  it('go on for another budget', async (t) => {
    const { planner } = await crewed(t);
    await planner.plan({ seed: 1, moves: 5_000, workers: 2 }).done;
    const { progress } = await planner.continue({ moves: 5_000 }).done;
    assert.equal(progress.moves, 20_000);
  });

  it('do without one that dies', async (t) => {
    const { planner, workers } = await crewed(t);
    const plan = planner.plan({ seed: 1, seconds: 1, workers: 3 });
    await plan.started;
    await workers[1].terminate();
    const { reason } = await plan.done;
    assert.equal(reason, 'budget');
    const again = await planner.plan({ seed: 1, moves: 5_000, workers: 3 }).done;
    assert.equal(again.progress.moves, 15_000);
  });

  it('keep the best when the first dies', async (t) => {
    const { planner, workers } = await crewed(t);
    let told = null;
    const plan = planner.plan({ seed: 1, seconds: 60, workers: 2 }, (p) => (told = p));
    await plan.started;
    await new Promise((resolve) => setTimeout(resolve, 200));
    await workers[0].terminate();
    const { reason, progress } = await plan.done;
    assert.equal(reason, 'replaced');
    assert.ok(progress.summary.total_time <= told.summary.total_time);
  });

  it('take the place of a plan under way, which is told so', async (t) => {
    const { planner } = await crewed(t);
    const first = planner.plan({ seed: 1, seconds: 60, workers: 2 });
    await first.started;
    const second = planner.plan({ seed: 2, moves: 2_000, workers: 2 });
    assert.equal((await first.done).reason, 'stopped');
    assert.equal((await second.done).progress.moves, 4_000);
  });

  it('are from 1 to 64', async (t) => {
    const { planner } = await crewed(t);
    await assert.rejects(planner.plan({ workers: 0, moves: 1 }).done, /The option "workers" is 0\. Give a whole number from 1 to 64/);
    await assert.rejects(planner.plan({ workers: 65, moves: 1 }).done, /from 1 to 64/);
  });
});
