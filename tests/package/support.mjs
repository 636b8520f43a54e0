// Helpers of the package tests: fixtures, the command line, temporary folders.

import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before } from 'node:test';
import { fileURLToPath } from 'node:url';

export const ROOT = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
export const CLI = join(ROOT, 'dist', 'sdk', 'cli.js');

/** Path of a fixture. */
export const fixture = (name) => join(ROOT, 'tests', 'fixtures', name);

/** Bytes of a fixture. */
export const bytes = (name) => new Uint8Array(readFileSync(fixture(name)));

/** A real keyboard case: 25 kB, circles, arcs and polylines. */
export const KEYBOARD = 'dxf-dev/peej_lumberjack-keyboard__lumberjack-polaris.dxf';

/** Runs the command line. */
export function kerfway(...args) {
  return ran([CLI, ...args]);
}

/** The same with bytes on standard input. */
export const piped = (input, ...args) => ran([CLI, ...args], input);

/** Runs a program of Node; resolves to its exit code and both outputs. */
export function ran(words, input = null) {
  return new Promise((resolve) => {
    const child = spawn(process.execPath, words, { stdio: [input === null ? 'ignore' : 'pipe', 'pipe', 'pipe'] });
    if (input !== null) child.stdin.end(input);
    const out = { code: null, stdout: '', stderr: '' };
    child.stdout.on('data', (d) => (out.stdout += d));
    child.stderr.on('data', (d) => (out.stderr += d));
    child.on('close', (code) => resolve({ ...out, code }));
  });
}

/** A folder for one test, which is removed after it. */
export function folder(t) {
  const path = mkdtempSync(join(tmpdir(), 'kerfway-'));
  t.after(() => rmSync(path, { recursive: true, force: true }));
  return path;
}

/** What the tests of a suite share: it is made before the first, by a function that takes a test, and what that leaves to be done is done after the last. */
export function shared(make) {
  const made = {};
  const ends = [];
  before(async () => Object.assign(made, await make({ after: (end) => ends.unshift(end) })));
  after(async () => {
    for (const end of ends) await end();
  });
  return made;
}

/** A DXF file in millimetres of some entities, each given as its group codes and values. */
export function dxf(...entities) {
  return groupsOf([0, 'SECTION'], [2, 'HEADER'], [9, '$INSUNITS'], [70, 4], [0, 'ENDSEC'], ...entitiesOf(entities));
}

/** The same without a unit. */
export const unitless = (...entities) => groupsOf(...entitiesOf(entities));

const entitiesOf = (entities) => [[0, 'SECTION'], [2, 'ENTITIES'], ...entities.flat(), [0, 'ENDSEC'], [0, 'EOF']];

function groupsOf(...groups) {
  return new TextEncoder().encode(groups.map(([code, value]) => `${code}\n${value}\n`).join(''));
}

export const line = (x0, y0, x1, y1, layer = '0') => [
  [0, 'LINE'], [8, layer], [10, x0], [20, y0], [11, x1], [21, y1],
];
export const circle = (x, y, r, layer = '0') => [[0, 'CIRCLE'], [8, layer], [10, x], [20, y], [40, r]];
/** A closed outline through some points. */
export const polygon = (points, layer = '0') => points.flatMap(([x, y], k) => line(x, y, ...points[(k + 1) % points.length], layer));
export const square = (x, y, side, layer = '0') => [
  ...line(x, y, x + side, y, layer),
  ...line(x + side, y, x + side, y + side, layer),
  ...line(x + side, y + side, x, y + side, layer),
  ...line(x, y + side, x, y, layer),
];

/** Packs the package into a folder, as it would be published; returns npm's description of the tarball. */
export function pack(at) {
  const options = { cwd: ROOT, encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] };
  return JSON.parse(execFileSync('npm', ['pack', '--json', '--pack-destination', at], options))[0];
}

/** Makes the folder a project and installs a tarball in it, as a user would, without the network. */
export function install(at, tarball) {
  writeFileSync(join(at, 'package.json'), '{ "type": "module", "private": true }');
  execFileSync('npm', ['install', '--offline', '--no-audit', '--no-fund', `./${tarball}`], { cwd: at, stdio: ['ignore', 'ignore', 'ignore'] });
}

/** A plate of 100 mm with a hole of radius 10 in its middle, and a marked circle beside it. */
export const PLATE = dxf(square(0, 0, 100), circle(50, 50, 10), circle(150, 50, 5, 'MARK'));
export const PLATE_OPTIONS = { units: 'mm', layers: [{ name: 'MARK', operation: 'mark' }] };

/** A search that would run for a minute. */
export const LONG = { seconds: 60, seed: 1, allowOffBed: true };
