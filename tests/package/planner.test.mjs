// The class `Planner` in Node: load, plan, pause and stop, outputs.

import assert from 'node:assert/strict';
import { after, before, beforeEach, describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { createPlanner, PROVEN, verifyQuote } from 'kerfway';
import { asJson } from '../../dist/sdk/plain-data.js';
import { bytes, circle, dxf, KEYBOARD, square } from './support.mjs';

let planner;
before(async () => (planner = await createPlanner()));
after(() => planner.close());

/** A plate of 100 mm with a hole of radius 10 in its middle, and a marked circle beside it. */
const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10), circle(150, 50, 5, 'MARK'));
const PLATE_OPTIONS = { units: 'mm', layers: [{ name: 'MARK', operation: 'mark' }] };

/** A search that would run for a minute. */
const LONG = { seconds: 60, seed: 1, allowOffBed: true };

describe('load', () => {
  it('reports contours, parts, layers and units', async () => {
    const loaded = await planner.load(PLATE, 'plate.dxf', PLATE_OPTIONS);
    assert.equal(loaded.name, 'plate.dxf');
    assert.match(loaded.sha256, /^[0-9a-f]{64}$/);
    assert.deepEqual([loaded.units.unit, loaded.units.source], ['mm', 'given']);
    assert.deepEqual(loaded.bounds, [0, 0, 155, 100]);
    const told = loaded.contours.map((c) => [c.closed, c.layer, c.operation, c.inside, Math.round(c.length * 1e3)]);
    assert.deepEqual(told, [
      [true, '0', 'cut', null, 400_000],
      [true, '0', 'cut', 0, 62_832],
      [true, 'MARK', 'mark', null, 31_416],
    ]);
    assert.deepEqual(loaded.parts[0], { outer: 0, holes: [1], inside: null });
  });

  it('returns geometry as seven numbers per element', async () => {
    const { geometry, contours } = await planner.load(PLATE, 'plate.dxf', PLATE_OPTIONS);
    assert.deepEqual([...geometry.offsets], [0, 4, 5, 6]);
    assert.equal(geometry.segments.length, 6 * 7);
    for (const { id, length } of contours) assert.ok(Math.abs(lengthOf(geometry, id) - length) < 1e-9);
  });

  it('does not cut an ignored layer, but returns its geometry', async () => {
    await planner.load(PLATE, 'plate.dxf', PLATE_OPTIONS);
    const loaded = await planner.reload({ units: 'mm', layers: [{ name: 'MARK', operation: 'ignore' }] });
    assert.equal(loaded.contours.length, 2);
    assert.equal(loaded.ignored.layers.length, 1);
    assert.equal(loaded.layers[loaded.ignored.layers[0]].name, 'MARK');
    assert.ok(Math.abs(lengthOf(loaded.ignored.geometry, 0) - 10 * Math.PI) < 1e-9);
  });

  it('reads the same bytes again in other units', async () => {
    await planner.load(PLATE, 'plate.dxf', { units: 'mm' });
    const loaded = await planner.reload({ units: 'in' });
    assert.ok(Math.abs(loaded.bounds[2] - 155 * 25.4) < 1e-9);
  });

  it('does not detach the bytes of the caller', async () => {
    const own = PLATE.slice();
    await planner.load(own, 'plate.dxf');
    assert.deepEqual(own, PLATE);
  });

  it('refuses another kind of file with one sentence, and reads the next file', async () => {
    const png = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);
    await assert.rejects(planner.load(png, 'a.png'), /PNG/);
    await assert.rejects(planner.load(new TextEncoder().encode('AC1032\0\0'), 'a.dwg'), /DWG/);
    await assert.rejects(planner.load(new Uint8Array(0), 'a.dxf'), /empty/i);
    assert.equal((await planner.load(PLATE, 'plate.dxf')).contours.length, 3);
  });

  it('refuses options out of range with the range', async () => {
    await assert.rejects(planner.load(PLATE, 'plate.dxf', { tolerance: -1 }), /"tolerance" is -1\. Give a number from 0\.000001 to 1 mm/);
    await assert.rejects(planner.load(PLATE, 'plate.dxf', { units: 'parsec' }), /The option "units" is "parsec"\. Choose one of: mm, /);
  });

  it('refuses a drawing with nothing to cut', async () => {
    await planner.load(PLATE, 'plate.dxf', {
      layers: [{ name: '0', operation: 'ignore' }, { name: 'MARK', operation: 'ignore' }],
    });
    await assert.rejects(planner.plan({ moves: 10 }).done, /nothing to cut: everything in the drawing is skipped/);
  });
});

