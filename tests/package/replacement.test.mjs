// A worker that dies or hangs is replaced, and no result is lost.

import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { Worker } from 'node:worker_threads';
import { createPlanner } from 'kerfway';
import { createFunctions } from '../../dist/sdk/functions.js';
import { Planner } from '../../dist/sdk/planner.js';
import { withNewPlanner } from '../../dist/sdk/with-planner.js';
import { bytes, CLI, fixture, folder, KEYBOARD, ran } from './support.mjs';

const SDK = new URL('../../dist/sdk/', import.meta.url);
const module = new WebAssembly.Module(await readFile(new URL('pkg/kerfway_bg.wasm', SDK)));

/** A planner on at most `most` real worker threads. The test can kill them, or drop their messages (`deaf`). */
async function fragile(t, silenceLimits, most = Infinity) {
  const control = { workers: [], replaced: [], searching: false, deaf: false };
  const start = (onMessage, onDeath) => {
    if (control.workers.length >= most) {
      setImmediate(() => onDeath('There is no memory for another.'));
      return { post: () => {}, close: () => {} };
    }
    const worker = new Worker(new URL('node-worker.js', SDK));
    control.workers.push(worker);
    worker.on('message', (message) => {
      control.searching ||= message.type === 'progress' && message.progress.moves > 0;
      if (!control.deaf) onMessage(message);
    });
    worker.on('error', (error) => onDeath(`The planner broke down (${error.message}).`));
    worker.on('exit', () => onDeath('The planner ended unexpectedly.'));
    return { post: (m) => worker.postMessage(m), close: () => void worker.terminate() };
  };
  const onReplaced = (message) => control.replaced.push(message);
  control.planner = await Planner.open({ module, start, onReplaced, silenceLimits });
  t.after(() => control.planner.close());
  return control;
}

/** A long plan, once it has reported a path. */
async function underWay(planner, options = {}) {
  let told;
  const first = new Promise((resolve) => (told = resolve));
  const plan = planner.plan({ seconds: 60, seed: 4, ...options }, (p) => p.path && told());
  await first;
  return plan;
}

