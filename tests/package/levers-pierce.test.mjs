// Levers that save piercings and stops: starting while moving, cutting on the run, keeping the head down or up.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { createPlanner } from 'kerfway';
import { circle, dxf, folder, kerfway, line, square } from './support.mjs';

const DRAWING = dxf(square(0, 0, 60), circle(20, 20, 3), circle(40, 40, 3), line(80, 0, 80, 30));

describe('moving pierce', () => {
  let planner, thin;
  before(async () => {
    planner = await createPlanner();
    thin = planner.machines.find((m) => m.name === 'fibre-3kw-thin');
  });
  after(() => planner.close());

  const planned = async (machine) => {
    await planner.load(DRAWING, 'plate.dxf');
    const run = planner.plan({ machine, seed: 1, moves: 20_000 });
    await run.done;
    return JSON.parse(await planner.output('json'));
  };

  it('saves the piercing and the delay before each closed cut', async () => {
    const [rest, moving] = [await planned(thin), await planned({ ...thin, levers: { moving_pierce: { overcut: 0 } } })];
    assert.equal(rest.summary.moving_starts, undefined);
    assert.deepEqual([rest.summary.pierces, moving.summary.pierces, moving.summary.moving_starts], [4, 1, 3]);
    const saved = rest.summary.total_time - moving.summary.total_time;
    assert.ok(Math.abs(saved - 3 * (thin.pierce_time + thin.beam_on_delay)) < 0.01, `${saved} s`);
    const kinds = moving.moves.map((m) => m.kind);
    assert.equal(kinds.filter((kind) => kind === 'moving-start').length, 3);
    for (const [k, kind] of kinds.entries()) if (kind === 'moving-start') assert.equal(kinds[k + 1], 'cut');
  });

  it('is an option of the command line, and the program has no wait at these cuts', async (t) => {
    const at = folder(t);
    const [file, program] = [join(at, 'plate.dxf'), join(at, 'plate.nc')];
    writeFileSync(file, DRAWING);
    const ran = await kerfway('plan', file, '--machine', 'fibre-3kw-thin', '--moving-pierce', '0.5', '--moves', '5000', '--seed', '1', '--gcode', program);
    assert.equal(ran.code, 0, ran.stderr);
    const waits = readFileSync(program, 'utf8').split('\n').filter((l) => /^G4 P0\.15/.test(l));
    assert.equal(waits.length, 1);
    const wrong = await kerfway('plan', file, '--moving-pierce', '1000', '--gcode', program);
    assert.equal(wrong.code, 2);
    assert.match(wrong.stderr, /--moving-pierce 1000: give a number from 0 to 100 mm/);
  });
});

describe('cuts on the run', () => {
  let planner, thin;
  const row = dxf(square(0, 0, 60), circle(10, 20, 3), circle(20, 20, 3), circle(30, 20, 3), circle(40, 20, 3));
  before(async () => {
    planner = await createPlanner();
    thin = planner.machines.find((m) => m.name === 'fibre-3kw-thin');
  });
  after(() => planner.close());

  const planned = async (machine) => {
    await planner.load(row, 'row.dxf');
    const { progress } = await planner.plan({ machine, seed: 1, moves: 20_000 }).done;
    return { ...JSON.parse(await planner.output('json')), path: progress.path, gcode: await planner.output('gcode'), check: await planner.check(), quote: await planner.quote() };
  };

  it('are one motion, with one stop of the path for each contour', async () => {
    const [rest, flown] = [await planned(thin), await planned({ ...thin, levers: { fly: { reach: 20, overcut: 0 } } })];
    assert.deepEqual([rest.summary.fly_cuts, flown.summary.fly_cuts, flown.summary.moving_starts, flown.summary.pierces], [undefined, 3, 1, 1]);
    assert.ok(rest.summary.total_time - flown.summary.total_time > 3 * (thin.pierce_time + thin.beam_on_delay + thin.beam_off_delay));
    assert.deepEqual([flown.check.passed, flown.check.problems], [true, []]);
    const kinds = flown.moves.map((m) => m.kind);
    const first = kinds.indexOf('moving-start');
    assert.deepEqual(kinds.slice(first, first + 8), ['moving-start', 'cut', 'fly', 'cut', 'fly', 'cut', 'fly', 'cut']);
    assert.equal(flown.gcode.match(/on the run: beam off for 10\.000 mm/g)?.length, 3);
    const { contours, times } = flown.path;
    assert.deepEqual([...contours].sort(), [0, 1, 2, 3, 4]);
    for (let k = 1; k < times.length; k += 1) assert.ok(times[k] >= times[k - 1] - 1e-9, `${k}: ${times[k - 1]} ${times[k]}`);
    // The seconds of the motion are shared by its contours, and add up to the job's.
    const { parts, loose_times: loose, time } = flown.quote;
    const seconds = parts.flatMap((group) => group.items).reduce((sum, part) => sum + part.times.total, loose?.total ?? 0);
    assert.ok(Math.abs(seconds - flown.summary.total_time) < 1e-6, `${seconds} ${flown.summary.total_time} ${JSON.stringify(time)}`);
  });

  it('are an option of the command line', async (t) => {
    const at = folder(t);
    const [file, program] = [join(at, 'row.dxf'), join(at, 'row.nc')];
    writeFileSync(file, row);
    const plan = (...options) => kerfway('plan', file, '--machine', 'fibre-3kw-thin', '--moves', '5000', '--seed', '1', '--gcode', program, ...options);
    const ran = await plan('--fly', '15', '--fly-overcut', '0.4');
    assert.equal(ran.code, 0, ran.stderr);
    assert.equal(readFileSync(program, 'utf8').match(/on the run: /g)?.length, 3);
    const far = await plan('--fly', '5000');
    assert.deepEqual([far.code, /--fly 5000: give a number/.test(far.stderr)], [2, true], far.stderr);
    const without = await plan('--fly-overcut', '0.4');
    assert.deepEqual([without.code, /--fly/.test(without.stderr)], [2, true], without.stderr);
  });
});

