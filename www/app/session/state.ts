/** What the page knows about the job in hand; the session changes it, the panels show it. */

import type { Box } from './extent.js';
import { type Insights, noInsights } from './insights.js';
import type { Baselines, Beam, BestPath, DoneReason, Finding, Geometry, LoadOptions, Loaded, MachineProfile, Progress } from 'kerfway';

/**
 * starting: the planner is being loaded. reading: a file is. question: an answer is needed before planning.
 * planning, paused, done: the search. failed: the file cannot be used.
 */
export type Phase = 'starting' | 'reading' | 'question' | 'ready' | 'planning' | 'paused' | 'done' | 'failed';

/** What the person is asked before planning. */
export type Question = 'units' | 'damaged';

/** The options of a search that a person sets. */
export interface Search {
  method: string;
  /** Of a method from a paper: those that differ from its defaults. */
  parameters: Record<string, unknown>;
  /** Null: another at each start, told with the result. */
  seed: number | null;
  /** Budget, s. */
  seconds: number;
}

export interface State {
  phase: Phase;
  /** Name of the file or sample in hand. */
  name: string;
  /** A sample of ours, not the person's own drawing. */
  sample: boolean;
  load: LoadOptions;
  loaded: Loaded | null;
  /** How far the drawing reaches, mm. */
  extent: Box;
  question: Question | null;
  machine: MachineProfile | null;
  search: Search;
  /** Seed of the search under way or done. */
  seed: number | null;
  baselines: Baselines | null;
  /** What is worth knowing of the drawing on this machine. */
  found: Finding[];
  /** The lines of the beam of the plan in hand, where they are not those drawn. */
  beam: Beam | null;
  /** What the plan in hand cuts once for two parts. */
  common: Geometry | null;
  progress: Progress | null;
  path: BestPath | null;
  /** Seconds of search and seconds of the job, for the chart. */
  history: { at: number[]; total: number[] };
  /** What a method from a paper has told of itself. */
  insights: Insights;
  /** The budget of the search in hand, s; grows with "keep improving". */
  budget: number;
  reason: DoneReason | null;
  /** One sentence: why the file cannot be used, or not be planned. */
  error: string | null;
}

export function initialState(): State {
  return {
    phase: 'starting', name: '', sample: true, load: {}, loaded: null, extent: [0, 0, 1, 1], question: null, machine: null,
    search: { method: '', parameters: {}, seed: null, seconds: 10 }, seed: null, baselines: null, found: [], beam: null, common: null, progress: null, path: null,
    history: { at: [], total: [] }, insights: noInsights(), budget: 10, reason: null, error: null,
  };
}
