/** Words used in more than one place. Plain, short, no blame; what, where, what to do. */

import { seconds } from './format.js';
import type { DoneReason, Operation, Unit, UnitsTaken } from 'kerfway';

export const UNIT_NAMES: Record<Unit, string> = {
  mm: 'millimetres', cm: 'centimetres', m: 'metres', dm: 'decimetres', um: 'micrometres',
  in: 'inches', ft: 'feet', yd: 'yards', mil: 'mils', microinch: 'microinches',
};

/** Millimetres in a unit. */
export const UNIT_SIZES: Record<Unit, number> = {
  mm: 1, in: 25.4, cm: 10, m: 1000, dm: 100, um: 0.001, ft: 304.8, yd: 914.4, mil: 0.0254, microinch: 2.54e-5,
};

export const UNIT_SOURCES: Record<UnitsTaken['source'], string> = {
  header: 'from the file', guessed: 'guessed', given: 'chosen by you',
};

export const OPERATIONS: readonly { value: Operation; label: string }[] = [
  { value: 'cut', label: 'Cut' },
  { value: 'mark', label: 'Mark' },
  { value: 'ignore', label: 'Ignore' },
];

/** What findings of a kind have in common; `n` of them. */
export const FINDING_TITLES: Record<string, string> = {
  'unsupported-entity': 'Entities without an outline to cut',
  'damaged-entity': 'Damaged entities',
  resynchronised: 'Breaks in the file',
  truncated: 'The file ends too early',
  'bad-number': 'Numbers that cannot be read',
  'invalid-geometry': 'Entities that make no geometry',
  'missing-block': 'Missing blocks',
  'cyclic-block': 'Blocks that contain themselves',
  'hidden-entity': 'Hidden entities, not cut',
  'units-guessed': 'Units guessed',
  'units-doubtful': 'Units in doubt',
  encoding: 'Characters that cannot be read',
  projected: 'Three-dimensional entities laid flat',
  'outline-taken': 'Filled areas and points',
  'gap-closed': 'Gaps closed',
  'gap-left': 'Gaps left open',
  branch: 'More than two ends meet',
  'duplicate-removed': 'Copies removed',
  'overlap-removed': 'Overlapping lines removed',
  'zero-length': 'Elements without length',
  'self-crossing': 'Contours that cross themselves',
  crossing: 'Contours that cross each other',
  'open-contour': 'Open contours',
  'several-layers': 'Contours on several layers',
  'sheet-outline': 'Border of the sheet',
  'layer-suggestion': 'Layers that are probably not cut',
  'layer-ignored': 'Layers left out',
  more: 'More, not listed one by one',
};

/** Seconds without an improvement, as people round them, from which one may say that none is found any more. */
const QUIET = 1;

/** Why a search ended; `quiet`: seconds since its last improvement. */
export function doneSentence(reason: DoneReason | null, quiet: number): string {
  switch (reason) {
    case 'exhausted': return 'Done. This method finds nothing better.';
    case 'replaced': return 'Stopped: the planner had to be replaced. The best path is kept.';
    case 'stopped': return 'Stopped. The best path is kept.';
    default: {
      const whole = Math.round(quiet);
      return whole < QUIET ? 'Time is up, and it was still improving.' : `Done. No better path found for ${whole === 1 ? 'a second' : seconds(whole)}.`;
    }
  }
}

export const SOMETHING_ELSE = 'The drawing could not be worked on. Reload the page and drop it again.';

/** The sentence of an error from the planner or the browser. */
export function messageOf(error: unknown): string {
  if (typeof error === 'string') return error;
  const message = error instanceof Error ? error.message : null;
  return message || SOMETHING_ELSE;
}

/** "drawing.dxf" -> "drawing". */
export function baseName(name: string): string {
  return name.replace(/\.[^.]*$/, '') || 'plan';
}
