/** The search for a path: starting, pausing, stopping and continuing it. Only the newest search changes the state. */

import { activeContours, type DoneReason, isKerfwayError, type PlanHandle, type PlanOptions, type Progress, type WarmPath } from 'kerfway';
import { Latest } from '../core/latest.js';
import { messageOf } from '../core/strings.js';
import { isUsed } from '../offline/first-visit.js';
import type { Catalog } from './catalog.js';
import { addedTo, type KeptPlan } from './kept-plan.js';
import { jobOptions } from './placing.js';
import { isOptimal } from './state.js';
import type { Store } from './store.js';

/** Milliseconds without a keystroke before the plan starts again, so that it does not start at every digit. */
const SETTLE = 350;

/**
 * How many workers search. One core is left for the page and for the person's other work. More than four workers cost more memory than they
 * gain in time, because each holds the drawing.
 */
const WORKERS = Math.min(Math.max((navigator.hardwareConcurrency || 2) - 1, 1), 4);

/**
 * So many seconds after it was started, a worker of its own begins to work on a stronger bound than the search's, or proves that the path is
 * optimal, beside the search or after it. The file for it is not part of a first visit.
 */
const PROVE_AFTER = 10;

/** Seconds that it goes on after the search: for hundreds of contours, most of what can be proven is proven within a minute. */
const PROVE_ON = 60;

export class Planning {
  private readonly latest = new Latest();
  private run: PlanHandle | null = null;
  /** The work on a stronger bound beside the search. */
  private prover: { close(): void } | null = null;
  /** The best path that it has found, until it is offered to the plan. */
  private found: WarmPath | null = null;
  private timer = 0;
  private proofTimer = 0;
  /** The plan that the current search goes on from. */
  private before: KeptPlan | null = null;

  constructor(private readonly store: Store, private readonly catalog: Catalog) {}

  /** Plans the drawing: from the start, or on from a plan that was kept. */
  start(kept: KeptPlan | null = null): void {
    const { loaded, machine, search: { method, parameters, seed, seconds } } = this.store.state;
    const { planner, papers } = this.catalog;
    if (!loaded || !machine || !planner) return;
    const isLatest = this.cancel();
    if (activeContours(loaded).length === 0) {
      this.store.nothingToPlan();
      return;
    }
    // A method from a paper works alone and has parameters.
    const fromPaper = papers.some((m) => m.name === method);
    const options = {
      machine, ...jobOptions(this.store.state), method,
      ...(fromPaper ? { parameters } : { workers: WORKERS }), ...(seed === null ? {} : { seed }), ...(kept === null ? { seconds } : continuing(kept)),
    };
    this.before = kept;
    const run = planner.plan(options, this.reporter(isLatest));
    this.store.planningStarted(kept?.budget ?? seconds, kept);
    this.follow(run, isLatest, kept?.reason ?? null);
  }

  /** Plans again after a choice. After a keystroke it waits for more of them. */
  restart(typed = false): void {
    if (typed && this.mayPlan()) {
      clearTimeout(this.timer);
      this.timer = window.setTimeout(() => this.start(), SETTLE);
    } else this.continueFrom(null);
  }

  /** Goes on with a plan that was kept, or plans again if there is none. */
  continueFrom(kept: KeptPlan | null): void {
    clearTimeout(this.timer);
    if (this.mayPlan()) this.start(kept);
  }

  /** There is a drawing, and no question about it is open. */
  private mayPlan(): boolean {
    const { loaded, phase } = this.store.state;
    return loaded !== null && phase !== 'question' && phase !== 'reading';
  }

  /** Ends the current search and the proof of its job, and discards whatever they still report. */
  cancel(): () => boolean {
    this.stopProof();
    return this.endSearch();
  }

