/** The search for a path: starting, pausing, stopping and continuing it. Only the newest search changes the state. */

import { activeContours, type PlanHandle } from 'kerfway';
import { Latest } from '../core/latest.js';
import { messageOf } from '../core/strings.js';
import type { Catalog } from './catalog.js';
import type { Store } from './store.js';

/** Milliseconds without a keystroke before the plan starts again, so that it does not start at every digit. */
const SETTLE = 350;

/**
 * How many workers search. One core is left for the page and for the person's other work. More than four workers cost more memory than they
 * gain in time, because each holds the drawing.
 */
const WORKERS = Math.min(Math.max((navigator.hardwareConcurrency || 2) - 1, 1), 4);

export class Planning {
  private readonly latest = new Latest();
  private run: PlanHandle | null = null;
  private timer = 0;

  constructor(private readonly store: Store, private readonly catalog: Catalog) {}

  /** Plans the drawing from the start. */
  start(): void {
    const { loaded, machine, search: { method, parameters, seed, seconds }, placing } = this.store.state;
    const { planner, papers } = this.catalog;
    if (!loaded || !machine || !planner) return;
    const isLatest = this.cancel();
    if (activeContours(loaded).length === 0) {
      this.store.nothingToPlan();
      return;
    }
    // A method from a paper works alone and has parameters.
    const fromPaper = papers.some((m) => m.name === method);
    const { place, start, allowOffBed } = placing;
    const options = { machine, start, allowOffBed, ...(place === null ? {} : { place }), method, seconds, ...(fromPaper ? { parameters } : { workers: WORKERS }), ...(seed === null ? {} : { seed }) };
    const run = planner.plan(options, (progress) => isLatest() && this.store.planProgressed(progress));
    this.store.planningStarted(seconds);
    this.follow(run, isLatest);
  }

  /** Plans again after a choice. After a keystroke it waits for more of them. */
  restart(typed = false): void {
    clearTimeout(this.timer);
    const { loaded, phase } = this.store.state;
    if (!loaded || phase === 'question') return;
    if (typed) this.timer = window.setTimeout(() => this.start(), SETTLE);
    else this.start();
  }

  /** Ends the current search, and discards whatever it still reports. */
  cancel(): () => boolean {
    clearTimeout(this.timer);
    this.run?.stop();
    this.run = null;
    return this.latest.begin();
  }

  /** Ends the search and keeps the best path. */
  stop(): void {
    this.run?.stop();
  }

  pause(): void {
    if (this.store.state.phase !== 'planning') return;
    this.run?.pause();
    this.store.planningPaused();
  }

  resume(): void {
    if (this.store.state.phase !== 'paused') return;
    this.run?.resume();
    this.store.planningResumed();
  }

  /** Continues the plan for another time budget. */
  keepImproving(): void {
    const { phase, progress, search: { seconds } } = this.store.state;
    const { planner } = this.catalog;
    if (phase !== 'done' || !planner) return;
    const isLatest = this.cancel();
    const run = planner.continue({ seconds }, (report) => isLatest() && this.store.planProgressed(report));
    this.store.planningContinued((progress?.seconds ?? 0) + seconds);
    this.follow(run, isLatest);
  }

  private follow(run: PlanHandle, isLatest: () => boolean): void {
    this.run = run;
    run.started.then(
      (started) => isLatest() && this.store.planPrepared(started),
      () => {}, // A search that cannot start also rejects `done`, which reports it.
    );
    run.done.then(
      ({ reason, progress }) => {
        if (!isLatest()) return;
        this.run = null;
        this.store.planProgressed(progress);
        this.store.planFinished(reason);
      },
      (error: unknown) => {
        if (!isLatest()) return;
        this.run = null;
        this.store.planFailed(messageOf(error));
      },
    );
  }
}
