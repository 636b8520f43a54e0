/** What the page knows about the current job. Only the actions of `store.ts` change it. */

import type { Box } from './extent.js';
import { type Insights, noInsights } from './insights.js';
import { AS_DRAWN, type Placing } from './placing.js';
import { type Baselines, type Beam, type BestPath, type DoneReason, type Finding, type Geometry, type LoadOptions, type Loaded, type MachineProfile, type Progress, PROVEN } from 'kerfway';

/**
 * starting: the planner is being loaded. reading: a file is being read. question: an answer is needed before planning.
 * ready: there is no plan, because there is nothing to cut or because these options allow none. planning, paused, done: the search.
 * failed: there is no drawing, because the file cannot be used.
 */
export type Phase = 'starting' | 'reading' | 'question' | 'ready' | 'planning' | 'paused' | 'done' | 'failed';

/** What the page may have to ask before planning. */
export const QUESTIONS = ['units', 'damaged', 'border'] as const;
export type Question = (typeof QUESTIONS)[number];

/** The options of a search that a person sets. */
export interface Search {
  readonly method: string;
  /** For a method from a paper: the parameters that differ from its defaults. */
  readonly parameters: Readonly<Record<string, unknown>>;
  /** Null: every start takes another seed and reports it. */
  readonly seed: number | null;
  /** Time budget, s. */
  readonly seconds: number;
}

/** What is known of a plan, from its start to its end. */
export interface PlanState {
  /** The seed that the search uses. */
  readonly seed: number | null;
  readonly baselines: Baselines | null;
  /** Findings about the drawing on this machine. */
  readonly planFindings: readonly Finding[];
  /** The lines that the beam follows, where they are not the drawn ones. */
  readonly beam: Beam | null;
  /** Stretches that are cut once for two parts. */
  readonly common: Geometry | null;
  readonly progress: Progress | null;
  readonly path: BestPath | null;
  /** The points of the chart: seconds of search, and the job time found by then, s. */
  readonly curve: { readonly at: readonly number[]; readonly total: readonly number[] };
  /** What a method from a paper has reported about itself. */
  readonly insights: Insights;
  readonly reason: DoneReason | null;
  /** Whether the program of the best path has failed its check. */
  readonly programFails: boolean;
}

export interface State extends PlanState {
  readonly phase: Phase;
  /** Name of the current file or sample. */
  readonly name: string;
  /** The drawing is one of the samples, not the person's own. */
  readonly sample: boolean;
  readonly load: LoadOptions;
  readonly loaded: Loaded | null;
  /** The box around the whole drawing, mm. */
  readonly extent: Box;
  readonly question: Question | null;
  readonly machine: MachineProfile | null;
  /** The name of the chosen setting of the machine's library; null: the machine's own values. */
  readonly material: string | null;
  readonly search: Search;
  readonly placing: Placing;
  /** Time budget of the current search, s; it grows with "keep improving". */
  readonly budget: number;
  /** One sentence: why the drawing cannot be planned. */
  readonly error: string | null;
  /** The file that is being read, while the drawing before it stays. */
  readonly opening: string | null;
  /** Whether a choice about the drawing is being read. Until then, the drawing and the plan of before are shown. */
  readonly applying: boolean;
  /** A file that could not be used, and why, until the person has seen it. */
  readonly refused: { readonly file: string; readonly sentence: string } | null;
}

export function noPlan(): PlanState {
  return {
    seed: null, baselines: null, planFindings: [], beam: null, common: null, progress: null, path: null,
    curve: { at: [], total: [] }, insights: noInsights, reason: null, programFails: false,
  };
}

export function initialState(): State {
  return {
    phase: 'starting', name: '', sample: true, load: {}, loaded: null, extent: [0, 0, 1, 1], question: null, machine: null,
    search: { method: '', parameters: {}, seed: null, seconds: 10 }, placing: AS_DRAWN, material: null, budget: 10, error: null, opening: null, applying: false, refused: null, ...noPlan(),
  };
}

/** The longest of the job times that are compared, s: all of them are written in its form. */
export function longestTime({ baselines, progress }: PlanState): number {
  return Math.max(progress?.summary.total_time ?? 0, baselines?.drawing.total_time ?? 0, baselines?.greedy.total_time ?? 0);
}

/** Whether no plan of the job takes less time than this one, proven. */
export function isOptimal({ progress }: PlanState): boolean {
  const gap = progress?.summary.gap ?? null;
  return gap !== null && gap <= PROVEN;
}
