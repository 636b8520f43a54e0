/**
 * Project files (`.kerfway`): a drawing with everything that was decided about it, and the best plan found for it. The page
 * saves and opens them, and the command line reads them wherever it reads a drawing.
 *
 * A project is a JSON document, `kerfway.project/1`. The drawing in it is compressed with gzip and written in base64.
 */

import { viewed } from './bytes.js';
import type { LoadOptions, PlanOptions, WarmPath } from './protocol.js';

/** A plan as a project keeps it. */
export interface SavedPlan {
  /** The seed of its search. */
  seed: number;
  /** The search behind it: moves, and seconds without pauses. */
  moves: number;
  seconds: number;
  /** Time of the whole job, s. */
  total_time: number;
  /** No path of this job takes less, s. Absent or 0: nothing is proven. */
  lower_bound?: number;
  /** Whether its search had ended. */
  done: boolean;
  /** How the job time fell: seconds of search, and the job time found by then, s. Two lists of one length. */
  curve: { at: number[]; total: number[] };
  /** What a search needs to continue from it: the option `warm`. */
  path: WarmPath;
}

/** A drawing, what was decided about it, and its best plan. */
export interface Project {
  /** The name of the drawing's file. */
  name: string;
  /** The drawing's bytes. */
  drawing: Uint8Array;
  /** How the drawing is read. */
  reading: LoadOptions;
  /** How it is planned: the machine as a whole profile, the method, the place on the bed. */
  planning: PlanOptions;
  /** The best plan; `null` if there is none yet. */
  plan: SavedPlan | null;
}

/** Whether bytes look like a project, by their beginning. */
export function isProject(bytes: ArrayBuffer | Uint8Array): boolean {
  const view = viewed(bytes);
  const start = view === null ? '' : new TextDecoder().decode(new Uint8Array(view.slice(0, 64)));
  return /^\s*\{\s*"schema"\s*:\s*"kerfway\.project\//.test(start);
}
