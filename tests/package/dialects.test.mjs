// Every dialect over every drawing, read by gcode-toolpath (cncjs, MIT): somebody else's interpreter finds every cut of the plan.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { check, createPlanner } from 'kerfway';
import { dxf, ROOT, square } from './support.mjs';
import { compared } from './toolpath.mjs';

const FIXTURES = join(ROOT, 'tests', 'fixtures');
const drawings = (folder) => readdirSync(folder).filter((f) => /\.dxf$/i.test(f)).map((f) => join(folder, f));
const DRAWINGS = [...drawings(join(FIXTURES, 'dxf-dev')), ...drawings(join(ROOT, 'www', 'app', 'public', 'samples')), join(FIXTURES, 'sheets', 'sheet_2000.dxf')];

describe('dialects', () => {
  let planner;
  let machine;
  before(async () => {
    planner = await createPlanner();
    machine = { ...planner.machines[0], bed: null, pierce_time: 0.25, beam_off_delay: 0 };
  });
  after(() => planner.close());

  for (const file of DRAWINGS) {
    const name = file.slice(ROOT.length + 1);
    it(`are read by gcode-toolpath: ${name}`, async (t) => {
      const loaded = await planner.load(readFileSync(file), name);
      if (!loaded.contours.some((c) => c.operation !== 'ignore')) return t.skip('nothing to cut');
      for (const { name: dialect } of planner.dialects) {
        await planner.plan({ machine: { ...machine, dialect }, moves: 0, seed: 1 }).done;
        const { cuts, planned, off, length, expected } = compared(await planner.output('gcode'), JSON.parse(await planner.output('json')));
        assert.equal(cuts, planned, dialect);
        assert.ok(off <= 0.002, `${dialect}: a cut is ${off} mm off`);
        assert.ok(Math.abs(length - expected) < 0.004 * planned + 1e-4 * length, `${dialect}: ${length} mm, ${expected} planned`);
      }
    });
  }

  it('are documents that the published schema allows', () => {
    const at = createRequire(import.meta.url).resolve('kerfway/dialect.schema.json');
    const validate = new Ajv2020({ allErrors: true, allowUnionTypes: true }).compile(JSON.parse(readFileSync(at, 'utf8')));
    assert.equal(planner.dialects.length, 11);
    for (const dialect of planner.dialects) {
      const file = JSON.parse(readFileSync(createRequire(import.meta.url).resolve(`kerfway/dialects/${dialect.name}.json`), 'utf8'));
      assert.ok(validate(file), `${dialect.name}: ${JSON.stringify(validate.errors)}`);
      assert.equal(file.title, dialect.title);
    }
    assert.ok(!validate({ ...planner.dialects[0], pierce: { by: 'hope' } }));
  });

  it('of one\'s own are used, and refused in a sentence', async () => {
    await planner.load(dxf(square(0, 0, 40)), 'square.dxf');
    const own = { ...structuredClone(planner.dialects.find((d) => d.name === 'smoothie')), name: 'mine', footer: ['M5', 'G28'] };
    await planner.plan({ machine: { ...machine, dialect: own }, moves: 0, seed: 1 }).done;
    await assert.rejects(planner.output('gcode'), /does not pass its own check, so it was not written: .*G28/);
    const fine = { ...own, footer: ['M5'], chords: 0.02 };
    await planner.plan({ machine: { ...machine, dialect: fine }, moves: 0, seed: 1 }).done;
    assert.match(await planner.output('gcode'), /S0\.85/);
    assert.match(await planner.sampleProgram({ machine: { ...machine, dialect: fine } }), /sample\.dxf/);
    const wrong = planner.plan({ machine: { ...machine, dialect: { ...own, pierce: { by: 'dwell-m3' } } }, moves: 0 });
    await assert.rejects(wrong.done, /pierces by "dwell-m3", which does not work with power by "motion"/);
    await assert.rejects(planner.plan({ machine: { ...machine, dialect: 'grbl-m5' }, moves: 0 }).done, /no dialect named "grbl-m5"\. Did you mean "grbl-m4"/);
  });

  it('are checked by the function check', async () => {
    await planner.load(dxf(square(0, 0, 40)), 'square.dxf');
    await planner.plan({ machine, moves: 0, seed: 1 }).done;
    const program = await planner.output('gcode');
    const report = await check(program, { machine });
    assert.deepEqual([report.passed, report.contours, report.parts, report.passes, report.dark_rapids], [true, 1, 1, 1, true]);
    assert.deepEqual((await planner.check()).problems, []);
    const broken = await check(new TextEncoder().encode(program.replace('G4 P0.255', 'G4 P255')), { machine });
    assert.equal(broken.passed, false);
    assert.match(broken.problems[0].message, /waits 255 s/);
    await assert.rejects(check(program, { machin: 'co2-100w' }), /Did you mean "machine"/);
  });

  it('of other programs pass with warnings where the file alone cannot tell', async () => {
    const lightburn = 'G21\nG90\nM4\nG0 X0 Y0\nG1 X10 S500 F600\nG0 X20 Y0\nG1 X30\nM5\nM2\n';
    const report = await check(lightburn);
    assert.equal(report.passed, true);
    assert.deepEqual(report.problems.map((p) => [p.code, p.severity]), [['power-on-rapid', 'warning']]);
    const marlin = await check('G90\nG1 X10 F600 S5\n', { machine: { ...machine, dialect: 'marlin-inline' } });
    assert.deepEqual(marlin.problems.map((p) => p.code).sort(), ['empty', 'units-unknown']);
  });

  it('LightBurn projects and Ruida files are written', async () => {
    await planner.load(dxf(square(0, 0, 40)), 'square.dxf');
    await planner.plan({ machine, moves: 0, seed: 1 }).done;
    const project = await planner.output('lbrn2');
    assert.match(project, /^<\?xml[^]*<Optimize_ReduceTravel Value="0"\/>[^]*<speed Value="35"\/>[^]*<PrimList>L0 1L1 2L2 3L3 0<\/PrimList>/);
    const ruida = await planner.output('rd');
    assert.ok(ruida instanceof Uint8Array && ruida.length > 200);
  });
});