describe('a worker that dies', () => {
  it('while it plans: the best path is kept, also for outputs', async (t) => {
    const control = await fragile(t);
    await control.planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    const plan = await underWay(control.planner);
    await control.workers[0].terminate();
    const { progress } = await plan.done;
    await until(() => control.replaced.length === 1);
    assert.match(control.replaced[0], /^The planner ended unexpectedly\. It was started again and the drawing loaded/);
    assert.equal(control.workers.length, 2);
    const written = JSON.parse(await control.planner.output('json'));
    assert.equal(written.summary.total_time, progress.summary.total_time);
    assert.equal(written.seed, 4);
  });

  it('after a plan: the plan is restored and can be continued', async (t) => {
    const control = await fragile(t);
    await control.planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    const { progress } = await control.planner.plan({ moves: 5_000, seed: 4 }).done;
    await control.workers[0].terminate();
    await until(() => control.replaced.length === 1);
    const gone = await control.planner.continue({ moves: 5_000 }).done;
    assert.ok(gone.progress.summary.total_time <= progress.summary.total_time + 1e-9);
    assert.equal(gone.seed, 4);
  });

  it('while it plans: the plan can be continued at once, also by one worker of two', { timeout: 60_000 }, async (t) => {
    for (const workers of [1, 2]) {
      const control = await fragile(t);
      await control.planner.load(bytes(KEYBOARD), 'keyboard.dxf');
      const plan = await underWay(control.planner, { workers });
      await control.workers[0].terminate();
      const { reason, progress } = await plan.done;
      // More moves than until the first exchange between two searches.
      const next = await control.planner.continue({ moves: 1_100_000 }).done;
      assert.deepEqual([reason, next.reason, next.seed, next.progress.moves], ['replaced', 'budget', 4, 1_100_000]);
      assert.ok(next.progress.summary.total_time <= progress.summary.total_time + 1e-9);
    }
  });

  it('while it plans: a plan that begins at once is the one that is continued and proven', { timeout: 60_000 }, async (t) => {
    const control = await fragile(t);
    await control.planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    const plan = await underWay(control.planner);
    await control.workers[0].terminate();
    await plan.done;
    const slow = structuredClone(control.planner.machines[0]);
    slow.cut.speed /= 10;
    const next = await control.planner.plan({ moves: 1000, seed: 9, machine: slow }).done;
    const { seed, progress } = await control.planner.continue({ moves: 1000 }).done;
    assert.deepEqual([seed, progress.moves], [9, 2000]);
    assert.ok(progress.summary.total_time <= next.progress.summary.total_time);
    const { seconds } = await control.planner.prove({ work: 2 }).done;
    // Cutting alone takes ten times as long as on the machine of the plan before.
    assert.ok(seconds > 0.9 * progress.summary.total_time && seconds <= progress.summary.total_time, `${seconds} s of ${progress.summary.total_time} s`);
  });

  it('while it reads: that file is refused, and the drawing before is restored', async (t) => {
    const control = await fragile(t);
    const before = await control.planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    const reading = control.planner.load(bytes('dxf-dev/mozman_ezdxf__forms.dxf'), 'forms.dxf');
    void control.workers[0].terminate();
    await assert.rejects(reading, /The planner ended unexpectedly\. It was started again/);
    const { sha256 } = await control.planner.reload({});
    assert.equal(sha256, before.sha256);
  });

  it('while it proves: the last bound is kept, and the plan goes on', async (t) => {
    const control = await fragile(t);
    await control.planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    const plan = await underWay(control.planner);
    let [last, found] = [0, null];
    const proof = control.planner.prove({}, (seconds, path) => {
      [last, found] = [seconds, path];
      void control.workers[1].terminate();
    });
    assert.deepEqual(await proof.done, { seconds: last, certificate: null, path: found, hindrance: 'The planner ended unexpectedly.' });
    assert.ok(last > 0);
    plan.stop();
    assert.ok((await plan.done).progress.summary.lower_bound >= last);
    assert.deepEqual([control.workers.length, control.replaced], [2, []]);
  });

  it('several times: a new one starts each time', async (t) => {
    const control = await fragile(t);
    await control.planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    for (let k = 0; k < 3; k++) {
      await control.workers[k].terminate();
      await until(() => control.replaced.length === k + 1);
    }
    assert.equal((await control.planner.reload({})).name, 'keyboard.dxf');
  });
});

/** The functions of the package, whose planners start a worker each. */
function functions(t) {
  const controls = [];
  const open = async () => (controls.push(await fragile(t)), controls.at(-1).planner);
  return { controls, ...createFunctions(withNewPlanner(open)) };
}

