/** The line on a terminal that tells of a search: how far it is, what it found, how far from the best, how long it takes. */

import { DEFAULT_SECONDS } from '../options.js';
import type { PlanOptions, Progress } from '../protocol.js';
import type { Place } from './batch.js';
import { visible } from './safe-text.js';
import { duration, percent } from './words.js';

const BAR = 16;

/** What is told of a search now; `name` only where there are several files. */
export function progressLine({ seconds, moves, rate, summary }: Progress, budget: PlanOptions, file: string, { index, of }: Place): string {
  const left = secondsLeft({ seconds, moves, rate }, budget);
  const done = left === null ? 0 : seconds / Math.max(seconds + left, Number.MIN_VALUE);
  const filled = Math.round(BAR * done);
  const pace = rate >= 1e6 ? `${(rate / 1e6).toFixed(1)} M` : `${Math.round(rate / 1000)} k`;
  return [
    of > 1 ? `${index + 1}/${of} ${visible(file)}` : '',
    `[${'#'.repeat(filled)}${'.'.repeat(BAR - filled)}]`,
    `job ${duration(summary.total_time)}`,
    summary.gap === null ? '' : `gap ${percent(summary.gap)}`,
    left === null ? '' : `${left.toFixed(0)} s left`,
    `${pace} moves/s`,
  ].filter(Boolean).join('  ');
}

/** By the sooner of both budgets, that in moves being each worker's; null while nobody knows how fast it goes. */
function secondsLeft({ seconds, moves, rate }: Pick<Progress, 'seconds' | 'moves' | 'rate'>, budget: PlanOptions): number | null {
  const bySeconds = budget.seconds ?? (budget.moves === undefined ? DEFAULT_SECONDS : undefined);
  const ends = [
    ...(bySeconds === undefined ? [] : [bySeconds - seconds]),
    ...(budget.moves === undefined || rate <= 0 ? [] : [(budget.moves * (budget.workers ?? 1) - moves) / rate]),
  ];
  return ends.length === 0 ? null : Math.max(0, Math.min(...ends));
}
