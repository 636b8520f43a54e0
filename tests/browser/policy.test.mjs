// Under the strict policy that the README states, everything works, and after loading nothing is fetched but own files.

import assert from 'node:assert/strict';
import { describe, it } from 'node:test';
import { bytes, KEYBOARD } from '../package/support.mjs';
import { policyWith } from '../../scripts/policy.mjs';
import { base64, embedding, openHost } from './embed-support.mjs';
import { download, openPage, phase } from './page-support.mjs';

const at = embedding();

/** What code from text comes to. Later, because a test's own code is exempt. */
const evalled = () =>
  new Promise((resolve) => {
    setTimeout(() => {
      try {
        resolve(new Function('return "run"')());
      } catch (error) {
        resolve(error.name);
      }
    });
  });

it('the policy allows wasm, and no code from text or from elsewhere', () => {
  const policy = new Map(policyWith().split('; ').map((d) => [d.slice(0, d.indexOf(' ')), d.slice(d.indexOf(' ') + 1)]));
  assert.equal(policy.get('default-src'), "'none'");
  assert.equal(policy.get('script-src'), "'self' 'wasm-unsafe-eval'");
  const sources = [...policy.values()].flatMap((list) => list.split(' '));
  assert.deepEqual([...new Set(sources)].sort(), ["'none'", "'self'", "'wasm-unsafe-eval'", 'blob:']);
});

describe('the package in a host of that policy', () => {
  it('plans, draws, loads methods of papers, takes wasm from JavaScript, and pools', async (t) => {
    const script = `
      import { createPlanner, createPool, plan } from './index.js';
      import { wasm } from './inline.js';
      window.use = async (drawing) => {
        const { outputs } = await plan(drawing, { units: 'mm', seed: 1, moves: 20000, allowOffBed: true, outputs: ['gcode', 'png'] });
        const planner = await createPlanner({ wasm: wasm() });
        const papers = (await planner.paperMethods()).length;
        planner.close();
        const pool = createPool({ size: 2 });
        const totals = await Promise.all([1, 2, 3].map((seed) => pool.plan(drawing, { seed, moves: 1000 })));
        pool.close();
        return [outputs.gcode.length, outputs.png.length, papers, totals.length];
      };`;
    const { page, requests, url } = await openHost(t, at, { html: '', script, allowed: /'unsafe-eval' is not an allowed source/ });
    await page.waitForFunction(() => window.use !== undefined);
    const loaded = requests.length;
    const made = await page.evaluate((file) => window.use(Uint8Array.from(atob(file), (c) => c.charCodeAt(0))), base64(bytes(KEYBOARD)));
    assert.ok(made.every((n) => n > 0), `${made}`);
    assert.equal(await page.evaluate(evalled), 'EvalError');
    const later = requests.slice(loaded);
    assert.ok(later.length > 0);
    assert.deepEqual(later.filter((r) => !(r.startsWith(url) && /\/[\w-]+\.(js|wasm)$/.test(r))), []);
  });
});

describe('the built page', () => {
  it('is served with the policy, plans and draws under it, and fetches nothing but its own files', async (t) => {
    const { page, requests, url } = await openPage(t);
    await phase(page, 'planning', 'done');
    const [document, worker] = await Promise.all([fetch(url), fetch(requests.find((r) => /worker[\w-]*\.js$/.test(r)))]);
    for (const { headers } of [document, worker]) assert.equal(headers.get('content-security-policy'), policyWith());
    const loaded = requests.length;
    const menu = page.getByRole('button', { name: 'Stop' });
    if (await menu.isVisible()) await menu.click();
    await phase(page, 'done');
    const { bytes: png } = await download(page, () => page.getByRole('button', { name: /PNG/ }).click());
    assert.deepEqual([...png.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
    const later = requests.slice(loaded);
    assert.ok(later.some((r) => r.includes('kerfway_png')), later.join(' '));
    assert.deepEqual(later.filter((r) => !r.startsWith(url) && !r.startsWith(`blob:${url}`)), []);
  });
});
