/**
 * Several outputs are renamed one after the other. Two programs that write the same files at once would each rename some of them last, and a
 * program would lie beside the plan of another. So a program renames them only while it has a lock in each of their folders: a file that only one
 * program can make. Programs that were killed leave it behind, so one that is too old counts for nothing. Where none can be made, there is no lock.
 */

import { closeSync, openSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';
import { remove, track } from './temporary.js';

/** Hidden, like other temporary files. */
const NAME = '.kerfway-lock.tmp';
/** Milliseconds after which a lock was left behind: renaming takes a few, on slow network shares a second. */
const STALE = 10_000;
/** Milliseconds between two attempts. */
const PAUSE = 10;

/** Runs work while no other program runs work for one of these folders. */
export async function locked(folders: Iterable<string>, work: () => Promise<void>): Promise<void> {
  const locks: string[] = [];
  try {
    // In the same order everywhere, so that no two programs wait for each other.
    for (const folder of [...new Set(folders)].sort()) {
      const lock = join(folder, NAME);
      if (await taken(lock)) locks.push(lock);
    }
    await work();
  } finally {
    locks.forEach(remove);
  }
}

/** Waits until this program has the lock; `false` if none can be made. */
async function taken(lock: string): Promise<boolean> {
  for (;;) {
    try {
      closeSync(openSync(lock, 'wx'));
      track(lock);
      return true;
    } catch (error) {
      if ((error as NodeJS.ErrnoException).code !== 'EEXIST') return false;
    }
    if (!isStale(lock)) await wait(PAUSE);
    else {
      remove(lock);
      // What is left of another person's program may not be removed.
      if (isStale(lock)) return false;
    }
  }
}

function isStale(lock: string): boolean {
  const made = statSync(lock, { throwIfNoEntry: false })?.mtimeMs;
  return made !== undefined && Math.abs(Date.now() - made) > STALE;
}
