// Levers through the package and the command line.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { createPlanner, LEVERS, leverSavings, withoutLever } from 'kerfway';
import { circle, dxf, folder, kerfway, line, polygon, square } from './support.mjs';

const schema = createRequire(import.meta.url).resolve('kerfway/plan.schema.json');
const validate = new Ajv2020({ allErrors: true }).compile(JSON.parse(readFileSync(schema, 'utf8')));
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

describe('bridges', () => {
  const row = dxf(...[0, 28, 56].map((x) => square(10 + x, 10, 20)));

  it('connect parts, in the plan, the program, the quote and the path', async (t) => {
    const planner = await createPlanner();
    t.after(() => planner.close());
    const thick = planner.machines.find((m) => m.name === 'fibre-6kw-thick');
    const machine = { ...thick, levers: { bridges: { width: 3, reach: 10 } } };
    await planner.load(row, 'row.dxf');
    const { progress: { path, summary } } = await planner.plan({ machine, seed: 1, moves: 20_000 }).done;
    assert.deepEqual([summary.bridges, summary.pierces, summary.contours, summary.parts], [2, 1, 3, 3]);
    assert.ok(Math.abs(summary.cut_length - (240 - 4 * 3 + 4 * 8)) < 1e-9);
    assert.deepEqual([...path.contours], [0]);
    const document = JSON.parse(await planner.output('json'));
    assert.ok(validate(document), JSON.stringify(validate.errors));
    assert.deepEqual(document.machine.levers.bridges, { width: 3, reach: 10, clearance: 1 });
    assert.deepEqual(document.bridges.map((b) => b.contours), [[0, 1], [1, 2]]);
    assert.deepEqual(document.moves.find((m) => m.kind === 'cut').contour, [0, 1, 2]);
    const check = await planner.check();
    assert.deepEqual([check.passed, check.problems, check.parts], [true, [], 1]);
    const quote = await planner.quote();
    assert.deepEqual([quote.part_count, quote.parts.length], [3, 1]);
    const parts = quote.parts.flatMap((part) => part.items).reduce((sum, item) => sum + item.times.total, 0);
    assert.ok(Math.abs(parts - summary.total_time) < 1e-6, `${parts}`);
    assert.deepEqual(withoutLever(machine, 'bridges').levers, {});
    await assert.rejects(planner.plan({ machine: { ...machine, pre_cut_time: 0.5 } }).done, /levers\.bridges and pre_cut_time/);
  });

  it('are cut later by the machine', async (t) => {
    const planner = await createPlanner();
    t.after(() => planner.close());
    const thick = planner.machines.find((m) => m.name === 'fibre-6kw-thick');
    const machine = { ...thick, pierce_time: 3, levers: { bridges: { width: 3, reach: 10, cut_later: true } } };
    await planner.load(row, 'row.dxf');
    const { progress: { path, summary } } = await planner.plan({ machine, seed: 1, moves: 20_000 }).done;
    assert.deepEqual([summary.bridges, summary.pierces, summary.contours, summary.parts], [2, 1, 3, 3]);
    assert.ok(Math.abs(summary.cut_length - (240 + 4 * 8)) < 1e-9);
    assert.equal(path.contours[0], 0);
    assert.deepEqual([...path.contours].sort(), [0, 3, 4, 5, 6]);
    const document = JSON.parse(await planner.output('json'));
    assert.ok(validate(document), JSON.stringify(validate.errors));
    assert.deepEqual(document.contours.slice(3).map((c) => [c.closed, c.bridged]), [[false, 0], [false, 1], [false, 1], [false, 2]]);
    const check = await planner.check();
    assert.deepEqual([check.passed, check.problems], [true, []]);
  });

  it('are cut later in a piece that stays, and parts tip when their own are cut', async (t) => {
    const planner = await createPlanner();
    t.after(() => planner.close());
    const thick = planner.machines.find((m) => m.name === 'fibre-6kw-thick');
    const tips = { drops_below: 10, tips_below: 40, nozzle_radius: 4, margin: 1 };
    const machine = { ...thick, pierce_time: 3, z_speed: 100, levers: { lift: { height: 10 }, tips, bridges: { width: 3, reach: 10, cut_later: true } } };
    // Small squares alone have nothing that holds them while they are cut.
    await planner.load(row, 'row.dxf');
    assert.equal((await planner.plan({ machine, seed: 1, moves: 20_000 }).done).progress.summary.bridges, undefined);
    await planner.load(dxf(square(10, 10, 60), square(78, 30, 20), square(106, 30, 20)), 'plate.dxf');
    const { progress: { path, summary } } = await planner.plan({ machine, seed: 1, moves: 20_000 }).done;
    assert.deepEqual([summary.bridges, summary.contours, summary.parts], [2, 3, 3]);
    assert.deepEqual([...path.tips], [1, 2]);
    // The far square comes off first, with the second cut, and the other one with the fourth.
    assert.deepEqual([path.contours[0], ...path.freedBy], [0, 3, 1]);
    const check = await planner.check();
    assert.deepEqual([check.passed, check.problems], [true, []]);
  });

  it('are options of the command line', async (t) => {
    const at = folder(t);
    const [file, json] = [join(at, 'row.dxf'), join(at, 'row.json')];
    writeFileSync(file, row);
    const plan = (...options) => kerfway('plan', file, '--machine', 'fibre-6kw-thick', '--moves', '5000', '--seed', '1', '--json', json, ...options);
    const ran = await plan('--bridges', '10', '--bridge-width', '3', '--bridge-clearance', '2', '--bridge-most', '2', '--savings');
    assert.equal(ran.code, 0, ran.stderr);
    assert.match(ran.stdout + ran.stderr, /bridges saves/);
    const { machine, summary } = JSON.parse(readFileSync(json, 'utf8'));
    assert.deepEqual([machine.levers.bridges, summary.bridges], [{ width: 3, reach: 10, clearance: 2, most: 2 }, 1]);
    const apart = await plan('--bridges', '10', '--cut-bridges');
    assert.equal(apart.code, 0, apart.stderr);
    assert.deepEqual(JSON.parse(readFileSync(json, 'utf8')).machine.levers.bridges, { width: 2, reach: 10, clearance: 1, cut_later: true });
    const tipping = await plan('--bridges', '10', '--cut-bridges', '--tips', 'ignore', '--tips-below', '15', '--drops-below', '5');
    assert.equal(tipping.code, 0, tipping.stderr);
    assert.equal(JSON.parse(readFileSync(json, 'utf8')).machine.levers.tips.tips_below, 15);
    const alone = await plan('--cut-bridges');
    assert.deepEqual([alone.code, /--cut-bridges: the machine does not connect parts/.test(alone.stderr)], [2, true], alone.stderr);
    const without = await plan('--bridge-width', '3');
    assert.deepEqual([without.code, /--bridge-width: the machine does not connect parts/.test(without.stderr)], [2, true], without.stderr);
  });
});

