// Builds everything into dist: the wasm files, the npm package (dist/sdk) and the page (dist/app), then weighs them.

import { createHash } from 'node:crypto';
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { pathToFileURL } from 'node:url';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { policyWith } from './policy.mjs';
import { setup } from './setup.mjs';
import { DIST, ENV, main, ROOT, run, Stop } from './tools.mjs';

const SDK = join(DIST, 'sdk');
const APP = join(DIST, 'app');
/** The wasm files: beside the sources of the package, whose types refer to them. */
const WASM = join(ROOT, 'www', 'sdk', 'pkg');

/** kB gzip. The core: planner, pierce groups, kerf, lower bound and quote. A first visit to the page, everything it fetches. */
const BUDGETS = { core: 520, page: 700 };

/**
 * Functions are inlined up to this size instead of 2.5 times it, and loops are not unrolled. At 35 the planner is 3 kB gzip
 * smaller, and makes 4, 8, 0 and -1 % fewer moves a second on sheets of 100, 500, 2,000 and 10,000 contours; at 225 it makes -1, 1, 2
 * and 11 % more and is too large.
 */
export const LEAN = '-Cllvm-args=-inline-threshold=90 -Cllvm-args=-unroll-threshold=0 -Cllvm-args=-unroll-partial-threshold=0';

/** Builds; each wasm file only when something it is made of changed. */
export function build() {
  mkdirSync(WASM, { recursive: true });
  wasm('kerfway', 'planner');
  wasm('kerfway_research', 'research');
  wasm('kerfway_png', 'png');
  sdk();
  console.log('build: the page');
  run('tsc', ['-p', join(ROOT, 'www', 'app')]);
  run('vite', ['build', '--logLevel', 'warn', join(ROOT, 'www', 'app')]);
  offline();
  weigh();
}

// Each in a folder of its own first: wasm-pack optimises every wasm file it finds where it writes, and what was optimised
// before has no names left to be put in order by, which made it up to 8 kB gzip larger.
function wasm(name, feature) {
  const out = join(ROOT, 'target', 'wasm-pack', name);
  const stamp = join(WASM, `${name}.stamp`);
  const made = digest([join(ROOT, 'Cargo.toml'), join(ROOT, 'Cargo.lock'), ...filesIn(join(ROOT, 'src'))]);
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === made) return;
  console.log(`build: ${name}.wasm`);
  const args = [
    ...['build', ROOT, '--release', '--target', 'web', '--mode', 'no-install', '--no-pack'],
    ...['--out-dir', out, '--out-name', name],
    ...['--', '--locked', '--no-default-features', '--features', feature],
  ];
  run('wasm-pack', args, { env: { ...ENV, CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS: LEAN } });
  for (const file of readdirSync(out).filter((f) => f.startsWith(name))) cpSync(join(out, file), join(WASM, file));
  writeFileSync(stamp, made);
}

function sdk() {
  console.log('build: the npm package');
  run('tsc', ['-p', join(ROOT, 'www', 'sdk')]);
  for (const schema of ['plan.schema.json', 'quote.schema.json']) cpSync(join(ROOT, 'www', 'sdk', schema), join(SDK, schema));
  framePage();
  cpSync(WASM, join(SDK, 'pkg'), { recursive: true, filter: (f) => !f.endsWith('.stamp') });
  const bytes = readFileSync(join(WASM, 'kerfway_bg.wasm')).toString('base64');
  writeFileSync(join(SDK, 'inline-bytes.js'), `export default '${bytes}';\n`);
  globalBuild();
}

/** Any server may serve it, so it states its policy itself. */
function framePage() {
  const from = join(ROOT, 'www', 'sdk', 'frame');
  const meta = `<meta http-equiv="Content-Security-Policy" content="${policyWith()}" />`;
  const page = readFileSync(join(from, 'frame.html'), 'utf8').replace('<head>', `<head>\n    ${meta}`);
  writeFileSync(join(SDK, 'frame', 'frame.html'), page);
  cpSync(join(from, 'frame.css'), join(SDK, 'frame', 'frame.css'));
}

