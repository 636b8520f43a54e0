/** Why no program is written: a unit in doubt, because a wrong one makes the job 25 times too large or too small, or a job that leaves the bed. */

import type { Finding, Loaded, OutputKind, PlanOptions } from './protocol.js';

/** What a machine runs. */
const PROGRAMS: readonly OutputKind[] = ['gcode', 'lbrn2', 'rd'];

/** Whether a machine runs one of these outputs. */
export function hasProgram(outputs: readonly string[]): boolean {
  return PROGRAMS.some((kind) => outputs.includes(kind));
}

/** Whether a program is asked for that will be refused because the job leaves the bed: a search would be for nothing. */
export function isRefusedOffBed(outputs: readonly string[], { allowOffBed }: PlanOptions, findings: readonly Finding[]): boolean {
  return allowOffBed !== true && hasProgram(outputs) && findings.some(({ code }) => code === 'off-bed');
}

/** The doubt in a sentence, without its call to check the units; null if the unit is sure. */
export function doubtAbout({ units }: Pick<Loaded, 'units'>): string | null {
  return units.doubtful ? units.reason.replace(/ Check the units\.$/, '') : null;
}