  private endSearch(): () => boolean {
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
    this.stopProof();
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
    // The proof goes on: the job is the same.
    clearTimeout(this.proofTimer);
    const isLatest = this.endSearch();
    const run = planner.continue({ seconds }, this.reporter(isLatest));
    this.store.planningContinued((progress?.seconds ?? 0) + seconds);
    this.follow(run, isLatest);
  }

  /** Takes over what a search reports, together with the search before it. */
  private reporter(isLatest: () => boolean): (progress: Progress) => void {
    return (progress) => {
      if (!isLatest()) return;
      this.store.planProgressed(addedTo(this.before, progress));
      if (progress.seconds > PROVE_AFTER) this.prove();
    };
  }

  /** Works on a stronger bound. While the search runs, its progress brings what is proven. */
  private prove(): void {
    const { planner } = this.catalog;
    if (this.prover !== null || planner === null) return;
    let last: WarmPath | null = null;
    const prover = planner.prove({}, (seconds, path) => {
      if (path !== last) this.found = last = path;
      if (this.run !== null) return;
      this.store.boundRaised(seconds);
      this.takeOver();
    });
    this.prover = prover;
    // Without it, the plan keeps the bound of its search.
    prover.done.catch(() => {});
  }

  /** Takes over a path that the proof has found, if it is better than that of the search, which has ended. */
  private takeOver(): void {
    const { found, store } = this;
    const { phase, search: { method } } = store.state;
    // While another file is being read, this plan may be about to go. Who chooses another method wants the path of that.
    if (found === null || phase !== 'done' || method !== this.catalog.methods[0]?.name) return;
    this.found = null;
    const isCurrent = this.latest.watch();
    this.catalog.planner?.offer(found).then(
      (progress) => progress !== null && isCurrent() && store.planImproved(addedTo(this.before, progress)),
      () => {}, // Without it, the plan is that of the search.
    );
  }

  /** After the search, the proof goes on for a while: it says whether more searching can help. */
  private proveOn(isLatest: () => boolean): void {
    if (isOptimal(this.store.state)) {
      this.stopProof();
      return;
    }
    const searched = this.store.state.progress?.seconds ?? 0;
    this.proofTimer = window.setTimeout(async () => {
      await isUsed;
      // Another file may be taking the place of this drawing.
      if (!isLatest() || this.store.state.phase !== 'done') return;
      this.prove();
      this.proofTimer = window.setTimeout(() => this.stopProof(), 1000 * PROVE_ON);
    }, 1000 * Math.max(0, PROVE_AFTER - searched));
  }

  private stopProof(): void {
    clearTimeout(this.proofTimer);
    this.prover?.close();
    this.prover = null;
    this.found = null;
  }

  /** `ended`: why the search of the plan had ended before it was kept. */
  private follow(run: PlanHandle, isLatest: () => boolean, ended: DoneReason | null = null): void {
    this.run = run;
    run.started.then(
      (started) => isLatest() && this.store.planPrepared(started),
      () => {}, // A search that cannot start also rejects `done`, which reports it.
    );
    run.done.then(
      ({ reason, progress }) => {
        if (!isLatest()) return;
        this.run = null;
        this.store.planProgressed(addedTo(this.before, progress));
        this.store.planFinished(ended ?? reason);
        this.takeOver();
        this.proveOn(isLatest);
      },
      (error: unknown) => {
        if (!isLatest()) return;
        this.run = null;
        this.stopProof();
        // A kept plan may not fit any more, because another version of the page reads the drawing differently.
        if (isKerfwayError(error) && error.code === 'unfit-path') this.start();
        else this.store.planFailed(messageOf(error));
      },
    );
  }
}

/** The options with which a search goes on from a plan: for the rest of its time, or for no time if it had ended. */
function continuing({ path, seed, seconds, budget, reason }: KeptPlan): PlanOptions {
  const left = Math.max(0, budget - seconds);
  return { warm: path, seed, ...(reason === null && left > 0 ? { seconds: left } : { moves: 0 }) };
}
