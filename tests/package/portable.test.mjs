// kerfway/portable: one module graph without workers, files or addresses, bundled by the tools of servers and cloud functions.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, it } from 'node:test';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';
import { build as viteBuild } from 'vite';
import webpack from 'webpack';
import { createPlanner, quote } from 'kerfway';
import { bytes, fixture, install, KEYBOARD, pack, ROOT } from './support.mjs';

let at, hash;
/** The program of each fixture: it prints the hash of a quote. */
const program = (open) => `${open}
quote(new Uint8Array(readFileSync(process.argv[2])), { name: 'keyboard.dxf', moves: 1000, seed: 1 }).then((report) => console.log(report.hash));
`;
const ESM = program("import { readFileSync } from 'node:fs';\nimport { quote } from 'kerfway/portable';");
const CJS = program("const { readFileSync } = require('node:fs');\nconst { quote } = require('kerfway/portable');");

before(async () => {
  at = mkdtempSync(join(tmpdir(), 'kerfway-portable-'));
  install(at, pack(at).filename);
  cpSync(fixture(KEYBOARD), join(at, 'keyboard.dxf'));
  writeFileSync(join(at, 'use.mjs'), ESM);
  writeFileSync(join(at, 'use.cjs'), CJS);
  writeFileSync(join(at, 'main.mjs'), ESM.replace('kerfway/portable', 'kerfway'));
  ({ hash } = await quote(bytes(KEYBOARD), { name: 'keyboard.dxf', moves: 1000, seed: 1 }));
});
after(() => rmSync(at, { recursive: true, force: true }));

/** The hash that a script prints. It is moved to an empty folder first, so that it finds nothing but itself. */
function printed(t, script) {
  const alone = mkdtempSync(join(tmpdir(), 'kerfway-alone-'));
  t.after(() => rmSync(alone, { recursive: true, force: true }));
  const own = join(alone, script);
  cpSync(join(at, script), own);
  return run(own);
}

function run(script) {
  const { stdout, stderr } = spawnSync(process.execPath, [script, join(at, 'keyboard.dxf')], { cwd: at, encoding: 'utf8' });
  assert.equal(stderr, '');
  return stdout.trim();
}

describe('kerfway/portable has the hash of the other entries', () => {
  it('in Node by import and by require', () => {
    assert.equal(run(join(at, 'use.mjs')), hash);
    assert.equal(run(join(at, 'use.cjs')), hash);
  });

  for (const [entry, format, script] of [['use.mjs', 'esm', 'lambda.mjs'], ['use.mjs', 'cjs', 'lambda.cjs'], ['main.mjs', 'esm', 'lambda-main.mjs'], ['main.mjs', 'cjs', 'lambda-main.cjs']]) {
    it(`in a Lambda bundled by esbuild as ${format}, from ${entry === 'main.mjs' ? 'the entry kerfway' : 'kerfway/portable'}`, async (t) => {
      const { warnings } = await build({ absWorkingDir: at, entryPoints: [entry], outfile: join(at, script), bundle: true, platform: 'node', format, logLevel: 'silent' });
      assert.deepEqual(warnings.filter(({ id }) => id !== 'empty-import-meta'), []);
      assert.equal(printed(t, script), hash);
    });
  }

  it('in a server bundled by webpack', async (t) => {
    const config = { context: at, mode: 'production', target: 'node20', entry: './use.mjs', output: { path: at, filename: 'webpack.cjs' }, optimization: { minimize: false } };
    const stats = await new Promise((resolve, reject) => webpack(config, (error, done) => (error ? reject(error) : resolve(done))));
    assert.equal(stats.hasErrors(), false, stats.toString());
    assert.equal(printed(t, 'webpack.cjs'), hash);
  });

  it('in a server bundled by Vite, whose bundler resolves as Rollup does', async (t) => {
    await viteBuild({ root: at, logLevel: 'silent', configFile: false, ssr: { noExternal: true }, build: { ssr: 'use.mjs', outDir: at, emptyOutDir: false, rollupOptions: { output: { entryFileNames: 'vite.mjs' } } } });
    assert.equal(printed(t, 'vite.mjs'), hash);
  });

  it('where no code may be compiled at run time, from a compiled module', () => {
    const script = `
      import { readFileSync } from 'node:fs';
      import { createPlanner } from 'kerfway/portable';
      const module = new WebAssembly.Module(readFileSync('node_modules/kerfway/dist/sdk/pkg/kerfway_bg.wasm'));
      WebAssembly.compile = () => { throw new Error('compiling is forbidden'); };
      const planner = await createPlanner({ wasm: module });
      await planner.load(readFileSync(process.argv[2]), 'keyboard.dxf');
      await planner.plan({ moves: 1000, seed: 1 }).done;
      console.log((await planner.quote()).hash);
      planner.close();`;
    writeFileSync(join(at, 'module.mjs'), script);
    assert.equal(run(join(at, 'module.mjs')), hash);
  });
});