describe('plan', () => {
  before(() => planner.load(bytes(KEYBOARD), 'keyboard.dxf'));

  it('starts with baselines and never gets worse', async () => {
    const seen = [];
    const plan = planner.plan({ moves: 200_000, seed: 5 }, (p) => seen.push(p));
    const { baselines, method, seed } = await plan.started;
    assert.deepEqual([method, seed], [planner.methods[0].name, 5]);
    const { progress, reason } = await plan.done;
    assert.ok(reason === 'budget' || reason === 'exhausted');
    const seconds = [baselines.greedy, ...seen.map((p) => p.summary), progress.summary].map((s) => s.total_time);
    for (let k = 1; k < seconds.length; k++) assert.ok(seconds[k] <= seconds[k - 1] + 1e-9, `${seconds}`);
    assert.ok(progress.summary.total_time < baselines.drawing.total_time);
    const moves = seen.map((p) => p.moves);
    assert.deepEqual(moves, moves.toSorted((a, b) => a - b));
  });

  it('reports a path that visits every contour once and ends with the job', async () => {
    const { progress } = await planner.plan({ moves: 10_000, seed: 1 }).done;
    const { path, summary } = progress;
    assert.deepEqual([...path.contours].sort((a, b) => a - b), Array.from({ length: summary.contours }, (_, k) => k));
    assert.equal(path.points.length, 4 * summary.contours);
    assert.equal(path.times.length, 2 * summary.contours);
    for (let k = 1; k < path.times.length; k++) assert.ok(path.times[k] > path.times[k - 1]);
    assert.ok(path.times.at(-1) <= summary.total_time);
  });

  it('makes exactly the moves of its budget, unless it ends before', async () => {
    for (const moves of [1, 1_000, 123_457]) {
      const { progress, reason } = await planner.plan({ moves, seed: 2 }).done;
      if (reason === 'budget') assert.equal(progress.moves, moves);
      else assert.ok(progress.moves < moves);
    }
  });

  it('stops at once, and keeps the best plan', async () => {
    const plan = planner.plan(LONG);
    await plan.started;
    plan.stop();
    const { reason, progress } = await plan.done;
    assert.ok(reason === 'stopped' || reason === 'exhausted');
    assert.equal(progress.path.contours.length, progress.summary.contours);
    assert.match(await planner.output('gcode'), /^; Kerfway/);
  });

  it('ends the running plan when another begins', async () => {
    const first = planner.plan(LONG);
    const second = planner.plan({ moves: 100, seed: 1 });
    assert.ok(['stopped', 'exhausted'].includes((await first.done).reason));
    assert.ok(['budget', 'exhausted'].includes((await second.done).reason));
  });

  it('refuses an unknown machine or method', async () => {
    await assert.rejects(planner.plan({ machine: 'plasma-9000' }).done, /no machine named "plasma-9000".*co2-100w/);
    await assert.rejects(planner.plan({ method: 'luck' }).done, /no method named "luck"/);
    const slow = { ...planner.machines[0], cut: { ...planner.machines[0].cut, speed: 0 } };
    await assert.rejects(planner.plan({ machine: slow }).done, /"cut\.speed" is 0\. Give a number/);
  });

  it('draws a random seed and reports it', async () => {
    const seeds = [];
    for (let k = 0; k < 2; k++) seeds.push((await planner.plan({ moves: 10 }).done).seed);
    assert.ok(seeds.every((s) => Number.isInteger(s) && s >= 0 && s < 2 ** 32));
    assert.notEqual(seeds[0], seeds[1]);
  });

  it('ends after its seconds', async () => {
    const { progress, reason } = await planner.plan({ seconds: 0.3, seed: 1 }).done;
    if (reason === 'budget') assert.ok(progress.seconds >= 0.3 && progress.seconds < 1, `${progress.seconds}`);
  });
});

describe('the same seed and moves', () => {
  const options = { moves: 60_000, seed: 11 };
  const planned = async (steer = () => {}) => {
    const plan = planner.plan(options);
    await plan.started;
    steer(plan);
    await plan.done;
    return planner.output('json');
  };
  let reference;
  before(async () => {
    await planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    reference = await planned();
  });

  it('give the same bytes again', async () => assert.equal(await planned(), reference));

  it('give the same bytes with pauses in between', async () => {
    const paused = await planned((plan) => {
      plan.pause();
      setTimeout(() => plan.resume(), 50);
    });
    assert.equal(paused, reference);
  });

  it('give the same moves in two budgets, one after the other', async () => {
    await planner.plan({ moves: 25_000, seed: 11 }).done;
    await planner.continue({ moves: 35_000 }).done;
    const moves = (json) => JSON.parse(json).moves;
    assert.deepEqual(moves(await planner.output('json')), moves(reference));
  });
});

