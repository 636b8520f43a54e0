/** A plan that is kept while something else is planned or the page is away, so that its search can go on where it was. */

import type { DoneReason, Progress, WarmPath } from 'kerfway';
import type { PlanState, State } from './state.js';

export interface KeptPlan {
  readonly seed: number;
  readonly path: WarmPath;
  /** The moves and seconds of search behind it. */
  readonly moves: number;
  readonly seconds: number;
  /** The time budget of its search, s. */
  readonly budget: number;
  /** Why its search had ended; null if it had not. */
  readonly reason: DoneReason | null;
  /** No path of this job takes less, s; 0 while nothing is proven. */
  readonly bound: number;
  readonly curve: PlanState['curve'];
  /** What the page showed of it; null if it comes from a file. */
  readonly shown: PlanState | null;
}

/** The plan of a state; null while there is none. */
export function keptPlan(state: State): KeptPlan | null {
  const { seed, path, progress, budget, reason } = state;
  if (seed === null || path === null || progress === null) return null;
  const shown: PlanState = {
    seed, baselines: state.baselines, planFindings: state.planFindings, beam: state.beam, common: state.common,
    progress: { ...progress, path }, path, curve: state.curve, insights: state.insights, reason, programFails: state.programFails,
  };
  return { seed, path, curve: state.curve, moves: progress.moves, seconds: progress.seconds, budget, reason, bound: progress.summary.lower_bound, shown };
}

/** What a search reports, with the search before it counted in. Its bound still holds: it is one of the same drawing and machine. */
export function addedTo(kept: KeptPlan | null, progress: Progress): Progress {
  if (kept === null) return progress;
  return withBound({ ...progress, moves: progress.moves + kept.moves, seconds: progress.seconds + kept.seconds }, kept.bound);
}

/** A progress with a bound that was proven elsewhere, s, if it is better than its own. One above the job's time is of another job. */
export function withBound(progress: Progress, bound: number): Progress {
  const { summary } = progress;
  if (bound <= summary.lower_bound || bound > summary.total_time) return progress;
  return { ...progress, summary: { ...summary, lower_bound: bound, gap: (summary.total_time - bound) / bound } };
}
