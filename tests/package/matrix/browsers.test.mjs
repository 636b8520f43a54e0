// npm run test:matrix: the package in projects for browsers, installed from its tarball, type-checked by their own compilers, built, and run in
// Chromium under the strict policy. All have one hash.

import assert from 'node:assert/strict';
import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { quote } from 'kerfway';
import { launchBrowser } from '../../../scripts/browser.mjs';
import { serve } from '../../../scripts/serve.mjs';
import { bytes, fixture, KEYBOARD, ROOT } from '../support.mjs';
import { OPTIONS, project } from './projects.mjs';

const PATIENCE = 60_000;
let browser, hash;
before(async () => {
  browser = await launchBrowser();
  ({ hash } = await quote(bytes(KEYBOARD), OPTIONS));
});
after(() => browser.close());

/** Opens what a project has built. Errors on the page and breaches of the policy fail the test. */
async function open(t, folder) {
  const server = await serve(folder);
  t.after(() => server.close());
  const page = await browser.newPage({ viewport: { width: 900, height: 700 } });
  t.after(() => page.close());
  page.setDefaultTimeout(PATIENCE);
  const wrong = [];
  page.on('pageerror', (error) => wrong.push(String(error)));
  page.on('console', (message) => message.type() === 'error' && !/404|favicon/.test(message.text()) && wrong.push(message.text()));
  t.after(() => assert.deepEqual(wrong, []));
  await page.goto(server.url);
  return page;
}

/** What people read in the quote element. */
const inside = (page) => page.locator('kerfway-quote').evaluate((e) => [...e.shadowRoot.children].map((child) => child.innerText).join('\n'));

/** Keeps a picture of the page where KERFWAY_SHOTS says, for people to look at. */
async function shot(page, name) {
  if (process.env.KERFWAY_SHOTS === undefined) return;
  mkdirSync(process.env.KERFWAY_SHOTS, { recursive: true });
  await page.screenshot({ path: join(process.env.KERFWAY_SHOTS, `${name}.png`) });
}

const example = (name, files) => Object.fromEntries(files.map((file) => [file, readFileSync(join(ROOT, 'examples', name, file), 'utf8')]));
const TS = (more, files) => JSON.stringify({ compilerOptions: { strict: true, noEmit: true, target: 'ES2022', module: 'ESNext', moduleResolution: 'Bundler', lib: ['ES2023', 'DOM', 'DOM.Iterable'], types: [], ...more }, include: files });

