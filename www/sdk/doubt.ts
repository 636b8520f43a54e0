/** Doubt about the unit of a drawing. A program in a wrong unit is 25 times too large or too small, so none is written until somebody decides. */

import type { Loaded, OutputKind } from './protocol.js';

/** What a machine runs. */
const PROGRAMS: readonly OutputKind[] = ['gcode', 'lbrn2', 'rd'];

/** Whether a machine runs one of these outputs. */
export function hasProgram(outputs: readonly string[]): boolean {
  return PROGRAMS.some((kind) => outputs.includes(kind));
}

/** The doubt in a sentence, without its call to check the units; null if the unit is sure. */
export function doubtAbout({ units }: Pick<Loaded, 'units'>): string | null {
  return units.doubtful ? units.reason.replace(/ Check the units\.$/, '') : null;
}
