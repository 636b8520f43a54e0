// The values of callers: each is accepted or refused with one sentence before a worker gets it. A callback that throws fails
// its own plan, closing ends no process, and a worker that dies while it starts is started once more.

import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { Worker } from 'node:worker_threads';
import { createPlanner, createPool, inspect, plan, quote } from 'kerfway';
import * as core from '../../dist/sdk/pkg/kerfway.js';
import { Planner } from '../../dist/sdk/planner.js';
import { poolOf } from '../../dist/sdk/pool.js';
import { bytes, circle, dxf, folder, KEYBOARD, kerfway, square } from './support.mjs';

const SDK = new URL('../../dist/sdk/', import.meta.url);
const module = new WebAssembly.Module(await readFile(new URL('pkg/kerfway_bg.wasm', SDK)));
const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10));
const SHORT = { units: 'mm', seed: 1, moves: 500 };
const LONG = { seconds: 60, seed: 4 };
const probe = await createPlanner();
const [PRESET] = probe.machines;
probe.close();
const machine = (change) => {
  const made = structuredClone(PRESET);
  change(made);
  return made;
};
const refusal = (work) => work.then(() => assert.fail('taken'), (error) => error.message);

describe('numbers', () => {
  for (const seconds of [NaN, null, Infinity, -1, '5', {}]) {
    it(`seconds of ${JSON.stringify(seconds)} (${seconds}) are refused at once`, async (t) => {
      const pool = createPool({ size: 1 });
      t.after(() => pool.close());
      for (const on of [{ plan, quote }, pool]) {
        for (const f of ['plan', 'quote']) assert.match(await refusal(on[f](PLATE, { seconds })), /^The option "seconds" is .*Give a number from 0 to 604800 s: /);
      }
      assert.equal((await pool.plan(PLATE, SHORT)).summary.contours, 2);
    });
  }

  it('of a material that are not numbers are refused', async () => {
    for (const thickness of [NaN, -1, Infinity, '3mm']) {
      assert.match(await refusal(quote(PLATE, { ...SHORT, material: { thickness } })), /^The option "material\.thickness" is .*Give a number from 0\.001 to 1000 mm/);
    }
  });

  it('of parameters that would use all memory are refused, and the worker survives', async (t) => {
    const planner = await createPlanner();
    t.after(() => planner.close());
    await planner.load(PLATE, 'plate.dxf');
    const says = await refusal(planner.plan({ ...{ seed: 1, moves: 500 }, method: 'lpspso', parameters: { particles: 1_000_000_000 } }).done);
    assert.match(says, /^The parameter "particles" is 1000000000\. Give a number from 1 to 1000: /);
    assert.match(await refusal(planner.plan({ method: 'lpspso', parameters: { particles: NaN } }).done), /^The option "parameters\.particles" is NaN\. Give a finite number/);
    assert.equal(planner.replaced, null);
  });
});

describe('names', () => {
  it('of machine fields, options and parameters that are misspelt are refused with a suggestion', async () => {
    const says = (options) => refusal(plan(PLATE, { ...SHORT, ...options }));
    assert.equal(await says({ machine: machine((m) => (m.kerf_witdh = 0.2)) }), 'The machine has no field "kerf_witdh". Did you mean "kerf_width"?');
    assert.equal(await says({ machine: machine((m) => (m.cut.sped = 1)) }), 'The machine has no field "cut.sped". Did you mean "cut.speed"?');
    assert.equal(await says({ secnds: 1 }), 'plan has no option "secnds". Did you mean "seconds"?');
    assert.equal(await says({ member: 1 }), 'plan has no option "member". There are: ' + 'units, dpi, tolerance, keepDamaged, turn, joinTolerance, copyTolerance, layers, orderByLayer, passOrder, ignoreOutline, keepBorder, groups, partByPart, commonCuts, first, last, mark, sequences, exclude, together, joints, contours, machine, material, place, start, allowOffBed, method, parameters, seed, warm, workers, seconds, moves, name, signal, onLoaded, onProgress, outputs.');
    assert.equal(await says({ method: 'rlsga', parameters: { popluation: 9 } }), 'The method has no parameter "popluation". Did you mean "population"?');
    assert.match(await says({ machine: 'co2-10w' }), /^There is no machine named "co2-10w"\. Did you mean "co2-100w"\?/);
    assert.equal(await refusal(quote(PLATE, { material: { thicknes: 1 } })), 'quote has no option "material.thicknes". Did you mean "material.thickness"?');
  });

  it('of files that are not text are refused', async () => {
    for (const name of [5, {}, true, null]) assert.match(await refusal(inspect(PLATE, { name })), /^The option "name" is .*Give a text\.$/);
    for (const source of [5, 'text', null, [1, 2]]) assert.match(await refusal(inspect(source)), /not given as bytes/);
  });

  it('in a Map or a Set were ignored, and so was what they said', async () => {
    for (const list of [new Map([['moves', 10]]), new Set(['moves'])]) assert.equal(await refusal(quote(PLATE, list)), 'quote is a list. Give an object with named options.');
    assert.equal(await refusal(quote(PLATE, { material: new Map([['thickness', 3]]) })), 'The option "material" is a list. Give an object.');
  });

  it('of bytes that were transferred to another thread are none: the sentence says so', async () => {
    const given = PLATE.slice();
    structuredClone(given.buffer, { transfer: [given.buffer] });
    assert.match(await refusal(inspect(given)), /^The drawing is not given as bytes, or its buffer was transferred\. Give an ArrayBuffer/);
  });

  it('of layers that the drawing does not have give a finding with a suggestion', async () => {
    const { findings } = await inspect(dxf(square(0, 0, 100, 'CUT')), { layers: [{ name: 'CTU', operation: 'mark' }] });
    const finding = findings.find((f) => f.code === 'layer-unknown');
    assert.deepEqual([finding.severity, finding.layer], ['warning', 'CTU']);
    assert.match(finding.message, /^The drawing has no layer "CTU"/);
  });
});

