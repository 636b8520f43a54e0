// A pool of planners: the queue, back-pressure, workers that die, signals, and memory that does not grow.

import assert from 'node:assert/strict';
import { getEventListeners } from 'node:events';
import { readFile } from 'node:fs/promises';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { Worker } from 'node:worker_threads';
import { createPool } from 'kerfway';
import { createFunctions } from '../../dist/sdk/functions.js';
import { Planner } from '../../dist/sdk/planner.js';
import { poolOf } from '../../dist/sdk/pool.js';
import { bytes, circle, dxf, KEYBOARD, square } from './support.mjs';

const SDK = new URL('../../dist/sdk/', import.meta.url);
const module = new WebAssembly.Module(await readFile(new URL('pkg/kerfway_bg.wasm', SDK)));
const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));
const SHORT = { units: 'mm', seed: 1, moves: 2_000, outputs: ['json'] };
const LONG = { seconds: 60, seed: 4 };

/** A pool whose workers the test can kill. */
function fragile(t, size) {
  const workers = [];
  const start = (onMessage, onDeath) => {
    const worker = new Worker(new URL('node-worker.js', SDK));
    workers.push(worker);
    worker.on('message', onMessage);
    worker.on('exit', () => onDeath('The planner ended unexpectedly.'));
    return { post: (m) => worker.postMessage(m), close: () => void worker.terminate() };
  };
  const pool = poolOf(() => Planner.open({ module, start }), size);
  t.after(() => pool.close());
  return { pool, workers };
}

/** A pool, closed after the test. */
function pooled(t, options) {
  const pool = createPool(options);
  t.after(() => pool.close());
  return pool;
}

/** Resolves when a plan first reports that moves were made. */
function underWay() {
  let resolve;
  const promise = new Promise((r) => (resolve = r));
  return { onProgress: (p) => p.moves > 0 && resolve(), promise };
}

