// What happens to the plate: pieces that tip, heat, corners.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { createPlanner, leverSavings, withoutLever } from 'kerfway';
import { circle, dxf, folder, kerfway, line, polygon, square } from './support.mjs';

const DRAWING = dxf(square(0, 0, 60), circle(20, 20, 3), circle(40, 40, 3), line(80, 0, 80, 30));

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
