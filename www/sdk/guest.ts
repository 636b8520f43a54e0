/** A method from a paper beside the planner: it has a wasm file of its own, and hands over what it finds. */

import type { Job } from './pkg/kerfway.js';
import type { Guest } from './pkg/kerfway_papers.js';
import type { Slice } from './protocol.js';

/** A slice of its work, as one of the planner's own: the budget is the planner's, the search the guest's. */
export function stepHosted(job: Job, guest: Guest, work: number): Slice {
  const granted = job.grant(work);
  if (granted === 0) return job.step(0);
  const { done, improved, exhausted } = guest.step(granted);
  if (improved) job.offer(guest.best());
  const slice = job.step(done);
  return { ...slice, improved, end: exhausted ? 'exhausted' : slice.end };
}