// The bindings without the package around them.
describe('the wasm file alone', () => {
  core.initSync({ module });
  const made = (...args) => {
    try {
      new core.Job(...args).free();
      return 'taken';
    } catch (error) {
      return error.message;
    }
  };
  it('refuses values that are not text, bytes or options', () => {
    for (const name of [5, {}, true, null, undefined, Symbol.iterator, () => {}]) assert.match(made(PLATE, name, {}), /^The file's name is .*Give a text\.$/);
    for (const file of [5, {}, 'x', null, undefined]) assert.match(made(file, 'x.dxf', {}), /Give its bytes/);
    for (const options of [5, 'x', [], true, () => {}]) assert.match(made(PLATE, 'x.dxf', options), /^Reading is /);
    assert.equal(made(PLATE, 'x.dxf', { tolerence: 1 }), 'Reading has no option "tolerence". Did you mean "tolerance"?');
    const endless = {};
    endless.layers = [endless];
    assert.match(made(PLATE, 'x.dxf', endless), /^Reading /);
    assert.equal(made(PLATE, 'x.dxf', { units: undefined }), 'taken');
  });

  it('refuses values that are not numbers', () => {
    const job = new core.Job(PLATE, 'x.dxf', {});
    for (const seconds of [NaN, Infinity, -1, null]) assert.throws(() => job.start({ seconds }), /^Error: The option "seconds" is /);
    for (const seed of [0.5, -1, 1e300, NaN]) assert.throws(() => job.start({ seed }), /^Error: The option "seed" is .*Give a whole number/);
    assert.throws(() => job.workOrder(5), /Give a text/);
    job.free();
  });
});

/** Resolves when a search reports progress. */
function underWay() {
  let resolve;
  const promise = new Promise((r) => (resolve = r));
  return { onProgress: (p) => p.moves > 0 && resolve(), promise };
}

describe('a callback that throws', () => {
  const thrown = new Error('The shop is closed.');
  const throwing = () => {
    throw thrown;
  };
  const rejecting = async () => throwing();

  for (const [how, callback] of [['throws', throwing], ['rejects', rejecting]]) {
    it(`rejects its own plan and no other (${how})`, async (t) => {
      const pool = createPool({ size: 2 });
      t.after(() => pool.close());
      const beside = pool.plan(PLATE, SHORT);
      for (const name of ['onProgress', 'onLoaded']) {
        await assert.rejects(plan(bytes(KEYBOARD), { ...LONG, [name]: callback }), thrown);
        await assert.rejects(pool.plan(bytes(KEYBOARD), { ...LONG, [name]: callback }), thrown);
      }
      await assert.rejects(pool.quote(bytes(KEYBOARD), { ...LONG, onProgress: callback }), thrown);
      assert.equal((await beside).summary.contours, 2);
      assert.equal((await pool.plan(PLATE, SHORT)).summary.contours, 2);
    });
  }

  it('is not called again, and its worker stops: the planner is free at once', async (t) => {
    const told = [];
    const worker = watched(told);
    const planner = await Planner.open({ module, start: worker.start });
    t.after(() => planner.close());
    await planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    let calls = 0;
    const running = planner.plan(LONG, () => {
      calls += 1;
      throw thrown;
    });
    await assert.rejects(running.done, thrown);
    await until(() => told.includes('done'));
    const before = told.length;
    await wait(600);
    assert.deepEqual([calls, told.length], [1, before]);
    assert.equal((await planner.plan({ seed: 1, moves: 500 }).done).reason, 'budget');
  });
});

function watched(told) {
  const workers = [];
  const start = (onMessage, onDeath) => {
    const worker = new Worker(new URL('node-worker.js', SDK));
    workers.push(worker);
    worker.on('message', (message) => {
      told.push(message.type);
      onMessage(message);
    });
    worker.on('exit', () => onDeath('The planner ended unexpectedly.'));
    return { post: (m) => worker.postMessage(m), close: () => void worker.terminate() };
  };
  return { start, workers };
}

async function until(holds) {
  for (let k = 0; k < 500 && !holds(); k += 1) await wait(20);
  assert.ok(holds());
}

// A rejection that nobody handles ends a Node process: here it fails the test.
describe('closing while nobody awaits a call does not end the process', () => {
  it('of a pool', async () => {
    const pool = createPool({ size: 1 });
    const news = underWay();
    void pool.plan(bytes(KEYBOARD), { ...LONG, onProgress: news.onProgress });
    void pool.quote(PLATE, LONG);
    void pool.inspect(PLATE);
    await news.promise;
    pool.close();
    await wait(100);
  });

  it('of a planner', async () => {
    const planner = await createPlanner();
    await planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    planner.plan(LONG);
    void planner.output('gcode');
    void planner.load(PLATE, 'plate.dxf');
    planner.close();
    planner.plan(LONG);
    await wait(100);
  });
});

describe('a worker that dies while it starts', () => {
  const kill = (worker, ms) => (ms === 0 ? void worker.terminate() : setTimeout(() => void worker.terminate(), ms));

  for (const ms of [0, 20, 50, 100, 200]) {
    it(`after ${ms} ms is started once more, and the file is planned`, async (t) => {
      const { start, workers } = watched([]);
      const dying = (onMessage, onDeath) => {
        const line = start(onMessage, onDeath);
        if (workers.length === 1) kill(workers[0], ms);
        return line;
      };
      const pool = poolOf(() => Planner.open({ module, start: dying }), 1);
      t.after(() => pool.close());
      assert.equal((await pool.plan(PLATE, SHORT)).summary.contours, 2);
      await until(() => workers.length > 1 || ms > 100);
    });
  }

  it('twice is reported in one sentence, and the pool continues', async (t) => {
    const { start, workers } = watched([]);
    const dying = (onMessage, onDeath) => {
      const line = start(onMessage, onDeath);
      if (workers.length <= 2) kill(workers.at(-1), 0);
      return line;
    };
    const pool = poolOf(() => Planner.open({ module, start: dying }), 1);
    t.after(() => pool.close());
    assert.equal(await refusal(pool.plan(PLATE, SHORT)), 'The planner could not be started. The planner ended unexpectedly. It was tried 2 times.');
    assert.equal((await pool.plan(PLATE, SHORT)).summary.contours, 2);
  });
});

describe('the command line', () => {
  it('reports a layer that the drawing does not have, and a machine with a misspelt field', async (t) => {
    const at = folder(t);
    writeFileSync(join(at, 'plate.dxf'), dxf(square(0, 0, 100, 'CUT')));
    const { code, stderr } = await kerfway('plan', join(at, 'plate.dxf'), '--layer', 'CTU=mark', '--moves', '100');
    assert.equal(code, 0, stderr);
    assert.match(stderr, /plate\.dxf: The drawing has no layer "CTU", so the choice for it does nothing\. Did you mean "CUT"\?/);
    writeFileSync(join(at, 'own.json'), JSON.stringify(machine((m) => (m.kerf_witdh = 0.2))));
    const refused = await kerfway('plan', join(at, 'plate.dxf'), '--machine', join(at, 'own.json'), '--moves', '100');
    assert.equal(refused.code, 1);
    assert.match(refused.stderr, /own\.json: The machine has no field "kerf_witdh"\. Did you mean "kerf_width"\?/);
  });

  it('refuses numbers and machines with a sentence', async () => {
    for (const [words, code, says] of [
      [['--seconds', 'NaN'], 2, /--seconds NaN/],
      [['--seconds', '1e300'], 2, /--seconds 1e300: give a number from 0 to 604800 s/],
      [['--workers', '65'], 2, /--workers 65: give a whole number from 1 to 64/],
    ]) {
      const { code: exit, stderr } = await kerfway('plan', KEYBOARD, ...words);
      assert.deepEqual([exit, says.test(stderr)], [code, true], stderr);
    }
  });
});
