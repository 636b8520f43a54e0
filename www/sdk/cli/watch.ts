/** `--watch`: runs a command for a file again whenever it changes. */

import { setTimeout as wait } from 'node:timers/promises';
import { filesOf } from './glob.js';
import { toldToEnd } from './interrupt.js';
import { WrongUse } from './io.js';
import { complain } from './safe-text.js';
import { lookAt, STANDARD_INPUT } from './target.js';

/** How the files are processed. */
export interface Watched {
  /** Processes some of all files; returns those that failed, which it has reported. */
  round(files: readonly string[], all: readonly string[]): Promise<readonly string[]>;
  /** The existing outputs of a file. */
  existing(file: string): readonly string[];
}

/** Milliseconds between two checks of the files: fast enough for a person, and little work for a disk. */
const INTERVAL = 250;

/** The version of a file that does not exist. */
const GONE = '';

/**
 * Checks the files repeatedly instead of using notifications: that works on every system and network share, for files that
 * are replaced, and for patterns that match a new file. A change counts when two checks in a row see the same, so that a
 * file is not read while it is being written, and does not count as gone while it is being replaced.
 */
export async function watch(words: readonly string[], { round, existing }: Watched): Promise<never> {
  if (words.includes(STANDARD_INPUT)) throw new WrongUse('--watch follows files, and standard input (-) is not a file.');
  /** The version of each file when it was last processed. */
  const done = new Map<string, string>();
  let before = new Map<string, string>();
  for (let first = true; ; first = false) {
    const files = filesOf(words);
    const now = new Map([...done.keys(), ...files].map((file) => [file, versionOf(file)]));
    const settled = [...now.keys()].filter((file) => done.get(file) !== now.get(file) && (first || now.get(file) === before.get(file)));
    before = now;
    // In the first round a missing file is reported like any file that cannot be read.
    const changed = files.filter((file) => settled.includes(file) && (first || now.get(file) !== GONE));
    for (const file of settled.filter((file) => done.has(file) && now.get(file) === GONE)) {
      complain(`${file} is gone.${stale(existing(file))} It is planned again when it comes back.`);
    }
    for (const file of settled) done.set(file, now.get(file) ?? GONE);
    if (changed.length > 0) {
      for (const file of await attempt(() => round(changed, files), first)) {
        const left = stale(existing(file));
        if (left !== '') complain(`${file} was not planned.${left}`);
      }
      if (toldToEnd()) process.kill(process.pid, 'SIGTERM');
      if (process.stderr.isTTY) process.stderr.write('Watching; Ctrl+C ends.\n');
    }
    await wait(INTERVAL);
  }
}

// The outputs of a new file may clash with others. After the first round that is reported, and watching continues.
async function attempt(work: () => Promise<readonly string[]>, first: boolean): Promise<readonly string[]> {
  try {
    return await work();
  } catch (error) {
    if (first || !(error instanceof WrongUse)) throw error;
    complain(error.message);
    return [];
  }
}

function stale(outputs: readonly string[]): string {
  if (outputs.length === 0) return '';
  return ` ${outputs.join(', ')} on the disk ${outputs.length === 1 ? 'is' : 'are'} from an earlier drawing, and stale.`;
}

function versionOf(file: string): string {
  const stat = lookAt(file);
  return stat === null ? GONE : `${stat.mtimeMs} ${stat.size}`;
}
