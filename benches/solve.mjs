// The search against the best values known and against other solvers, on every kind of instance, natively and in wasm
// under Node:
//
//     npm run bench -- solve [sheets|grids|holes|pool|qu-du|proofs|bounds|bounds-gtsplib|stops|gtsplib|pcgtsp|large|scaling]...
//                            [--seconds S] [--seeds K] [--only NAME] [--cpu] [--data FOLDER]
//                            [--gtsplib FOLDER [--log FILE] [--tours FOLDER] [--lkh PROGRAM]]
//
// `--cpu` counts processor time instead of the time of the clock, for a machine that others use too (Linux only).
// `large`: the instances of GTSPLIB with 200 sets and more in the folder that `--gtsplib` names (benches/solve/large.mjs: `--log` keeps
// each run, and goes on from what is there; `--tours` adds the best tours of GLKH, `--lkh` runs the program LKH beside).
// Instances are in benches/data. Those that may not be copied are read from `--data FOLDER` (benches/data/README.md). Each run has a
// process of its own, one after the other, and ends early when the best known value is reached. The tour at the end of a run is
// checked by code that shares nothing with the search. Other solvers run on the same instances if Python has them
// (`KERFWAY_PYTHON`, otherwise python3; benches/solve/baselines.py lists what they need).

import { readFileSync, rmSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { setup } from '../scripts/setup.mjs';
import { ask, DIST, ENV, ROOT, run, Stop } from '../scripts/tools.mjs';
import { build as buildAll, LEAN } from '../scripts/build.mjs';
import { IGNORED, Instances, NOT_RUN } from './common/data.mjs';
import { mb, mean, median, ms, rows, table } from './common/table.mjs';
import { byHand, drawn, PATTERNS, SIDES } from './solve/grids.mjs';
import { MARKS as HOLE_MARKS } from './solve/holes.mjs';
import { large } from './solve/large.mjs';
import { proofs } from './solve/proofs.mjs';
import { at, baseline, boundsOf, HERE, inWasm, NATIVE, natively, off, percent, proven, PYTHON } from './solve/runs.mjs';
import { partial, plates } from './solve/stops.mjs';

/** Seconds after which values are printed. */
const MARKS = [1, 10, 30, 60];
const SHEETS = [100, 500, 2000, 10000];
const SOLVERS = ['elkai', 'pyvrp', 'ortools'];

const SETS = {
  sheets,
  grids,
  holes,
  pool,
  'qu-du': quDu,
  proofs,
  bounds,
  'bounds-gtsplib': boundsOfGtsplib,
  stops,
  gtsplib: (options) => library('gtsplib', '.gtsp', options, true),
  pcgtsp: (options) => library('pcgtsp', '.pcglns', options, false),
  large,
  scaling,
};

/** Seconds of a run, by set, where they are not given. */
const SECONDS = { 'bounds-gtsplib': 120 };
const USUAL_SECONDS = 10;

export async function bench(args) {
  const { values, positionals } = parseArgs({
    args,
    allowPositionals: true,
    options: {
      seconds: { type: 'string' },
      seeds: { type: 'string' },
      only: { type: 'string' },
      cpu: { type: 'boolean' },
      data: { type: 'string' },
      gtsplib: { type: 'string' },
      tours: { type: 'string' },
      log: { type: 'string' },
      lkh: { type: 'string' },
    },
  });
  const unknown = positionals.find((name) => !(name in SETS));
  if (unknown !== undefined) throw new Stop(`There is no set ${unknown}: ${Object.keys(SETS).join(', ')}.`);
  const instances = new Instances(values.data);
  await setup({ tests: true });
  const chosen = positionals.length > 0 ? positionals : Object.keys(SETS).filter((name) => name !== 'large' || values.gtsplib !== undefined);
  build(chosen);
  for (const name of chosen) {
    const { seconds = SECONDS[name] ?? USUAL_SECONDS, seeds = 5, ...more } = values;
    await SETS[name]({ ...more, seconds: Number(seconds), seeds: Number(seeds), instances });
    instances.report();
  }
}

function build(chosen) {
  const manifest = ['--manifest-path', join(HERE, 'Cargo.toml')];
  if (chosen.every((name) => name === 'large')) {
    console.log('bench: the search, natively');
    run('cargo', ['build', '--release', ...manifest, '--bin', basename(NATIVE)]);
    return;
  }
  console.log('bench: the search, natively and in wasm');
  run('cargo', ['build', '--release', ...manifest]);
  const args = [
    ...['build', HERE, '--release', '--target', 'web', '--mode', 'no-install', '--no-pack'],
    ...['--out-dir', join(DIST, 'bench-solve'), '--out-name', 'solve'],
  ];
  run('wasm-pack', args, { env: { ...ENV, CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS: LEAN } });
}

/** The sheets whose names contain `only`: number of contours and file. */
const sheetFiles = ({ instances, only = '' }) =>
  SHEETS.filter((n) => `sheet_${n}.dxf`.includes(only)).map((n) => [n, instances.file(`sheets/sheet_${n}.dxf`)]);
const bySize = (a, b) => (parseInt(basename(a)) || 0) - (parseInt(basename(b)) || 0) || (a < b ? -1 : 1);

async function sheets({ seconds, seeds, only, cpu, instances }) {
  const lines = [];
  for (const [n, file] of sheetFiles({ instances, only })) {
    const { known } = natively(file, { seconds: 0, seeds: 1 }, '--on')[0];
    const ours = Array.from({ length: seeds }, (_, k) => inWasm(file, { index: 0, known: null }, k + 1, { seconds, cpu }));
    const of = (key) => median(ours.map((r) => at(r, key)));
    const marks = MARKS.filter((m) => m <= seconds);
    lines.push([
      `sheet_${n}`, ms(1000 * median(ours.map((r) => r.trace[0][0]))), ...marks.map((m) => of(m).toFixed(1)),
      Math.min(...ours.map((r) => r.value)).toFixed(1), known.toFixed(1), percent(of(seconds), known),
      off(of(seconds), proven(file, seconds).get(`sheet_${n}`)),
      `${mb(Math.max(...ours.map((r) => r.memory)))} MB`,
    ]);
  }
  const marks = MARKS.filter((m) => m <= seconds).map((m) => `${m} s`);
  table(`Sheets in wasm, one worker: air length in mm, median of ${seeds} seeds`, ['', 'first plan', ...marks, 'best', 'best known before', 'median to it', 'above the bound', 'memory'], lines);
}

/** Perforated sheets, natively in one thread, compared with the nearest-next path and the best of some paths along the rows. */
async function grids({ seconds, seeds, only = '', cpu }) {
  const marks = [1, 5, 15].filter((m) => m <= seconds);
  const cases = Object.keys(PATTERNS).flatMap((name) => SIDES.map((side) => [name, side]));
  const lines = cases.filter(([name, side]) => `${name}_${side * side}`.includes(only)).map(([name, side]) => {
    const file = drawn(name, side);
    const [{ runs }] = natively(file, { seconds, seeds, cpu });
    rmSync(dirname(file), { recursive: true });
    const [hand, first] = [byHand(name, side), runs[0].trace[0][1]];
    const ours = marks.map((m) => median(runs.map((r) => at(r, m))));
    const line = [`${name}_${side * side}`, hand.toFixed(1), first.toFixed(1), ...ours.map((v) => v.toFixed(1)), percent(ours.at(-1) ?? first, first), percent(ours.at(-1) ?? first, hand)];
    console.log(line.join('  '));
    return line;
  });
  const columns = ['', 'by hand', 'nearest next', ...marks.map((m) => `${m} s`), 'to nearest next', 'to by hand'];
  table(`Perforated sheets natively: air length in mm, median of ${seeds} seeds`, columns, lines);
}

/** Large perforated sheets in the planner as it is shipped, one worker, in seconds of processor time. */
async function holes({ seconds }) {
  await buildAll();
  const marks = HOLE_MARKS.filter((m) => m <= seconds);
  const lines = [10_000, 100_000].map((count) => {
    const { read, first, air, memory } = rows(process.execPath, [join(HERE, 'holes.mjs'), String(count), String(seconds)])[0];
    const line = [String(count), `${read.toFixed(2)} s`, `${first.toFixed(2)} s`, `${(air[0] / 1000).toFixed(1)} m`, ...air.slice(1).map((mm) => percent(mm, air[0])), `${mb(memory)} MB`];
    console.log(line.join('  '));
    return line;
  });
  table('Holes in the planner as shipped, in wasm: air of the nearest-next path, and how it changes', ['holes', 'read', 'first path', 'nearest next', ...marks.slice(1).map((m) => `after ${m} s`), 'memory'], lines);
}

/** The sheets with parallel searches of the package, as many as there are cores. */
async function pool({ seconds, only, instances }) {
  await buildAll();
  const { plan } = await import(pathToFileURL(join(DIST, 'sdk', 'node.js')).href);
  const workers = availableParallelism();
  const lines = [];
  for (const [n, file] of sheetFiles({ instances, only })) {
    const { known } = natively(file, { seconds: 0, seeds: 1 }, '--on')[0];
    const options = { machine: 'length', layers: IGNORED, workers, seed: 1, seconds };
    const { summary } = await plan(readFileSync(file), options);
    lines.push([`sheet_${n}`, summary.air_length.toFixed(3), known.toFixed(3), percent(summary.air_length, known)]);
    console.log(lines.at(-1).join('  '));
  }
  table(`Sheets by the pool of the package under Node, ${workers} workers, ${seconds} s, seed 1: air length in mm`, ['', 'length', 'best known before', 'to it'], lines);
}

async function quDu({ seconds, seeds, only, cpu, instances }) {
  const file = instances.file('qu-du-43/qu_du_43.json');
  const bounds = proven(file, seconds);
  const wanted = natively(file, { seconds, seeds, cpu }).filter((source) => only === undefined || source.name.includes(only));
  const lines = wanted.map((source) => {
    const wasm = source.runs.map(({ seed }) => inWasm(file, source, seed, { seconds, cpu }));
    const reached = (runs) => `${runs.filter((r) => r.reached).length}/${runs.length}`;
    const found = (runs) => `${median(runs.map((r) => r.found)).toFixed(3)} s`;
    const best = Math.min(...wasm.map((r) => r.value));
    return [source.name, source.known.toFixed(3), best.toFixed(3), reached(source.runs), found(source.runs), reached(wasm), found(wasm), off(best, bounds.get(source.name))];
  });
  table('Qu & Du, 43 contours, fixed points: optima of benches/data/README.md', ['', 'optimum', 'best', 'natively', 'median', 'wasm', 'median', 'above the bound'], lines);
}

/** Seconds that the bound of a sheet is given, by its number of contours. */
const BOUNDED = { 100: 60, 500: 120, 2000: 300 };

/** The lower bound of the sheets as shipped, in wasm, by itself as in the worker beside a search, in seconds of processor time. */
async function bounds({ only, instances }) {
  await buildAll();
  const lines = sheetFiles({ instances, only }).filter(([n]) => n in BOUNDED).map(([n, file]) => {
    const { known } = natively(file, { seconds: 0, seeds: 1 }, '--on')[0];
    const { trace } = rows(process.execPath, [join(HERE, 'bounds.mjs'), file, String(BOUNDED[n])])[0];
    const shares = trace.map(([s, mm]) => `${((100 * mm) / known).toFixed(1)} % after ${s.toFixed(0)} s`);
    const line = [`sheet_${n}`, known.toFixed(1), shares.slice(-4, -1).join(', '), shares.at(-1)];
    console.log(line.join('  '));
    return line;
  });
  table('Lower bounds of the sheets in wasm: share of the best known air length', ['', 'best known', 'on the way', 'at the end'], lines);
}

/** The lower bounds of GTSPLIB's instances in wasm: by walks until they end, then by flows, within some seconds of processor time each. */
function boundsOfGtsplib({ seconds, only, instances }) {
  instances.file('gtsplib/best_known.json');
  const shares = [];
  const lines = instances.list('gtsplib', '.gtsp', only).sort(bySize).map((path) => {
    const file = instances.find(path);
    if (file === null) return [basename(path, '.gtsp'), NOT_RUN, ...Array(3).fill('')];
    const { known } = natively(file, { seconds: 0, seeds: 1 })[0];
    const found = rows(process.execPath, [join(HERE, 'instance-bounds.mjs'), file, String(known), String(seconds)])[0];
    const best = Math.max(found.walks.bound, found.flows?.bound ?? 0) / known;
    const cell = (kind) => (kind === null ? 'none' : `${kind.bound.toFixed(1)}, ${((100 * kind.bound) / known).toFixed(1)} % after ${kind.seconds.toFixed(1)} s`);
    const line = [basename(file, '.gtsp'), String(known), cell(found.walks), cell(found.flows), `${(100 * best).toFixed(1)} %`];
    shares.push(best);
    console.log(line.join('  '));
    return line;
  });
  if (shares.length > 0) lines.push([`mean of ${shares.length}`, '', '', '', `${(100 * mean(shares)).toFixed(1)} %`]);
  const columns = ['', 'best known', 'walks', 'proven by the certificate of the flows', 'the greater one'];
  table(`GTSPLIB: lower bounds in wasm within ${seconds} s of the processor`, columns, lines);
}

/** The search's own bound and that by stops, natively, as shares of the best value known. */
async function stops({ seconds, only = '', instances }) {
  const last = (file, flags, known, ...more) => {
    return boundsOf(file, ...flags, ...known, '--seconds', String(seconds), ...more).at(-1);
  };
  const share = ({ bound, known }) => bound / known;
  const pair = (file, flags, known) => [last(file, flags, known), last(file, flags, known, '--stops')];
  const lines = [];
  const add = (name, pairs) => {
    const shares = [0, 1].map((k) => `${(100 * mean(pairs.map((p) => share(p[k])))).toFixed(1)} %`);
    lines.push([name, String(pairs.length), ...shares, `${mean(pairs.map((p) => p[1].seconds)).toFixed(1)} s`]);
    console.log(lines.at(-1).join('  '));
  };
  for (const [group, all] of partial()) {
    if (group.includes(only)) add(group, all.map(({ file, flags, known }) => pair(file, flags, ['--upper', String(known)])));
  }
  for (const [n, file] of sheetFiles({ instances, only })) {
    if (n <= 500) add(`sheet_${n}, partial cutting`, [pair(file, ['--machine', 'length-partial'], ['--search', '3000000'])]);
  }
  for (const { name, file, flags } of plates()) {
    if (name.includes(only)) add(name, [pair(file, flags, ['--search', '1000000'])]);
  }
  table(`Contours that may be left, and pierce groups: mean share of the best value known after ${seconds} s`, ['', 'instances', 'bound of the search', 'bound by stops', 'time'], lines);
}

function library(set, extension, options, baselines) {
  const { seconds, seeds, only, instances } = options;
  const gaps = [];
  const behind = [];
  const solvers = baselines ? SOLVERS.filter((s) => ask(PYTHON, '-c', `import ${s}`) !== null) : [];
  if (baselines && solvers.length < SOLVERS.length) {
    console.log(`bench: other solvers do not run, because ${PYTHON} lacks their modules: ${SOLVERS.filter((s) => !solvers.includes(s)).join(', ')}`);
  }
  instances.file(`${set}/best_known.json`);
  const lines = instances.list(set, extension, only).sort(bySize).map((path) => {
    const file = instances.find(path);
    if (file === null) return [basename(path, extension), NOT_RUN, ...Array(6 + solvers.length).fill('')];
    const [source] = natively(file, options);
    const wasm = inWasm(file, source, 1, options);
    const values = source.runs.map((r) => r.value);
    gaps.push(...values.map((v) => (100 * (v - source.known)) / source.known));
    const others = solvers.map((solver) => {
      const row = baseline(file, solver, seconds);
      if (typeof row?.length !== 'number') return 'none';
      // The worst seed, natively, after the seconds of the other solver, which ends by itself or at the limit.
      const then = Math.max(...source.runs.map((r) => at(r, row.seconds)));
      if (then > row.length + 1e-6) behind.push(`${basename(file)}: ${solver}`);
      return `${percent(row.length, source.known)} in ${row.seconds} s, ours then ${percent(then, source.known)}`;
    });
    const line = [
      basename(file, extension), String(source.known), `${source.runs.filter((r) => r.reached).length}/${values.length}`,
      percent(Math.min(...values), source.known), percent(mean(values), source.known),
      `${median(source.runs.map((r) => r.found)).toFixed(2)} s`, percent(wasm.value, source.known), off(Math.min(...values), proven(file, seconds).get(source.name)), ...others,
    ];
    console.log(line.join('  '));
    return line;
  });
  const columns = ['', 'best known', 'reached', 'best', 'mean', 'median found', 'wasm, seed 1', 'above the bound', ...solvers];
  table(`${set}: gap to the best known after ${seconds} s, ${seeds} seeds`, columns, lines);
  if (gaps.length === 0) return;
  const reached = gaps.filter((g) => g <= 1e-6).length;
  console.log(`reached ${reached} of ${gaps.length} runs, mean gap ${mean(gaps).toFixed(4)} %`);
  if (solvers.length > 0) console.log(`a seed behind another solver in the same time: ${behind.join(', ') || 'none'}`);
}

/** Compares the time of a move in wasm and natively, in alternating runs, on sheets of growing size. */
async function scaling({ seeds, only, cpu, instances }) {
  const MOVES = 8_000_000;
  const lines = sheetFiles({ instances, only }).map(([, file]) => {
    const work = (r) => r.seconds - r.trace[0][0];
    const fixed = [file, '--moves', String(MOVES), '--seeds', '1', '--on', '--json', ...(cpu ? ['--cpu'] : [])];
    const runs = Array.from({ length: seeds }, (_, k) => [
      rows(NATIVE, [...fixed, '--first', String(k + 1)])[0],
      inWasm(file, { index: 0, known: null }, k + 1, { seconds: Infinity, cpu }, MOVES),
    ]);
    const same = runs.every(([native, wasm]) => native.value === wasm.value) ? 'yes' : 'NO';
    const [a, b] = [0, 1].map((k) => median(runs.map((run) => work(run[k]))));
    return [basename(file, '.dxf'), `${((1e9 * a) / MOVES).toFixed(0)} ns`, `${((1e9 * b) / MOVES).toFixed(0)} ns`, (b / a).toFixed(2), same];
  });
  table(`${MOVES / 1e6} million moves, median of ${seeds} seeds: time of a move, and whether both find the same value`, ['', 'natively', 'wasm', 'ratio', 'same'], lines);
}
