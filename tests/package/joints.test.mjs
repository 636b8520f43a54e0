// Micro-joints through the package and the command line.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { createPlanner, DEFAULT_JOINTS, jointRules, jointSettings, quote } from 'kerfway';
import { circle, dxf, folder, kerfway, line, square } from './support.mjs';

const DRAWING = dxf(square(0, 0, 60), circle(20, 20, 6), circle(40, 40, 6), line(80, 0, 80, 30));

describe('micro-joints', () => {
  let planner, thin;
  before(async () => {
    planner = await createPlanner();
    thin = planner.machines.find((m) => m.name === 'fibre-3kw-thin');
  });
  after(() => planner.close());

  const planned = async (machine, load = {}) => {
    await planner.load(DRAWING, 'plate.dxf', load);
    const run = planner.plan({ machine, seed: 1, moves: 20_000 });
    const { path } = (await run.done).progress;
    return { path, plan: JSON.parse(await planner.output('json')) };
  };

  it('are rules of the machine, which the settings come back from', () => {
    const some = { ...DEFAULT_JOINTS, count: 3, width: 0.3, spacing: 120, side: 'both', kind: 'flying', sizeMin: [1, 2], sizeMax: [100, 50], test: 'or' };
    for (const settings of [DEFAULT_JOINTS, some]) assert.deepEqual(jointSettings(jointRules(settings)), settings);
    assert.deepEqual(jointRules({ width: 0.3 }), { rules: [{ count: 2, width: 0.3, corner_clearance: 2, kind: 'stop', side: 'outer' }] });
    assert.equal(jointSettings({ rules: [...jointRules().rules, ...jointRules().rules] }), null);
  });

  it('stay uncut, cost seconds, and are in the plan and in the path', async () => {
    const without = await planned(thin);
    assert.equal(without.plan.summary.joints, undefined);
    for (const kind of ['stop', 'flying']) {
      const { plan, path } = await planned({ ...thin, joints: jointRules({ side: 'both', kind }) });
      assert.equal(plan.summary.joints, 6);
      const moves = plan.moves.filter((m) => m.kind === 'joint');
      // A joint at which a contour begins has no move.
      assert.ok(moves.length >= 3 && moves.every((m) => (m.flying === true) === (kind === 'flying')), `${moves.length} moves`);
      assert.equal(path.jointOffsets.length - 1, 6);
      assert.equal((plan.summary.joint_time ?? 0) > 0, kind === 'stop');
      if (kind === 'stop') assert.ok(plan.summary.total_time > without.plan.summary.total_time);
    }
  });

  it('are placed by hand on a contour, and an unknown contour is refused', async () => {
    const { plan } = await planned(thin, { joints: [{ contour: 0, at: 0.125 }] });
    assert.equal(plan.summary.joints, 1);
    assert.deepEqual(plan.options.joints, [{ contour: 0, at: 0.125 }]);
    await assert.rejects(planner.load(DRAWING, 'plate.dxf', { joints: [{ contour: 9, at: 0.5 }] }), /Contour 9 is listed in the options/);
    await assert.rejects(planner.load(DRAWING, 'plate.dxf', { joints: [{ contour: 0, at: 1.5 }] }), /joints/);
  });

  it('are in the seconds of a quote', async () => {
    for (const kind of ['stop', 'flying']) {
      const found = await quote(DRAWING, { machine: { ...thin, joints: jointRules({ side: 'both', kind }) }, moves: 5000, seed: 1 });
      assert.equal(found.joints, 6);
      assert.equal((found.joint_time ?? 0) > 0, kind === 'stop');
    }
  });

  it('are options of the command line', async (t) => {
    const at = folder(t);
    const [file, program] = [join(at, 'plate.dxf'), join(at, 'plate.json')];
    writeFileSync(file, DRAWING);
    const plan = async (...options) => {
      const ran = await kerfway('plan', file, '--machine', 'fibre-3kw-thin', '--moves', '2000', '--seed', '1', '--json', program, ...options);
      return { ...ran, plan: ran.code === 0 ? JSON.parse(readFileSync(program, 'utf8')) : null };
    };
    const all = await plan('--joints', '3', '--joint-side', 'both', '--joint-width', '0.3');
    assert.equal(all.code, 0, all.stderr);
    assert.equal(all.plan.summary.joints, 9);
    assert.equal((await plan('--joints', '3', '--joint-size-min', '50')).plan.summary.joints, 3);
    assert.equal((await plan('--joint-at', '0@0.125', '--joint-at', '1@0.5')).plan.summary.joints, 2);
    for (const [wrong, says] of [
      [['--joint-at', '0@2'], /--joint-at 0@2: give the id of a contour/], [['--joint-size-max', '5,x'], /give one length in mm/],
      [['--joint-width', '0'], /--joint-width 0: give a number/], [['--joint-kind', 'soft'], /--joint-kind/],
    ]) {
      const ran = await plan(...wrong);
      assert.equal(ran.code, 2, ran.stderr);
      assert.match(ran.stderr, says);
    }
  });
});