describe('pages have the hash of the package', () => {
  it('React by Vite, type-checked by tsc: the element and its typed events', async (t) => {
    const p = await project(t, {
      dependencies: { vite: '*', react: '*', 'react-dom': '*', '@types/react': '*', '@types/react-dom': '*', typescript: '^5' },
      files: { ...example('vite-react', ['index.html', 'main.tsx']), 'tsconfig.json': TS({ jsx: 'react-jsx' }, ['main.tsx', 'wrong.tsx']), 'wrong.tsx': `
        import 'kerfway/element/react';
        // @ts-expect-error: no such option
        export const a = <kerfway-planner options={{ secnds: 1 }} />;
        // @ts-expect-error: the report has no such field
        export const b = <kerfway-quote onresult={({ detail }) => detail.cost} />;
        export const c = <kerfway-quote material="steel" price={(quote) => quote.hash} onerror={({ detail }) => detail.code === 'not-a-drawing'} labels={{ stop: 'Halt' }} />;` },
    });
    await p.run(p.bin('tsc'), '-p', '.');
    await p.run(p.bin('vite'), 'build', '--logLevel', 'error');
    const page = await open(t, join(p.at, 'dist'));
    await page.locator('input[type=file]').setInputFiles(fixture(KEYBOARD));
    await page.locator('output').waitFor();
    assert.match(await page.locator('output').innerText(), /^\d+\.\d\d € for \d+ parts$/);
    await shot(page, 'react');
  });

  it('Vue by Vite, type-checked by vue-tsc: the quote element in German, with a price', async (t) => {
    const p = await project(t, {
      dependencies: { vite: '*', vue: '*', '@vitejs/plugin-vue': '*', 'vue-tsc': '*', typescript: '^5' },
      files: { ...example('vite-vue', ['index.html', 'main.ts', 'App.vue', 'vite.config.ts']), 'tsconfig.json': TS({ jsx: 'preserve' }, ['main.ts', 'App.vue']), 'env.d.ts': "declare module '*.vue';" },
    });
    await p.run(p.bin('vue-tsc'), '-p', '.');
    await p.run(p.bin('vite'), 'build', '--logLevel', 'error');
    const page = await open(t, join(p.at, 'dist'));
    await page.locator('kerfway-quote').getByText('Zeichnung hierher ziehen').waitFor();
    await page.locator('input[type=file]').setInputFiles(fixture(KEYBOARD));
    await page.locator('output').waitFor();
    const { hash: own } = await quote(bytes(KEYBOARD), { machine: 'co2-100w', material: { name: 'Acrylic', thickness: 3, density: 1.19 } });
    assert.equal(await page.locator('output').innerText(), own);
    assert.match(await inside(page), /\d €\s+Dauer\s+\d+\.\d s/);
    await shot(page, 'vue');
    await page.locator('input[type=file]').setInputFiles({ name: 'x.dxf', mimeType: 'image/vnd.dxf', buffer: Buffer.from('%PDF-1.7') });
    await page.locator('kerfway-quote [part=message]').waitFor();
    assert.match(await inside(page), /Diese Datei ist keine Zeichnung\./);
  });

  for (const [how, entry, before, copies] of [
    ['kerfway/portable, which needs no files', 'kerfway/portable', '', false],
    ['kerfway, whose files are in a place of their own', 'kerfway', "configure({ locate: (file) => new URL(`/kerfway/${file === 'kerfway_bg.wasm' ? 'pkg/' : ''}${file}`, location.href) });", true],
  ]) {
    it(`Rollup with node-resolve, from ${how}`, async (t) => {
      const main = `import { configure, quote } from '${entry}';\n${before}\nvoid configure;\nwindow.quoted = async (drawing) => (await quote(drawing, ${JSON.stringify(OPTIONS)})).hash;`;
      const config = "import resolve from '@rollup/plugin-node-resolve';\nexport default { input: 'main.js', plugins: [resolve({ browser: true })], output: { dir: 'out', format: 'es' } };";
      const p = await project(t, { dependencies: { rollup: '*', '@rollup/plugin-node-resolve': '*' }, files: { 'main.js': main, 'rollup.config.mjs': config, 'out/index.html': '<!doctype html><title>Rollup</title><script type="module" src="./main.js"></script>' } });
      await p.run(p.bin('rollup'), '-c', '--silent');
      if (copies) cpSync(join(p.at, 'node_modules', 'kerfway', 'dist', 'sdk'), join(p.at, 'out', 'kerfway'), { recursive: true });
      const page = await open(t, join(p.at, 'out'));
      await page.waitForFunction(() => window.quoted);
      const file = Buffer.from(bytes(KEYBOARD)).toString('base64');
      assert.equal(await page.evaluate((text) => window.quoted(Uint8Array.from(atob(text), (c) => c.charCodeAt(0))), file), hash);
    });
  }

  it('Rollup with node-resolve, from kerfway without configuration, says what is missing and what to do', async (t) => {
    const main = "import { quote } from 'kerfway';\nwindow.quoted = (drawing) => quote(drawing).then(() => 'quoted', (error) => error.code + ' ' + error.message);";
    const config = "import resolve from '@rollup/plugin-node-resolve';\nexport default { input: 'main.js', plugins: [resolve({ browser: true })], output: { dir: 'out', format: 'es' } };";
    const p = await project(t, { dependencies: { rollup: '*', '@rollup/plugin-node-resolve': '*' }, files: { 'main.js': main, 'rollup.config.mjs': config, 'out/index.html': '<!doctype html><title>Rollup</title><script type="module" src="./main.js"></script>' } });
    await p.run(p.bin('rollup'), '-c', '--silent');
    writeFileSync(join(p.at, 'out', 'x'), '');
    const page = await open(t, join(p.at, 'out'));
    await page.waitForFunction(() => window.quoted);
    assert.match(await page.evaluate(() => window.quoted(new Uint8Array(9))), /^not-started .*(locate|kerfway\/portable)/);
  });
});
