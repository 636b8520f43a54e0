/** Lending planners, one new one for every call; and what a lender does about signals. */

import type { Lend } from './functions.js';
import type { Planner } from './planner.js';

/** A lender that opens a planner for each piece of work and closes it after. */
export function lendingNew(open: () => Promise<Planner>): Lend {
  return async (work, signal) => {
    signal?.throwIfAborted();
    const planner = await open();
    try {
      return await abortable(work(planner), signal);
    } finally {
      planner.close();
    }
  };
}

/** What the work comes to, or a rejection with the signal's reason as soon as it aborts; the work itself goes on. */
export async function abortable<T>(work: Promise<T>, signal: AbortSignal | undefined): Promise<T> {
  if (signal === undefined) return work;
  let abort!: () => void;
  const aborted = new Promise<never>((_, reject) => {
    abort = () => reject(signal.reason);
    if (signal.aborted) abort();
    signal.addEventListener('abort', abort);
  });
  // What becomes of it after an abort is of no interest any more.
  work.catch(() => {});
  try {
    return await Promise.race([work, aborted]);
  } finally {
    signal.removeEventListener('abort', abort);
  }
}
