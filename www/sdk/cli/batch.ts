/** Runs a command for each of its files, one after the other. */

import { KerfwayError } from '../errors.js';
import type { Words } from './arguments.js';
import { Destinations, type Output } from './destinations.js';
import { filesOf } from './glob.js';
import { toldToEnd } from './interrupt.js';
import { EXIT, failureDocument, print, subject, Unusable } from './io.js';
import { Report, type Column } from './report.js';
import { complain } from './safe-text.js';
import { STANDARD_OUTPUT } from './target.js';
import { watch } from './watch.js';

/** The position of a file among all. */
export interface Place {
  index: number;
  of: number;
}

/** The outputs of a command, and the columns of its table after the file name. */
export interface Requested<Kind extends string = string> {
  outputs: readonly Output<Kind>[];
  columns: readonly Column[];
  /** Files that are read in addition to the drawings. */
  inputs?: readonly string[];
}

/** Where the results of files go: to output files, and to the report for people. */
export interface Outlet {
  write: Destinations['write'];
  report: Report['add'];
}

/** Processes one file. */
export type Work = (file: string, place: Place, to: Outlet) => Promise<void>;

/** Processes all files. An unusable file is reported in a sentence, and the others are processed anyway. */
export async function eachFile({ words, values }: Words, { outputs, columns, inputs = [] }: Requested, work: Work): Promise<void> {
  const destinations = new Destinations(outputs, inputs);
  const jsonPiped = outputs.some(({ kind, out }) => kind === 'json' && out === STANDARD_OUTPUT);
  const report = new Report(destinations.piped, columns, values['quiet'] === true);
  const to: Outlet = {
    write: (file, written) => destinations.write(file, written),
    report: (place, lines, cells, under) => report.add(place, lines, cells, under),
  };
  const round = async (files: readonly string[], all: readonly string[]): Promise<string[]> => {
    destinations.begin(all);
    report.begin(all);
    const failed: string[] = [];
    const exits = new Set<number>();
    for (const file of files) {
      try {
        if (toldToEnd()) throw leftOut(file);
        await work(file, { index: all.indexOf(file), of: all.length }, to);
      } catch (error) {
        if (!(error instanceof Unusable)) throw error;
        complain(error.message);
        if (jsonPiped && error.report !== null) await print(failureDocument(file, error.report)).catch(() => {});
        failed.push(file);
        exits.add(error.exit);
        // In case the reader of standard output leaves before the last of them.
        process.exitCode = files.length > 1 ? EXIT.some : error.exit;
      }
    }
    if (failed.length > 0) process.exitCode = failed.length < files.length ? EXIT.some : files.length > 1 ? EXIT.all : [...exits][0];
    return failed;
  };
  if (values['watch'] === true) return watch(words, { round, existing: (file) => destinations.existing(file) });
  const files = filesOf(words);
  await round(files, files);
}

function leftOut(file: string): Unusable {
  const message = `${subject(file)} was left out: SIGTERM ended the command before.`;
  return new Unusable(message, new KerfwayError('stopping', message).toJSON());
}
