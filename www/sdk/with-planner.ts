/** Runs work on a planner that is opened for it, and waits for work until a signal aborts. */

import { KerfwayError } from './errors.js';
import type { WithPlanner } from './functions.js';
import { onAbort } from './on-abort.js';
import type { Planner } from './planner.js';

/** How often a file is tried when its worker dies: one death may be chance, a second one is probably due to the file. */
export const TRIES = 2;

/** Opens a new planner for each piece of work and closes it afterwards. Work that fails because its worker died is done once more. */
export function withNewPlanner(open: () => Promise<Planner>): WithPlanner {
  return async (work, signal) => {
    let why = '';
    for (let k = 0; k < TRIES; k++) {
      signal?.throwIfAborted();
      const opening = open();
      try {
        const planner = await abortable(opening, signal);
        try {
          return await abortable(work(planner), signal);
        } catch (error) {
          if (planner.replaced === null || signal?.aborted === true) throw error;
          why = planner.replaced;
        }
      } finally {
        // A planner that is still starting when the signal aborts is closed once it has started.
        opening.then((planner) => planner.close(), () => {});
      }
    }
    throw diedEachTime(why);
  };
}

/** The error of a file whose worker died each time that it was tried. */
export function diedEachTime(why: string): KerfwayError {
  return new KerfwayError('planner-died', `${why} It was tried ${TRIES} times; this file may need more memory than there is.`);
}

/** The result of the work, or a rejection with the signal's reason as soon as it aborts. The work itself continues. */
export async function abortable<T>(work: Promise<T>, signal: AbortSignal | undefined): Promise<T> {
  if (signal === undefined) return work;
  let forget!: () => void;
  const aborted = new Promise<never>((_, reject) => {
    const abort = () => reject(signal.reason);
    if (signal.aborted) abort();
    forget = onAbort(signal, abort);
  });
  // After an abort nobody waits for the work: its failure must not count as unhandled.
  work.catch(() => {});
  try {
    return await Promise.race([work, aborted]);
  } finally {
    forget();
  }
}
