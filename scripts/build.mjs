// Builds everything into dist: the wasm files, the npm package (dist/sdk) and the page (dist/app), then weighs them.
// `npm run build -- --quick` is for trying out: it compiles in a third of the time and weighs nothing.

import { createHash } from 'node:crypto';
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { brotliCompress, constants, gzip } from 'node:zlib';
import { policyWith } from './policy.mjs';
import { setup } from './setup.mjs';
import { quietly, together } from './together.mjs';
import { BESIDE, COMPILING, DIST, ENV, main, ROOT, run, Stop } from './tools.mjs';

const SDK = join(DIST, 'sdk');
const APP = join(DIST, 'app');
/** The wasm files: beside the sources of the package, whose types refer to them. */
const WASM = join(ROOT, 'www', 'sdk', 'pkg');
/** The same as they come from the compiler. */
const COMPILED = join(ROOT, 'target', 'compiled');
const TARGET = 'wasm32-unknown-unknown';

/**
 * kB. The core: planner, pierce groups, kerf, lower bound and quote, by gzip. A first visit to the page, everything it fetches, by Brotli:
 * every browser takes it, and the build writes the compressed files for any server to send.
 */
export const BUDGETS = { core: 698, page: 700 };

/**
 * Functions are inlined up to this size instead of five times it, and loops are not unrolled. At 90 the planner is 18 kB gzip larger and
 * makes no more moves a second (64, 65, 75 and 164 ns a move at 45 on sheets of 100, 500, 2,000 and 10,000 contours, 63, 67, 73 and 166 ns at 90,
 * medians of seven runs in turn); at 35 it made 4 and 8 % fewer on the first two.
 */
export const LEAN = '-Cllvm-args=-inline-threshold=45 -Cllvm-args=-unroll-threshold=0 -Cllvm-args=-unroll-partial-threshold=0';

/** Compressed beside each other, on all cores. */
const [brotli, zip] = [brotliCompress, gzip].map(promisify);

/** The wasm files, with the feature of the crate each is built with. */
const FILES = { kerfway: 'planner', kerfway_outputs: 'outputs', kerfway_research: 'research', kerfway_png: 'png' };

/** A quick build has the writers and the renderer compiled together, so that cargo compiles once for both files. */
const featureOf = (name, quick) => (quick && /outputs|png/.test(name) ? 'outputs,png' : FILES[name]);

/** What wasm-opt does to a release. What LLVM left outside stays outside but for the smallest functions, and like functions lie side by side. */
const OPTIMISE = ['-O3', '--flexible-inline-max-function-size=8', '--one-caller-inline-max-function-size=0', '--reorder-functions-by-name'];
/**
 * Before that, two turns with a look at the whole program after each: the first makes the core 1.3 to 1.7 kB smaller by gzip (two builds),
 * the second 1.2 kB (one build), and a third 0.2 kB. The other files are not worth the two minutes.
 */
const TURNS = ['-O3', '--gufa-optimizing', '-O3', '--gufa-optimizing'];

/** Builds everything; each wasm file only when something it is made of changed. `quick`: for trying out, not for publishing. */
export async function build({ quick = false } = {}) {
  await wasmFiles({ quick });
  sdk();
  console.log('build: the page');
  run('tsc', ['-p', join(ROOT, 'www', 'app')]);
  run('vite', ['build', '--logLevel', 'warn', join(ROOT, 'www', 'app')]);
  offline();
  if (quick) return;
  await compress();
  await weigh();
}

/** Makes the wasm files that are out of date, with their JavaScript and their types. */
export async function wasmFiles({ quick = false } = {}) {
  mkdirSync(WASM, { recursive: true });
  await together(lanes(quick, (name) => !isCurrent(join(WASM, name), quick), async (name, folder) => {
    if (!isCurrent(join(COMPILED, name), quick)) await compile(name, quick, folder);
    await bind(name, quick);
  }));
}

/** The tasks that compile the wasm files which are out of date; they need no tool but cargo. */
export function compiling({ quick = false } = {}) {
  const isStale = (name) => !isCurrent(join(WASM, name), quick) && !isCurrent(join(COMPILED, name), quick);
  return lanes(quick, isStale, (name, folder) => compile(name, quick, folder));
}

/**
 * Tasks that make files one after the other. A release is compiled on one core, so there are two of them. A quick build takes all cores
 * and is one.
 */
