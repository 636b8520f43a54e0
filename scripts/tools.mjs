// What the set-up, build and test scripts share: where things are, and how a command is run.
// Plain Node, nothing to install: these scripts run before node_modules exists.

import { spawn, spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { homedir } from 'node:os';
import { delimiter, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const ROOT = dirname(dirname(fileURLToPath(import.meta.url)));
export const DIST = join(ROOT, 'dist');
/** Where cargo compiles, and where it compiles something else at the same time, because it locks its folder. */
export const COMPILING = process.env.CARGO_TARGET_DIR ?? join(ROOT, 'target');
export const BESIDE = join(COMPILING, 'beside');

const cargoHome = process.env.CARGO_HOME ?? join(homedir(), '.cargo');
/** Tools that must not replace the person's own of another version. */
export const LOCAL_TOOLS = join(ROOT, '.setup');

/** Our own tools first, then those of npm packages (wasm-opt), then cargo's, then the person's path. */
export const ENV = {
  ...process.env,
  PATH: [
    join(LOCAL_TOOLS, 'bin'),
    join(ROOT, 'node_modules', '.bin'),
    process.env.PATH ?? '',
    join(cargoHome, 'bin'),
  ].join(delimiter),
};

// npm and the tools of npm packages are .cmd files on Windows, which only a shell can start.
const shell = process.platform === 'win32';

/** A failure that is reported in one sentence, without a stack trace. */
export class Stop extends Error {}

/** Output of a command, or null when it is missing or fails. */
export function ask(command, ...args) {
  const r = spawnSync(command, args, { env: ENV, cwd: ROOT, encoding: 'utf8', shell });
  return r.status === 0 ? r.stdout.trim() : null;
}

/** Runs a command with its output shown; stops with a sentence when it fails. */
export function run(command, args, options = {}) {
  const r = spawnSync(command, args, { env: ENV, cwd: ROOT, stdio: 'inherit', shell, ...options });
  if (r.error) throw new Stop(`${command} could not be started: ${r.error.message}`);
  if (r.status !== 0) throw new Stop(`${command} ${args.join(' ')} ended with ${r.status ?? r.signal}`);
}

/** Runs a command, shows its output and returns it with the exit code. */
export function tee(command, args, env = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(command, args, {
      env: { ...ENV, ...env },
      cwd: ROOT,
      stdio: ['ignore', 'pipe', 'pipe'],
      shell,
    });
    let text = '';
    child.stdout.on('data', (d) => ((text += d), process.stdout.write(d)));
    child.stderr.on('data', (d) => ((text += d), process.stderr.write(d)));
    child.on('error', reject);
    child.on('close', (code, signal) => resolve({ code: code ?? 1, signal, text }));
  });
}

/** Where the first of these programs is, looked for on the path; whole paths are taken as they are. */
export function firstOf(programs) {
  const folders = ENV.PATH.split(delimiter);
  const places = programs.flatMap((p) => (/[\\/]/.test(p) ? [p] : folders.map((folder) => join(folder, p))));
  return places.find((place) => existsSync(place));
}

/** Runs a script's main function; a `Stop` is one sentence and exit code 1. */
export async function main(body) {
  try {
    await body();
  } catch (error) {
    if (!(error instanceof Stop)) throw error;
    console.error(`\n${error.message}`);
    process.exitCode = 1;
  }
}
