// Skeleton cuts and the remainder of the sheet through the package and the command line.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { createPlanner, quote } from 'kerfway';
import { circle, dxf, folder, kerfway, square } from './support.mjs';

const schemaOf = (name) => new Ajv2020({ allErrors: true }).compile(JSON.parse(readFileSync(createRequire(import.meta.url).resolve(`kerfway/${name}.schema.json`), 'utf8')));
const plate = (width, height) => [[0, 'LWPOLYLINE'], [8, 'PLATE'], [90, 4], [70, 1], ...[[0, 0], [width, 0], [width, height], [0, height]].flatMap(([x, y]) => [[10, x], [20, y]])];
// The square ends at 80, the disk reaches from x 120 to 180 and from y 70 to 130.
const DRAWING = dxf(square(20, 20, 60), circle(50, 50, 20), circle(150, 100, 30), plate(300, 200));
const LOAD = { layers: [{ name: 'PLATE', operation: 'ignore' }] };
const GRID = { spacing_x: 100, spacing_y: 120 };

describe('skeleton cuts', () => {
  let planner, thin;
  before(async () => {
    planner = await createPlanner();
    thin = planner.machines.find((m) => m.name === 'fibre-3kw-thin');
  });
  after(() => planner.close());

  const planned = async (machine, drawing = DRAWING, load = LOAD) => {
    await planner.load(drawing, 'sheet.dxf', load);
    const run = planner.plan({ machine, seed: 1, moves: 20_000 });
    const { path } = (await run.done).progress;
    const started = await run.started;
    return { started, path, plan: JSON.parse(await planner.output('json')) };
  };

  /** The layers and areas of the closed outlines in a drawing. */
  const outlines = async (text) => {
    const read = await planner.load(new TextEncoder().encode(text), 'remainder.dxf', { keepBorder: true });
    return read.contours.map(({ layer, area }) => [layer, Math.round(area)]).sort();
  };

  it('divide the sheet evenly, keep away from parts, come last, and are in the plan', async () => {
    const without = await planned(thin);
    assert.deepEqual([without.plan.summary.skeleton_cuts, without.plan.machine.skeleton], [undefined, undefined]);
    const { plan, path, started } = await planned({ ...thin, skeleton: GRID });
    assert.deepEqual(plan.machine.skeleton, { ...GRID, clearance: 2, joint_width: 1 });
    const own = plan.contours.filter((c) => c.skeleton).map((c) => c.id);
    assert.deepEqual(own, [3, 4, 5, 6]);
    assert.deepEqual(started.beam.contours.map((c) => c.skeleton === true), [false, false, false, true, true, true, true]);
    // Two lines up, and one along that ends 2 mm before the disk and goes on 2 mm after it.
    assert.deepEqual([plan.summary.skeleton_cuts, plan.summary.contours, plan.summary.pierces], [4, 3, 7]);
    assert.ok(Math.abs(plan.summary.skeleton_length - (200 + 200 + 118 + 118)) < 1e-3, `${plan.summary.skeleton_length}`);
    assert.ok(Math.abs(plan.summary.total_time - without.plan.summary.total_time - plan.summary.skeleton_time) < 1);
    assert.deepEqual([...path.contours].slice(3).sort(), own);
    const cuts = plan.moves.filter((m) => m.kind === 'cut').map((m) => m.contour);
    assert.deepEqual(cuts.slice(3).sort(), own);
    const validate = schemaOf('plan');
    assert.ok(validate(plan), JSON.stringify(validate.errors, null, 1));
    const { passed, problems } = await planner.check();
    assert.deepEqual([passed, problems], [true, []]);
  });

  it('leave joints in long cuts', async () => {
    const { plan } = await planned({ ...thin, skeleton: { spacing_x: 100, joint_spacing: 100, joint_width: 2 } });
    // Two lines of 200 mm with one joint each.
    assert.equal(plan.summary.skeleton_cuts, 4);
    assert.ok(Math.abs(plan.summary.skeleton_length - 2 * (200 - 2 - (thin.kerf_width ?? 0))) < 1e-3, `${plan.summary.skeleton_length}`);
  });

  it('leave a drawing of the remainder: the sheet with its holes, or the strip that is cut off', async () => {
    await planned({ ...thin, skeleton: GRID });
    const whole = await planner.output('remainder');
    await planned({ ...thin, skeleton: { remainder: 50 } });
    const strip = await planner.output('remainder');
    await planned(thin);
    const plain = await planner.output('remainder');
    const disk = Math.round(Math.PI * 30 ** 2);
    assert.deepEqual(await outlines(whole), [['CUT OUT', disk], ['CUT OUT', 60 * 60], ['SHEET', 300 * 200]]);
    assert.deepEqual(await outlines(strip), [['SHEET', 118 * 200]]);
    assert.equal(plain, whole);
  });

  it('are in a quote', async () => {
    const found = await quote(DRAWING, { ...LOAD, machine: { ...thin, skeleton: GRID }, moves: 5000, seed: 1 });
    assert.deepEqual([found.skeleton_cuts, Math.round(found.skeleton_length)], [4, 636]);
    assert.ok(found.skeleton_time > 0 && found.skeleton_time < found.times.total);
    assert.deepEqual(found.layers.map((l) => l.contours), [3]);
    const validate = schemaOf('quote');
    assert.ok(validate(found), JSON.stringify(validate.errors, null, 1));
  });

  it('are refused with a sentence where they cannot be', async () => {
    const start = (skeleton, drawing = DRAWING) => planned({ ...thin, bed: null, skeleton }, drawing);
    await assert.rejects(start(GRID, dxf(circle(0, 0, 30))), /the size of the sheet is not known\. Draw its outline as a closed line on a layer that is ignored, or give the machine's bed and a program in machine coordinates\./);
    await assert.rejects(start({ spacing_x: 5 }), /skeleton\.spacing_x/);
    await assert.rejects(start({ spacing: 100 }), /skeleton\.spacing/);
    await assert.rejects(start({ clearance: 0 }), /skeleton\.clearance/);
    await assert.rejects(start({ remainder: null, joint_width: '1' }), /skeleton\.joint_width/);
  });

  it('are options of the command line', async (t) => {
    const at = folder(t);
    const [file, json, rest] = ['sheet.dxf', 'plan.json', 'rest.dxf'].map((name) => join(at, name));
    writeFileSync(file, DRAWING);
    const plan = async (...options) => {
      const ran = await kerfway('plan', file, '--layer', 'PLATE=ignore', '--machine', 'fibre-3kw-thin', '--moves', '2000', '--seed', '1', '--json', json, ...options);
      return { ...ran, plan: ran.code === 0 ? JSON.parse(readFileSync(json, 'utf8')) : null };
    };
    const all = await plan('--skeleton', '100,120', '--skeleton-clearance', '3', '--skeleton-joints', '150', '--keep-strip', '90', '--remainder', rest);
    assert.equal(all.code, 0, all.stderr);
    assert.deepEqual(all.plan.machine.skeleton, { ...GRID, clearance: 3, joint_spacing: 150, joint_width: 1, remainder: 90 });
    assert.match(all.stdout, /skeleton/i);
    // The strip begins 3 mm beside the disk.
    assert.deepEqual(await outlines(readFileSync(rest, 'utf8')), [['SHEET', 117 * 200]]);
    assert.equal((await plan('--skeleton', '100')).plan.machine.skeleton.spacing_y, 100);
    // What is left of the sheet is written without skeleton cuts, too.
    const plain = await plan('--remainder', join(at, 'plain.dxf'));
    assert.deepEqual([plain.code, existsSync(join(at, 'plain.dxf')), plain.plan.summary.skeleton_cuts], [0, true, undefined]);
    for (const [wrong, says] of [
      [['--skeleton', '5'], /--skeleton 5: give a number from 10/], [['--skeleton', '1,2,3'], /give one length in mm for x and y/],
      [['--skeleton-joints', '100'], /Ask for them with --skeleton or --keep-strip/],
    ]) {
      const ran = await plan(...wrong);
      assert.equal(ran.code, 2, ran.stderr);
      assert.match(ran.stderr, says);
    }
  });
});
