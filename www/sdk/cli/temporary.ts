/**
 * Temporary files. They are removed when the program ends, even if a signal ends it. Only SIGKILL, which no program can
 * handle, leaves them behind.
 */

import { randomBytes } from 'node:crypto';
import { rmSync } from 'node:fs';
import { dirname, join } from 'node:path';

const SIGNALS = ['SIGINT', 'SIGTERM', 'SIGHUP'] as const;

/** The temporary files that may exist now. */
const files = new Set<string>();

/** A new name in the folder of a file. It is hidden and does not match patterns of drawings. */
export function temporaryBeside(path: string): string {
  const name = join(dirname(path), `.kerfway-${randomBytes(8).toString('hex')}.tmp`);
  track(name);
  return name;
}

/** From now on a file is removed when the program ends. */
export function track(file: string): void {
  files.add(file);
}

/** Removes a temporary file, if it is there. */
export function remove(file: string): void {
  try {
    rmSync(file, { force: true });
  } catch {
    // The folder was removed, and the file with it.
  }
  files.delete(file);
}

/** Runs work that makes temporary files, and removes those that are left. */
export async function withTemporaries(work: () => Promise<void>): Promise<void> {
  listen();
  try {
    await work();
  } finally {
    removeAll();
    // A signal that arrived during the work is handled before the listeners are removed.
    await turn();
    unlisten();
  }
}

/** Waits until pending signals have been handled. Two turns of the event loop: the first may be the rest of the current one. */
export async function turn(): Promise<void> {
  for (let k = 0; k < 2; k++) await new Promise((resume) => setImmediate(resume));
}

function removeAll(): void {
  files.forEach(remove);
}

function listen(): void {
  process.on('exit', removeAll);
  for (const signal of SIGNALS) process.on(signal, end);
}

function unlisten(): void {
  process.off('exit', removeAll);
  for (const signal of SIGNALS) process.off(signal, end);
}

/** Ends the program as the signal would have without a listener. */
function end(signal: NodeJS.Signals): void {
  removeAll();
  unlisten();
  process.kill(process.pid, signal);
}
