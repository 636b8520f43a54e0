/** What the levers of a machine save, for `--savings`. */

import type { PlanResult } from '../node.js';
import type { PlanOptions } from '../protocol.js';
import { leverSavings, type LeverSaving, type Replanner } from '../savings.js';
import { duration } from '../words.js';

/** What each lever saves in a plan. The plans without one are searched for as long as the plan was, from the beginning. */
export async function savingsOf(planner: Replanner, { warm, ...options }: PlanOptions, { progress }: PlanResult): Promise<LeverSaving[]> {
  // A plan that was kept as it was has no budget of its own.
  if (warm !== undefined && options.moves === 0) delete options.moves;
  const saved: LeverSaving[] = [];
  for await (const one of leverSavings(planner, options, progress.summary.total_time)) saved.push(one);
  return saved;
}

/** The lines of a report; `null`: nobody asked. */
export function savingLines(saved: readonly LeverSaving[] | null): string[] {
  if (saved === null) return [];
  if (saved.length === 0) return ['Levers     the machine has none'];
  return saved.map(({ lever, seconds }, k) => `${k === 0 ? 'Levers' : '      '}     ${lever} ${seconds >= 0 ? `saves ${duration(seconds)}` : `costs ${duration(-seconds)}`}`);
}
