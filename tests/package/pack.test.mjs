// The published package: its files, and its entry points by import, require and types.

import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { before, after, describe, it } from 'node:test';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { checkPackage, createPackageFromTarballData } from '@arethetypeswrong/core';
import { publint } from 'publint';
import { install, pack, ROOT } from './support.mjs';

/** kB, packed: four wasm files, the core and the writers once more in the single file and as text for `inline`, the scripts, and the list of changes. */
const PACKED_BUDGET = 5630;

describe('the published package', () => {
  let at, packed;

  before(() => {
    at = mkdtempSync(join(tmpdir(), 'kerfway-pack-'));
    packed = pack(at);
    install(at, packed.filename);
  });
  after(() => rmSync(at, { recursive: true, force: true }));

  const run = (...args) => execFileSync(process.execPath, args, { cwd: at, encoding: 'utf8' });

  it('contains the listed files and nothing else', () => {
    const files = packed.files.map((f) => f.path);
    for (const wanted of [
      'LICENSE', 'README.md', 'CHANGELOG.md', 'package.json', 'dist/sdk/index.js', 'dist/sdk/index.d.ts', 'dist/sdk/node.js', 'dist/sdk/node.cjs', 'dist/sdk/node-types.d.cts',
      'dist/sdk/worker.js', 'dist/sdk/node-worker.js', 'dist/sdk/cli.js', 'dist/sdk/inline.js', 'dist/sdk/inline-bytes.js', 'dist/sdk/inline-outputs-bytes.js', 'dist/sdk/portable.js', 'dist/sdk/portable.cjs', 'dist/sdk/workerd.js',
      'dist/sdk/node-types.d.cts', 'dist/sdk/portable-types.d.cts', 'dist/sdk/server/serve.js',
      'dist/sdk/plan.schema.json', 'dist/sdk/kerfway.global.js', 'dist/sdk/element/index.js', 'dist/sdk/frame/frame.html',
      'dist/sdk/frame/frame.css', 'dist/sdk/frame/page.js', 'dist/sdk/pkg/kerfway.js', 'dist/sdk/pkg/kerfway_bg.wasm', 'dist/sdk/pkg/kerfway_outputs_bg.wasm', 'dist/sdk/pkg/kerfway_png_bg.wasm',
    ]) {
      assert.ok(files.includes(wanted), wanted);
    }
    const strange = files.filter((f) => !/^(LICENSE|README\.md|CHANGELOG\.md|package\.json|dist\/sdk\/.*\.(c?js|c?js\.map|d\.c?ts|json|wasm|html|css))$/.test(f));
    assert.deepEqual(strange, []);
    // Nothing imports the command line and the service, so that their types are of no use.
    assert.deepEqual(files.filter((f) => /^dist\/sdk\/(cli|server)\/.*\.d\.ts$/.test(f)), []);
    assert.ok(packed.size < PACKED_BUDGET * 1000, `${packed.size} bytes`);
  });

  it('has a source map, with its sources, for every module of code that is compiled from TypeScript', () => {
    const own = packed.files.map((f) => f.path).filter((f) => /\.c?js$/.test(f) && !/\/pkg\/|inline-(outputs-)?bytes|kerfway\.global/.test(f));
    assert.ok(own.length > 40);
    const text = (file) => readFileSync(join(at, 'node_modules', 'kerfway', file), 'utf8');
    const isTypes = (file) => /^(\/\*.*?\*\/\s*)*export \{\};\s*$/s.test(text(file));
    assert.ok(isTypes('dist/sdk/generated/types.js'), 'types have no map');
    for (const file of own.filter((f) => !isTypes(f))) {
      const { sources, sourcesContent } = JSON.parse(text(`${file}.map`));
      assert.deepEqual([sources.length, sourcesContent.length], [1, 1], file);
    }
  });

  it('has its licence', () => {
    assert.match(readFileSync(join(at, 'node_modules', 'kerfway', 'LICENSE'), 'utf8'), /MIT License/);
  });

  it('is published by a workflow with provenance, from the tag of its version', () => {
    const workflow = readFileSync(join(ROOT, '.github', 'workflows', 'release.yml'), 'utf8');
    for (const wanted of [/tags: \['v\*'\]/, /id-token: write/, /npm publish --provenance/, /run: npm test/, /GITHUB_REF_NAME/]) assert.match(workflow, wanted);
  });

  it('passes publint', async () => {
    const { messages } = await publint({ pkgDir: join(at, 'node_modules', 'kerfway'), strict: true, pack: false });
    assert.deepEqual(messages, []);
  });

  it('has types that resolve everywhere, according to @arethetypeswrong', async () => {
    const { problems, entrypoints } = await checkPackage(createPackageFromTarballData(readFileSync(join(at, packed.filename))));
    assert.ok(Object.values(entrypoints).every((e) => e.resolutions.bundler.resolution !== undefined || e.isWildcard));
    // Left out: the resolution of before 2020 (node10), which knows no `exports`, and require for what is meant for
    // browsers, which have none.
    const counts = ({ entrypoint, resolutionKind }) => resolutionKind !== 'node10' && (entrypoint === '.' || resolutionKind !== 'node16-cjs');
    assert.deepEqual(problems.filter(counts), []);
  });

  it('can be imported, required and read as data', () => {
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

  it('is the same by import and by require, without a warning', () => {
    const script = `
      const kerfway = require('kerfway');
      const square = [[0, 0, 9, 0], [9, 0, 9, 9], [9, 9, 0, 9], [0, 9, 0, 0]];
      const lines = square.map(([a, b, c, d]) => '0\\nLINE\\n10\\n' + a + '\\n20\\n' + b + '\\n11\\n' + c + '\\n21\\n' + d + '\\n');
      const dxf = '0\\nSECTION\\n2\\nENTITIES\\n' + lines.join('') + '0\\nENDSEC\\n0\\nEOF\\n';
      import('kerfway').then(async (imported) => {
        const { summary } = await kerfway.plan(Buffer.from(dxf), { units: 'mm', moves: 10 });
        console.log(JSON.stringify([imported.plan === kerfway.plan, summary.cut_length]));
      });`;
    writeFileSync(join(at, 'use.cjs'), script);
    const { stdout, stderr } = spawnSync(process.execPath, ['use.cjs'], { cwd: at, encoding: 'utf8' });
    assert.equal(stderr, '');
    assert.deepEqual(JSON.parse(stdout), [true, 36]);
  });

  it('has types that a strict program compiles against', () => {
    const program = `
      import { createPlanner, createPool, inspect, plan, render, type BestPath, type Loaded, type PlanRun, type Pool } from 'kerfway';
      const planner = await createPlanner({ onReplaced: (message: string) => console.log(message) });
      const loaded: Loaded = await planner.load(new Uint8Array(0), 'a.dxf', { units: 'mm' });
      let path: BestPath | null = null;
      const handle = planner.plan({ moves: 10, machine: 'length' }, (p) => (path = p.path));
      const seconds: number = (await handle.done).progress.summary.total_time;
      const gcode: string = await planner.output('gcode');
      const png: Uint8Array = await planner.output('png', 300);
      console.log(loaded.units.reason, path, seconds, gcode, png);
      // @ts-expect-error: no such unit
      void planner.reload({ units: 'parsec' });
      const run: PlanRun<'gcode' | 'png'> = plan(new Uint8Array(0), { outputs: ['gcode', 'png'], signal: AbortSignal.timeout(5) });
      for await (const { summary } of run) console.log(summary.gap);
      const planned = await run;
      const [text, picture]: [string, Uint8Array] = [planned.outputs.gcode, planned.outputs.png];
      // @ts-expect-error: not asked for
      planned.outputs.svg;
      const svg: string = await render(new Uint8Array(0), planned, 'svg');
      const pool: Pool = createPool({ size: 2 });
      const other: Loaded = await pool.inspect(() => new Uint8Array(0), { keepDamaged: true });
      console.log(text, picture, svg, other, inspect);`;
    writeFileSync(join(at, 'use.ts'), program);
    writeFileSync(join(at, 'common.cts'), `
      import { leadRules, plan, readProject, type Planned, type Project } from 'kerfway';
      import kerfway = require('kerfway');
      const project: Promise<Project> = readProject(new Uint8Array(0));
      console.log(leadRules({ kind: 'arc' }).rules.length, project, kerfway.PROVEN);
      const planned: Promise<Planned> = plan(new Uint8Array(0), { seconds: 1 });
      void planned.then((p: kerfway.Planned) => p.summary.total_time);`);
    // The names of the elements were unknown to hosts that import their classes.
    writeFileSync(join(at, 'element.ts'), `
      import type { KerfwayQuote } from 'kerfway/element';
      const quote: KerfwayQuote | null = document.querySelector('kerfway-quote');
      document.createElement('kerfway-planner').stop();
      document.createElement('kerfway-quote').price = (report) => report.hash + String(quote);`);
    // `error` and `progress` had the types of the DOM's events, and `result` that of any event.
    writeFileSync(join(at, 'events.ts'), `
      import 'kerfway/element';
      import type { ErrorReport, Planned, Progress, Quote } from 'kerfway';
      const planner = document.createElement('kerfway-planner');
      planner.addEventListener('error', ({ detail }) => { const report: ErrorReport = detail; console.log(report.code); });
      planner.addEventListener('progress', ({ detail }) => { const progress: Progress = detail; console.log(progress.moves); }, { once: true });
      planner.addEventListener('result', ({ detail }) => { const planned: Planned<'gcode'> = detail; console.log(planned.outputs.gcode); });
      planner.addEventListener('ready', function ({ detail }) { console.log(this.result, detail.machines[0]?.name); });
      planner.addEventListener('click', (event) => console.log(event.clientX));
      planner.addEventListener('of-my-own', (event: Event) => console.log(event.type));
      const quoted = ({ detail }: CustomEvent<Quote>) => console.log(detail.hash);
      const quote = document.createElement('kerfway-quote');
      quote.addEventListener('result', quoted);
      quote.removeEventListener('result', quoted);
      // @ts-expect-error: that is an error of a script
      planner.addEventListener('error', (event: ErrorEvent) => console.log(event.filename));
      const element: HTMLElement = planner;
      element.addEventListener('error', (event) => console.log(event.type));`);
    const tsc = join(ROOT, 'node_modules', 'typescript', 'bin', 'tsc');
    for (const [module, resolution] of [['NodeNext', 'NodeNext'], ['ESNext', 'Bundler']]) {
      const options = ['--strict', '--noEmit', '--target', 'ES2022', '--lib', 'ES2022,DOM', '--types', ''];
      run(tsc, ...options, '--module', module, '--moduleResolution', resolution, 'use.ts', 'element.ts', 'events.ts');
    }
    run(tsc, '--strict', '--noEmit', '--target', 'ES2022', '--types', '', '--lib', 'ES2022,DOM', '--module', 'NodeNext', 'common.cts');
  });

  it('runs as a command', () => {
    const { version } = JSON.parse(readFileSync(join(ROOT, 'package.json'), 'utf8'));
    assert.equal(run(join('node_modules', 'kerfway', 'dist', 'sdk', 'cli.js'), '--version').split('\n')[0], version);
    const wasm = readFileSync(join(at, 'node_modules', 'kerfway', 'dist', 'sdk', 'pkg', 'kerfway_bg.wasm'));
    assert.match(run(join('node_modules', 'kerfway', 'dist', 'sdk', 'cli.js'), '--version'), new RegExp(`sha256 ${createHash('sha256').update(wasm).digest('hex')}\\n`));
  });
});