describe('lifting the head', () => {
  let planner, thin;
  before(async () => {
    planner = await createPlanner();
    thin = { ...planner.machines.find((m) => m.name === 'fibre-3kw-thin'), z_speed: 200 };
  });
  after(() => planner.close());

  const planned = async (machine) => {
    await planner.load(DRAWING, 'plate.dxf');
    const run = planner.plan({ machine, seed: 1, moves: 20_000 });
    await run.done;
    const { summary } = JSON.parse(await planner.output('json'));
    return { ...summary, gcode: await planner.output('gcode'), check: await planner.check() };
  };

  it('costs less on the way than at rest, and nothing where the head stays down', async () => {
    const [none, way, rest, low] = [
      await planned(thin), await planned({ ...thin, levers: { lift: { height: 10 } } }),
      await planned({ ...thin, levers: { lift: { height: 10, at_rest: true } } }), await planned({ ...thin, levers: { lift: { height: 10, stay_down: 1000 } } }),
    ];
    assert.deepEqual([none.lifts, way.lifts, rest.lifts, low.lifts], [undefined, 4, 4, undefined]);
    assert.ok(none.total_time < way.total_time && way.total_time < rest.total_time);
    assert.ok(Math.abs(rest.total_time - none.total_time - 4 * 2 * 10 / 200) < 0.01);
    assert.equal(low.total_time, none.total_time);
    for (const { check } of [none, way, rest, low]) assert.deepEqual([check.passed, check.problems], [true, []]);
    assert.equal(way.gcode.match(/^G0 X\S+ Y\S+ Z10/gm)?.length, 4);
    assert.equal(rest.gcode.match(/^G0 Z10/gm)?.length, 4);
    assert.doesNotMatch(low.gcode, / Z/);
  });

  it('is an option of the command line', async (t) => {
    const at = folder(t);
    const [file, program] = [join(at, 'plate.dxf'), join(at, 'plate.nc')];
    writeFileSync(file, DRAWING);
    const plan = (...options) => kerfway('plan', file, '--machine', 'fibre-3kw-thin', '--moves', '5000', '--seed', '1', '--gcode', program, ...options);
    const ran = await plan('--lift', '12', '--z-speed', '150', '--stay-down', '25');
    assert.equal(ran.code, 0, ran.stderr);
    assert.match(readFileSync(program, 'utf8'), /^G0 X\S+ Y\S+ Z12/m);
    const slow = await plan('--lift', '12');
    assert.deepEqual([slow.code, /--z-speed/.test(slow.stderr)], [2, true], slow.stderr);
    const without = await plan('--stay-down', '25');
    assert.deepEqual([without.code, /Give the height with --lift/.test(without.stderr)], [2, true], without.stderr);
  });
});