describe('a plan that another one has displaced', () => {
  before(() => planner.load(bytes(KEYBOARD), 'keyboard.dxf'));

  it('does not stop or pause the newer one', async () => {
    for (const order of ['stop', 'pause']) {
      const older = planner.plan(LONG);
      await older.started;
      const newer = planner.plan({ moves: 100_000, seed: 1 });
      older[order]();
      assert.equal((await older.done).reason, 'stopped');
      const { reason, progress } = await newer.done;
      assert.deepEqual([reason, progress.moves], ['budget', 100_000], order);
    }
  });
});

describe('a plan is continued', () => {
  /** The result of a promise that must not take longer than some seconds. */
  const soon = (promise) => Promise.race([promise, wait(10_000, null, { ref: false }).then(() => assert.fail('it is still pending'))]);
  beforeEach(() => planner.load(bytes(KEYBOARD), 'keyboard.dxf'));

  it('that was begun before its drawing had been read', async () => {
    const ways = [() => planner.load(PLATE, 'plate.dxf', PLATE_OPTIONS), () => planner.reload(PLATE_OPTIONS)];
    for (const [k, read] of ways.entries()) {
      const reading = read();
      const plan = planner.plan({ moves: 1000, seed: 5, allowOffBed: true });
      await reading;
      assert.equal((await plan.done).progress.path.contours.length, 3);
      const { seed, reason, progress } = await soon(planner.continue({ moves: 500 }).done);
      assert.deepEqual([seed, reason, progress.path.contours.length], [5, 'budget', 3], `way ${k}`);
      assert.equal(await planner.offer(progress.path), null);
    }
  });

  it('although it has not begun yet', async () => {
    const plan = planner.plan({ moves: 1_000_000, seed: 6 });
    const more = planner.continue({ moves: 1000 });
    assert.equal((await soon(plan.done)).reason, 'stopped');
    const { seed, reason, progress, baselines } = await soon(more.done);
    assert.deepEqual([seed, reason, progress.path.contours.length], [6, 'budget', 60]);
    assert.ok(progress.summary.total_time <= baselines.drawing.total_time);
    assert.equal((await more.started).seed, 6);
  });

  it('unless it failed', async () => {
    const plan = planner.plan({ method: 'no-such-method', moves: 1 });
    const more = planner.continue({ moves: 1000 });
    await assert.rejects(plan.done, /no-such-method/);
    await assert.rejects(soon(more.done), { code: 'no-plan' });
  });

  it('unless another drawing has been read', async () => {
    await planner.plan({ moves: 10 }).done;
    await planner.load(PLATE, 'plate.dxf');
    await assert.rejects(soon(planner.continue({ moves: 10 }).done), { code: 'no-plan' });
    await assert.rejects(planner.offer({}), { code: 'no-plan' });
  });
});

