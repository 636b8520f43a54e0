// The plans of tests/golden, byte for byte, by wasm in Node. The same files are compared natively and in a browser.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { createPlanner } from 'kerfway';
import { cases, MATERIAL } from '../golden/cases.mjs';
import { ROOT } from './support.mjs';

const { version } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'));

/** As in `tests/it/golden.rs`: the hash of an output without the version in the comments of programs. */
const hashOf = (output) => createHash('sha256').update(typeof output === 'string' ? output.replaceAll(version, '') : output).digest('hex');

describe('golden plans under Node', () => {
  let planner;
  before(async () => (planner = await createPlanner()));
  after(() => planner.close());

  for (const { name, file, bytes, load, plan, golden, hash, outputs } of cases()) {
    it(name, async () => {
      await planner.load(bytes, file, load);
      await planner.plan({ ...plan, allowOffBed: true }).done;
      assert.ok((await planner.output('json')) === golden, `${name} differs from tests/golden/${name}.json`);
      assert.equal((await planner.quote({ material: MATERIAL })).hash, hash);
      for (const [kind, expected] of Object.entries(outputs)) {
        // Where a format cannot hold the plan, the file has the sentence that says so.
        const written = await planner.output(kind).then(hashOf, (refusal) => refusal.message);
        assert.equal(written, expected, `${name}, ${kind}`);
      }
    });
  }
});
