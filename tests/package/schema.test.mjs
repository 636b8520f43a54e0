// Every written plan is valid according to the published schema, and the schema refuses other documents.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, describe, it } from 'node:test';
import { Ajv2020 } from 'ajv/dist/2020.js';
import { createPlanner } from 'kerfway';
import { bytes, circle, dxf, KEYBOARD, square } from './support.mjs';

const schema = createRequire(import.meta.url).resolve('kerfway/plan.schema.json');
const validate = new Ajv2020({ allErrors: true }).compile(JSON.parse(readFileSync(schema, 'utf8')));

const DRAWINGS = {
  'a keyboard': bytes(KEYBOARD),
  'forms with ellipses': bytes('dxf-dev/mozman_ezdxf__forms.dxf'),
  'splines': bytes('dxf-dev/gdsestimating_dxf-parser__arcs-as-splines.dxf'),
  'bulges': bytes('oracle/lwpolyline-bulges.dxf'),
  'one circle': dxf(circle(0, 0, 5)),
  'cuts and marks': dxf(square(0, 0, 100), circle(50, 50, 10, 'MARK')),
};

describe('plan JSON', () => {
  let planner;
  before(async () => (planner = await createPlanner()));
  after(() => planner.close());

  for (const [name, drawing] of Object.entries(DRAWINGS)) {
    it(`is valid: ${name}`, async () => {
      await planner.load(drawing, `${name}.dxf`, { layers: [{ name: 'MARK', operation: 'mark' }] });
      await planner.plan({ moves: 500, seed: 1 }).done;
      const plan = JSON.parse(await planner.output('json'));
      assert.ok(validate(plan), JSON.stringify(validate.errors, null, 1));
    });
  }

  it('is refused when a field is missing, unknown or of another type', async () => {
    await planner.load(DRAWINGS['one circle'], 'circle.dxf');
    await planner.plan({ moves: 1, seed: 1 }).done;
    const plan = JSON.parse(await planner.output('json'));
    const { moves, ...without } = plan;
    for (const wrong of [
      without,
      { ...plan, schema: 'kerfway.plan/2' },
      { ...plan, units: 'in' },
      { ...plan, moves: [...moves, { kind: 'jump', to: [0, 0] }] },
      { ...plan, moves: [...moves, { kind: 'air', to: [0, 0, 0] }] },
      { ...plan, summary: { ...plan.summary, total_time: 'long' } },
    ]) {
      assert.equal(validate(wrong), false);
    }
  });
});