describe('chains', () => {
  const nest = dxf(...[[0, 0], [28, 0], [0, 28], [28, 28]].map(([x, y]) => square(10 + x, 10 + y, 20)));

  it('join parts through waste, in the plan, the program and the path', async (t) => {
    const planner = await createPlanner();
    t.after(() => planner.close());
    const thick = planner.machines.find((m) => m.name === 'fibre-6kw-thick');
    let document;
    const planned = async (machine) => {
      await planner.load(nest, 'nest.dxf');
      const { progress } = await planner.plan({ machine, seed: 1, moves: 20_000 }).done;
      document = JSON.parse(await planner.output('json'));
      return { ...document, path: progress.path, gcode: await planner.output('gcode'), check: await planner.check(), quote: await planner.quote() };
    };
    const [apart, joined] = [await planned(thick), await planned({ ...thick, levers: { chains: { reach: 30 } } })];
    assert.deepEqual([apart.summary.chains, apart.summary.pierces, joined.summary.chains, joined.summary.pierces], [undefined, 4, 3, 1]);
    assert.ok(apart.summary.total_time - joined.summary.total_time > 2.5);
    assert.ok(Math.abs(joined.summary.chain_length - 24) < 1e-9);
    assert.ok(validate(document), JSON.stringify(validate.errors));
    assert.deepEqual([joined.check.passed, joined.check.problems, joined.check.parts], [true, [], 4]);
    assert.deepEqual(joined.moves.map((m) => m.kind), ['air', 'pierce', 'cut', 'chain', 'cut', 'chain', 'cut', 'chain', 'cut', 'air']);
    assert.deepEqual([...joined.path.ways], [0, 4, 4, 4, 0]);
    const { times } = joined.path;
    for (let k = 1; k < times.length; k += 1) assert.ok(times[k] > times[k - 1], `${k}: ${times[k - 1]} ${times[k]}`);
    assert.equal(joined.gcode.match(/through waste for 8\.000 mm to contour/g)?.length, 3);
    // The seconds of the parts add up to those of the job, chains included.
    const parts = joined.quote.parts.flatMap((part) => part.items).reduce((sum, item) => sum + item.times.total, 0);
    assert.ok(Math.abs(parts - joined.summary.total_time) < 1e-6, `${parts}`);
    assert.deepEqual(withoutLever({ ...thick, levers: { chains: { reach: 30 } } }, 'chains').levers, {});
    await assert.rejects(planner.plan({ machine: { ...thick, pre_cut_time: 0.5, levers: { chains: { reach: 30 } } } }).done, /levers\.chains and pre_cut_time/);
  });

  it('begin on the kerf of the last contour, too', async (t) => {
    const planner = await createPlanner();
    t.after(() => planner.close());
    const thick = planner.machines.find((m) => m.name === 'fibre-6kw-thick');
    await planner.load(dxf(...[0, 28, 56, 84].map((x) => square(10 + x, 10, 20))), 'row.dxf');
    const machine = { ...thick, levers: { chains: { reach: 30, edge_starts: true } } };
    const { progress: { path, summary } } = await planner.plan({ machine, seed: 1, moves: 20_000 }).done;
    assert.deepEqual([summary.chains, summary.edge_starts, summary.pierces], [3, 2, 1]);
    assert.deepEqual([...path.ways], [0, 4, 5, 5, 0]);
    assert.deepEqual([path.via.length, [...path.viaOf]], [4, [2, 3]]);
    for (let k = 1; k < path.times.length; k += 1) assert.ok(path.times[k] > path.times[k - 1], `${k}`);
    const document = JSON.parse(await planner.output('json'));
    assert.ok(validate(document), JSON.stringify(validate.errors));
    assert.deepEqual(document.machine.levers.chains, { reach: 30, clearance: 1, edge_starts: true });
    const check = await planner.check();
    assert.deepEqual([check.passed, check.problems], [true, []]);
    const quote = await planner.quote();
    const parts = quote.parts.flatMap((part) => part.items).reduce((sum, item) => sum + item.times.total, 0);
    assert.ok(Math.abs(parts - summary.total_time) < 1e-6, `${parts}`);
    assert.equal(withoutLever(machine, 'edge-starts').levers.chains.edge_starts, false);
  });

  it('are an option of the command line', async (t) => {
    const at = folder(t);
    const [file, program] = [join(at, 'nest.dxf'), join(at, 'nest.nc')];
    writeFileSync(file, nest);
    const plan = (...options) => kerfway('plan', file, '--machine', 'fibre-6kw-thick', '--moves', '5000', '--seed', '1', '--gcode', program, ...options);
    const ran = await plan('--chains', '30', '--chain-clearance', '0.5', '--savings');
    assert.equal(ran.code, 0, ran.stderr);
    assert.match(ran.stdout + ran.stderr, /chains saves/);
    assert.equal(readFileSync(program, 'utf8').match(/through waste for /g)?.length, 3);
    const edges = await plan('--chains', '30', '--edge-starts', '--savings');
    assert.deepEqual([edges.code, /edge-starts (saves|costs)/.test(edges.stdout + edges.stderr)], [0, true], edges.stderr);
    const far = await plan('--chains', '5000');
    assert.deepEqual([far.code, /--chains 5000: give a number/.test(far.stderr)], [2, true], far.stderr);
    const without = await plan('--chain-clearance', '0.4');
    assert.deepEqual([without.code, /--chains/.test(without.stderr)], [2, true], without.stderr);
    const alone = await plan('--edge-starts');
    assert.deepEqual([alone.code, /--chains/.test(alone.stderr)], [2, true], alone.stderr);
  });
});