describe('a planner runs where the host says', () => {
  it('in the caller\'s thread, from bytes, a compiled module, or a file in another place', async () => {
    const { createPool, configure, createPlanner } = await import('kerfway');
    const options = { name: 'keyboard.dxf', moves: 1000, seed: 1 };
    const wasm = join(at, 'node_modules', 'kerfway', 'dist', 'sdk', 'pkg', 'kerfway_bg.wasm');
    const sdk = pathToFileURL(join(at, 'node_modules', 'kerfway', 'dist', 'sdk', '/'));
    const asked = [];
    const locate = (file) => (asked.push(file), new URL(file === 'kerfway_bg.wasm' ? `pkg/${file}` : file, sdk));
    for (const places of [{ worker: false }, { wasm: readFileSync(wasm) }, { wasm: new WebAssembly.Module(readFileSync(wasm)), worker: false }, { wasmUrl: pathToFileURL(wasm) }, { locate }]) {
      const pool = createPool({ size: 1, ...places });
      assert.equal((await pool.quote(bytes(KEYBOARD), options)).hash, hash, JSON.stringify(Object.keys(places)));
      pool.close();
    }
    assert.deepEqual(new Set(asked), new Set(['kerfway_bg.wasm', 'node-worker.js']));
    for (const wrong of [{ worker: 'no' }, { locate: 5 }, { wasmUrl: 5 }, { wasmURL: 'x' }]) assert.throws(() => configure(wrong), { code: /wrong-type|unknown-field/ });
    await assert.rejects(createPlanner({ wasmUrl: join(at, 'nowhere.wasm') }));
  });

  it('a function "locate" that returns no address was a message of Node\'s', async () => {
    const { createPlanner } = await import('kerfway');
    const sdk = pathToFileURL(join(at, 'node_modules', 'kerfway', 'dist', 'sdk', '/'));
    const beside = (file) => new URL(file.endsWith('.wasm') ? `pkg/${file}` : file, sdk);
    const cases = [[5, '5'], [null, 'null'], ['', '""'], [{}, 'an object'], [Promise.resolve('x'), 'an object']];
    for (const file of ['kerfway_bg.wasm', 'node-worker.js', 'kerfway_outputs_bg.wasm']) {
      for (const [returned, named] of cases) {
        const locate = (asked) => (asked === file ? returned : beside(asked));
        const worker = file !== 'kerfway_outputs_bg.wasm';
        const work = async () => {
          const planner = await createPlanner({ locate, worker });
          await planner.load(bytes(KEYBOARD), 'keyboard.dxf');
          await planner.plan({ moves: 1, allowOffBed: true }).done;
          await planner.output('gcode');
        };
        const message = `The function "locate" returns ${named} for ${file}. Return its address at once, as a text or a URL.`;
        await assert.rejects(work, { name: 'KerfwayError', code: 'wrong-type', message, params: { field: 'locate', value: named } });
      }
    }
    // One that moves some files only leaves the others beside the package.
    (await createPlanner({ locate: () => undefined })).close();
  });

  it('in a browser that serves no files of the package, the sentence says what to do', () => {
    const index = readFileSync(join(ROOT, 'dist', 'sdk', 'index.js'), 'utf8');
    assert.match(index, /say where they are \(locate\), or import kerfway\/portable/);
  });
});