describe('options of a call', () => {
  /** What `reactive()` of Vue makes: a proxy of the object and of all objects in it, which no message can carry. */
  const reactive = (object) =>
    new Proxy(object, {
      get: (target, name) => {
        const value = Reflect.get(target, name);
        return typeof value === 'object' && value !== null ? reactive(value) : value;
      },
    });
  const machine = () => ({ ...structuredClone(planner.machines[0]), name: 'my-laser' });

  it('may be changed by the caller afterwards', async () => {
    const reading = { units: 'mm' };
    const loading = planner.load(PLATE, 'plate.dxf', reading);
    reading.units = 'in';
    assert.equal((await loading).bounds[2], 155);
    const planning = { machine: machine(), seed: 3, moves: 10 };
    const plan = planner.plan(planning);
    planning.seed = 4;
    planning.machine.name = 'another';
    const terms = { material: { name: 'mild steel' } };
    const quoting = plan.done.then(() => planner.quote(terms));
    assert.equal((await plan.done).seed, 3);
    terms.material.name = 'glass';
    const { material } = await quoting;
    assert.equal(material.name, 'mild steel');
    assert.equal(JSON.parse(await planner.output('json')).machine.name, 'my-laser');
    const budget = { moves: 20 };
    const more = planner.continue(budget);
    budget.moves = 1;
    assert.equal((await more.done).progress.moves, 30);
  });

  it('may be behind proxies', async () => {
    const texts = [];
    for (const given of [(o) => o, reactive]) {
      await planner.load(PLATE, 'plate.dxf', given(PLATE_OPTIONS));
      const { progress } = await planner.plan(given({ machine: machine(), seed: 3, moves: 1000 })).done;
      await planner.plan(given({ machine: machine(), seed: 3, moves: 1000, warm: JSON.parse(JSON.stringify(asJson(progress.path))) })).done;
      await planner.continue(given({ moves: 1000 })).done;
      await planner.reload(given(PLATE_OPTIONS));
      await planner.plan(given({ machine: machine(), seed: 3, moves: 1000, warm: progress.path })).done;
      texts.push(await planner.output('json'));
      assert.equal((await planner.check(null, given({ machine: machine() }))).passed, true);
    }
    assert.equal(texts[0], texts[1]);
  });

  it('that cannot be sent reject their call alone', async () => {
    await planner.load(PLATE, 'plate.dxf');
    const plan = planner.plan({ ...LONG, moves: 1e9 });
    await plan.started;
    await assert.rejects(planner.calibrate(machine(), [{ plan: 'x', seconds: () => 1 }]), { name: 'KerfwayError', code: 'wrong-type', message: /^This cannot be sent/ });
    plan.stop();
    assert.equal((await plan.done).reason, 'stopped');
    const { path } = (await plan.done).progress;
    await assert.rejects(planner.offer({ ...path, f() {} }), { name: 'KerfwayError', code: 'wrong-type' });
    assert.equal(await planner.offer(path), null);
    assert.equal(planner.replaced, null);
  });
});

describe('a proof', () => {
  before(() => planner.load(bytes(KEYBOARD), 'keyboard.dxf'));

  /** Begins a search and a proof, and ends the proof in one way or the other after its first bound. */
  async function ended(how) {
    const plan = planner.plan(LONG);
    await plan.started;
    const bounds = [];
    const proof = planner.prove({ seconds: 60 }, (seconds) => {
      bounds.push(seconds);
      proof[how]();
    });
    const done = await proof.done;
    plan.stop();
    await plan.done;
    return { done, first: bounds[0], last: bounds.at(-1) };
  }

  it('that is stopped has a certificate of what is proven', async () => {
    const { done, first } = await ended('stop');
    assert.ok(done.seconds >= first && first > 0);
    assert.equal(JSON.parse(done.certificate).schema, 'kerfway.certificate/1');
  });

  it('fails with the error of its callback, and the plan goes on', async () => {
    const plan = planner.plan({ ...LONG, moves: 1e9 });
    await plan.started;
    for (const throwing of [() => { throw new Error('my callback'); }, async () => { throw new Error('my callback'); }]) {
      await assert.rejects(planner.prove({ seconds: 60 }, throwing).done, /^Error: my callback$/);
    }
    plan.stop();
    assert.equal((await plan.done).reason, 'stopped');
  });

  it('is refused once the planner is closed', async () => {
    const other = await createPlanner();
    await other.load(PLATE, 'plate.dxf');
    await other.plan({ moves: 10, seed: 1 }).done;
    other.close();
    assert.throws(() => other.prove({ seconds: 1 }), { name: 'KerfwayError', code: 'closed', message: 'The planner was closed.' });
  });

  it('that is closed ends with its last bound, without a certificate', async () => {
    const { done, last } = await ended('close');
    assert.deepEqual({ ...done, path: null }, { seconds: last, certificate: null, path: null, hindrance: null });
    assert.ok(last > 0);
  });
});

