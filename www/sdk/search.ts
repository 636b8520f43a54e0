/**
 * Runs the search of a job in slices of about 20 ms and lets messages in between, so that pause and stop take effect
 * at once. Reports every improvement, at most one a frame, and never loses the last.
 */

import { bounded } from './bound.js';
import type { Job } from './pkg/kerfway.js';
import type { Budget, DoneReason, Progress, Slice, Summary, WarmPath } from './protocol.js';
import { stepFor } from './slice.js';

/** What a search tells. */
export interface Listener {
  progress(message: { id: number; progress: Progress }): void;
  done(message: { id: number; reason: DoneReason; progress: Progress }): void;
  meeting(message: { id: number; progress: Progress }): void;
  bound(message: { id: number; lowerBound: number }): void;
  failed(id: number, error: unknown): void;
}

/** Long enough that calls into wasm and messages cost nothing beside it, short enough that stop is at once. */
const SLICE_MS = 20;
/** A path is posted at most this often: a page draws no more than 60 frames a second, and eyes follow fewer. */
const FRAME_MS = 30;
/** Without improvements a number still moves: the moves done, four times a second. */
const PULSE_MS = 250;
/** Work put into telling of improvements is at most a fifth of the whole: on large sheets a path takes longer. */
const TELLING_SHARE = 4;
/** Moves of the very first slice, before anything is known of their speed. */
const FIRST_WORK = 256;
/** The most moves asked for at once: fits the 32 bits of the call. */
const MOST_WORK = 1e9;
/**
 * Moves at which several searches meet: first after so many, a third of a second's worth, then as often as they double,
 * as the cycles of the search do, and from the second on after so many each, some five seconds' worth.
 */
const MEETINGS = { first: 2 ** 20, apart: 2 ** 24 };

export class Search {
  private id = -1;
  private work = FIRST_WORK;
  private scheduled = false;
  private state: 'running' | 'paused' | 'ended' = 'ended';
  /** Moves at which the others are met; none when alone. */
  private meetAt = Infinity;
  /** When it came to where they meet; it waits. */
  private waitingSince: number | null = null;
  /** Milliseconds of work, pauses left out. */
  private worked = 0;
  /** When this budget is used up, on the same clock. */
  private until = Infinity;
  private rate = 0;
  private untold = true;
  private summary: Summary | null = null;
  private bound = 0;
  private tellAfter = 0;
  private pulseAt = 0;

  constructor(
    private readonly job: Job,
    private readonly listener: Listener,
    workers = 1,
  ) {
    if (workers > 1) this.meetAt = MEETINGS.first;
  }

  /** Starts on a budget; every message bears this id. */
  run(id: number, budget: Budget): void {
    this.id = id;
    this.until = this.worked + (budget.seconds ?? Infinity) * 1000;
    this.state = 'running';
    this.tell();
    this.schedule();
  }

  /** Goes on after the end, for another budget. */
  extend(id: number, budget: Budget): void {
    this.job.extend(budget);
    this.untold = true;
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

  /** Goes on after a meeting; after the end, takes the path over and tells it. */
  meet(path: WarmPath | null): void {
    if (path !== null) this.untold = this.job.offer(path) || this.untold;
    if (this.state === 'ended') return this.end('stopped');
    if (this.waitingSince === null) return;
    // Seconds are granted by the clock: waiting counts.
    this.worked += performance.now() - this.waitingSince;
    this.waitingSince = null;
    this.meetAt += Math.min(this.meetAt, MEETINGS.apart);
    this.schedule();
  }

  // One slice waits at most, also when a pause and a resume come before it has its turn.
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

  private raise(bound: number): void {
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

  // After a slice: it ends, waits for the others, tells, or just goes on.
  private proceed(end: Slice['end'], atMeeting: boolean): void {
    if (this.state !== 'running') return;
    if (end !== 'running') return this.end(end);
    if (this.worked >= this.until) return this.end('budget');
    if (atMeeting) return this.wait();
    const now = performance.now();
    if ((this.untold && now >= this.tellAfter) || now >= this.pulseAt) this.tell();
    this.schedule();
  }

  private wait(): void {
    this.waitingSince = performance.now();
    this.untold = true;
    this.listener.meeting({ id: this.id, progress: this.progress() });
  }

  private account(done: number, improved: boolean, ms: number): void {
    this.worked += ms;
    this.untold ||= improved;
    const pace = done / Math.max(ms, 0.05);
    // Of late: an average over the last dozen slices.
    this.rate += (pace * 1000 - this.rate) * (this.rate === 0 ? 1 : 1 / 12);
    const fitting = (pace * SLICE_MS) / this.work;
    this.work = Math.min(Math.max(this.work * Math.min(Math.max(fitting, 0.25), 4), 1), MOST_WORK);
  }

  // The last message always holds the path, told before or not: whoever waits for the end alone has all of it.
  private end(reason: DoneReason): void {
    this.state = 'ended';
    this.waitingSince = null;
    this.untold = true;
    this.listener.done({ id: this.id, reason, progress: this.progress() });
  }

  private tell(): void {
    const start = performance.now();
    this.listener.progress({ id: this.id, progress: this.progress() });
    const end = performance.now();
    this.worked += end - start;
    this.tellAfter = end + Math.max(FRAME_MS, TELLING_SHARE * (end - start));
    this.pulseAt = end + PULSE_MS;
  }

  private progress(): Progress {
    let [path, summary]: [Progress['path'], Summary | null] = [null, this.summary];
    if (this.untold || summary === null) {
      ({ path, summary } = this.job.best());
      this.summary = summary;
      this.untold = false;
    }
    const insight = this.job.insight();
    const seconds = this.worked / 1000;
    const all = { moves: this.job.moves(), seconds, rate: this.rate, summary: bounded(summary, this.bound), path };
    return insight === null ? all : { ...all, insight };
  }
}

/**
 * Runs `next` after waiting messages have been let in. Not by `setTimeout`, which browsers hold back to 4 ms when
 * nested; not by a message channel under Node, where one port can starve another.
 */
const later: (next: () => void) => void =
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
