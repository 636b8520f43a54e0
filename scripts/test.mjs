// npm test: sets up, builds and runs every test there is. npm run check: formatting, lints, native tests and types, for
// between two edits. The last line counts passed, failed and skipped tests.

import { readdirSync } from 'node:fs';
import { basename, join, relative } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build, wasmFiles } from './build.mjs';
import { findShell, setup } from './setup.mjs';
import { quietly, sinceStart, together } from './together.mjs';
import { BESIDE, COMPILING, main, ROOT, tee } from './tools.mjs';

const DENY = ['--', '-D', 'warnings'];
const WASM = ['--target', 'wasm32-unknown-unknown'];
// The native tests read files, which wasm cannot: it has a test binary of its own.
const WASM_TESTS = ['--lib', '--test', 'wasm'];

const CLIPPY = ['clippy', '--locked', '--all-targets', '--features', 'png', ...DENY];
const FORMAT = command('Rust formatting', 'cargo', ['fmt', '--check']);
const TESTS = command('Rust tests', 'cargo', ['test', '--locked', '--features', 'png', '--no-fail-fast']);

const LINTS = [
  ['clippy', CLIPPY],
  // Nothing runs the benches here, so that at least they must compile.
  ...['intake', 'solve'].map((bench) => [
    `bench ${bench} compiles`,
    ['check', '--locked', '--all-targets', '--manifest-path', join(ROOT, 'benches', bench, 'Cargo.toml'), '--target-dir', COMPILING],
  ]),
].map(lint);

const LINTS_IN_WASM = [
  ['core', ['--lib', '--no-default-features', '--features', 'planner']],
  ['writers of outputs', ['--lib', '--no-default-features', '--features', 'outputs']],
  ['research build and its tests', WASM_TESTS],
].map(([what, of]) => lint([`clippy of the ${what}, in wasm`, ['clippy', '--locked', ...WASM, ...of, '--target-dir', BESIDE, ...DENY]]));

// wasm-pack builds the tests before it runs them: with the profile of the run, so that they are compiled once.
// Without optimisation: that saves about 100 s of compiling, and the tests then take 18 s instead of 2.
const TESTS_IN_WASM = command('wasm tests under Node', 'wasm-pack', ['test', '--node', '--mode', 'no-install', '--', '--locked', '--test', 'wasm', '--profile', 'test'], { CARGO_PROFILE_TEST_OPT_LEVEL: '0' });

/**
 * V8 compiles a function of a wasm file anew, as fast code, when that much of it has run: here 33 times as much as usual. Most tests end within a
 * second, in which optimising costs more than it saves: commands take 40 % less of the processor, pages 8 % less, and searches of some seconds no more.
 */
const LATE = '--wasm-tiering-budget=60000000';
const OPTIMISED_LATE = { KERFWAY_V8: LATE, NODE_OPTIONS: `${process.env.NODE_OPTIONS ?? ''} --import ${pathToFileURL(join(ROOT, 'scripts', 'v8.mjs'))}` };

/** Tests that look at what the page does by the clock: no other test runs beside them, and nothing differs from what users have. */
const BY_THE_CLOCK = ['page-speed.test.mjs', 'page-visit.test.mjs'];

/** The tests of what was built. The set-up may have brought in their browser. */
function ofTheBuild() {
  const shell = findShell();
  const browser = { ...OPTIMISED_LATE, ...(shell === undefined ? {} : { CHROME_PATH: shell }) };
  return [
    node('package tests', 2, testFiles('package'), OPTIMISED_LATE),
    node('browser tests', 2, testFiles('browser').filter((f) => !BY_THE_CLOCK.includes(basename(f))), browser),
    node('browser tests by the clock', 1, testFiles('browser').filter((f) => BY_THE_CLOCK.includes(basename(f)))),
  ];
}

const TYPES = [
  step('wasm files, quick', () => wasmFiles({ quick: true })),
  command('types of the package', 'tsc', ['-p', join(ROOT, 'www', 'sdk')]),
  command('types of the page', 'tsc', ['-p', join(ROOT, 'www', 'app')]),
];