describe('common cuts', () => {
  // Four parts one kerf of 0.4 mm apart, two by two.
  const nest = dxf(...[[0, 0], [20.4, 0], [0, 20.4], [20.4, 20.4]].map(([x, y]) => square(10 + x, 10 + y, 20)));

  it('pierce parts one kerf apart once, in the plan, the program and the path', async (t) => {
    const planner = await createPlanner();
    t.after(() => planner.close());
    const thick = { ...planner.machines.find((m) => m.name === 'fibre-6kw-thick'), kerf_width: 0.4 };
    let document;
    const planned = async (machine) => {
      await planner.load(nest, 'nest.dxf');
      const { progress } = await planner.plan({ machine, seed: 1, moves: 20_000 }).done;
      document = JSON.parse(await planner.output('json'));
      return { ...document, path: progress.path, check: await planner.check(), quote: await planner.quote() };
    };
    const machine = { ...thick, levers: { common_cuts: {} } };
    const [apart, joined] = [await planned(thick), await planned(machine)];
    assert.deepEqual([apart.summary.pierces, joined.summary.pierces], [4, 1]);
    // Three lines of 40.8 mm in each direction.
    for (const { summary } of [apart, joined]) assert.ok(Math.abs(summary.cut_length - 6 * 40.8) < 1e-6, `${summary.cut_length}`);
    assert.ok(apart.summary.total_time - joined.summary.total_time > 2.5);
    assert.ok(validate(document), JSON.stringify(validate.errors));
    assert.deepEqual([joined.check.passed, joined.check.problems], [true, []]);
    const { times } = joined.path;
    for (let k = 1; k < times.length; k += 1) assert.ok(times[k] >= times[k - 1], `${k}: ${times[k - 1]} ${times[k]}`);
    const parts = joined.quote.parts.flatMap((part) => part.items).reduce((sum, item) => sum + item.times.total, 0);
    assert.ok(Math.abs(parts - joined.summary.total_time) < 1e-6, `${parts}`);
    assert.deepEqual(withoutLever(machine, 'common-cuts').levers, {});
    await assert.rejects(planner.plan({ machine: { ...machine, pre_cut_time: 0.5 } }).done, /levers\.common_cuts and pre_cut_time/);
  });

  it('are an option of the command line', async (t) => {
    const at = folder(t);
    const [file, shop, json] = [join(at, 'nest.dxf'), join(at, 'shop.json'), join(at, 'nest.json')];
    writeFileSync(file, nest);
    const planner = await createPlanner();
    t.after(() => planner.close());
    writeFileSync(shop, JSON.stringify({ ...planner.machines.find((m) => m.name === 'fibre-6kw-thick'), kerf_width: 0.4 }));
    const ran = await kerfway('plan', file, '--machine', shop, '--moves', '5000', '--seed', '1', '--shared-cuts', '--savings', '--json', json);
    assert.equal(ran.code, 0, ran.stderr);
    assert.match(ran.stdout + ran.stderr, /common-cuts saves/);
    const { machine, summary } = JSON.parse(readFileSync(json, 'utf8'));
    assert.deepEqual([machine.levers, summary.pierces], [{ common_cuts: {} }, 1]);
    // A tenth of a millimetre more than a kerf apart: offered, and shifted.
    writeFileSync(file, dxf(square(10, 10, 20), square(30.5, 10, 20)));
    const shifted = async (option) => {
      const done = await kerfway('plan', file, '--machine', shop, '--moves', '5000', '--seed', '1', option, '0.5', '--json', json);
      assert.equal(done.code, 0, done.stderr);
      const document = JSON.parse(readFileSync(json, 'utf8'));
      assert.ok(validate(document), JSON.stringify(validate.errors));
      return [document.machine.levers.common_cuts, document.summary.pierces, document.findings.filter((f) => f.code === 'part-shift').map((f) => f.message)];
    };
    assert.deepEqual(await shifted('--offer-shifts'), [{ shift: 0.5 }, 2, ['Shifted by (-0.100, 0.000) mm, this part would stand one kerf from a neighbour. It stays where it is drawn.']]);
    assert.deepEqual(await shifted('--shift-parts'), [{ shift: 0.5, shift_parts: true }, 1, ['This part is shifted by (-0.100, 0.000) mm, so that it stands one kerf from a neighbour.']]);
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

describe('what each lever saves', () => {
  const row = dxf(square(0, 0, 60), circle(10, 20, 3), circle(20, 20, 3), circle(30, 20, 3), line(80, 0, 80, 30));
  const levers = { moving_pierce: { overcut: 0 }, fly: { reach: 20 }, lift: { height: 10, stay_down: 20 } };

  it('is found by planning again without it', async () => {
    const planner = await createPlanner();
    const thin = planner.machines.find((m) => m.name === 'fibre-3kw-thin');
    const joints = { rules: [{ side: 'outer', count: 2, width: 0.5, kind: 'flying' }] };
    const machine = { ...thin, z_speed: 100, levers, joints };
    const total = async (profile) => (await planner.plan({ machine: profile, seed: 1, moves: 20_000 }).done).progress.summary.total_time;
    await planner.load(row, 'row.dxf');
    const all = await total(machine);
    const saved = [];
    for await (const one of leverSavings(planner, { machine, seed: 1, moves: 20_000 }, all)) saved.push(one);
    assert.deepEqual(saved.map((s) => s.lever), LEVERS.filter((lever) => lever !== 'avoid-tips' && lever !== 'heat' && lever !== 'chains' && lever !== 'edge-starts' && lever !== 'bridges' && lever !== 'common-cuts' && lever !== 'corners'));
    for (const { lever, seconds } of saved) assert.equal(seconds, (await total(withoutLever(machine, lever))) - all, lever);
    const by = Object.fromEntries(saved.map((s) => [s.lever, s.seconds]));
    // Two holes more begin at rest, and so does nothing else: the outline has joints, and the line is open.
    assert.ok(by.fly > 2 * thin.beam_off_delay, JSON.stringify(by));
    assert.ok(by['lift-on-the-way'] > 0 && by['stay-down'] >= 0 && by['flying-joints'] > 2 * thin.pierce_time, JSON.stringify(by));
    planner.close();
  });

  it('is left out of machines without levers', async () => {
    const planner = await createPlanner();
    for (const machine of planner.machines) for (const lever of LEVERS) assert.equal(withoutLever(machine, lever), null, `${machine.name} ${lever}`);
    planner.close();
  });

  it('is printed by the command line and written into the plan', async (t) => {
    const at = folder(t);
    const [file, json] = [join(at, 'row.dxf'), join(at, 'row.json')];
    writeFileSync(file, row);
    const plan = (...options) => kerfway('plan', file, '--machine', 'fibre-3kw-thin', '--moves', '5000', '--seed', '1', '--savings', ...options);
    const ran = await plan('--moving-pierce', '0', '--fly', '20', '--json', json);
    assert.equal(ran.code, 0, ran.stderr);
    assert.match(ran.stdout, /^Levers {5}moving-pierce saves .+\n {11}fly saves /m);
    const document = JSON.parse(readFileSync(json, 'utf8'));
    assert.deepEqual(document.savings.map((s) => s.lever), ['moving-pierce', 'fly']);
    assert.ok(document.savings.every((s) => s.seconds > 0));
    assert.ok(validate(document), JSON.stringify(validate.errors, null, 1));
    assert.match((await plan()).stdout, /^Levers {5}the machine has none$/m);
    const quoted = await kerfway('quote', file, '--machine', 'fibre-3kw-thin', '--moves', '5000', '--fly', '20', '--savings');
    assert.match(quoted.stdout, /^Levers {5}fly saves /m);
  });
});

describe('tipped pieces', () => {
  // Five squares of 40 mm in a row, 10 mm apart, that tip up.
  const ROW = dxf(...Array.from({ length: 5 }, (_, k) => square(50 + 50 * k, 50, 40)));
  const TIPS = { drops_below: 0, nozzle_radius: 6, margin: 2 };
  let planner, thin;
  before(async () => {
    planner = await createPlanner();
    thin = { ...planner.machines.find((m) => m.name === 'fibre-3kw-thin'), z_speed: 100 };
  });
  after(() => planner.close());

  const planned = async (levers) => {
    await planner.load(ROW, 'row.dxf');
    const run = planner.plan({ machine: { ...thin, levers }, seed: 1, moves: 50_000 });
    const { path } = (await run.done).progress;
    const plan = JSON.parse(await planner.output('json'));
    return { ...plan, path, gcode: await planner.output('gcode'), check: await planner.check() };
  };

  it('are reported, or avoided in less time than lifting the head for every move takes', async () => {
    const ignored = await planned({ tips: { ...TIPS, risky_moves: 'ignore' } });
    const risky = ignored.moves.filter((m) => m.way === 'crosses').length;
    assert.ok(risky > 0 && ignored.summary.crossings === risky);
    const [finding] = ignored.findings.filter((f) => f.code === 'risky-moves');
    assert.match(finding.message, /crosse?s? a piece that may have tipped up/);
    assert.deepEqual([...ignored.path.tips], [0, 1, 2, 3, 4]);
    assert.equal([...ignored.path.ways].filter((w) => w === 3).length, risky);

    const [avoided, lifted] = [await planned({ tips: TIPS, lift: { height: 10 } }), await planned({ lift: { height: 10 } })];
    assert.equal(avoided.summary.crossings, undefined);
    assert.ok(avoided.summary.total_time < lifted.summary.total_time);
    assert.ok(avoided.summary.total_time >= ignored.summary.total_time - 1e-9);
    // What is left out of it for the savings is the lifts for every move.
    const machine = { ...thin, levers: { tips: TIPS, lift: { height: 10, stay_down: 5 } } };
    assert.deepEqual([withoutLever(machine, 'stay-down'), withoutLever(machine, 'avoid-tips').levers], [null, { lift: { height: 10, stay_down: 0 } }]);
    for (const { check } of [ignored, avoided, lifted]) assert.deepEqual([check.passed, check.problems], [true, []]);
    assert.equal(avoided.gcode.match(/^G0 X\S+ Y\S+ Z10/gm)?.length ?? 0, avoided.summary.lifts ?? 0);
  });

  it('are options of the command line', async (t) => {
    const at = folder(t);
    const [file, json] = [join(at, 'row.dxf'), join(at, 'row.json')];
    writeFileSync(file, ROW);
    const plan = (...options) => kerfway('plan', file, '--machine', 'fibre-3kw-thin', '--moves', '5000', '--seed', '1', '--json', json, ...options);
    const ran = await plan('--tips', 'avoid', '--lift', '10', '--z-speed', '100', '--slats', '60,90', '--nozzle-radius', '5', '--drops-below', '20', '--cross-over', '8');
    assert.equal(ran.code, 0, ran.stderr);
    const { tips } = JSON.parse(readFileSync(json, 'utf8')).machine.levers;
    assert.deepEqual(tips, { risky_moves: 'avoid', nozzle_radius: 5, margin: 2, slats: { pitch: 60, angle: Math.PI / 2 }, tips_below: 150, drops_below: 20, cross_over: 8 });
    const without = await plan('--tips', 'avoid');
    assert.deepEqual([without.code, /Give the height with --lift/.test(without.stderr)], [2, true], without.stderr);
    const unsaid = await plan('--nozzle-radius', '5');
    assert.deepEqual([unsaid.code, /--tips avoid or --tips ignore/.test(unsaid.stderr)], [2, true], unsaid.stderr);
  });
});

describe('heat', () => {
  // A grid of 5 x 5 squares of 10 mm, 10 mm apart.
  const GRID = dxf(...Array.from({ length: 25 }, (_, k) => square(30 + 20 * (k % 5), 30 + 20 * Math.floor(k / 5), 10)));
  const HEAT = { distance: 12, seconds: 2 };
  let planner, thin;
  before(async () => {
    planner = await createPlanner();
    thin = planner.machines.find((m) => m.name === 'fibre-3kw-thin');
  });
  after(() => planner.close());

  const options = (levers) => ({ machine: { ...thin, levers }, seed: 1, moves: 100_000 });
  const planned = async (levers) => {
    await planner.load(GRID, 'grid.dxf');
    await planner.plan(options(levers)).done;
    const plan = JSON.parse(await planner.output('json'));
    return { ...plan, gcode: await planner.output('gcode'), check: await planner.check() };
  };

  it('is minded by another order, by waiting, or at a charge', async () => {
    const [plain, waiting, charged, reported] = [await planned({}), await planned({ heat: HEAT }), await planned({ heat: { ...HEAT, charge: 50 } }), await planned({ heat: { ...HEAT, charge: 0 } })];
    for (const { check } of [plain, waiting, charged, reported]) assert.deepEqual([check.passed, check.problems], [true, []]);
    const waits = waiting.moves.filter((m) => m.kind === 'wait');
    assert.equal(waits.length, waiting.summary.waits ?? 0);
    assert.ok(Math.abs(waits.reduce((sum, m) => sum + m.seconds, 0) - (waiting.summary.wait_time ?? 0)) < 1e-9);
    assert.equal(waiting.gcode.match(/waits \d+\.\d+ s until it has cooled/g)?.length ?? 0, waits.length);
    assert.equal(waiting.summary.hot_pairs, undefined);
    // Another order costs far less than waiting for most squares would.
    assert.ok(waiting.summary.total_time > plain.summary.total_time && waiting.summary.total_time < plain.summary.total_time + 10, `${plain.summary.total_time} ${waiting.summary.total_time}`);
    assert.equal(charged.summary.waits, undefined);
    assert.ok((charged.summary.hot_pairs ?? 0) < reported.summary.hot_pairs);
    const [finding] = reported.findings.filter((f) => f.code === 'hot-pairs');
    assert.equal(finding.count, reported.summary.hot_pairs);
    assert.match(finding.message, /^\d+ pairs of cuts nearer to each other than 12 mm follow each other within 2 s\./);
  });

  it('is among the savings as what it costs', async () => {
    await planner.load(GRID, 'grid.dxf');
    const { progress } = await planner.plan(options({ heat: HEAT })).done;
    const saved = [];
    for await (const one of leverSavings(planner, options({ heat: HEAT }), progress.summary.total_time)) saved.push(one);
    assert.deepEqual(saved.map((s) => s.lever), ['heat']);
    assert.ok(saved[0].seconds < 0, JSON.stringify(saved));
  });

  it('goes together with chains: the head waits on kerfs, and a charge is paid at chains', async () => {
    const thick = planner.machines.find((m) => m.name === 'fibre-6kw-thick');
    const planned = async (heat) => {
      await planner.load(dxf(...[[0, 0], [28, 0], [0, 28], [28, 28]].map(([x, y]) => square(10 + x, 10 + y, 20))), 'nest.dxf');
      const levers = { chains: { reach: 30, clearance: 1, edge_starts: true }, heat: { distance: 12, seconds: 3, ...heat } };
      const { progress } = await planner.plan({ machine: { ...thick, levers }, seed: 1, moves: 100_000 }).done;
      const check = await planner.check();
      assert.deepEqual([check.passed, check.problems], [true, []]);
      return { ...JSON.parse(await planner.output('json')), path: progress.path, gcode: await planner.output('gcode') };
    };
    const [waiting, charged] = [await planned({}), await planned({ charge: 0.1 })];
    assert.deepEqual([waiting.summary.pierces, waiting.summary.waits, waiting.summary.edge_starts], [1, 3, 3]);
    const kinds = waiting.moves.map((m) => m.kind);
    assert.equal(kinds.filter((kind, k) => kind === 'wait' && kinds[k + 1] === 'chain').length, 3);
    assert.equal(waiting.gcode.match(/from a kerf or an edge through waste/g)?.length, 3);
    // The path says where it waits before it cuts through waste.
    assert.deepEqual([...waiting.path.ways].slice(0, 4), [0, 5, 5, 5]);
    assert.deepEqual([...waiting.path.waits].map((seconds) => seconds > 2), [false, true, true, true]);
    assert.deepEqual([charged.summary.pierces, charged.summary.waits, charged.summary.chains, charged.summary.edge_starts], [1, undefined, 3, undefined]);
    assert.ok(charged.summary.hot_pairs > 0);
  });

  it('contradicts cuts on the run', async () => {
    await planner.load(GRID, 'grid.dxf');
    await assert.rejects(planner.plan(options({ heat: HEAT, fly: { reach: 20 } })).done, /levers\.heat and levers\.fly/);
  });

  it('is an option of the command line', async (t) => {
    const at = folder(t);
    const [file, json] = [join(at, 'grid.dxf'), join(at, 'grid.json')];
    writeFileSync(file, GRID);
    const plan = (...words) => kerfway('plan', file, '--machine', 'fibre-3kw-thin', '--moves', '5000', '--seed', '1', '--json', json, ...words);
    const ran = await plan('--heat', '12,2', '--heat-charge', '3', '--small-holes', '8,1.5');
    assert.equal(ran.code, 0, ran.stderr);
    assert.deepEqual(JSON.parse(readFileSync(json, 'utf8')).machine.levers.heat, { distance: 12, seconds: 2, charge: 3, small_holes: { thickness: 8, ratio: 1.5 } });
    const holes = await plan('--small-holes', '8');
    assert.equal(holes.code, 0, holes.stderr);
    assert.deepEqual(JSON.parse(readFileSync(json, 'utf8')).machine.levers.heat, { distance: 0, seconds: 0, small_holes: { thickness: 8, ratio: 1 } });
    for (const [words, says] of [[['--heat', '12'], /as MM,S/], [['--heat-charge', '3'], /with --heat MM,S/], [['--heat', '12,2', '--fly', '20'], /--heat and --fly/]]) {
      const wrong = await plan(...words);
      assert.deepEqual([wrong.code, says.test(wrong.stderr)], [2, true], wrong.stderr);
    }
  });
});

describe('corners', () => {
  // Three wedges of 60 degrees, 20 mm apart, and a plate with a square hole.
  const wedge = (x) => polygon([[x, 20], [x + 30, 20], [x + 15, 20 + 15 * Math.sqrt(3)]]);
  const DRAWING = dxf(wedge(20), wedge(70), wedge(120), square(180, 20, 60), square(200, 40, 20));
  const CORNERS = { outer: 'loop', hole: 'round', loop_radius: 1 };
  let planner, plate;
  before(async () => {
    planner = await createPlanner();
    plate = { ...planner.machines.find((m) => m.name === 'fibre-6kw-plate'), pre_cut_time: null, pre_cut_length: 0 };
  });
  after(() => planner.close());

  const options = (levers) => ({ machine: { ...plate, levers }, seed: 1, moves: 50_000 });
  const planned = async (levers, load = {}) => {
    await planner.load(DRAWING, 'wedges.dxf', load);
    await planner.plan(options(levers)).done;
    return { ...JSON.parse(await planner.output('json')), check: await planner.check(), quote: await planner.quote(), svg: await planner.output('svg') };
  };

  it('are cut in loops or rounded, and the result says how many and how far off', async () => {
    const [before, now] = [await planned({}), await planned({ corners: CORNERS })];
    for (const { check } of [before, now]) assert.deepEqual([check.passed, check.problems], [true, []]);
    const corners = now.moves.flatMap((m) => m.corners ?? []);
    const of = (kind) => corners.filter((c) => c.kind === kind).length;
    assert.deepEqual([of('loop'), of('round')], [now.summary.loops, now.summary.rounded_corners ?? 0]);
    assert.ok(now.summary.loops >= 6 && now.summary.rounded_corners >= 3, JSON.stringify(now.summary));
    assert.ok(Math.abs(now.summary.corner_deviation - 0.1) < 1e-9);
    assert.deepEqual([before.summary.macro_time, now.summary.macro_time], [6, 0]);
    assert.ok(before.summary.total_time - now.summary.total_time > 3);
    assert.match(now.svg, /Loops at corners/);
    // Parts have the area and the outline that was drawn, and together all of the time.
    const facts = ({ quote: { parts } }) => parts.map((p) => [p.contours, p.area]);
    assert.deepEqual(facts(now), facts(before));
  });

  it('are chosen for single contours, on a machine that says how', async () => {
    const chosen = await planned({ corners: {} }, { contours: [{ contour: 0, corners: 'loop' }] });
    assert.deepEqual(chosen.moves.filter((m) => m.corners).map((m) => m.contour), [0]);
    await planner.load(DRAWING, 'wedges.dxf', { contours: [{ contour: 0, corners: 'loop' }] });
    await assert.rejects(planner.plan(options({})).done, /The corners of contour 0 are to be cut without a stop, but the machine fibre-6kw-plate has no "levers.corners"/);
    await assert.rejects(planner.load(DRAWING, 'wedges.dxf', { contours: [{ contour: 0, corners: 'curl' }] }), /stop, loop, round/);
  });

  it('are among the savings', async () => {
    await planner.load(DRAWING, 'wedges.dxf');
    const { progress } = await planner.plan(options({ corners: CORNERS })).done;
    const saved = [];
    for await (const one of leverSavings(planner, options({ corners: CORNERS }), progress.summary.total_time)) saved.push(one);
    assert.deepEqual([saved.map((s) => s.lever), saved[0].seconds > 3], [['corners'], true]);
  });

  it('are options of the command line', async (t) => {
    const at = folder(t);
    const [file, json] = [join(at, 'wedges.dxf'), join(at, 'wedges.json')];
    writeFileSync(file, DRAWING);
    const plan = (...words) => kerfway('plan', file, '--machine', 'fibre-6kw-plate', '--moves', '5000', '--seed', '1', '--json', json, ...words);
    const levers = () => JSON.parse(readFileSync(json, 'utf8')).machine.levers;
    const defaults = { outer: 'stop', hole: 'stop', loop_radius: 2, clearance: 1, round_radius: 1, deviation: 0.1 };
    const ran = await plan('--corners', 'loop', '--hole-corners', 'round', '--loop-radius', '1', '--loop-clearance', '0.5', '--round-radius', '3', '--corner-deviation', '0.2');
    assert.equal(ran.code, 0, ran.stderr);
    assert.deepEqual(levers().corners, { outer: 'loop', hole: 'round', loop_radius: 1, clearance: 0.5, round_radius: 3, deviation: 0.2 });
    const single = await plan('--corners-of', '1=round');
    assert.equal(single.code, 0, single.stderr);
    assert.deepEqual(levers().corners, defaults);
    assert.deepEqual(JSON.parse(readFileSync(json, 'utf8')).options.contours, [{ contour: 1, corners: 'round' }]);
    const wrong = await plan('--corners', 'curl');
    assert.deepEqual([wrong.code, /choose one of stop, loop, round/.test(wrong.stderr)], [2, true], wrong.stderr);
  });
});
