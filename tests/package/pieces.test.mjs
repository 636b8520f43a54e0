// What the planner says of a large drawing arrives in several messages, and is whole again when it is handed over.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { createPlanner } from 'kerfway';
import { circle, dxf } from './support.mjs';

/** More than two messages' worth, and a few more. */
const COUNT = 9_001;

test('the contours and parts of a large drawing are all there, in their order, also when it is read again', async (t) => {
  const drawing = dxf(Array.from({ length: COUNT }, (_, k) => circle(10 * (k % 100), 10 * Math.floor(k / 100), 1 + (k % 7) / 2)).flat());
  const planner = await createPlanner();
  t.after(() => planner.close());
  for (const loaded of [await planner.load(drawing, 'many.dxf'), await planner.reload({ first: [COUNT - 1] })]) {
    assert.equal(loaded.contours.length, COUNT);
    assert.ok(loaded.contours.every(({ id }, k) => id === k));
    assert.deepEqual(loaded.parts.map((p) => p.outer), Array.from({ length: COUNT }, (_, k) => k));
    assert.equal(loaded.geometry.offsets.length, COUNT + 1);
    for (const k of [0, 3_999, 4_000, 7_999, 8_000, COUNT - 1]) assert.ok(Math.abs(loaded.contours[k].length - 2 * Math.PI * (1 + (k % 7) / 2)) < 1e-9, `contour ${k}`);
  }
  const small = await planner.load(dxf([...circle(0, 0, 5), ...circle(20, 0, 5)]), 'two.dxf');
  assert.equal(small.contours.length, 2, 'nothing is left over for the next drawing');
});
