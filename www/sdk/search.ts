/**
 * Runs the search of a job in slices of about 20 ms. Messages are handled between slices, so that pause and stop take
 * effect at once. Improvements are reported at most once per frame, and the last one is always reported.
 */

import { bounded } from './bound.js';
import type { Job } from './pkg/kerfway.js';
import type { Budget, DoneReason, Progress, Slice, Summary, WarmPath } from './protocol.js';
import { stepFor } from './slice.js';

/** Receives the messages of a search. */
export interface Listener {
  progress(message: { id: number; progress: Progress }): void;
  done(message: { id: number; reason: DoneReason; progress: Progress }): void;
  meeting(message: { id: number; progress: Progress }): void;
  bound(message: { id: number; lowerBound: number }): void;
  failed(id: number, error: unknown): void;
}

/** Length of a slice: long enough that calls into wasm and messages cost nothing in comparison, short enough for an immediate stop. */
const SLICE_MS = 20;
/** Shortest time between two paths. A page draws at most 60 frames a second, and eyes follow fewer. */
const FRAME_MS = 30;
/** Longest time between two reports, so that the number of moves keeps changing while there is no improvement. */
const QUIET_MS = 250;
/** After a report the search runs at least this many times as long, so that reports take a fifth of the time at most: the path of a large sheet takes long to copy. */
const SEARCH_PER_REPORT = 4;
/** Moves of the first slice, whose speed is not known yet. */
const FIRST_WORK = 256;
/** Most moves of one call: the argument has 32 bits. */
const MOST_WORK = 1e9;
/**
 * Numbers of moves at which several searches exchange their paths. The first exchange is after `first` moves (about a
 * third of a second). Then the number doubles, like the cycles of the search, until exchanges are `interval` moves apart
 * (about five seconds).
 */
const EXCHANGES = { first: 2 ** 20, interval: 2 ** 24 };

export class Search {
  /** The id of the plan, which all messages carry. */
  id = -1;
  private work = FIRST_WORK;
  private scheduled = false;
  private state: 'running' | 'paused' | 'ended' = 'ended';
  /** Number of moves of the next exchange with the other searches; infinite when there are none. */
  private meetAt = Infinity;
  /** Since when this search waits for the others, in milliseconds of the clock; `null` while it runs. */
  private waitingSince: number | null = null;
  /** Milliseconds of work, without pauses. */
  private worked = 0;
  /** The value of `worked` at which the budget is used up. */
  private until = Infinity;
  /** Moves per second. */
  private rate = 0;
  /** Whether the best path has not been reported yet. */
  private unreported = true;
  private summary: Summary | null = null;
  private bound = 0;
  private reportAfter = 0;
  private reportBy = 0;

  constructor(
    private readonly job: Job,
    private readonly listener: Listener,
    workers = 1,
  ) {
    if (workers > 1) this.meetAt = EXCHANGES.first;
  }

  /** Starts the search with a budget, as the plan with this id. */
  run(id: number, budget: Budget): void {
    this.id = id;
    this.until = this.worked + (budget.seconds ?? Infinity) * 1000;
    this.state = 'running';
    this.report();
    this.schedule();
  }

  /** Continues a search that has ended, with another budget. */
  extend(id: number, budget: Budget): void {
    this.job.extend(budget);
    this.unreported = true;
    this.run(id, budget);
  }

  pause(): void {
    if (this.state === 'running') this.state = 'paused';
  }

  resume(): void {
    if (this.state !== 'paused') return;
    this.state = 'running';
    this.schedule();
  }

  stop(): void {
    if (this.state !== 'ended') this.end('stopped');
  }

  /** Continues after an exchange, from `path` if that is faster. After the end, takes over the path and reports it. */
  meet(path: WarmPath | null): void {
    if (path !== null) this.unreported = this.job.offer(path) || this.unreported;
    if (this.state === 'ended') return this.end('stopped');
    if (this.waitingSince === null) return;
    // A budget in seconds is one of the clock, so waiting counts.
    this.worked += performance.now() - this.waitingSince;
    this.waitingSince = null;
    this.meetAt += Math.min(this.meetAt, EXCHANGES.interval);
    this.schedule();
  }

