// The class `Planner` in Node: load, plan, pause and stop, outputs.

import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { createPlanner } from 'kerfway';
import { bytes, KEYBOARD, LONG, PLATE, PLATE_OPTIONS } from './support.mjs';

let planner;
before(async () => (planner = await createPlanner()));
after(() => planner.close());

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

describe('a planner that is closed', () => {
  for (const workers of [1, 2]) {
    it(`with ${workers} worker${workers > 1 ? 's' : ''} at a plan, resolved it as if its worker had been replaced`, async () => {
      const own = await createPlanner();
      await own.load(bytes(KEYBOARD), 'keyboard.dxf');
      let plan;
      await new Promise((resolve) => (plan = own.plan({ ...LONG, workers }, ({ moves }) => moves > 0 && resolve())));
      own.close();
      await assert.rejects(plan.done, { code: 'closed', message: 'The planner was closed.' });
    });
  }
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