function lanes(quick, isStale, make) {
  const all = quick ? [[Object.keys(FILES), COMPILING]] : [[['kerfway_research', 'kerfway_outputs'], COMPILING], [['kerfway', 'kerfway_png'], BESIDE]];
  return all.flatMap(([names, folder]) => {
    const stale = names.filter(isStale);
    const work = async () => {
      for (const name of stale) await make(name, folder);
    };
    return stale.length === 0 ? [] : [{ name: `build: ${stale.join(', ')}`, usually: quick ? '2 to 3 minutes' : '4 minutes', work }];
  });
}

async function compile(name, quick, folder) {
  mkdirSync(COMPILED, { recursive: true });
  const profile = quick ? 'quick' : 'release';
  // Nothing but wasm: compiled as a Rust library as well, which `Cargo.toml` has for the tests, it takes nearly twice as long, and the core is 9 kB
  // larger by gzip.
  const args = ['rustc', '--locked', '--lib', '--crate-type', 'cdylib', '--target', TARGET, '--profile', profile, '--no-default-features', '--features', featureOf(name, quick)];
  const flags = quick ? '' : LEAN;
  await quietly('cargo', [...args, '--target-dir', folder], { env: { ...ENV, CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS: flags } });
  cpSync(join(folder, TARGET, profile, 'kerfway.wasm'), join(COMPILED, `${name}.wasm`));
  stamp(join(COMPILED, name), quick);
}

/** The JavaScript beside a compiled wasm file, and the optimised wasm, in the folder of the sources that refer to them. */
async function bind(name, quick) {
  await quietly('wasm-bindgen', [join(COMPILED, `${name}.wasm`), '--target', 'web', '--out-dir', WASM, '--out-name', name]);
  const file = join(WASM, `${name}_bg.wasm`);
  if (!quick) await quietly('wasm-opt', [...(name === 'kerfway' ? TURNS : []), ...OPTIMISE, file, '-o', file]);
  stamp(join(WASM, name), quick);
}

/** Whether a file was made of the sources as they are; a release serves where a quick build would do. */
function isCurrent(file, quick) {
  const made = existsSync(`${file}.stamp`) ? readFileSync(`${file}.stamp`, 'utf8') : '';
  return made === sources(false) || (quick && made === sources(true));
}

function stamp(file, quick) {
  writeFileSync(`${file}.stamp`, sources(quick));
}

function sources(quick) {
  const made = digest([join(ROOT, 'Cargo.toml'), join(ROOT, 'Cargo.lock'), ...filesIn(join(ROOT, 'src'))]);
  return quick ? `quick ${made}` : made;
}

function sdk() {
  console.log('build: the npm package');
  run('tsc', ['-p', join(ROOT, 'www', 'sdk')]);
  typesWithoutMaps();
  tableWithoutPlaces();
  cpSync(join(ROOT, 'src', 'machine', 'dialect', 'shipped'), join(SDK, 'dialects'), { recursive: true });
  for (const schema of ['plan.schema.json', 'quote.schema.json', 'dialect.schema.json', 'certificate.schema.json']) cpSync(join(ROOT, 'www', 'sdk', schema), join(SDK, schema));
  for (const types of ['node-types.d.cts', 'portable-types.d.cts']) cpSync(join(ROOT, 'www', 'sdk', types), join(SDK, types));
  for (const framework of ['react', 'vue']) cpSync(join(ROOT, 'www', 'sdk', 'frameworks', `${framework}.d.ts`), join(SDK, 'element', `${framework}.d.ts`));
  framePage();
  cpSync(WASM, join(SDK, 'pkg'), { recursive: true, filter: (f) => !f.endsWith('.stamp') });
  for (const [name, script] of [['kerfway', 'inline-bytes.js'], ['kerfway_outputs', 'inline-outputs-bytes.js']]) {
    const bytes = readFileSync(join(WASM, `${name}_bg.wasm`)).toString('base64');
    writeFileSync(join(SDK, script), `export default '${bytes}';\n`);
  }
  globalBuild();
}

