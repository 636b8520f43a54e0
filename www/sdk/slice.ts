/** Runs a slice of a job's search and keeps it to a time limit by checking the clock several times. */

import type { Job } from './pkg/kerfway.js';
import type { Slice } from './protocol.js';

/**
 * A slice is done in this many pieces, and the clock is checked after each. In some methods a move costs more than ten
 * times as much in one stage as in the stage before; a slice whose size fits the earlier stage must not take ten times as long.
 */
const PIECES = 16;

/** Searches for at most `work` moves and about `ms` milliseconds. */
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