describe('kerfway/portable', () => {
  it('lets the event loop run during a search', async () => {
    const { plan } = await import('kerfway/portable');
    let [ticks, last, longest] = [0, performance.now(), 0];
    const timer = setInterval(() => {
      const now = performance.now();
      [ticks, longest, last] = [ticks + 1, Math.max(longest, now - last), now];
    }, 5);
    await plan(bytes(KEYBOARD), { seconds: 1, onLoaded: () => void ([last, longest] = [performance.now(), 0]) });
    clearInterval(timer);
    assert.ok(ticks > 20, `${ticks} ticks`);
    assert.ok(longest < 500, `${longest} ms`);
  });

  it('writes the programs of the other entries', async () => {
    const options = { name: 'keyboard.dxf', moves: 1000, seed: 1, allowOffBed: true, outputs: ['gcode', 'lbrn2', 'rd'] };
    const [{ plan }, { plan: planInWorker }] = await Promise.all([import('kerfway/portable'), import('kerfway')]);
    const [here, there] = await Promise.all([plan(bytes(KEYBOARD), options), planInWorker(bytes(KEYBOARD), options)]);
    assert.deepEqual(here.outputs, there.outputs);
    assert.match(here.outputs.gcode, /^; Kerfway/);
  });

  it('says which entry has PNG and the methods from papers', async () => {
    const { createPlanner } = await import('kerfway/portable');
    const planner = await createPlanner();
    await planner.load(bytes(KEYBOARD), 'keyboard.dxf');
    await planner.plan({ moves: 10 }).done;
    await assert.rejects(planner.output('png'), /writes no PNG\. Render SVG instead, or use the entry kerfway, with its workers\./);
    await assert.rejects(planner.paperMethods(), /no methods from papers/);
    planner.close();
    await assert.rejects(planner.output('svg'), /closed/);
  });

  it('refuses the levers that the guide lists', async () => {
    const { message } = await createPlanner({ worker: false }).then(async (planner) => {
      await planner.load(bytes(KEYBOARD), 'keyboard.dxf');
      const [machine] = planner.machines;
      return planner.plan({ moves: 1, machine: { ...machine, levers: { corners: { outer: 'loop' } } } }).done.catch((error) => error).finally(() => planner.close());
    });
    const [, refused] = /the levers ([a-z_, ]+)\./.exec(message);
    const guide = readFileSync(join(ROOT, 'docs', 'embedding.md'), 'utf8').replaceAll('\n', ' ');
    const listed = [...guide.matchAll(/the levers ([`a-z_, ]+)\./g)].map(([, list]) => list.replaceAll('`', ''));
    assert.deepEqual(listed, [refused, refused]);
  });

  it('ends a plan by a signal, and answers calls at the same time', async () => {
    const { plan, quote: quoted } = await import('kerfway/portable');
    const aborted = plan(bytes(KEYBOARD), { seconds: 60, signal: AbortSignal.timeout(300) });
    await assert.rejects(aborted, { name: 'TimeoutError' });
    const options = { name: 'keyboard.dxf', moves: 1000, seed: 1 };
    const hashes = await Promise.all([1, 2, 3].map(async () => (await quoted(bytes(KEYBOARD), options)).hash));
    assert.deepEqual(hashes, [hash, hash, hash]);
  });

  it('has types without the DOM library, for modules and for a CommonJS program of TypeScript', () => {
    const tsc = join(ROOT, 'node_modules', 'typescript', 'bin', 'tsc');
    const types = createRequire(import.meta.url).resolve('@types/node/package.json').replace(/[\\/]node[\\/]package\.json$/, '');
    // A file that TypeScript takes for CommonJS, as in a package without "type": "module".
    writeFileSync(join(at, 'handler.cts'), `
      import type { Quote } from 'kerfway/portable' with { 'resolution-mode': 'import' };
      export const handler = async (body: Uint8Array): Promise<Quote> => {
        const { quote } = await import('kerfway/portable');
        return quote(body, { name: 'plate.dxf' });
      };`);
    // Without `with`, as the documentation shows it: TypeScript's module kind node16 refuses types of an ES module in CommonJS.
    writeFileSync(join(at, 'common.cts'), `
      import { KerfwayError, quote, type Quote } from 'kerfway';
      import { quote as portable } from 'kerfway/portable';
      export const handler = async (body: Uint8Array): Promise<Quote | string> => {
        try {
          return await quote(body);
        } catch (error) {
          return error instanceof KerfwayError ? error.code : portable(body);
        }
      };`);
    writeFileSync(join(at, 'handler.ts'), `
      import { quote, type Quote } from 'kerfway/portable';
      import { quote as threaded } from 'kerfway';
      export const handlers = [quote, threaded].map((handler) => async (body: Uint8Array): Promise<Quote> => handler(body, { name: 'plate.dxf' }));`);
    const options = ['--strict', '--noEmit', '--target', 'ES2022', '--lib', 'ES2023', '--types', 'node', '--typeRoots', types];
    execFileSync(process.execPath, [tsc, ...options, '--module', 'NodeNext', '--moduleResolution', 'NodeNext', 'handler.ts', 'handler.cts', 'common.cts'], { cwd: at });
    execFileSync(process.execPath, [tsc, ...options, '--module', 'Node16', '--moduleResolution', 'Node16', 'common.cts'], { cwd: at });
  });
});
