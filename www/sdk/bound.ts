/** The lower bound of a job in its sums. */

import type { Summary } from './protocol.js';

/** The sums with a bound that is at least as good as theirs; what is above the total by rounding is the total. */
export function bounded(summary: Summary, bound: number): Summary {
  const lower_bound = Math.min(Math.max(bound, summary.lower_bound), summary.total_time);
  if (lower_bound <= 0) return summary;
  return { ...summary, lower_bound, gap: (summary.total_time - lower_bound) / lower_bound };
}
