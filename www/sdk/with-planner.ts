/** Runs work on a planner that is opened for it, and waits for work until a signal aborts. */

import type { WithPlanner } from './functions.js';
import { onAbort } from './on-abort.js';
import type { Planner } from './planner.js';

/** Opens a new planner for each piece of work and closes it afterwards. */
export function withNewPlanner(open: () => Promise<Planner>): WithPlanner {
  return async (work, signal) => {
    signal?.throwIfAborted();
    const opening = open();
    try {
      const planner = await abortable(opening, signal);
      return await abortable(work(planner), signal);
    } finally {
      // A planner that is still starting when the signal aborts is closed once it has started.
      opening.then((planner) => planner.close(), () => {});
    }
  };
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
