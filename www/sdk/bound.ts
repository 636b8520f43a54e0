/** Puts a lower bound of the job's time into the summary of a plan. */

import type { Summary } from './protocol.js';

/** The summary with the better of its own bound and `bound`, in seconds. A bound that rounding has put above the total becomes the total. */
export function bounded(summary: Summary, bound: number): Summary {
  const lower_bound = Math.min(Math.max(bound, summary.lower_bound), summary.total_time);
  if (lower_bound <= 0) return summary;
  return { ...summary, lower_bound, gap: (summary.total_time - lower_bound) / lower_bound };
}
