// Projects that install the packed tarball and bundle it: what they build plans a sheet in Chromium under the strict policy.

import assert from 'node:assert/strict';
import { cpSync, mkdirSync, mkdtempSync, readdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { promisify } from 'node:util';
import { build as esbuild } from 'esbuild';
import { plan } from 'kerfway';
import { build as vite } from 'vite';
import webpack from 'webpack';
import { serve } from '../../scripts/serve.mjs';
import { bytes, fixture, install, KEYBOARD, pack, ROOT } from '../package/support.mjs';
import { base64, embedding } from './embed-support.mjs';

const at = embedding();
const OPTIONS = { units: 'mm', seed: 4, moves: 20_000, outputs: ['json'] };

let project, json;
before(async () => {
  project = mkdtempSync(join(tmpdir(), 'kerfway-bundled-'));
  install(project, pack(project).filename);
  writeFileSync(join(project, 'index.html'), '<!doctype html><title>Bundled</title><kerfway-planner></kerfway-planner><script type="module" src="./main.js"></script>');
  writeFileSync(join(project, 'main.js'), `
    import { plan } from 'kerfway';
    import 'kerfway/element';
    window.planned = async (drawing, options) => (await plan(drawing, options)).outputs;`);
  ({ json } = (await plan(bytes(KEYBOARD), OPTIONS)).outputs);
});
after(() => rmSync(project, { recursive: true, force: true }));

/** Serves what a bundler built, and plans there; with a picture, whose renderer is loaded when it is asked for. */
async function plans(t, out) {
  const server = await serve(out);
  t.after(() => server.close());
  const page = await at.browser.newPage();
  t.after(() => page.close());
  const wrong = [];
  page.on('console', (message) => message.type() === 'error' && !message.text().includes('404') && wrong.push(message.text()));
  await page.goto(server.url);
  await page.waitForFunction(() => window.planned && document.querySelector('kerfway-planner').state === 'empty');
  const made = await page.evaluate(async ({ file, options }) => {
    const { json, svg, png } = await window.planned(Uint8Array.from(atob(file), (c) => c.charCodeAt(0)), { ...options, outputs: ['json', 'svg', 'png'] });
    return { json, svg, png: [...png.subarray(0, 4)] };
  }, { file: base64(bytes(KEYBOARD)), options: { ...OPTIONS, name: 'drawing.dxf' } });
  assert.ok(made.json === json, 'another plan than under Node');
  assert.match(made.svg, /^<svg/);
  assert.deepEqual(made.png, [0x89, 0x50, 0x4e, 0x47]);
  assert.deepEqual(wrong, []);
}

describe('a project bundled by', () => {
  it('Vite, as it comes', async (t) => {
    const out = join(project, 'vite');
    await vite({ root: project, configFile: false, logLevel: 'error', build: { outDir: out, assetsInlineLimit: 0, modulePreload: false }, worker: { format: 'es' } });
    await plans(t, out);
  });

  it('webpack, as it comes', async (t) => {
    const out = join(project, 'webpack');
    // Not minified: that is terser's time, not ours.
    const stats = await promisify(webpack)({ mode: 'production', context: project, entry: './main.js', output: { path: out, filename: 'main.js' }, optimization: { minimize: false } });
    assert.deepEqual(stats.toJson({ all: false, errors: true }).errors, []);
    cpSync(join(project, 'index.html'), join(out, 'index.html'));
    await plans(t, out);
  });

  it('esbuild, with the worker as an entry of its own and the wasm files beside', async (t) => {
    const out = join(project, 'esbuild');
    const sdk = join(project, 'node_modules', 'kerfway', 'dist', 'sdk');
    mkdirSync(out);
    await esbuild({
      absWorkingDir: project, entryPoints: { main: 'main.js', worker: 'kerfway/worker' }, outdir: out,
      bundle: true, splitting: true, format: 'esm', minify: true, logLevel: 'error',
    });
    cpSync(join(project, 'index.html'), join(out, 'index.html'));
    for (const file of readdirSync(join(sdk, 'pkg')).filter((f) => f.endsWith('.wasm'))) {
      cpSync(join(sdk, 'pkg', file), join(out, file === 'kerfway_bg.wasm' ? 'pkg' : '', file));
    }
    await plans(t, out);
  });
});

it('examples/vite-react tells what a drawing costs', async (t) => {
  const root = join(project, 'vite-react');
  cpSync(join(ROOT, 'examples', 'vite-react'), root, { recursive: true });
  for (const name of ['react', 'react-dom', 'scheduler']) symlinkSync(join(ROOT, 'node_modules', name), join(project, 'node_modules', name));
  const out = join(project, 'react');
  await vite({ root, configFile: false, logLevel: 'error', build: { outDir: out, emptyOutDir: true } });
  const server = await serve(out);
  t.after(() => server.close());
  const page = await at.browser.newPage();
  t.after(() => page.close());
  await page.goto(server.url);
  await page.getByLabel('Material').selectOption('thin steel');
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), page.getByRole('button', { name: 'Choose a file' }).click()]);
  await chooser.setFiles(fixture(KEYBOARD));
  await page.getByRole('button', { name: 'Stop' }).click();
  const price = await page.locator('output').textContent();
  const { summary } = await page.evaluate(() => document.querySelector('kerfway-planner').result);
  assert.equal(price, `${((summary.total_time / 60) * 1.5).toFixed(2)} € for ${summary.parts} parts`);
  assert.equal(await page.evaluate(() => document.querySelector('kerfway-planner').result.options.machine), 'fibre-3kw-thin');
});