  /** Takes over a path after the end, if it is faster. Returns what the plan has become, or null if nothing changes. */
  offer(path: WarmPath): Progress | null {
    this.unreported = this.job.takeOver(path);
    return this.unreported ? this.progress() : null;
  }

  // At most one slice is scheduled, even if a pause and a resume come before it runs.
  private schedule(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    later(this.slice);
  }

  private readonly slice = (): void => {
    this.scheduled = false;
    if (this.state !== 'running' || this.waitingSince !== null) return;
    this.attempt(() => {
      const start = performance.now();
      const toMeeting = this.meetAt - this.job.moves();
      const { done, improved, end, bound } = stepFor(this.job, Math.min(Math.round(this.work), toMeeting), SLICE_MS);
      this.account(done, improved, performance.now() - start);
      this.raise(bound);
      this.proceed(end, done === toMeeting);
    });
  };

  /** Reports a lower bound of the job in seconds, if it is the highest so far. */
  raise(bound: number): void {
    if (bound <= this.bound) return;
    this.bound = bound;
    this.listener.bound({ id: this.id, lowerBound: bound });
  }

  private attempt(work: () => void): void {
    try {
      work();
    } catch (error) {
      this.state = 'ended';
      this.listener.failed(this.id, error);
    }
  }

  // After a slice: ends, waits for the other searches, reports, or just continues.
  private proceed(end: Slice['end'], atMeeting: boolean): void {
    if (this.state !== 'running') return;
    if (end !== 'running') return this.end(end);
    if (this.worked >= this.until) return this.end('budget');
    if (atMeeting) return this.wait();
    const now = performance.now();
    if ((this.unreported && now >= this.reportAfter) || now >= this.reportBy) this.report();
    this.schedule();
  }

  private wait(): void {
    this.waitingSince = performance.now();
    this.unreported = true;
    this.listener.meeting({ id: this.id, progress: this.progress() });
  }

  private account(done: number, improved: boolean, ms: number): void {
    this.worked += ms;
    this.unreported ||= improved;
    const pace = done / Math.max(ms, 0.05);
    // A moving average over about twelve slices.
    this.rate += (pace * 1000 - this.rate) * (this.rate === 0 ? 1 : 1 / 12);
    const fitting = (pace * SLICE_MS) / this.work;
    this.work = Math.min(Math.max(this.work * Math.min(Math.max(fitting, 0.25), 4), 1), MOST_WORK);
  }

  // The last message always contains the path, even if it was reported before: a caller may wait for the end alone.
  private end(reason: DoneReason): void {
    this.state = 'ended';
    this.waitingSince = null;
    this.unreported = true;
    this.listener.done({ id: this.id, reason, progress: this.progress() });
  }

  private report(): void {
    const start = performance.now();
    this.listener.progress({ id: this.id, progress: this.progress() });
    const end = performance.now();
    this.worked += end - start;
    this.reportAfter = end + Math.max(FRAME_MS, SEARCH_PER_REPORT * (end - start));
    this.reportBy = end + QUIET_MS;
  }

  private progress(): Progress {
    let [path, summary]: [Progress['path'], Summary | null] = [null, this.summary];
    if (this.unreported || summary === null) {
      ({ path, summary } = this.job.best());
      this.summary = summary;
      this.unreported = false;
    }
    const insight = this.job.insight();
    const seconds = this.worked / 1000;
    const progress = { moves: this.job.moves(), seconds, rate: this.rate, summary: bounded(summary, this.bound), path };
    return insight === null ? progress : { ...progress, insight };
  }
}

/**
 * Runs `next` after pending messages have been handled. Browsers delay nested calls of `setTimeout` to 4 ms, so it is not
 * used; in Node a message channel is not used either, because one port can starve another there.
 */
export const later: (next: () => void) => void =
  typeof setImmediate === 'function'
    ? (next) => void setImmediate(next)
    : (() => {
        const { port1, port2 } = new MessageChannel();
        let waiting: (() => void)[] = [];
        port1.onmessage = () => {
          const run = waiting;
          waiting = [];
          for (const next of run) next();
        };
        return (next) => {
          waiting.push(next);
          port2.postMessage(null);
        };
      })();
