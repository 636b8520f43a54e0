/** The progress line on a terminal: how far the search is, the time of the job, the gap to the lower bound, the time left. */

import { PROVEN } from '../gap.js';
import { DEFAULT_SECONDS } from '../options.js';
import type { PlanOptions, Progress } from '../protocol.js';
import type { Place } from './batch.js';
import { visible } from './safe-text.js';
import { duration, percentAtMost } from '../words.js';

const BAR = 16;

/** The progress line. The file is named only if there are several. */
export function progressLine({ seconds, moves, rate, summary }: Progress, budget: PlanOptions, file: string, { index, of }: Place): string {
  const left = secondsLeft({ seconds, moves, rate }, budget);
  const done = left === null ? 0 : seconds / Math.max(seconds + left, Number.MIN_VALUE);
  const filled = Math.round(BAR * done);
  const pace = rate >= 1e6 ? `${(rate / 1e6).toFixed(1)} M` : `${Math.round(rate / 1000)} k`;
  return [
    of > 1 ? `${index + 1}/${of} ${visible(file)}` : '',
    `[${'#'.repeat(filled)}${'.'.repeat(BAR - filled)}]`,
    `job ${duration(summary.total_time)}`,
    summary.gap === null ? '' : summary.gap <= PROVEN ? 'proven optimal' : `gap ${percentAtMost(summary.gap)}`,
    left === null ? '' : `${left.toFixed(0)} s left`,
    `${pace} moves/s`,
  ].filter(Boolean).join('  ');
}

/** Seconds until the first of the budgets ends; one in moves applies to each worker. Null while the speed is unknown. */
function secondsLeft({ seconds, moves, rate }: Pick<Progress, 'seconds' | 'moves' | 'rate'>, budget: PlanOptions): number | null {
  const bySeconds = budget.seconds ?? (budget.moves === undefined ? DEFAULT_SECONDS : undefined);
  const ends = [
    ...(bySeconds === undefined ? [] : [bySeconds - seconds]),
    ...(budget.moves === undefined || rate <= 0 ? [] : [(budget.moves * (budget.workers ?? 1) - moves) / rate]),
  ];
  return ends.length === 0 ? null : Math.max(0, Math.min(...ends));
}
