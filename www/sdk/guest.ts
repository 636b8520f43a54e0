/** A method from a paper beside the planner: it has a wasm file of its own, and hands over what it finds. */

import type { Job } from './pkg/kerfway.js';
import type { Guest } from './pkg/kerfway_papers.js';
import type { Slice } from './protocol.js';

/**
 * Pieces a slice is done in, with a look at the clock after each: moves of these methods differ in what they cost, from
 * one stage to the next by more than tenfold, and a slice measured by the last stage must not run on for ten times as long.
 */
const PIECES = 16;

/** A slice of its work, `ms` long at most, as one of the planner's own: the budget is the planner's, the search the guest's. */
export function stepHosted(job: Job, guest: Guest, work: number, ms: number): Slice {
  const until = performance.now() + ms;
  const piece = Math.max(Math.ceil(work / PIECES), 1);
  let [done, improved] = [0, false];
  for (;;) {
    const slice = stepOnce(job, guest, Math.min(piece, work - done));
    done += slice.done;
    improved ||= slice.improved;
    const over = slice.end !== 'running' || slice.prove > 0 || done >= work || performance.now() >= until;
    if (over) return { ...slice, done, improved };
  }
}

function stepOnce(job: Job, guest: Guest, work: number): Slice {
  const granted = job.grant(work);
  if (granted === 0) return job.step(0);
  const { done, improved, exhausted } = guest.step(granted);
  if (improved) job.offer(guest.best());
  const slice = job.step(done);
  return { ...slice, improved, end: exhausted ? 'exhausted' : slice.end };
}
