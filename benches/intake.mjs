// How fast drawings come in: reading beside the `dxf` crate, assembling and nesting, and the time to a first plan.
// Everything in wasm under Node, as in a browser: processor time, which a busy machine changes little; reading also
// natively, by the clock. Medians of repeated runs.

import { mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { build } from '../scripts/build.mjs';
import { setup } from '../scripts/setup.mjs';
import { DIST, ROOT, run } from '../scripts/tools.mjs';
import { drawing } from './intake/drawing.mjs';
import { hostile } from './intake/hostile.mjs';
import { paths } from './intake/paths.mjs';
import { mb, median, ms, rows, table } from './common/table.mjs';

const HERE = join(ROOT, 'benches', 'intake');
const SHEETS = join(ROOT, 'tests', 'fixtures', 'sheets');
const RUNS = 7;
const ENTITIES = 63_000;
const SEED = 1;
const SVG_BYTES = 20 << 20;

/** What the figures should stay below. */
const TARGETS = { read: 500, svg: 1000, memory: 250, assemble: 1000, hostile: 1000 };

export async function bench() {
  await setup();
  await build();
  // Not --locked: the lock file of this crate follows the dependencies of ours.
  console.log('bench: the readers side by side');
  run('wasm-pack', [
    ...['build', HERE, '--release', '--target', 'web', '--mode', 'no-install', '--no-pack'],
    ...['--out-dir', join(DIST, 'bench-intake'), '--out-name', 'intake'],
  ]);
  run('cargo', ['build', '--release', '--manifest-path', join(HERE, 'Cargo.toml')]);

  const folder = mkdtempSync(join(tmpdir(), 'kerfway-bench-'));
  try {
    const large = join(folder, 'large.dxf');
    writeFileSync(large, drawing(ENTITIES, SEED));
    reading(large);
    readingSvg(folder);
    assembling(join(SHEETS, 'sheet_10000.dxf'));
    planning();
    enduring(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

function reading(file) {
  const ours = measure('kerfway', file);
  const theirs = measure('dxf', file);
  const native = outside(join(HERE, 'target', 'release', 'kerfway-bench-intake'), [file, String(RUNS)]);
  const row = (name, wasm, times) => [
    name,
    wasm.found > 0 ? ms(median(wasm.times)) : 'refused',
    `${mb(wasm.memory)} MB`,
    ms(median(times)),
  ];
  table(`Reading ${ENTITIES} entities, ${mb(statSync(file).size)} MB`, ['', 'wasm', 'wasm memory', 'native'], [
    row('kerfway (geometry in mm)', ours, native.kerfway),
    row('dxf 0.6.2 (entities as written)', theirs, native.dxf),
    ['ratio', ratio(theirs.times, ours.times), (theirs.memory / ours.memory).toFixed(1), ratio(native.dxf, native.kerfway)],
    ['target', ms(TARGETS.read), `${TARGETS.memory} MB`, ''],
  ]);
}

function readingSvg(folder) {
  const lines = Object.entries(paths).map(([name, text]) => {
    const file = join(folder, 'paths.svg');
    writeFileSync(file, text(SVG_BYTES, SEED));
    const { times, found, memory } = measure('svg', file);
    return [name, String(found), ms(median(times)), `${mb(memory)} MB`];
  });
  table(`Reading ${mb(SVG_BYTES)} MB of SVG paths in wasm`, ['', 'lines and arcs', 'wasm', 'wasm memory'], [...lines, ['target', '', ms(TARGETS.svg), '']]);
}

function assembling(file) {
  const wasm = measure('assemble', file);
  const native = outside(join(HERE, 'target', 'release', 'kerfway-bench-intake'), [file, String(RUNS)]);
  table('Joining, cleaning and nesting 10,000 contours', ['', 'contours', 'wasm', 'native'], [
    ['kerfway', String(wasm.found), ms(median(wasm.times)), ms(median(native.assemble))],
    ['target', '', ms(TARGETS.assemble), ''],
  ]);
}

function planning() {
  const sheets = [100, 500, 2000, 10000].map((n) => {
    const runs = [1, 2, 3].map(() => measure('plan', join(SHEETS, `sheet_${n}.dxf`)));
    const of = (key) => median(runs.map((r) => r[key]));
    const { contours, drawnSeconds, firstSeconds, seconds, memory } = runs[0];
    const machine = [drawnSeconds, firstSeconds, seconds].map((v) => `${v.toFixed(1)} s`);
    return [`sheet_${n}`, String(contours), ms(of('load')), ms(of('first')), ms(of('search')), ...machine, `${mb(memory)} MB`];
  });
  const columns = ['contours', 'loaded', 'first plan', 'then 100,000 moves', 'as drawn', 'first', 'best', 'wasm memory'];
  table('Four sheets: from bytes to a first plan, then a search', ['', ...columns], sheets);
}

function enduring(folder) {
  const lines = Object.entries(hostile).map(([name, text]) => {
    const path = join(folder, 'hostile.dxf');
    writeFileSync(path, text());
    const { times, found } = measure('hostile', path);
    return [name, ms(median(times)), found];
  });
  table('Files made to hang a reader, through contours and parts', ['', 'wasm', 'ends with'], [
    ...lines,
    ['target', ms(TARGETS.hostile), ''],
  ]);
}

/** One case in a process of its own. */
function measure(kind, file) {
  return outside(process.execPath, [join(HERE, 'measure.mjs'), kind, file, String(RUNS)]);
}

const outside = (command, args) => rows(command, args)[0];

const ratio = (a, b) => (median(a) / median(b)).toFixed(1);
