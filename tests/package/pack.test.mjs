// What is published: the files, their entry points by import, require and type, and no more.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, after, describe, it } from 'node:test';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { publint } from 'publint';
import { ROOT } from './support.mjs';

/** kB, packed: the two wasm files, the planner once more in base64, and the scripts. */
const PACKED_BUDGET = 1200;

describe('the published package', () => {
  let at, packed;

  before(() => {
    at = mkdtempSync(join(tmpdir(), 'kerfway-pack-'));
    const out = execFileSync('npm', ['pack', '--json', '--pack-destination', at], { cwd: ROOT, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] });
    [packed] = JSON.parse(out);
    mkdirSync(join(at, 'node_modules', 'kerfway'), { recursive: true });
    execFileSync('tar', ['-xzf', join(at, packed.filename), '--strip-components=1', '-C', join(at, 'node_modules', 'kerfway')]);
    writeFileSync(join(at, 'package.json'), '{ "type": "module" }');
  });
  after(() => rmSync(at, { recursive: true, force: true }));

  const run = (...args) => execFileSync(process.execPath, args, { cwd: at, encoding: 'utf8' });

  it('holds what is listed and nothing else', () => {
    const files = packed.files.map((f) => f.path);
    for (const wanted of [
      'LICENSE', 'README.md', 'CHANGELOG.md', 'package.json', 'dist/sdk/index.js', 'dist/sdk/index.d.ts', 'dist/sdk/node.js',
      'dist/sdk/worker.js', 'dist/sdk/node-worker.js', 'dist/sdk/cli.js', 'dist/sdk/inline.js', 'dist/sdk/inline-bytes.js',
      'dist/sdk/plan.schema.json', 'dist/sdk/pkg/kerfway.js', 'dist/sdk/pkg/kerfway_bg.wasm', 'dist/sdk/pkg/kerfway_png_bg.wasm',
    ]) {
      assert.ok(files.includes(wanted), wanted);
    }
    const strange = files.filter((f) => !/^(LICENSE|README\.md|CHANGELOG\.md|package\.json|dist\/sdk\/.*\.(js|d\.ts|json|wasm))$/.test(f));
    assert.deepEqual(strange, []);
    assert.ok(packed.size < PACKED_BUDGET * 1000, `${packed.size} bytes`);
  });

  it('is in order by publint', async () => {
    const { messages } = await publint({ pkgDir: join(at, 'node_modules', 'kerfway'), strict: true, pack: false });
    assert.deepEqual(messages, []);
  });

  it('is found by import, by require and as data', () => {
    const script = `
      import { createRequire } from 'node:module';
      import { readFileSync } from 'node:fs';
      const require = createRequire(import.meta.url);
      const { createPlanner } = await import('kerfway');
      const { wasm } = await import('kerfway/inline');
      const file = readFileSync(require.resolve('kerfway/kerfway_bg.wasm'));
      const schema = JSON.parse(readFileSync(require.resolve('kerfway/plan.schema.json')));
      const planner = await createPlanner({ wasm: wasm() });
      const worker = import.meta.resolve('kerfway/worker');
      console.log(JSON.stringify([
        planner.methods.length > 0, Buffer.compare(file, wasm()), schema.$id !== undefined,
        typeof require('kerfway').createPlanner, worker.endsWith('dist/sdk/worker.js'),
      ]));
      planner.close();`;
    writeFileSync(join(at, 'use.mjs'), script);
    assert.deepEqual(JSON.parse(run('use.mjs')), [true, 0, true, 'function', true]);
  });

  it('has types that a strict program compiles against', () => {
    const program = `
      import { createPlanner, type BestPath, type Loaded } from 'kerfway';
      const planner = await createPlanner({ onReplaced: (message: string) => console.log(message) });
      const loaded: Loaded = await planner.load(new Uint8Array(0), 'a.dxf', { units: 'mm' });
      let path: BestPath | null = null;
      const plan = planner.plan({ moves: 10, machine: 'length' }, (p) => (path = p.path));
      const seconds: number = (await plan.done).progress.summary.total_time;
      const gcode: string = await planner.output('gcode');
      const png: Uint8Array = await planner.output('png', 300);
      console.log(loaded.units.reason, path, seconds, gcode, png);
      // @ts-expect-error: no such unit
      void planner.reload({ units: 'parsec' });`;
    writeFileSync(join(at, 'use.ts'), program);
    for (const [module, resolution] of [['NodeNext', 'NodeNext'], ['ESNext', 'Bundler']]) {
      const options = ['--strict', '--noEmit', '--target', 'ES2022', '--lib', 'ES2022,DOM', '--types', ''];
      const tsc = join(ROOT, 'node_modules', 'typescript', 'bin', 'tsc');
      run(tsc, ...options, '--module', module, '--moduleResolution', resolution, 'use.ts');
    }
  });

  it('runs as a command', () => {
    const { version } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'));
    assert.equal(run(join('node_modules', 'kerfway', 'dist', 'sdk', 'cli.js'), '--version'), `${version}\n`);
  });
});
