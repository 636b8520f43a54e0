// The kerf width: the beam is offset from the drawn outlines, and sides one kerf apart are cut once.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { createPlanner } from 'kerfway';
import { circle, dxf, folder, kerfway, square } from './support.mjs';

const schema = createRequire(import.meta.url).resolve('kerfway/plan.schema.json');
const validate = new Ajv2020({ allErrors: true }).compile(JSON.parse(readFileSync(schema, 'utf8')));

/** A plate of 40 mm with a hole of 8 mm, and another plate one kerf from it. */
const KERF = 0.4;
const MM = { units: 'mm' };
const drawing = () => dxf(square(0, 0, 40), circle(20, 20, 4), square(40 + KERF, 0, 40));

const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-6, `${a} is not ${b}`);

describe('the width of the kerf', () => {
  let planner, plain, wide;
  before(async () => {
    planner = await createPlanner();
    plain = planner.machines.find((m) => m.name === 'co2-100w');
    wide = { ...plain, kerf_width: KERF };
  });
  after(() => planner.close());

  const planned = async (machine, options = {}) => {
    const run = planner.plan({ machine, seed: 1, moves: 5_000, ...options });
    const started = await run.started;
    await run.done;
    return { started, document: JSON.parse(await planner.output('json')) };
  };

  it('changes the contours, and removing it restores them', async () => {
    const loaded = await planner.load(drawing(), 'kerf.dxf', MM);
    const before = await planned(plain);
    assert.equal(before.started.beam, null);
    near(before.document.summary.cut_length, 2 * 160 + 8 * Math.PI);
    assert.ok(before.document.contours.every((c) => c.drawn === undefined));

    const { started, document } = await planned(wide);
    // Two squares of 40.4 mm with a common side, and a smaller hole.
    near(document.summary.cut_length, 7 * 40.4 + (8 - KERF) * Math.PI);
    assert.ok(validate(document), JSON.stringify(validate.errors, null, 1));
    assert.deepEqual(document.contours[1].drawn.from, [24, 20]);
    near(document.contours[0].area, 1600);
    [-0.2, -0.2, 80.6, 40.2].forEach((mm, k) => near(document.summary.bounds[k], mm));
    assert.equal(started.beam.contours.length, loaded.contours.length);
    assert.equal(started.beam.geometry.offsets.length, loaded.geometry.offsets.length);
    assert.ok(started.common.offsets.length > 1, 'what is cut once is told');
    assert.ok(document.findings.some((f) => f.code === 'overlap-removed' && f.message.includes('cut once')));

    assert.deepEqual((await planned(plain)).document, before.document);
  });

  it('is in the G-code', async () => {
    await planner.load(dxf(square(10, 10, 20)), 'square.dxf', MM);
    await planned(wide);
    const words = (await planner.output('gcode')).match(/[XY]-?[\d.]+/g).map((w) => Number(w.slice(1)));
    assert.ok(Math.min(...words.filter((w) => w > 0)) === 9.8 && Math.max(...words) === 30.2, words.join(' '));
  });

  it('is not applied to some contours, and findings report them with their position', async () => {
    await planner.load(dxf(square(0, 0, 10), square(10.1, 0, 10)), 'near.dxf', MM);
    const { started } = await planned(wide);
    const kept = started.findings.filter((f) => f.code === 'kerf-not-applied');
    assert.deepEqual(kept.map((f) => f.severity), ['warning', 'warning']);
    assert.ok(kept.every((f) => Math.abs(f.at[0] - 10.05) < 1e-9 && f.message.includes(' 0.1 mm')), JSON.stringify(kept));
  });

  it('gives a quote lengths of the beam and areas of the drawing', async () => {
    await planner.load(drawing(), 'kerf.dxf', MM);
    // On the bed, which a drawing around the origin is not.
    await planned(wide, { place: { at: [100, 100] } });
    const quote = await planner.quote({ material: { thickness: 2, density: 7.85 } });
    near(quote.cut_length, 7 * 40.4 + (8 - KERF) * Math.PI);
    near(quote.net_area, 2 * 1600 - 16 * Math.PI);
    assert.deepEqual([quote.part_count, quote.confidence.level], [2, 'high']);
    near(Math.round(quote.smallest_hole.width * 10) / 10, 8);
    near(Math.round(quote.narrowest_web.width * 10) / 10, 16);
  });

  it('gives the same plan with three workers as with one that starts from their path', async () => {
    await planner.load(drawing(), 'kerf.dxf', MM);
    const { document } = await planned(wide, { workers: 3, moves: 60_000 });
    near(document.summary.cut_length, 7 * 40.4 + (8 - KERF) * Math.PI);
  });

  it('is read from the machine file on the command line', async (t) => {
    const at = folder(t);
    writeFileSync(join(at, 'kerf.dxf'), drawing());
    writeFileSync(join(at, 'wide.json'), JSON.stringify({ schema: 'kerfway.machine/1', profile: wide }));
    writeFileSync(join(at, 'wrong.json'), JSON.stringify({ ...wide, kerf_width: 0.01 }));
    const run = (machine) => kerfway('plan', join(at, 'kerf.dxf'), '--units', 'mm', '--machine', join(at, machine), '--moves', '2000', '--seed', '1', '--json', '-');
    near(JSON.parse((await run('wide.json')).stdout).summary.cut_length, 7 * 40.4 + (8 - KERF) * Math.PI);
    const refused = await run('wrong.json');
    assert.equal(refused.code, 1);
    assert.match(refused.stderr, /"kerf_width" is 0\.01\. Give a number from 0\.02 to 10 mm, or 0/);
  });

  it('had no option on the command line', async (t) => {
    const at = folder(t);
    writeFileSync(join(at, 'kerf.dxf'), drawing());
    const materials = [{ name: 'birch', kerf_width: 1 }];
    writeFileSync(join(at, 'shop.json'), JSON.stringify({ ...plain, materials }));
    const run = (...options) => kerfway('plan', join(at, 'kerf.dxf'), '--units', 'mm', '--moves', '2000', '--seed', '1', '--json', '-', ...options);
    const length = async (...options) => JSON.parse((await run(...options)).stdout).summary.cut_length;
    near(await length('--kerf-width', `${KERF}`), 7 * 40.4 + (8 - KERF) * Math.PI);
    // It counts for the materials of the machine, too; 0 is as drawn.
    near(await length('--machine', join(at, 'shop.json'), '--material', 'birch', '--kerf-width', `${KERF}`), 7 * 40.4 + (8 - KERF) * Math.PI);
    near(await length('--machine', join(at, 'shop.json'), '--material', 'birch', '--kerf-width', '0'), 320 + 8 * Math.PI);
    const refused = await run('--kerf-width', '0.01');
    assert.equal(refused.code, 2);
    assert.match(refused.stderr, /^kerfway: --kerf-width 0\.01: give a number from 0\.02 to 10 mm, or 0/);
  });
});
