/** `--watch`: a command over its files again whenever one changes. */

import { setTimeout as wait } from 'node:timers/promises';
import { filesOf } from './glob.js';
import { WrongUse } from './io.js';
import { complain } from './safe-text.js';
import { lookAt } from './target.js';

/** What is done with the files. */
export interface Watched {
  /** Works on some of all files; returns those that failed, which it has reported. */
  round(files: readonly string[], all: readonly string[]): Promise<readonly string[]>;
  /** Outputs on the disk that were made of a file. */
  existing(file: string): readonly string[];
}

/** Milliseconds between two looks at the files: soon enough for an eye, and nothing for a disk. */
const LOOK = 250;

/** How a file looks that is not there. */
const GONE = '';

/**
 * Looks again and again instead of being told: that works on every system and share, for files that are replaced, and for
 * patterns that match a new one. What two looks see the same is taken: a file is then not in the middle of being written, and one that
 * is gone is not in the middle of being replaced.
 */
export async function watch(words: readonly string[], { round, existing }: Watched): Promise<never> {
  /** How each file looked when it was last worked on. */
  const done = new Map<string, string>();
  let before = new Map<string, string>();
  for (let first = true; ; first = false) {
    const files = filesOf(words);
    const now = new Map([...done.keys(), ...files].map((file) => [file, lookOf(file)]));
    const settled = [...now.keys()].filter((file) => done.get(file) !== now.get(file) && (first || now.get(file) === before.get(file)));
    before = now;
    // At the beginning a file that is not there is reported like any that cannot be read.
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
      if (process.stderr.isTTY) process.stderr.write('Watching; Ctrl+C ends.\n');
    }
    await wait(LOOK);
  }
}

// A new file may clash with others; that ends nothing that is under way.
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
  return ` ${outputs.join(', ')} on the disk ${outputs.length === 1 ? 'is' : 'are'} of an earlier drawing, and stale.`;
}

function lookOf(file: string): string {
  const stat = lookAt(file);
  return stat === null ? GONE : `${stat.mtimeMs} ${stat.size}`;
}
