/** What a method from a paper has told of itself, round by round. */

import type { Insight } from 'kerfway';

export interface Insights {
  now: Insight | null;
  rounds: number[];
  /** By round, then by curve. */
  values: number[][];
}

/** Rounds kept at most: a curve is no wider. Beyond, every other one is dropped. */
const MOST = 240;

export const noInsights = (): Insights => ({ now: null, rounds: [], values: [] });

/** Takes another one in. */
export function learn(insights: Insights, now: Insight): void {
  insights.now = now;
  const { rounds, values } = insights;
  if (rounds.at(-1) === now.round) {
    rounds.pop();
    values.pop();
  }
  rounds.push(now.round);
  values.push(now.curves.map((c) => c.value));
  if (rounds.length <= MOST) return;
  insights.rounds = rounds.filter((_, i) => i % 2 === 0);
  insights.values = values.filter((_, i) => i % 2 === 0);
}
