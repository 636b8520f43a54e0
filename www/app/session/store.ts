/**
 * The state of the page, and the only place where it changes: each action is one thing that can happen to a job. Listeners hear `change`
 * after an action, and read the state; nobody else can write it.
 */

import type { DoneReason, Loaded, LoadOptions, MachineProfile, Progress, Started } from 'kerfway';
import { Emitter } from '../core/emitter.js';
import { extentOf } from './extent.js';
import { withInsight } from './insights.js';
import { type KeptPlan, withBound } from './kept-plan.js';
import type { Placing } from './placing.js';
import { initialState, noPlan, type Phase, type PlanState, type Question, type Search, type State } from './state.js';

interface Events extends Record<string, unknown> {
  /** Anything but the progress of the search has changed. */
  change: State;
  /**
   * A drawing was read. `fresh`: it is another file, not the same one read with other options. `same`: its contours and their numbers are
   * the same as before.
   */
  loaded: { loaded: Loaded; fresh: boolean; same: boolean };
  /** Something was decided about the contours that are shown, and the drawing is about to be read again with it. */
  decided: void;
  /** The drawing is about to be read again with a choice. */
  applying: void;
  /** There is no drawing, or none that can be used. */
  cleared: void;
  /** The search has reported its progress. */
  progress: State;
  /** A sentence for the person that is not part of the state. */
  notice: string;
}

export class Store extends Emitter<Events> {
  private current: State = initialState();
  private emitting = false;
  private changed = false;
  /** The phase of the drawing that stays while another file is being read. */
  private beneath: Phase = 'starting';

  get state(): State {
    return this.current;
  }

  /** Shows a sentence that is not part of the state. */
  notify(sentence: string): void {
    this.emit('notice', sentence);
  }

  /** The lists of methods or machines have changed. */
  catalogChanged(): void {
    this.update({});
  }

  /** Takes over a machine, a search or a placement. */
  choose(choices: { machine?: MachineProfile | null; search?: Search; placing?: Placing; material?: string | null }): void {
    this.update(choices);
  }

  /** Another drawing is about to be read. The one before stays until then, and its search goes on. */
  reading(file: string): void {
    if (this.current.phase !== 'reading') this.beneath = this.current.phase;
    this.update({ phase: 'reading', opening: file, refused: null, ...(this.current.loaded === null ? { name: file } : {}) });
  }

  /** A file cannot be used. The drawing before stays as it was. */
  fileRefused(file: string, sentence: string): void {
    const refused = { file, sentence };
    if (this.current.loaded === null) {
      this.update({ phase: 'failed', opening: null, refused, name: file, sample: false });
      return;
    }
    // The reading was over before if the file was not even opened.
    const phase = this.current.phase === 'reading' ? this.beneath : this.current.phase;
    this.update({ phase, opening: null, refused });
  }

  /** The person has seen why a file cannot be used. */
  refusalSeen(): void {
    this.update({ refused: null });
  }

  /**
   * The same drawing is about to be read with other options. It stays visible until then, so only what lists the decisions about its contours
   * changes. `same`: the contours and their numbers stay the same.
   */
  readAgain(load: LoadOptions, same: boolean): void {
    this.set({ load, applying: true });
    this.emit('applying', undefined);
    if (same) this.emit('decided', undefined);
  }

  /** The drawing could not be read with other options. */
  readAsBefore(load: LoadOptions): void {
    this.update({ load, applying: false });
    this.emit('decided', undefined);
  }

  /** Another drawing was read. */
  drawingOpened(loaded: Loaded, { name, sample, load }: Pick<State, 'name' | 'sample' | 'load'>): void {
    this.set({ name, sample, load, opening: null, refused: null, question: null });
    this.drawingRead(loaded, { fresh: true, same: false });
  }

  drawingRead(loaded: Loaded, as: { fresh: boolean; same: boolean }): void {
    this.set({ loaded, extent: extentOf(loaded), applying: false, error: null, ...noPlan() });
    this.emit('loaded', { loaded, ...as });
  }

