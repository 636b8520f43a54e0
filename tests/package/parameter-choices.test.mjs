// The page offers the words that parameters of methods from papers can be: each is one that the planner takes.

import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import { createPlanner } from 'kerfway';
import { APP, bundled } from './page-words.mjs';
import { bytes } from './support.mjs';

const { CHOICES } = await bundled(join(APP, 'panels', 'parameter-choices.ts'));

test('each word that the page offers for a parameter is taken by every method that has it, and every parameter that is a word is offered', async (t) => {
  const planner = await createPlanner();
  t.after(() => planner.close());
  await planner.load(bytes('dxf-dev/gdsestimating_dxf-parser__polylines.dxf'), 'plates.dxf');
  const offered = new Set();
  for (const { name: method, parameters } of await planner.paperMethods()) {
    for (const [name, usual] of Object.entries(parameters).filter(([, value]) => typeof value === 'string')) {
      assert.ok(CHOICES[name]?.includes(usual), `${method}: ${name} is ${usual}`);
      offered.add(name);
      const planned = (word) => planner.plan({ method, parameters: { [name]: word }, moves: 1, seed: 1 }).done;
      for (const word of CHOICES[name]) await assert.doesNotReject(planned(word), `${method}: ${name} is ${word}`);
      await assert.rejects(planned(`${usual}?`), { code: 'invalid-parameter' });
    }
  }
  assert.deepEqual([...offered].sort(), Object.keys(CHOICES).sort());
});
