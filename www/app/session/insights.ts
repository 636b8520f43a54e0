/** What a method from a paper reports about itself, round by round. */

import type { Insight } from 'kerfway';

export interface Insights {
  readonly now: Insight | null;
  readonly rounds: readonly number[];
  /** The values by round, then by curve. */
  readonly values: readonly (readonly number[])[];
}

/** How many rounds are kept, as no curve is wider. Beyond that every second one is dropped. */
const MOST = 240;

export const noInsights: Insights = { now: null, rounds: [], values: [] };

/** The insights with another report. A second report of the same round replaces the first. */
export function withInsight({ rounds, values }: Insights, now: Insight): Insights {
  const known = rounds.at(-1) === now.round ? -1 : rounds.length;
  const all = {
    now,
    rounds: [...rounds.slice(0, known), now.round],
    values: [...values.slice(0, known), now.curves.map((c) => c.value)],
  };
  if (all.rounds.length <= MOST) return all;
  const everySecond = (_: unknown, i: number) => i % 2 === 0;
  return { now, rounds: all.rounds.filter(everySecond), values: all.values.filter(everySecond) };
}