describe('calls of a pool', () => {
  it('are all answered, each with the plan of its own file', async (t) => {
    const pool = pooled(t, { size: 2 });
    const sides = Array.from({ length: 12 }, (_, k) => 10 + k);
    const plans = sides.map((side) => pool.plan(dxf(square(0, 0, side)), SHORT));
    assert.equal(pool.waiting, 10);
    const lengths = (await Promise.all(plans)).map(({ summary }) => Math.round(summary.cut_length));
    assert.deepEqual(lengths, sides.map((side) => 4 * side));
    assert.equal(pool.waiting, 0);
  });

  it('keep the options that they were given, although the caller changes them while they wait', async (t) => {
    const pool = pooled(t, { size: 1 });
    const reading = { units: 'mm', name: 'a.dxf' };
    const planning = { ...SHORT };
    const quoting = { units: 'mm', moves: 10, seed: 1, material: { name: 'birch' } };
    const calls = [pool.inspect(PLATE, reading), pool.plan(PLATE, planning), pool.quote(PLATE, quoting)];
    [reading.units, reading.name, planning.seed, planning.outputs, quoting.material.name] = ['in', 'b.dxf', 2, [], 'glass'];
    const [inspected, planned, quoted] = await Promise.all(calls);
    assert.deepEqual([inspected.units.unit, inspected.name], ['mm', 'a.dxf']);
    assert.deepEqual([planned.seed, Object.keys(planned.outputs), planned.options.seed], [1, ['json'], 1]);
    assert.equal(quoted.material.name, 'birch');
  });

  it('read no more files at once than the pool has workers', async (t) => {
    const pool = pooled(t, { size: 2 });
    let [open, most] = [0, 0];
    const read = async () => {
      most = Math.max(most, (open += 1));
      return PLATE;
    };
    const done = () => (open -= 1);
    await Promise.all(Array.from({ length: 20 }, () => pool.inspect(read).then(done)));
    // The second worker may come too late to meet the first.
    assert.ok(most <= 2, `${most} at once`);
  });

  it('let as many wait as the queue allows, and make the next wait for room', async (t) => {
    const pool = pooled(t, { size: 1, queue: 2 });
    const jobs = [];
    for (let k = 0; k < 9; k++) {
      await pool.room();
      jobs.push(pool.plan(PLATE, SHORT));
      assert.ok(pool.waiting <= 2, `${pool.waiting} wait`);
    }
    assert.equal(pool.waiting, 2);
    await Promise.all(jobs);
  });

  it('continue after unusable files', async (t) => {
    const pool = pooled(t, { size: 1 });
    const results = await Promise.allSettled([
      pool.plan(new Uint8Array(0), SHORT),
      pool.plan(PLATE, { ...SHORT, machine: 'plasma-9000' }),
      pool.plan(PLATE, SHORT),
    ]);
    assert.deepEqual(results.map((r) => r.status), ['rejected', 'rejected', 'fulfilled']);
    assert.match(results[0].reason.message, /empty/);
  });

  it('need a size and a queue that are whole numbers', () => {
    assert.throws(() => createPool({ siz: 2 }), /The pool has no option "siz"\. Did you mean "size"\?/);
    assert.throws(() => createPool({ size: 0 }), /The pool's size is 0\. Give a whole number from 1 on/);
    assert.throws(() => createPool({ size: 1, queue: 0.5 }), /queue is 0\.5/);
    assert.throws(() => createPool({ size: 'a'.repeat(100_000) }), { message: `The pool's size is "${'a'.repeat(40)}…". Give a whole number from 1 on.` });
    assert.throws(() => createPool({ size: Object.create(null) }), { code: 'out-of-range', message: "The pool's size is an object. Give a whole number from 1 on." });
  });
});

describe('the deadline of a pool', () => {
  it('did not grant the ten seconds that a plan searches by default', async () => {
    const { plan, quote } = createFunctions(async (_, __, seconds) => seconds);
    const granted = await Promise.all([plan(PLATE), plan(PLATE, { seconds: 3 }), plan(PLATE, { moves: 5 }), plan(PLATE, { seconds: 3, moves: 5 })]);
    assert.deepEqual(granted, [10, 3, 0, 3]);
    // A quote has a number of moves by default, which is known once the drawing was read.
    assert.deepEqual(await Promise.all([quote(PLATE), quote(PLATE, { seconds: 3 })]), [undefined, 3]);
  });
});

describe('a worker that dies', () => {
  it('loses nothing: its file is planned again, with the same bytes', async (t) => {
    const { pool, workers } = fragile(t, 2);
    // Progress is reported at least four times a second, so the plan has to run for longer than that.
    const options = { ...SHORT, moves: 12_000_000 };
    const { outputs } = await pool.plan(bytes(KEYBOARD), options);
    const news = underWay();
    const again = pool.plan(bytes(KEYBOARD), { ...options, onProgress: news.onProgress });
    const beside = pool.plan(PLATE, SHORT);
    await Promise.race([news.promise, again.then(() => assert.fail('done before its worker could die'))]);
    await workers[0].terminate();
    assert.ok((await again).outputs.json === outputs.json, 'another plan after the death');
    assert.equal((await beside).summary.contours, 2);
  });

  it('twice at the same file: that file fails with a sentence, and the next does not', async (t) => {
    const { pool, workers } = fragile(t, 1);
    const killing = () => {
      void workers.at(-1).terminate();
      return bytes(KEYBOARD);
    };
    const failing = pool.plan(killing, LONG);
    const next = pool.plan(PLATE, SHORT);
    await assert.rejects(failing, /^KerfwayError: The planner ended unexpectedly\. It was tried 2 times; this file may need more memory than there is\.$/);
    assert.equal((await next).summary.contours, 2);
  });

  it('while idle: the next file gets a new worker', async (t) => {
    const { pool, workers } = fragile(t, 1);
    await pool.plan(PLATE, SHORT);
    await workers[0].terminate();
    assert.equal((await pool.plan(PLATE, SHORT)).summary.contours, 2);
  });
});

// Seen on a busy machine: two workers died at once, the death of the idle one was reported last, and it got the file of the
// other, which used up both tries.
it('a file whose worker died does not go to an idle one that died with it', async (t) => {
  const planner = (name, work) => ({ name, replaced: null, close: () => {}, work });
  const answered = [];
  const all = ['first', 'second', 'third'].map((name) => planner(name));
  const opened = [...all];
  const pool = poolOf(async () => opened.shift(), 2);
  t.after(() => pool.close());
  // The death of a worker is noticed when it gets a request, or when it is reported.
  const dead = new Set();
  let fall;
  const falls = new Promise((resolve) => (fall = resolve));
  for (const p of all) {
    p.load = async (_, name) => {
      if (name === 'long.dxf' && p.name === 'first') await falls;
      if (dead.has(p.name)) {
        p.replaced = 'The planner ended unexpectedly.';
        throw new Error(p.replaced);
      }
      answered.push([p.name, name]);
      throw new Error(`read by the ${p.name}`);
    };
  }
  const long = pool.inspect(PLATE, { name: 'long.dxf' });
  await assert.rejects(pool.inspect(PLATE, { name: 'short.dxf' }), /read by the second/);
  ['first', 'second'].forEach((name) => dead.add(name));
  fall();
  await assert.rejects(long, /read by the third/);
  assert.deepEqual(answered, [['second', 'short.dxf'], ['third', 'long.dxf']]);
});

describe('signals and closing', () => {
  it('an aborted plan makes room for the next at once, and an aborted call leaves the queue', async (t) => {
    const pool = pooled(t, { size: 1 });
    const [first, second] = [new AbortController(), new AbortController()];
    const news = underWay();
    const running = pool.plan(bytes(KEYBOARD), { ...LONG, signal: first.signal, onProgress: news.onProgress });
    const waiting = pool.plan(PLATE, { ...SHORT, signal: second.signal });
    const last = pool.plan(PLATE, SHORT);
    await news.promise;
    second.abort();
    await assert.rejects(waiting, { name: 'AbortError' });
    assert.equal(pool.waiting, 1);
    first.abort();
    await assert.rejects(running, { name: 'AbortError' });
    assert.equal((await last).summary.contours, 2);
  });

  it('one signal for a batch made Node warn of a leak', async (t) => {
    const warnings = [];
    const heard = (warning) => warnings.push(warning.name);
    process.on('warning', heard);
    t.after(() => process.off('warning', heard));
    const pool = pooled(t, { size: 2 });
    const control = new AbortController();
    const { signal } = control;
    const listeners = () => getEventListeners(signal, 'abort').length;
    const batch = () => Array.from({ length: 12 }, () => pool.plan(PLATE, { ...SHORT, signal }));
    assert.equal((await Promise.all(batch())).length, 12);
    assert.equal(listeners(), 0);
    const aborted = batch();
    assert.equal(listeners(), 1);
    control.abort();
    assert.deepEqual((await Promise.allSettled(aborted)).map(({ reason }) => reason?.name), Array(12).fill('AbortError'));
    assert.deepEqual([listeners(), warnings], [0, []]);
  });

  it('closing rejects running, waiting and later calls', async () => {
    const pool = createPool({ size: 1 });
    const news = underWay();
    const jobs = [pool.plan(bytes(KEYBOARD), { ...LONG, onProgress: news.onProgress }), pool.plan(PLATE, SHORT)];
    await news.promise;
    pool.close();
    for (const job of [...jobs, pool.inspect(PLATE)]) await assert.rejects(job, /^KerfwayError: The pool was closed\.$/);
  });
});

describe('a worker that is still starting', () => {
  /** A pool of one whose planners start when the test says so. */
  function starting(deadline) {
    const starts = [];
    const closed = [];
    const pool = poolOf(() => new Promise((resolve) => {
      const own = starts.length + 1;
      starts.push(() => resolve({ replaced: null, close: () => closed.push(own), check: async () => own }));
    }), 1, 1, deadline);
    return { pool, starts, closed };
  }

  it('did not let go of a call that was aborted', async () => {
    const { pool, starts, closed } = starting();
    const control = new AbortController();
    const first = pool.check('x', { signal: control.signal });
    await wait(1);
    control.abort();
    await assert.rejects(first, { name: 'AbortError' });
    assert.deepEqual([starts.length, pool.waiting], [1, 0]);
    // The next call does not wait for it, and a pool keeps no more planners than its size.
    const second = pool.check('y');
    await wait(1);
    starts[1]();
    assert.equal(await second, 2);
    starts[0]();
    await wait(1);
    assert.deepEqual(closed, [1]);
    pool.close();
    assert.deepEqual(closed, [1, 2]);
  });

  it('serves the next call when it has started', async () => {
    const { pool, starts, closed } = starting();
    const first = pool.check('x', { signal: AbortSignal.timeout(1) });
    await assert.rejects(first, { name: 'TimeoutError' });
    starts[0]();
    await wait(1);
    assert.equal(await pool.check('y'), 1);
    assert.deepEqual([starts.length, closed], [1, []]);
  });

  it('was given any time beside the deadline', async () => {
    const { pool, starts } = starting(0.05);
    await assert.rejects(pool.check('x'), { code: 'deadline' });
    starts[0]();
    await wait(1);
    assert.equal(await pool.check('y'), 1);
  });
});

it('a hundred files take no more memory than ten', async (t) => {
  const pool = pooled(t, { size: 2 });
  const file = bytes(KEYBOARD);
  const run = (count) => Promise.all(Array.from({ length: count }, () => pool.plan(() => file, { ...SHORT, outputs: [] }).then(() => {})));
  await run(20);
  const before = process.memoryUsage().rss;
  await run(100);
  const grown = (process.memoryUsage().rss - before) / 1e6;
  // A planner for each file that is never released would take about 300 MB.
  assert.ok(grown < 60, `${grown.toFixed(0)} MB more`);
});

it('a call that was aborted just as its turn came kept its place for ever', async () => {
  // A planner whose checks end when the test says so.
  for (let ticks = 0; ticks < 12; ticks += 1) {
    const running = [];
    const pool = poolOf(async () => ({ replaced: null, close() {}, check: () => new Promise((resolve) => running.push(resolve)) }), 1, 1);
    const first = pool.check('x');
    await wait(1);
    const control = new AbortController();
    const second = pool.check('y', { signal: control.signal }).catch((error) => error.name);
    await wait(1);
    running[0]('done');
    let later = Promise.resolve();
    for (let k = 0; k < ticks; k += 1) later = later.then(() => {});
    later.then(() => control.abort());
    assert.equal(await first, 'done');
    assert.equal(await second, 'AbortError');
    const third = pool.check('z');
    await wait(1);
    assert.equal(pool.waiting, 0, `aborted after ${ticks} ticks`);
    running.at(-1)('third');
    assert.equal(await third, 'third');
    pool.close();
  }
});
