// The plans of tests/golden, byte for byte, by wasm in Node. The same files are compared natively and in a browser.

import assert from 'node:assert/strict';
import { after, before, describe, it } from 'node:test';
import { createPlanner } from 'kerfway';
import { cases, MATERIAL } from '../golden/cases.mjs';

describe('golden plans under Node', () => {
  let planner;
  before(async () => (planner = await createPlanner()));
  after(() => planner.close());

  for (const { name, file, bytes, load, plan, golden, hash } of cases()) {
    it(name, async () => {
      await planner.load(bytes, file, load);
      await planner.plan(plan).done;
      assert.ok((await planner.output('json')) === golden, `${name} differs from tests/golden/${name}.json`);
      assert.equal((await planner.quote({ material: MATERIAL })).hash, hash);
    });
  }
});
