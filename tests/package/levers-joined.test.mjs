// Levers that join contours: bridges, chains, common cuts.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { createPlanner, withoutLever } from 'kerfway';
import { dxf, folder, kerfway, line, square } from './support.mjs';

const schema = createRequire(import.meta.url).resolve('kerfway/plan.schema.json');
const validate = new Ajv2020({ allErrors: true }).compile(JSON.parse(readFileSync(schema, 'utf8')));

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

  it('are named by their options where they contradict something', async (t) => {
    const at = folder(t);
    const [file, profile] = [join(at, 'row.dxf'), join(at, 'flying.json')];
    writeFileSync(file, row);
    const plan = async (...options) => {
      const { code, stderr } = await kerfway('plan', file, '--moves', '500', '--quiet', ...options);
      return [code, stderr.trim()];
    };
    const because = 'Outlines that bridges connect are cut in one go: give one of them.';
    assert.deepEqual(await plan('--bridges', '10', '--fly', '20'), [1, `kerfway: ${file}: --bridges and --fly contradict each other. ${because}`]);
    // What the machine has of its own keeps its name.
    const planner = await createPlanner();
    t.after(() => planner.close());
    writeFileSync(profile, JSON.stringify({ ...planner.machines.find(({ name }) => name === 'co2-100w'), levers: { fly: { reach: 20 } } }));
    assert.deepEqual(await plan('--machine', profile, '--bridges', '10'), [1, `kerfway: ${file}: --bridges and levers.fly contradict each other. ${because}`]);
    assert.deepEqual(await plan('--bridges', '10', '--part-by-part'), [1, `kerfway: ${file}: Parts that bridges connect are finished together. Leave out "--bridges", or do not cut part by part.`]);
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