describe('a path from elsewhere', () => {
  const seconds = ({ summary }) => summary.total_time;
  const holes = () => dxf(...Array.from({ length: 12 }, (_, k) => circle(20 + 31 * (k % 4), 20 + 29 * Math.floor(k / 4), 4 + ((5 * k) % 7))));
  beforeEach(() => planner.load(holes(), 'holes.dxf'));

  it('that a proof has found is taken over after the search, and proven optimal', async () => {
    const plan = planner.plan({ moves: 1, seed: 1 });
    await plan.started;
    const proof = await planner.prove({ work: 2000 }).done;
    const { progress } = await plan.done;
    const better = await planner.offer(proof.path);
    assert.ok(seconds(better) < seconds(progress) - 0.01, `${seconds(better)} s after ${seconds(progress)} s`);
    assert.ok(better.summary.gap <= PROVEN, `a gap of ${better.summary.gap}`);
    assert.deepEqual([better.moves, better.path.contours.length], [progress.moves, progress.path.contours.length]);
    const document = JSON.parse(await planner.output('json'));
    assert.equal(document.summary.total_time, seconds(better));
    // Seed and moves alone do not give it again, and nobody is told so.
    assert.equal(document.budget.from_path, true);
    const quote = await planner.quote();
    assert.equal(quote.from_path, true);
    const { valid, differences } = await verifyQuote(holes(), quote);
    assert.deepEqual([valid, differences.includes('from_path'), differences.includes('input')], [false, true, false], String(differences));
    // What is no better changes nothing, and the search goes on from the better path.
    assert.equal(await planner.offer(progress.path), null);
    const { progress: later } = await planner.continue({ moves: 100 }).done;
    assert.ok(seconds(later) <= seconds(better));
  });

  it('waits for the search, whose result is its own', async () => {
    const alone = await planner.plan({ moves: 2000, seed: 1 }).done;
    assert.equal('from_path' in JSON.parse(await planner.output('json')).budget, false);
    const best = (await planner.plan({ moves: 200_000, seed: 1 }).done).progress;
    const plan = planner.plan({ moves: 2000, seed: 1 });
    const offered = planner.offer(best.path);
    assert.equal(seconds((await plan.done).progress), seconds(alone.progress));
    assert.equal(seconds((await offered) ?? alone.progress), Math.min(seconds(best), seconds(alone.progress)));
  });

  it('of another drawing is refused, and so is one without a plan', async () => {
    await assert.rejects(planner.offer({}), { code: 'no-plan' });
    await planner.plan({ moves: 1 }).done;
    const path = { contours: Uint32Array.of(0), along: Float64Array.of(0), reversed: Uint8Array.of(0) };
    await assert.rejects(planner.offer(path), { code: 'unfit-path' });
    await assert.rejects(planner.offer({}), { code: 'unfit-path' });
  });

  it('is dropped when another plan has begun', async () => {
    const first = planner.plan({ moves: 1, seed: 1 });
    const offered = first.done.then(({ progress }) => planner.offer(progress.path));
    await first.done;
    const second = planner.plan({ moves: 1, seed: 2 });
    assert.equal(await offered, null);
    await second.done;
  });
});

describe('output', () => {
  before(async () => {
    await planner.load(PLATE, 'plate.dxf', PLATE_OPTIONS);
    await planner.plan({ moves: 100, seed: 1 }).done;
  });

  it('is G-code, SVG, DXF or JSON', async () => {
    assert.match(await planner.output('gcode'), /^M5/m);
    assert.match(await planner.output('svg'), /^<svg /m);
    assert.match(await planner.output('dxf'), /^EOF$/m);
    assert.equal(JSON.parse(await planner.output('json')).schema, 'kerfway.plan/1');
  });

  it('is a picture of the requested width', async () => {
    const png = await planner.output('png', 640);
    assert.deepEqual([...png.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
    assert.equal(new DataView(png.buffer, png.byteOffset).getUint32(16), 640);
  });

  it('can be read again with the same length', async () => {
    const before = JSON.parse(await planner.output('json')).summary.cut_length;
    const again = await createPlanner();
    const loaded = await again.load(new TextEncoder().encode(await planner.output('dxf')), 'again.dxf');
    again.close();
    const length = loaded.contours.reduce((sum, c) => sum + c.length, 0);
    assert.ok(Math.abs(length - before) < 1e-3, `${length} against ${before}`);
  });

  it('is refused before there is a plan', async () => {
    const fresh = await createPlanner();
    await assert.rejects(fresh.output('gcode'), /No drawing is loaded/);
    await fresh.load(PLATE, 'plate.dxf');
    await assert.rejects(fresh.output('gcode'), /no plan yet/);
    await assert.rejects(fresh.continue({ moves: 5 }).done, /no plan to continue/);
    fresh.close();
  });
});

/** Length of a chain, from its numbers. */
function lengthOf({ segments, offsets }, chain) {
  let sum = 0;
  for (let k = offsets[chain]; k < offsets[chain + 1]; k++) {
    const [x0, y0, x1, y1, cx, cy, sweep] = segments.subarray(7 * k, 7 * k + 7);
    sum += sweep === 0 ? Math.hypot(x1 - x0, y1 - y0) : Math.abs(sweep) * Math.hypot(x0 - cx, y0 - cy);
  }
  return sum;
}
