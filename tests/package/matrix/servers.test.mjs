// npm run test:matrix: the package in a project of each kind of server, installed from its tarball. All have one hash.

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:net';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { before, describe, it } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { quote } from 'kerfway';
import { launchBrowser } from '../../../scripts/browser.mjs';
import { bytes, KEYBOARD } from '../support.mjs';
import { OPTIONS, project } from './projects.mjs';

const CALL = `quote(new Uint8Array(readFileSync('keyboard.dxf')), ${JSON.stringify(OPTIONS)}).then((report) => console.log(report.hash));`;
const ESM = `import { readFileSync } from 'node:fs';\nimport { quote } from 'kerfway';\n${CALL}`;
const CJS = `const { readFileSync } = require('node:fs');\nconst { quote } = require('kerfway');\n${CALL}`;
const ROUTE = `import { quote } from 'kerfway';
export async function POST(request: Request): Promise<Response> {
  return Response.json({ hash: (await quote(request, ${JSON.stringify(OPTIONS)})).hash });
}`;

let hash;
before(async () => ({ hash } = await quote(bytes(KEYBOARD), OPTIONS)));

async function freePort() {
  const server = createServer().listen(0, '127.0.0.1');
  await once(server, 'listening');
  const { port } = server.address();
  server.close();
  return port;
}

/** Sends the drawing to an address until a server answers. */
async function answer(url, seconds = 120) {
  for (let k = 0; k < seconds * 2; k += 1) {
    const response = await fetch(url, { method: 'POST', body: bytes(KEYBOARD) }).catch(() => null);
    if (response !== null) return response;
    await wait(500);
  }
  throw new Error(`${url} does not answer`);
}

