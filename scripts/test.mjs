// npm test: sets up, builds and runs every test there is; the last line counts them.

import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { build } from './build.mjs';
import { setup } from './setup.mjs';
import { main, ROOT, tee } from './tools.mjs';

// The native tests read files, which wasm has none of: it has its own.
const WASM = ['--target', 'wasm32-unknown-unknown', '--lib', '--test', 'wasm'];
const DENY = ['--', '-D', 'warnings'];

const CHECKS = [
  ['Rust formatting', 'cargo', ['fmt', '--check']],
  ['clippy', 'cargo', ['clippy', '--locked', '--all-targets', ...DENY]],
  ['clippy, PNG renderer', 'cargo', ['clippy', '--locked', '--all-targets', '--features', 'png', ...DENY]],
  ['clippy, wasm', 'cargo', ['clippy', '--locked', ...WASM, '--features', 'lab', ...DENY]],
  ['Rust tests', 'cargo', ['test', '--locked', '--features', 'png', '--no-fail-fast']],
  ['wasm tests under Node', 'wasm-pack', ['test', '--node', '--mode', 'no-install', '--', '--locked', '--test', 'wasm']],
];

const AFTER_BUILD = [
  ['package tests', 'node', ['--test', '--test-reporter=spec', ...testFiles('package')]],
  ['browser tests', 'node', ['--test', '--test-reporter=spec', '--test-concurrency=1', ...testFiles('browser')]],
];

main(async () => {
  await setup({ tests: true });
  const results = [];
  for (const step of CHECKS) results.push(await check(step));
  results.push(await attempt('build', build));
  if (results.at(-1).failed === 0) for (const step of AFTER_BUILD) results.push(await check(step));
  else results.push({ name: 'package and browser tests, not run without a build', passed: 0, failed: 1 });

  console.log('');
  for (const r of results) console.log(`${r.failed === 0 ? 'ok    ' : 'FAILED'}  ${r.name}${counts(r)}`);
  const sum = (key) => results.reduce((n, r) => n + r[key], 0);
  console.log(`\n${sum('passed')} passed, ${sum('failed')} failed`);
  if (sum('failed') > 0) process.exitCode = 1;
});

/** Runs one command and counts the tests it reports; one without tests (a linter) counts as one. */
async function check([name, command, args]) {
  console.log(`\n== ${name}`);
  const { code, text } = await tee(command, args);
  const plain = text.replace(/\x1b\[[0-9;]*m/g, '');
  const rust = [...plain.matchAll(/^test result: \w+\. (\d+) passed; (\d+) failed/gm)];
  const node = [['pass', 'fail'].map((k) => Number(new RegExp(`^\\S+ ${k} (\\d+)$`, 'm').exec(plain)?.[1] ?? 0))];
  const all = [...rust.map((m) => [Number(m[1]), Number(m[2])]), ...node];
  const [passed, failed] = all.reduce(([p, f], [a, b]) => [p + a, f + b], [0, 0]);
  if (code === 0) return { name, passed: passed || 1, failed };
  return { name, passed, failed: failed || 1 };
}

async function attempt(name, body) {
  console.log(`\n== ${name}`);
  try {
    await body();
    return { name, passed: 1, failed: 0 };
  } catch (error) {
    console.error(error.message);
    return { name, passed: 0, failed: 1 };
  }
}

function counts({ passed, failed }) {
  return passed + failed > 1 ? ` (${passed} passed, ${failed} failed)` : '';
}

function testFiles(folder) {
  const at = join(ROOT, 'tests', folder);
  return readdirSync(at).filter((f) => /\.test\.m?js$/.test(f)).map((f) => join(at, f));
}
