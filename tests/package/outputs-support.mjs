// Helpers of the tests of outputs: the command line under faults, its inputs, and small disks.

import assert from 'node:assert/strict';
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import { chmodSync, closeSync, mkdtempSync, openSync, rmdirSync, rmSync, writeFileSync, writeSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { CLI, dxf, folder, ROOT, square } from './support.mjs';

export const POSIX = process.platform !== 'win32';
export const ROOT_USER = POSIX && process.getuid() === 0;
/** A user without permissions. */
export const NOBODY = 65_534;

export const OLD = 'the old program, whole\n';
/** Contours of many sizes, so that every output is longer than a page of memory. */
export const contours = (count) => dxf(...Array.from({ length: count }, (_, k) => square(30 * (k % 16), 30 * Math.floor(k / 16), 10 + k / 20)));
const DRAWING = contours(120);
const CITIES = Array.from({ length: 1500 }, (_, k) => `${k + 1} ${(k * 7919) % 1009} ${(k * 104_729) % 997}`);
const PROGRAM = 'G21 G90\nM4 S0\nG0 X10 Y10\nG1 X20 S500 F600\nM5 S0\nM2\n';
const INSTANCE = `NAME: t\nTYPE: TSP\nDIMENSION: ${CITIES.length}\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n${CITIES.join('\n')}\nEOF\n`;
export const QUICK = ['--moves', '5', '--seed', '1'];

/** Runs the command line, if needed through other programs; resolves to its exit code or signal and its messages. */
export function run(args, { before = [], env = {}, preload = [], ...options } = {}) {
  const [program, ...words] = [...before, process.execPath, ...preload, CLI, ...args];
  return new Promise((resolve) => {
    const child = spawn(program, words, { stdio: ['ignore', 'pipe', 'pipe'], env: { ...process.env, ...env }, ...options });
    const out = { stdout: '', stderr: '' };
    child.stdout?.on('data', (d) => (out.stdout += d));
    child.stderr.on('data', (d) => (out.stderr += d));
    child.on('close', (code, signal) => resolve({ ...out, code, signal }));
  });
}

/** A folder with the inputs. */
export function inputs(t) {
  const at = folder(t);
  chmodSync(at, 0o755);
  writeFileSync(join(at, 'a.dxf'), DRAWING);
  writeFileSync(join(at, 'a.tsp'), INSTANCE);
  writeFileSync(join(at, 'a.ngc'), PROGRAM);
  const planned = (output) => execFileSync(process.execPath, [CLI, 'plan', join(at, 'a.dxf'), ...QUICK, output, '-'], { stdio: ['ignore', 'pipe', 'ignore'], maxBuffer: 2 ** 26 });
  writeFileSync(join(at, 'plan.json'), (plan ??= planned('--json')));
  writeFileSync(join(at, 'a.certificate.json'), (certificate ??= planned('--certificate')));
  return at;
}

/** The plan of the drawing and its certificate, made once. */
let plan, certificate;

export const refused = ({ code, stderr }, why) => {
  assert.equal(code, 3, stderr);
  assert.match(stderr, new RegExp(`^kerfway: \\S+ cannot be written: ${why}\\. No file was changed\\. [A-Z][^\\n]*\\.\\n$`));
};

export const faulty = (fault, more = {}) => ({
  preload: ['--import', pathToFileURL(join(ROOT, 'tests', 'package', 'faulty-disk.mjs')).href],
  env: { FAULT: fault, ...more },
});

/** A separate disk of this many pages, or the reason why it cannot be made. */
export function disk(t, pages) {
  const at = mkdtempSync(join(tmpdir(), 'kerfway-'));
  const options = `size=${pages * 4096}`;
  const mounted = ROOT_USER && process.platform === 'linux' && spawnSync('mount', ['-t', 'tmpfs', '-o', options, 'tmpfs', at]).status === 0;
  t.after(() => {
    if (mounted) execFileSync('umount', ['--lazy', at]);
    rmdirSync(at);
  });
  return mounted ? at : null;
}

/** Fills a disk; returns a function that empties it again. */
export function fill(at) {
  const filler = join(at, 'filler');
  const file = openSync(filler, 'w');
  for (const size of [4096, 1]) {
    try {
      for (;;) writeSync(file, Buffer.alloc(size));
    } catch (error) {
      assert.equal(error.code, 'ENOSPC');
    }
  }
  closeSync(file);
  return () => rmSync(filler);
}