/** Everything in one script: first the worker, then what holds it as text. */
function globalBuild() {
  const bundle = (from, to, ...options) =>
    run('esbuild', [
      ...[join(ROOT, 'www', 'sdk', 'global', from), `--outfile=${to}`, '--bundle', '--minify', '--format=iife', '--target=es2022'],
      ...['--loader:.wasm=binary', '--loader:.worker=text', '--legal-comments=none', '--log-level=warning'],
      // Only reached where no wasm is handed over.
      ...['--log-override:empty-import-meta=silent', ...options],
    ]);
  const worker = join(ROOT, 'www', 'sdk', 'global', 'planner.worker');
  bundle('worker.ts', worker);
  bundle('index.ts', join(SDK, 'kerfway.global.js'), '--global-name=Kerfway');
  rmSync(worker);
  rmSync(join(SDK, 'global'), { recursive: true });
}

/** The worker that keeps the page for when there is no network is told its files. */
function offline() {
  const files = filesIn(APP).filter((f) => !onDemand(f));
  const names = files.map((f) => relative(APP, f).split(sep).join('/')).filter((f) => f !== 'index.html');
  const text = readFileSync(join(ROOT, 'www', 'app', 'offline', 'worker.js'), 'utf8')
    .replace('__VERSION__', digest(files).slice(0, 16))
    .replace('__FILES__', JSON.stringify(['./', ...names]));
  writeFileSync(join(APP, 'offline.js'), text);
}

function weigh() {
  const rows = [
    ['core wasm', [join(WASM, 'kerfway_bg.wasm')], BUDGETS.core],
    ['research wasm, on demand', [join(WASM, 'kerfway_research_bg.wasm')], null],
    ['PNG wasm, on demand', [join(WASM, 'kerfway_png_bg.wasm')], null],
    ['single file for a script tag', [join(SDK, 'kerfway.global.js')], null],
    ['page, all of a first visit', filesIn(APP).filter((f) => !onDemand(f)), BUDGETS.page],
  ];
  let over = false;
  console.log('');
  for (const [what, files, budget] of rows) {
    const raw = files.reduce((sum, f) => sum + statSync(f).size, 0) / 1000;
    const [gzip, brotli] = [(b) => gzipSync(b, { level: 9 }), brotliCompressSync].map(
      (pack) => files.reduce((sum, f) => sum + pack(readFileSync(f)).length, 0) / 1000,
    );
    const limit = budget === null ? '' : `   budget ${budget} kB gzip${gzip > budget ? '   OVER' : ''}`;
    over ||= budget !== null && gzip > budget;
    console.log(`${what.padEnd(28)}${kB(raw)} kB raw${kB(gzip)} kB gzip${kB(brotli)} kB brotli${limit}`);
  }
  if (over) throw new Stop('The build is over its size budget.');
}

/** The sample shown on a first visit. */
const FIRST_SAMPLE = 'sheet_500.dxf';

/** Not fetched before somebody asks for it: the research build, the PNG renderer, source maps, samples past the first. */
function onDemand(file) {
  return /kerfway_(png|research)|\.map$/.test(file) || (/samples[\\/]/.test(file) && !file.endsWith(FIRST_SAMPLE));
}

const kB = (n) => n.toFixed(1).padStart(9);

function filesIn(folder) {
  return readdirSync(folder, { withFileTypes: true })
    .flatMap((e) => (e.isDirectory() ? filesIn(join(folder, e.name)) : [join(folder, e.name)]))
    .sort();
}

function digest(files) {
  const hash = createHash('sha256');
  for (const f of files) hash.update(f.slice(ROOT.length)).update('\0').update(readFileSync(f)).update('\0');
  return hash.digest('hex');
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  main(() => {
    setup();
    build();
  });
}
