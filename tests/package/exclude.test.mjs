// Skipping single contours, in the package and on the command line.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { createPlanner, inspect, quote } from 'kerfway';
import { circle, dxf, folder, kerfway, square } from './support.mjs';

/** A square with a hole, and a circle next to it. */
const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10), circle(150, 50, 20));
const BUDGET = { seed: 1, moves: 2000, units: 'mm' };

describe('exclude', () => {
  let planner;
  before(async () => (planner = await createPlanner()));
  after(() => planner.close());

  it('skips a contour: the others keep their ids, and its hole is a part', async () => {
    const loaded = await planner.load(PLATE, 'plate.dxf', { units: 'mm', exclude: [0] });
    assert.deepEqual(loaded.contours.map((c) => [c.id, c.operation, c.inside]), [[0, 'ignore', null], [1, 'cut', null], [2, 'cut', null]]);
    assert.deepEqual(loaded.parts.map((p) => p.outer), [1, 2]);
    assert.equal(loaded.ignored.layers.length, 1);
    assert.deepEqual(loaded.bounds.map(Math.round), [40, 30, 170, 70]);
    const found = loaded.findings.find((f) => f.code === 'contour-excluded');
    assert.deepEqual([found.message, found.count, found.severity], ['1 contour left out by choice.', 1, 'info']);
    // Long enough for the lower bound to be started.
    const { progress } = await planner.plan({ seed: 1, moves: 1_500_000 }).done;
    assert.deepEqual([...progress.path.contours].sort(), [1, 2]);
    assert.ok(progress.summary.gap !== null && progress.summary.gap < 1e-6, 'the bound holds for what is left');
    const document = JSON.parse(await planner.output('json'));
    const schema = createRequire(import.meta.url).resolve('kerfway/plan.schema.json');
    const validate = new Ajv2020({ allErrors: true }).compile(JSON.parse(readFileSync(schema, 'utf8')));
    assert.ok(validate(document), JSON.stringify(validate.errors));
    assert.deepEqual([document.options.exclude, document.summary.contours], [[0], 2]);
  });

  it('is undone on reload, and refuses unknown ids with a sentence', async () => {
    await planner.load(PLATE, 'plate.dxf', { units: 'mm', exclude: [0] });
    const back = await planner.reload({ units: 'mm' });
    assert.deepEqual(back.contours.map((c) => [c.operation, c.inside]), [['cut', null], ['cut', 0], ['cut', null]]);
    await assert.rejects(inspect(PLATE, { exclude: [3] }), /Contour 3 is listed in the options, but there are only 3 contours, counted from 0\.$/);
  });

  it('is in the quote, and in its hash', async () => {
    const [all, less, again] = await Promise.all([[], [2], [2]].map((exclude) => quote(PLATE, { ...BUDGET, exclude, name: 'plate.dxf' })));
    assert.deepEqual([all.part_count, less.part_count], [2, 1]);
    assert.deepEqual(less.options.exclude, [2]);
    assert.equal(less.layers.reduce((n, l) => n + l.contours, 0), 2);
    assert.notEqual(all.hash, less.hash);
    assert.equal(again.hash, less.hash);
  });

  it('is an option of the command line', async (t) => {
    const file = join(folder(t), 'plate.dxf');
    writeFileSync(file, PLATE);
    const { code, stdout } = await kerfway('inspect', file, '--units', 'mm', '--exclude', '1', '--exclude', '2');
    assert.equal(code, 0);
    assert.match(stdout, /^Contours +1: 1 closed, 0 open$/m);
    assert.match(stdout, /info contour-excluded \[2\]: 2 contours left out by choice\./);
    const wrong = await kerfway('plan', file, '--exclude', 'first');
    assert.deepEqual([wrong.code, wrong.stderr.split('\n')[0]], [2, 'kerfway: --exclude first: give a whole number from 0 to 9007199254740991.']);
  });
});
