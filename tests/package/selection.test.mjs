// What is decided for single contours: by the package and by the command line, which say the same in the plan document.

import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { createPlanner } from 'kerfway';
import { circle, dxf, folder, kerfway, ROOT, square } from './support.mjs';

const DRAWING = dxf([0, 1, 2, 3].flatMap((k) => [...square(20 + 60 * k, 20, 40), ...circle(40 + 60 * k, 40, 8)]));

/** Runs the command line on the drawing. */
async function cli(t, ...args) {
  const at = folder(t);
  const [drawing, json] = [join(at, 'row.dxf'), join(at, 'row.json')];
  writeFileSync(drawing, DRAWING);
  const { code, stderr } = await kerfway('plan', drawing, '--moves', '3000', '--seed', '1', '--json', json, ...args);
  return { code, stderr, plan: code === 0 ? JSON.parse(readFileSync(json, 'utf8')) : null };
}

test('groups, joints and leads of single contours are in the plan of the package and of the command line', async (t) => {
  const planner = await createPlanner();
  t.after(() => planner.close());
  const options = { together: [[0, 6]], contours: [{ contour: 0, joints: 3, lead: 'line' }, { contour: 4, joints: 0 }] };
  const { contours } = await planner.load(DRAWING, 'row.dxf', options);
  assert.deepEqual([0, 4, 6].map((id) => contours[id].inside), [null, null, null]);
  await planner.plan({ moves: 3000, seed: 1 }).done;
  const plan = JSON.parse(await planner.output('json'));
  assert.deepEqual([plan.options.together, plan.options.contours], [options.together, options.contours]);
  assert.equal(plan.summary.joints, 3);
  const validate = new Ajv2020({ strict: false }).compile(JSON.parse(readFileSync(join(ROOT, 'www', 'sdk', 'plan.schema.json'), 'utf8')));
  assert.ok(validate(plan), JSON.stringify(validate.errors));

  const same = await cli(t, '--together', '0,6', '--joints-of', '0=3', '--lead-of', '0=line', '--joints-of', '4=0');
  assert.equal(same.code, 0, same.stderr);
  assert.deepEqual([same.plan.options.together, same.plan.options.contours], [options.together, options.contours]);
  assert.deepEqual(same.plan.moves, plan.moves);
  const order = [...new Set(plan.moves.filter((m) => m.kind === 'cut').map((m) => m.contour))];
  const places = order.map((c, k) => ([0, 1, 6, 7].includes(c) ? k : -1)).filter((k) => k >= 0);
  assert.equal(places[3] - places[0], 3, `one after the other: ${order}`);
});

test('a part of a choice that is no number was named without the choice, or not at all', async (t) => {
  for (const [option, given, part] of [['sequence', '1,', ''], ['together', '0,6a', '6a'], ['joints-of', '3=x', 'x'], ['lead-of', 'x=arc', 'x'], ['joint-at', 'x@0.5', 'x']]) {
    const { code, stderr } = await cli(t, `--${option}`, given);
    assert.deepEqual([code, stderr.split('\n')[0]], [2, `kerfway: --${option} ${given}: "${part}" is no whole number from 0 to 9007199254740991.`]);
  }
});

test('choices that cannot be are refused with a sentence', async (t) => {
  assert.match((await cli(t, '--lead-of', '3=spiral')).stderr, /--lead-of/);
  assert.match((await cli(t, '--joints-of', '3')).stderr, /give the id of a contour and a value, as 3=2/);
  assert.match((await cli(t, '--together', '0,4000')).stderr, /Contour 4000 is listed/);
  const planner = await createPlanner();
  t.after(() => planner.close());
  await assert.rejects(planner.load(DRAWING, 'row.dxf', { together: [[0], [1, 2]] }), { code: 'options-conflict', message: /contour 1 lies inside contour 0, which is in another group/ });
  await assert.rejects(planner.load(DRAWING, 'row.dxf', { contours: [{ contour: 1, joints: 2000 }] }), { code: 'out-of-range' });
});
