// What a browser says of a drawing is what a server says: the whole report, hash and all, of every real drawing. That it is
// what the core says natively, too, is tested by tests/golden.rs against the same hashes.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { it } from 'node:test';
import { quote } from 'kerfway';
import { bytes, fixture } from '../package/support.mjs';
import { base64, embedding, openHost } from './embed-support.mjs';

const at = embedding();
const { plan, material, hashes } = JSON.parse(readFileSync(new URL('../golden/dev-quotes.json', import.meta.url), 'utf8'));
const OPTIONS = { ...plan, material };
const drawings = readdirSync(fixture('dxf-dev')).filter((file) => /\.dxf$/i.test(file));

it(`quotes of ${drawings.length} real drawings are the same in Chromium and under Node`, async (t) => {
  const { page } = await openHost(t, at, { html: '', script: "import { createPool } from './index.js'; window.pool = createPool({ size: 1 });" });
  await page.waitForFunction(() => window.pool !== undefined);
  assert.deepEqual(Object.keys(hashes), [...drawings].sort());
  for (const file of drawings) {
    const here = await quote(bytes(`dxf-dev/${file}`), { ...OPTIONS, name: file });
    const there = await page.evaluate(
      ({ text, options }) => window.pool.quote(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)), options),
      { text: base64(bytes(`dxf-dev/${file}`)), options: { ...OPTIONS, name: file } },
    );
    assert.equal(here.hash, hashes[file], file);
    assert.equal(there.hash, hashes[file], file);
    assert.deepEqual(there, here, file);
  }
});
