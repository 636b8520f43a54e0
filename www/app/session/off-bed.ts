/** Programs of a job that is not on the bed: the planner writes none until the job is placed or the person allows it. */

import type { OutputKind } from 'kerfway';
import type { Box } from './extent.js';
import type { State } from './state.js';

/** What a machine runs. Drawings of the path are written wherever the job is. */
const PROGRAMS: readonly OutputKind[] = ['gcode', 'lbrn2', 'rd'];

/** Whether an output, or the one that the machine takes, is refused because of the place of the job. */
export function isRefusedOffBed({ placing, planFindings, machine }: State, output: OutputKind = machine?.takes ?? 'gcode'): boolean {
  return PROGRAMS.includes(output) && !placing.allowOffBed && planFindings.some((f) => f.code === 'off-bed');
}

/** What the beam reaches, in the coordinates of the drawing: a kerf, leads and loops lie beyond the drawn lines. */
export function reachOf({ progress, loaded }: State): Box | undefined {
  return progress?.summary.bounds ?? loaded?.bounds;
}
