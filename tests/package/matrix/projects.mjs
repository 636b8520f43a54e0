// Makes fixture projects: the tarball of the package and what else the project needs, installed as a user would.

import { execFile } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { promisify } from 'node:util';
import { fixture, KEYBOARD, pack } from '../support.mjs';

const run = promisify(execFile);
let tarball = null;
let folder = null;

/** The drawing that every project quotes, and with what. */
export const OPTIONS = { name: 'keyboard.dxf', moves: 1000, seed: 1 };

/** The tarball, packed once for all projects. */
function packed() {
  if (tarball === null) {
    folder = mkdtempSync(join(tmpdir(), 'kerfway-tarball-'));
    tarball = join(folder, pack(folder).filename);
    process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  }
  return tarball;
}

/** A project with these dependencies, by name and version, and files. */
export async function project(t, { dependencies = {}, files, type }) {
  const at = mkdtempSync(join(tmpdir(), 'kerfway-matrix-'));
  t.after(() => rmSync(at, { recursive: true, force: true }));
  const packageJson = { name: 'fixture', private: true, ...(type === undefined ? {} : { type }), dependencies: { ...dependencies, kerfway: `file:${packed()}` } };
  for (const [name, content] of Object.entries({ 'package.json': JSON.stringify(packageJson), ...files })) {
    mkdirSync(dirname(join(at, name)), { recursive: true });
    writeFileSync(join(at, name), content);
  }
  cpSync(fixture(KEYBOARD), join(at, 'keyboard.dxf'));
  await run('npm', ['install', '--no-audit', '--no-fund', '--prefer-offline', '--loglevel=error'], { cwd: at, maxBuffer: 2 ** 26 });
  return {
    at,
    /** Runs a program of the project and resolves to what it prints. */
    run: async (program, ...args) => (await run(program, args, { cwd: at, maxBuffer: 2 ** 26, env: { ...process.env, NEXT_TELEMETRY_DISABLED: '1', CI: '1' } })).stdout.trim(),
    bin: (name) => join(at, 'node_modules', '.bin', name),
  };
}