main(async () => {
  const quick = process.argv.includes('--check');
  await setup({ tests: !quick });
  const results = [];
  const all = async (steps) => {
    for (const { name, work } of steps) {
      console.log(`\n== ${name}`);
      const begun = Date.now();
      results.push({ name, ...(await work()), seconds: Math.round((Date.now() - begun) / 1000) });
    }
  };
  await all([FORMAT]);
  if (quick) await all([command('clippy', 'cargo', CLIPPY), TESTS, ...TYPES]);
  else {
    // A crate is checked on one core.
    await together([
      { name: 'lints and benches', usually: '1 to 2 minutes', work: () => all(LINTS) },
      { name: 'lints in wasm', usually: '1 to 2 minutes', work: () => all(LINTS_IN_WASM) },
    ]);
    await all([TESTS, TESTS_IN_WASM, step('build', build)]);
    if (results.at(-1).failed === 0) await all(ofTheBuild());
    else results.push({ name: 'package and browser tests, not run without a build', passed: 0, failed: 1, skipped: 0, seconds: 0 });
  }
  console.log('');
  for (const r of results) console.log(`${r.failed === 0 ? 'ok    ' : 'FAILED'}${String(r.seconds).padStart(6)} s  ${r.name}${counts(r)}`);
  const sum = (key) => results.reduce((n, r) => n + r[key], 0);
  for (const r of results) for (const name of r.names ?? []) console.log(`       failed: ${name}`);
  for (const r of results) for (const name of r.late ?? []) console.log(`       passed when run again: ${name}`);
  console.log(`\nAfter ${sinceStart()}:\n${sum('passed')} passed, ${sum('failed')} failed, ${sum('skipped')} skipped`);
  if (sum('failed') > 0) process.exitCode = 1;
});

/** A step that runs a command and counts the tests it reports; a command without tests, such as a linter, counts as one. */
function command(name, program, args, env = {}) {
  const work = async () => {
    const { code, text } = await tee(program, args, env);
    const plain = text.replace(/\x1b\[[0-9;]*m/g, '');
    const rust = [...plain.matchAll(/^test result: \w+\. (\d+) passed; (\d+) failed; (\d+) ignored/gm)].map((m) => m.slice(1, 4).map(Number));
    const node = ['pass', 'fail', 'skipped'].map((k) => Number(new RegExp(`^\\S+ ${k} (\\d+)$`, 'm').exec(plain)?.[1] ?? 0));
    const [passed, failed, skipped] = [...rust, node].reduce((sum, counts) => sum.map((n, k) => n + counts[k]), [0, 0, 0]);
    if (code === 0) return { passed: passed || 1, failed, skipped };
    // The file of each failure, as the runner of Node prints it.
    const at = [...plain.matchAll(/^test at (\S+?):\d+:\d+$/gm)].map((m) => m[1]);
    return { passed, failed: failed || 1, skipped, names: failures(plain), at };
  };
  return { name, work };
}

/** The names of the tests that failed, as the runners of Rust and Node print them: they stand again at the end of a long output. */
function failures(text) {
  return [...new Set([...text.matchAll(/^test (\S+) \.\.\. FAILED$|^\s*✖ (.+?) \([\d.]+ms\)$/gm)].map((m) => m[1] ?? m[2]))];
}

/**
 * Test files, so many of them at the same time: most wait for a browser or a program they have started. Files with a failed test are run once more, alone: on
 * a machine that others use too, a finger or a click can come later than the page expects. The last lines name what passed only then.
 */
function node(name, atOnce, files, env = {}) {
  const run = (files, atOnce) => command(name, 'node', ['--test', '--test-reporter=spec', `--test-concurrency=${atOnce}`, ...files], env).work();
  const work = async () => {
    const first = await run(files, atOnce);
    const again = files.filter((file) => first.at?.includes(relative(ROOT, file)));
    // A failure without a place, such as a file that cannot be read, stays one.
    if (again.length === 0 || first.at.length < first.failed) return first;
    console.log(`\n== ${name}, again: ${again.map((file) => basename(file)).join(', ')}`);
    const second = await run(again, 1);
    const late = first.names.filter((test) => !second.names?.includes(test));
    return { ...first, passed: first.passed + first.failed - second.failed, failed: second.failed, names: second.names, late };
  };
  return { name, work };
}

/** A step of cargo that runs beside others: what it prints is shown if it fails. */
function lint([name, args]) {
  return step(name, () => quietly('cargo', args));
}

/** A step of our own scripts, which counts as one test. */
function step(name, body) {
  const work = async () => {
    try {
      await body();
      return { passed: 1, failed: 0, skipped: 0 };
    } catch (error) {
      console.error(error.message);
      return { passed: 0, failed: 1, skipped: 0 };
    }
  };
  return { name, work };
}

function counts({ passed, failed, skipped }) {
  if (passed + failed + skipped <= 1) return '';
  return ` (${passed} passed, ${failed} failed${skipped > 0 ? `, ${skipped} skipped` : ''})`;
}

function testFiles(folder) {
  const at = join(ROOT, 'tests', folder);
  return readdirSync(at).filter((f) => /\.test\.m?js$/.test(f)).map((f) => join(at, f));
}
