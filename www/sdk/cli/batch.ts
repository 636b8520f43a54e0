/** A command over its files: one after the other, and with `--watch` again whenever one changes. */

import { statSync } from 'node:fs';
import { setTimeout as wait } from 'node:timers/promises';
import type { Words } from './arguments.js';
import { Destinations, type Output } from './destinations.js';
import { filesOf } from './glob.js';
import { Unusable } from './io.js';
import { Report, type Column } from './report.js';

/** Which of how many files one is. */
export interface Place {
  index: number;
  of: number;
}

/** What a command writes, and the columns of its table after that of the file. */
export interface Asked<Kind extends string = string> {
  outputs: readonly Output<Kind>[];
  columns: readonly Column[];
}

/** Where what comes of files goes: outputs, and what people read. */
export interface Outlet {
  write: Destinations['write'];
  tell: Report['tell'];
}

/** What is done with one file. */
export type Work = (file: string, place: Place, to: Outlet) => Promise<void>;

/** What is done with all of them. */
interface Job {
  /** Told all files before the first. */
  begin(files: readonly string[]): void;
  work(file: string, place: Place): Promise<void>;
}

/** Milliseconds between two looks at the files: soon enough for an eye, and nothing for a disk. */
const LOOK = 250;

/** A file that is unusable is told in a sentence and makes the exit code 1; the others are done all the same. */
export async function eachFile({ words, values }: Words, { outputs, columns }: Asked, work: Work): Promise<void> {
  const destinations = new Destinations(outputs);
  const report = new Report(destinations.piped, columns);
  const to: Outlet = {
    write: (output, file, data) => destinations.write(output, file, data),
    tell: (place, words, cells) => report.tell(place, words, cells),
  };
  const job: Job = {
    begin: (files) => {
      destinations.begin(files);
      report.begin(files);
    },
    work: (file, place) => work(file, place, to),
  };
  const files = filesOf(words);
  if (values['watch'] === true) return watched(words, job);
  await round(files, files, job);
}

async function round(files: readonly string[], all: readonly string[], job: Job): Promise<void> {
  job.begin(all);
  for (const file of files) {
    try {
      await job.work(file, { index: all.indexOf(file), of: all.length });
    } catch (error) {
      if (!(error instanceof Unusable)) throw error;
      process.stderr.write(`kerfway: ${error.message}\n`);
      process.exitCode = 1;
    }
  }
}

/**
 * Looks again and again instead of being told: that works on every system and share, for files that are replaced, and for
 * patterns that match a new one. A file is taken when two looks see the same, so not in the middle of being written.
 */
async function watched(words: readonly string[], job: Job): Promise<never> {
  const done = new Map<string, string>();
  let before = new Map<string, string>();
  for (let first = true; ; first = false) {
    const files = filesOf(words);
    const now = new Map(files.map((file) => [file, lookOf(file)]));
    const changed = files.filter((file) => done.get(file) !== now.get(file) && (first || now.get(file) === before.get(file)));
    before = now;
    for (const file of changed) done.set(file, now.get(file) ?? '');
    // One that is gone is being replaced, or was taken away: both are no news but at the beginning.
    const there = changed.filter((file) => first || now.get(file) !== '');
    if (there.length > 0) {
      await round(there, files, job);
      if (process.stderr.isTTY) process.stderr.write('Watching; Ctrl+C ends.\n');
    }
    await wait(LOOK);
  }
}

function lookOf(file: string): string {
  const stat = statSync(file, { throwIfNoEntry: false });
  return stat === undefined ? '' : `${stat.mtimeMs} ${stat.size}`;
}