/** A module of types alone has no code, so there is nothing to map: the map would only repeat the types. */
function typesWithoutMaps() {
  for (const file of filesIn(SDK).filter((f) => f.endsWith('.js'))) {
    const [code, map] = readFileSync(file, 'utf8').split('//# sourceMappingURL=');
    if (map === undefined || code.replace(/\/\*.*?\*\//gs, '').trim() !== 'export {};') continue;
    writeFileSync(file, code);
    rmSync(`${file}.map`);
  }
}

/** The table of fields is data, in which no debugger stops: its map has its source, without the place of each brace. */
function tableWithoutPlaces() {
  const map = join(SDK, 'fields.js.map');
  writeFileSync(map, JSON.stringify({ ...JSON.parse(readFileSync(map, 'utf8')), mappings: '' }));
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

/** Writes the lists of files into the service worker, which stores them for use without a network. */
function offline() {
  const files = filesIn(APP).filter((f) => !onDemand(f));
  const later = filesIn(APP).filter((f) => /(kerfway_outputs|later-)[^.]*\.(js|wasm)$/.test(f));
  const namesOf = (list) => list.map((f) => relative(APP, f).split(sep).join('/'));
  const names = namesOf(files).filter((f) => f !== 'index.html');
  const text = readFileSync(join(ROOT, 'www', 'app', 'offline', 'worker.js'), 'utf8')
    .replace('__VERSION__', digest([...files, ...later]).slice(0, 16))
    .replace('__FILES__', JSON.stringify(['./', ...names]))
    .replace('__LATER__', JSON.stringify(namesOf(later)));
  const to = join(APP, 'offline.js');
  writeFileSync(to, text);
  run('esbuild', [to, '--minify', '--allow-overwrite', `--outfile=${to}`, '--log-level=warning']);
}

/** Writes each file of the page compressed beside it, once at build time, as well as Brotli can: what a first visit fetches in several ways. */
function compress() {
  return Promise.all(filesIn(APP).map(async (file) => writeFileSync(`${file}.br`, await (onDemand(file) ? brotli : smallest)(readFileSync(file)))));
}

/**
 * How short distances are coded: with codes of their own they suit wasm, whose functions repeat what was near. Which of these suits the core best
 * changes with every build, by up to half a kB, so all are tried. Other files are smaller without.
 */
const DISTANCES = [[0, 0], [0, 15], [1, 20], [1, 24], [1, 30]];

async function smallest(bytes) {
  const { BROTLI_PARAM_NPOSTFIX: postfix, BROTLI_PARAM_NDIRECT: direct } = constants;
  const tried = await Promise.all(DISTANCES.map(([p, d]) => brotli(bytes, { params: { [postfix]: p, [direct]: d } })));
  return tried.reduce((least, other) => (other.length < least.length ? other : least));
}

async function weigh() {
  const rows = [
    ['core wasm', [join(WASM, 'kerfway_bg.wasm')], BUDGETS.core],
    ['writers of outputs, on demand', [join(WASM, 'kerfway_outputs_bg.wasm')], null],
    ['research wasm, on demand', [join(WASM, 'kerfway_research_bg.wasm')], null],
    ['PNG wasm, on demand', [join(WASM, 'kerfway_png_bg.wasm')], null],
    ['single file for a script tag', [join(SDK, 'kerfway.global.js')], null],
    ['page, all of a first visit', filesIn(APP).filter((f) => !onDemand(f)), BUDGETS.page, 'brotli'],
  ];
  let over = false;
  console.log('');
  for (const [what, files, budget, by = 'gzip'] of rows) {
    const raw = files.reduce((sum, f) => sum + statSync(f).size, 0) / 1000;
    const kilobytes = async (size) => (await Promise.all(files.map(size))).reduce((sum, bytes) => sum + bytes, 0) / 1000;
    // The files of the page have been compressed already.
    const compressed = async (f) => (by === 'brotli' ? statSync(`${f}.br`).size : (await brotli(readFileSync(f))).length);
    const [zipped, packed] = await Promise.all([kilobytes(async (f) => (await zip(readFileSync(f), { level: 9 })).length), kilobytes(compressed)]);
    const isOver = budget !== null && { gzip: zipped, brotli: packed }[by] > budget;
    const limit = budget === null ? '' : `   budget ${budget} kB ${by}${isOver ? '   OVER' : ''}`;
    over ||= isOver;
    console.log(`${what.padEnd(36)}${kB(raw)} kB raw${kB(zipped)} kB gzip${kB(packed)} kB brotli${limit}`);
  }
  if (over) throw new Stop('The build is over its size budget.');
}

/** The sample shown on a first visit. */
const FIRST_SAMPLE = 'sheet_500.dxf';

/**
 * Not fetched before it is needed: the writers of programs, the research build, the PNG renderer, other languages, other orders to compare with,
 * source maps, samples past the first, and the planner without a worker, which the page never uses. Nor are compressed copies.
 */
function onDemand(file) {
  return /kerfway_(outputs|png|research)|(language|later|in-thread)-[^/\\]*\.js$|\.(map|br)$/.test(file) || (/samples[\\/]/.test(file) && !file.endsWith(FIRST_SAMPLE));
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
  main(async () => {
    await setup();
    await build({ quick: process.argv.includes('--quick') });
  });
}
