/** A slice of a job's search, held to a time by looking at the clock several times on the way. */

import type { Job } from './pkg/kerfway.js';
import type { Slice } from './protocol.js';

/**
 * Pieces a slice is done in, with a look at the clock after each: moves of some methods differ in what they cost, from one
 * stage to the next by more than tenfold, and a slice measured by the last stage must not run on for ten times as long.
 */
const PIECES = 16;

/** Works for at most `work` moves and about `ms` milliseconds. */
export function stepFor(job: Pick<Job, 'step'>, work: number, ms: number): Slice {
  const until = performance.now() + ms;
  const piece = Math.max(Math.ceil(work / PIECES), 1);
  let [done, improved] = [0, false];
  for (;;) {
    const slice = job.step(Math.min(piece, work - done));
    done += slice.done;
    improved ||= slice.improved;
    const over = slice.end !== 'running' || done >= work || performance.now() >= until;
    if (over) return { ...slice, done, improved };
  }
}