describe('a worker that dies while a quote is made', () => {
  const QUOTE = { moves: 3_000_000, seed: 4, material: { thickness: 3 } };
  const dying = (controls, deaths) => ({ moves }) => {
    if (moves > 0 && controls.length <= deaths) void controls.at(-1).workers[0].terminate();
  };

  it('left a report with 0 moves, which nobody can confirm: the quote is made once more', async (t) => {
    const { controls, quote } = functions(t);
    const whole = await quote(bytes(KEYBOARD), QUOTE);
    const again = await quote(bytes(KEYBOARD), { ...QUOTE, onProgress: dying(controls, 2) });
    assert.deepEqual(again, whole);
    assert.deepEqual([again.moves, controls.length], [QUOTE.moves, 3]);
  });

  it('twice: the quote fails with a sentence', async (t) => {
    const { controls, quote } = functions(t);
    const failing = quote(bytes(KEYBOARD), { ...QUOTE, onProgress: dying(controls, 2) });
    await assert.rejects(failing, { code: 'planner-died', message: 'The planner ended unexpectedly. It was tried 2 times; this file may need more memory than there is.' });
  });

  it('and confirmed: a good report was taken for a wrong one', async (t) => {
    const { controls, quote, verifyQuote } = functions(t);
    const report = await quote(bytes(KEYBOARD), QUOTE);
    const verifying = verifyQuote(bytes(KEYBOARD), report);
    await until(() => controls[1]?.searching);
    await controls[1].workers[0].terminate();
    assert.deepEqual(await verifying, { valid: true, differences: [], report });
    assert.equal(controls.length, 3);
  });

  it('on the command line: nothing is written, and the file fails with a sentence', async (t) => {
    const out = join(folder(t), 'quote.json');
    const dying = `import { Worker } from 'node:worker_threads';
      const { postMessage } = Worker.prototype;
      Worker.prototype.postMessage = function (message, ...rest) {
        if (message.type === 'plan') this.on('message', ({ type, progress }) => type === 'progress' && progress.moves > 0 && this.terminate());
        return postMessage.call(this, message, ...rest);
      };`;
    const { code, stderr } = await ran(['--import', `data:text/javascript,${encodeURIComponent(dying)}`, CLI, 'quote', fixture(KEYBOARD), '--moves', '30000000', '--json', out]);
    assert.deepEqual([code, existsSync(out)], [1, false]);
    assert.match(stderr, /polaris\.dxf: The planner ended unexpectedly\. Quote this drawing again\.\n$/);
  });
});

describe('a worker that no longer answers', () => {
  it('is replaced', async (t) => {
    const control = await fragile(t, { searching: 1, working: 1 });
    await control.planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    control.deaf = true;
    const reading = control.planner.reload({});
    setTimeout(() => (control.deaf = false), 1_500);
    await assert.rejects(reading, /no longer answers/);
    await until(() => control.replaced.length === 1);
    assert.equal((await control.planner.reload({})).name, 'keyboard.dxf');
  });

  it('is not replaced while a plan is paused or it has nothing to do', async (t) => {
    const control = await fragile(t, { searching: 0, working: 0 });
    await control.planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    await wait(1_500);
    assert.equal(control.workers.length, 1);
  });
});

describe('a worker that does not start', () => {
  it('is reported in one sentence', async () => {
    const start = (_, onDeath) => {
      setImmediate(() => onDeath('The planner broke down (its script did not load).'));
      return { post: () => {}, close: () => {} };
    };
    await assert.rejects(Planner.open({ module, start }), /^KerfwayError: The planner could not be started\./);
  });

  it('with a wasm file of another version was waited for for four minutes', async () => {
    const other = new WebAssembly.Module(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0));
    for (const worker of [true, false]) {
      const opening = createPlanner({ wasm: other, worker });
      const late = wait(10_000, 'late', { ref: false });
      await assert.rejects(Promise.race([opening, late]), { code: 'not-started', message: /^The planner could not be started\. The wasm file is not that of this version \(.+\)\. It was tried 2 times\.$/ });
    }
  });

  it('as the replacement of one that died: calls are rejected with the reason, and the process continues', async (t) => {
    const control = await fragile(t, undefined, 1);
    await control.planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    const plan = await underWay(control.planner);
    await control.workers[0].terminate();
    assert.equal((await plan.done).reason, 'replaced');
    await assert.rejects(control.planner.reload({}), /could not be started/);
    await assert.rejects(control.planner.plan({ moves: 10 }).done, /could not be started/);
    assert.equal(control.replaced.length, 0);
  });
});

describe('close', () => {
  it('rejects running calls and keeps no process alive', async (t) => {
    const control = await fragile(t);
    await control.planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    const reading = control.planner.reload({});
    control.planner.close();
    await assert.rejects(reading, /was closed/);
    await wait(50);
    assert.equal(control.workers.length, 1);
    assert.equal(control.replaced.length, 0);
  });
});

async function until(condition) {
  for (let k = 0; k < 500 && !condition(); k++) await wait(10);
  assert.ok(condition(), 'not within five seconds');
}
