/** A command over its files, one after the other. */

import type { Words } from './arguments.js';
import { Destinations, type Output } from './destinations.js';
import { filesOf } from './glob.js';
import { Unusable } from './io.js';
import { Report, type Column } from './report.js';
import { complain } from './safe-text.js';
import { watch } from './watch.js';

/** Which of how many files one is. */
export interface Place {
  index: number;
  of: number;
}

/** What a command writes, and the columns of its table after that of the file. */
export interface Asked<Kind extends string = string> {
  outputs: readonly Output<Kind>[];
  columns: readonly Column[];
  /** Files that are read besides the drawings. */
  inputs?: readonly string[];
}

/** Where what comes of files goes: outputs, and what people read. */
export interface Outlet {
  write: Destinations['write'];
  tell: Report['tell'];
}

/** What is done with one file. */
export type Work = (file: string, place: Place, to: Outlet) => Promise<void>;

/** A file that is unusable is reported in a sentence and makes the exit code 1; the others are done all the same. */
export async function eachFile({ words, values }: Words, { outputs, columns, inputs = [] }: Asked, work: Work): Promise<void> {
  const destinations = new Destinations(outputs, inputs);
  const report = new Report(destinations.piped, columns);
  const to: Outlet = {
    write: (file, written) => destinations.write(file, written),
    tell: (place, lines, cells) => report.tell(place, lines, cells),
  };
  const round = async (files: readonly string[], all: readonly string[]): Promise<string[]> => {
    destinations.begin(all);
    report.begin(all);
    const failed: string[] = [];
    for (const file of files) {
      try {
        await work(file, { index: all.indexOf(file), of: all.length }, to);
      } catch (error) {
        if (!(error instanceof Unusable)) throw error;
        complain(error.message);
        failed.push(file);
        process.exitCode = 1;
      }
    }
    return failed;
  };
  if (values['watch'] === true) return watch(words, { round, existing: (file) => destinations.existing(file) });
  const files = filesOf(words);
  await round(files, files);
}
