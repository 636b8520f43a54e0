/**
 * Temporary files, removed whatever happens: when the program ends, and when a signal ends it. Only a signal that no program can
 * handle (SIGKILL) leaves them behind.
 */

import { randomBytes } from 'node:crypto';
import { rmSync } from 'node:fs';
import { dirname, join } from 'node:path';

const SIGNALS = ['SIGINT', 'SIGTERM', 'SIGHUP'] as const;

/** Those there may be now. */
const files = new Set<string>();
let active = false;

/** True while outputs are being written. */
export function writing(): boolean {
  return active;
}

/** A new name beside a file, hidden and not matched by patterns of drawings. */
export function temporaryBeside(path: string): string {
  const name = join(dirname(path), `.kerfway-${randomBytes(8).toString('hex')}.tmp`);
  files.add(name);
  return name;
}

/** Does some work that makes temporary files; none is left after it. */
export async function withTemporaries(work: () => Promise<void>): Promise<void> {
  active = true;
  listen();
  try {
    await work();
  } finally {
    removeAll();
    // A signal that came during the work must still find its listener.
    await turn();
    active = false;
    unlisten();
  }
}

/** Waits until signals that came meanwhile have been handled: the first turn may be the rest of the present one. */
export async function turn(): Promise<void> {
  for (let k = 0; k < 2; k++) await new Promise((resume) => setImmediate(resume));
}

function removeAll(): void {
  for (const file of files) {
    try {
      rmSync(file, { force: true });
    } catch {
      // A folder that was taken away took the file with it.
    }
  }
  files.clear();
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