  /** The page cannot plan at all, because there is no planner. */
  plannerFailed(sentence: string): void {
    this.set({ phase: 'failed', refused: { file: '', sentence }, loaded: null, question: null, ...noPlan() });
    this.emit('cleared', undefined);
    this.update({});
  }

  ask(question: Question): void {
    this.update({ phase: 'question', question });
  }

  programChecked(passed: boolean): void {
    if (this.state.programFails === passed) this.update({ programFails: !passed });
  }

  /** No question is open any more. Planning starts next, so there is no event. */
  questionsAnswered(): void {
    this.set({ question: null });
  }

  /** Planning has not started, because there is nothing to cut. */
  nothingToPlan(): void {
    this.update({ phase: 'ready', ...noPlan() });
  }

  /** `kept`: the plan that the search goes on from. What is known of it is shown at once. */
  planningStarted(budget: number, kept: KeptPlan | null): void {
    const shown = kept?.shown ?? { ...noPlan(), ...(kept === null ? {} : { curve: kept.curve }) };
    this.update({ phase: 'planning', error: null, budget, ...shown, reason: null });
    if (shown.progress !== null) this.emit('progress', this.current);
  }

  /** The search continues with a plan that was done; `budget` counts from its start, s. */
  planningContinued(budget: number): void {
    this.update({ ...this.entered('planning'), error: null, reason: null, budget });
  }

  /** The planner has prepared the search. */
  planPrepared({ seed, baselines, findings, beam, common }: Started): void {
    this.update({ seed, baselines, planFindings: findings, beam, common });
  }

  planningPaused(): void {
    this.update({ phase: 'paused' });
  }

  planningResumed(): void {
    this.update({ phase: 'planning' });
  }

  planProgressed(progress: Progress): void {
    const { path, insights, curve } = this.current;
    this.set({
      progress, path: progress.path ?? path,
      insights: progress.insight ? withInsight(insights, progress.insight) : insights,
      curve: extended(curve, progress.seconds, progress.summary.total_time),
    });
    this.emit('progress', this.current);
  }

  /** No plan of this job takes less than these seconds. */
  boundRaised(seconds: number): void {
    const { progress } = this.current;
    if (progress === null) return;
    // Rounding may have put it above the time of an optimal plan.
    this.set({ progress: withBound(progress, Math.min(seconds, progress.summary.total_time)) });
    this.emit('progress', this.current);
  }

  /** The plan has become better after its search: what was made of it is made again. */
  planImproved(progress: Progress): void {
    const { budget, reason } = this.current;
    this.planningContinued(budget);
    this.planProgressed(progress);
    this.planFinished(reason ?? 'stopped');
  }

  planFinished(reason: DoneReason): void {
    this.update({ ...this.entered('done'), reason });
  }

  /** These options allow no plan; the drawing stays. */
  planFailed(error: string): void {
    this.update({ ...this.entered('ready'), error, ...noPlan() });
  }

  /** The phase that the plan enters; while another file is being read it is the one to come back to. */
  private entered(phase: Phase): Partial<State> {
    if (this.current.phase !== 'reading') return { phase };
    this.beneath = phase;
    return {};
  }

  private set(changes: Partial<State>): void {
    this.current = { ...this.current, ...changes };
  }

  /** Changes the state and emits `change`. An action that a listener starts is emitted after the current round, so that the last state arrives last. */
  private update(changes: Partial<State>): void {
    this.set(changes);
    this.changed = true;
    if (this.emitting) return;
    this.emitting = true;
    try {
      while (this.changed) {
        this.changed = false;
        this.emit('change', this.current);
      }
    } finally {
      this.emitting = false;
    }
  }
}

/** The curve with another point. While the job time does not change, the last point moves along instead of a new one being added. */
function extended({ at, total }: PlanState['curve'], seconds: number, jobTime: number): PlanState['curve'] {
  const level = at.length > 1 && total.at(-1) === jobTime && total.at(-2) === jobTime;
  const kept = level ? at.length - 1 : at.length;
  return { at: [...at.slice(0, kept), seconds], total: [...total.slice(0, kept), jobTime] };
}
