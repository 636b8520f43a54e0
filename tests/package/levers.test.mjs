// What each lever of a machine saves.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { describe, it } from 'node:test';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { createPlanner, LEVERS, leverSavings, withoutLever } from 'kerfway';
import { circle, dxf, folder, kerfway, line, square } from './support.mjs';

const schema = createRequire(import.meta.url).resolve('kerfway/plan.schema.json');
const validate = new Ajv2020({ allErrors: true }).compile(JSON.parse(readFileSync(schema, 'utf8')));

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
