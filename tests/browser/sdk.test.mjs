// The package in Chromium as an embedder without a bundler uses it: an import map and the files of dist/sdk.

import assert from 'node:assert/strict';
import { createHash } from 'node:crypto';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { launchBrowser } from '../../scripts/browser.mjs';
import { serve } from '../../scripts/serve.mjs';
import { DIST } from '../../scripts/tools.mjs';
import { cases, MATERIAL } from '../golden/cases.mjs';

const PAGE = `<!doctype html><script type="importmap">{"imports":{
  "kerfway": "/index.js", "kerfway/inline": "/inline.js" }}</script>`;

let server, browser, page;
const requests = [];

before(async () => {
  server = await serve(join(DIST, 'sdk'));
  browser = await launchBrowser();
  page = await browser.newPage();
  await page.route('**/embedder.html', (route) => route.fulfill({ contentType: 'text/html', body: PAGE }));
  page.on('request', (request) => requests.push(new URL(request.url()).pathname));
  await page.goto(`${server.url}embedder.html`);
});
after(async () => {
  await browser.close();
  await server.close();
});

/** Plans in the page; returns the plan JSON and what was told on the way. */
const planned = (drawing, file, load, plan, inline = false) =>
  page.evaluate(
    async ({ base64, file, load, plan, inline, material }) => {
      const { createPlanner } = await import('kerfway');
      const { outputsWasm, wasm } = await import('kerfway/inline');
      const options = inline ? { wasm: wasm(), outputsWasm: outputsWasm() } : {};
      const planner = await createPlanner(options);
      const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
      await planner.load(bytes, file, load);
      const { reason, seed } = await planner.plan(plan).done;
      const json = await planner.output('json');
      const svg = await planner.output('svg');
      const png = [...(await planner.output('png', 200)).subarray(0, 4)];
      const { hash } = await planner.quote({ material });
      planner.close();
      return { reason, seed, json, svg, png, hash };
    },
    { base64: Buffer.from(drawing).toString('base64'), file, load, plan, inline, material: MATERIAL },
  );

describe('golden plans in Chromium', () => {
  for (const { name, file, bytes, load, plan, golden, hash } of cases()) {
    it(name, async () => {
      const { json, seed, hash: quoted } = await planned(bytes, file, load, plan);
      assert.equal(seed, plan.seed);
      assert.equal(quoted, hash);
      assert.ok(json === golden, `${name} differs from tests/golden/${name}.json`);
    });
  }
});

describe('the package without a bundler', () => {
  const [first] = cases();

  it('loads the writers and the PNG renderer only when they are asked for', async () => {
    const { png } = await planned(first.bytes, first.file, first.load, first.plan);
    assert.deepEqual(png, [0x89, 0x50, 0x4e, 0x47]);
    const of = (name) => requests.findIndex((path) => path.endsWith(name));
    assert.ok(of('kerfway_png_bg.wasm') > of('kerfway_outputs_bg.wasm') && of('kerfway_outputs_bg.wasm') > of('kerfway_bg.wasm') && of('kerfway_bg.wasm') > 0);
  });

  it('works from wasm inside JavaScript, without fetching it', async () => {
    requests.length = 0;
    await page.reload();
    const { json, svg } = await planned(first.bytes, first.file, first.load, first.plan, true);
    assert.ok(json === first.golden);
    assert.equal(createHash('sha256').update(svg).digest('hex'), first.outputs.svg);
    assert.ok(!requests.some((path) => /kerfway(_outputs)?_bg\.wasm$/.test(path)), requests.join(' '));
  });

  it('stops at once and keeps the best while a long plan runs', async () => {
    const { told, waited, total, summary } = await page.evaluate(async (base64) => {
      const { createPlanner } = await import('kerfway');
      const planner = await createPlanner();
      await planner.load(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)), 'a.dxf');
      const told = [];
      let first;
      const reported = new Promise((resolve) => (first = resolve));
      const plan = planner.plan({ seconds: 60, seed: 3 }, (p) => first(told.push(p.summary.total_time)));
      await plan.started;
      await reported;
      const asked = performance.now();
      plan.stop();
      const { progress } = await plan.done;
      const waited = performance.now() - asked;
      const total = JSON.parse(await planner.output('json')).summary.total_time;
      planner.close();
      return { told, waited, total, summary: progress.summary };
    }, Buffer.from(first.bytes).toString('base64'));
    assert.equal(total, summary.total_time);
    assert.ok(told.length > 0 && summary.total_time <= Math.min(...told) + 1e-9);
    // A slice is 20 ms; the rest is room for a busy machine.
    assert.ok(waited < 2_000, `${waited} ms`);
  });
});
