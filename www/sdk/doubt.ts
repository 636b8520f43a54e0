/** Why no program is written: a unit in doubt, because a wrong one makes the job 25 times too large or too small, or a job that leaves the bed. */

import type { PlanHandle } from './plan-handle.js';
import type { Loaded, OutputKind, PlanOptions } from './protocol.js';

/** What a machine runs. */
const PROGRAMS: readonly OutputKind[] = ['gcode', 'lbrn2', 'rd'];

/** Whether a machine runs one of these outputs. */
export function hasProgram(outputs: readonly string[]): boolean {
  return PROGRAMS.some((kind) => outputs.includes(kind));
}

/**
 * Waits until the plan has started, or has failed, and stops its search if a program is asked for that will be refused because
 * the job leaves the bed: the search would be for nothing.
 */
export async function stopIfRefusedOffBed(plan: PlanHandle, outputs: readonly string[], { allowOffBed }: PlanOptions): Promise<void> {
  const { findings } = await Promise.race([plan.started, plan.done]);
  if (allowOffBed !== true && hasProgram(outputs) && findings.some(({ code }) => code === 'off-bed')) plan.stop();
}

/** The doubt in a sentence, without its call to check the units; null if the unit is sure. */
export function doubtAbout({ units }: Pick<Loaded, 'units'>): string | null {
  return units.doubtful ? units.reason.replace(/ Check the units\.$/, '') : null;
}
