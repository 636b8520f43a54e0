/** What the levers of a machine save, for `--savings`. */

import type { PlanHandle, Planner, PlanResult } from '../node.js';
import type { PlanOptions } from '../protocol.js';
import { leverSavings, type LeverSaving } from '../savings.js';
import { duration } from '../words.js';
import { toldToEnd, untilInterrupted, type Interruption } from './interrupt.js';

/** What the levers save, as far as they were compared. */
export interface Compared {
  saved: LeverSaving[];
  /** The signal that ended the comparison, or the search before it; `null`: none. */
  interrupted: Interruption | null;
}

/** What each lever saves in a plan. The plans without one are searched for as long as the plan was, from the beginning. A signal skips the rest. */
export async function savingsOf(planner: Planner, { warm, ...options }: PlanOptions, { progress }: PlanResult): Promise<Compared> {
  // A plan that was kept as it was has no budget of its own.
  if (warm !== undefined && options.moves === 0) delete options.moves;
  const compared: Compared = { saved: [], interrupted: toldToEnd() ? 'SIGTERM' : null };
  if (compared.interrupted !== null) return compared;
  let running: PlanHandle | null = null;
  const replanner = { plan: (without: PlanOptions) => (running = planner.plan(without)) };
  const stop = (signal: Interruption) => {
    compared.interrupted = signal;
    running?.stop();
  };
  return untilInterrupted(stop, async () => {
    for await (const one of leverSavings(replanner, options, progress.summary.total_time)) {
      // A search that was cut short says nothing.
      if (compared.interrupted !== null) break;
      compared.saved.push(one);
    }
    return compared;
  });
}

/** The lines of a report; `null`: nobody asked. */
export function savingLines(compared: Compared | null): string[] {
  if (compared === null) return [];
  const lines = compared.saved.map(({ lever, seconds }) => `${lever} ${seconds >= 0 ? `saves ${duration(seconds)}` : `costs ${duration(-seconds)}`}`);
  if (compared.interrupted !== null) lines.push(`${lines.length === 0 ? 'not' : 'the others not'} compared, because of ${compared.interrupted === 'SIGINT' ? 'Ctrl+C' : compared.interrupted}`);
  if (lines.length === 0) lines.push('the machine has none');
  return lines.map((line, k) => `${k === 0 ? 'Levers' : '      '}     ${line}`);
}