describe('servers have the hash of the package', () => {
  it('Node, by import and by require', async (t) => {
    const p = await project(t, { files: { 'use.mjs': ESM, 'use.cjs': CJS } });
    assert.equal(await p.run(process.execPath, 'use.mjs'), hash);
    assert.equal(await p.run(process.execPath, 'use.cjs'), hash);
  });

  it('Bun', async (t) => {
    const p = await project(t, { dependencies: { bun: '*' }, files: { 'use.mjs': ESM } });
    // The package of Bun fetches nothing when it is installed; its script puts the program in place.
    await p.run(process.execPath, 'node_modules/bun/install.js');
    assert.equal(await p.run(p.bin('bun'), 'use.mjs'), hash);
  });

  it('Deno', async (t) => {
    const p = await project(t, { dependencies: { deno: '*' }, files: { 'use.mjs': ESM } });
    await p.run(process.execPath, 'node_modules/deno/install_api.cjs').catch(() => {});
    assert.equal(await p.run(p.bin('deno'), 'run', '-A', '--node-modules-dir=manual', 'use.mjs'), hash);
  });

  it('workerd, by Miniflare, from the entry kerfway without configuration', async (t) => {
    const worker = `import { quote } from 'kerfway';
      export default { async fetch(request) { return Response.json({ hash: (await quote(request, ${JSON.stringify(OPTIONS)})).hash }); } };`;
    const p = await project(t, { dependencies: { miniflare: '*', esbuild: '*' }, files: { 'worker.mjs': worker } });
    await p.run(p.bin('esbuild'), 'worker.mjs', '--bundle', '--format=esm', '--conditions=workerd', '--loader:.wasm=copy', '--asset-names=[name]', '--outdir=out', '--log-level=error');
    const { Miniflare } = await import(pathToFileURL(join(p.at, 'node_modules', 'miniflare', 'dist', 'src', 'index.js')).href);
    const rules = [{ type: 'ESModule', include: ['**/*.js'] }, { type: 'CompiledWasm', include: ['**/*.wasm'] }];
    const out = join(p.at, 'out');
    const server = new Miniflare({ scriptPath: join(out, 'worker.js'), modules: true, modulesRoot: out, modulesRules: rules, compatibilityDate: '2026-01-01' });
    t.after(() => server.dispose());
    const response = await server.dispatchFetch('http://x/', { method: 'POST', body: readFileSync(join(p.at, 'keyboard.dxf')) });
    assert.equal((await response.json()).hash, hash);
  });

  it('a route handler and a client page of Next without configuration, built and in development', async (t) => {
    const client = `'use client';
      import { useState } from 'react';
      import { quote } from 'kerfway';
      export default function Page() {
        const [hash, setHash] = useState('');
        return <main><input type="file" onChange={async (event) => setHash((await quote(event.target.files![0]!, ${JSON.stringify(OPTIONS)})).hash)} /><output>{hash}</output></main>;
      }`;
    const p = await project(t, {
      dependencies: { next: '*', react: '*', 'react-dom': '*', typescript: '^5', '@types/react': '*', '@types/react-dom': '*', '@types/node': '*' },
      files: { 'app/api/quote/route.ts': ROUTE, 'app/page.tsx': client, 'app/layout.tsx': 'export default function Layout({ children }: { children: React.ReactNode }) { return <html><body>{children}</body></html>; }' },
    });
    await p.run(p.bin('next'), 'build');
    const browser = await launchBrowser();
    t.after(() => browser.close());
    for (const how of ['start', 'dev']) {
      const port = await freePort();
      const server = spawn(p.bin('next'), [how, '-p', String(port), '-H', '127.0.0.1'], { cwd: p.at, stdio: 'ignore', env: { ...process.env, NEXT_TELEMETRY_DISABLED: '1' }, detached: true });
      const end = () => {
        try {
          process.kill(-server.pid, 'SIGKILL');
        } catch {}
      };
      t.after(end);
      const response = await answer(`http://127.0.0.1:${port}/api/quote`);
      assert.deepEqual([response.status, (await response.json()).hash], [200, hash], how);
      const page = await browser.newPage();
      await page.goto(`http://127.0.0.1:${port}/`);
      // The page is there before it listens.
      await page.waitForFunction(() => Object.keys(document.querySelector('input')).some((key) => key.startsWith('__reactProps')));
      await page.locator('input').setInputFiles(join(p.at, 'keyboard.dxf'));
      await page.waitForFunction((hash) => document.querySelector('output').textContent === hash, hash);
      end();
    }
  });

  it('a server bundled by Rollup with node-resolve', async (t) => {
    const config = `import resolve from '@rollup/plugin-node-resolve';
      export default { input: 'use.mjs', external: /^node:/, plugins: [resolve({ exportConditions: ['node'] })], output: { file: 'out/server.mjs', format: 'es', inlineDynamicImports: true } };`;
    const p = await project(t, { dependencies: { rollup: '*', '@rollup/plugin-node-resolve': '*' }, files: { 'use.mjs': ESM, 'rollup.config.mjs': config } });
    await p.run(p.bin('rollup'), '-c', '--silent');
    assert.equal(await p.run(process.execPath, 'out/server.mjs'), hash);
  });

  it('the service, called by a client that is generated from its OpenAPI', async (t) => {
    const client = `
      import createClient from 'openapi-fetch';
      import type { paths } from './service.js';
      const client = createClient<paths>({ baseUrl: process.argv[2] ?? '' });
      const { data, error } = await client.POST('/quote', {
        params: { query: { name: 'keyboard.dxf', moves: 1000, seed: 1 } }, body: '', headers: { 'content-type': 'application/octet-stream' },
        bodySerializer: () => new Blob([readFileSync('keyboard.dxf')]),
      });
      const problem: string | undefined = error?.error.code;
      console.log(problem ?? data?.['hash']);
      // @ts-expect-error: no such unit
      void (() => client.POST('/quote', { params: { query: { units: 'parsec' } }, body: '' }));`;
    const p = await project(t, {
      dependencies: { 'openapi-typescript': '*', 'openapi-fetch': '*', typescript: '^5', '@types/node': '*' },
      type: 'module',
      files: { 'use.ts': `import { readFileSync } from 'node:fs';${client}`, 'tsconfig.json': JSON.stringify({ compilerOptions: { strict: true, target: 'ES2022', module: 'NodeNext', outDir: 'out', rootDir: '.', skipLibCheck: true }, files: ['use.ts', 'service.ts'] }) },
    });
    const server = spawn(p.bin('kerfway'), ['serve', '--port', '0'], { cwd: p.at, stdio: ['ignore', 'pipe', 'ignore'] });
    t.after(() => server.kill('SIGKILL'));
    const [said] = await once(server.stdout, 'data');
    const url = /http:\S+/.exec(String(said))[0];
    await p.run(p.bin('openapi-typescript'), `${url}/openapi.json`, '-o', 'service.ts');
    await p.run(p.bin('tsc'), '-p', '.');
    assert.equal(await p.run(process.execPath, 'out/use.js', url), hash);
  });
});
