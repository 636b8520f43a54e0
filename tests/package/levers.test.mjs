// Levers through the package and the command line.

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
    assert.match(wrong.stderr, /levers\.moving_pierce\.overcut/);
  });
});
