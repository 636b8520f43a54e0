/** A plan under way, as its caller holds it, and what is known of it. */

import { bounded } from './bound.js';
import { ClosedError } from './closed.js';
import type { Baselines, Beam, BestPath, DoneReason, Finding, FromWorker, Geometry, PlanOptions, Progress } from './protocol.js';

/** What a plan started with. */
export interface Started {
  seed: number;
  method: string;
  baselines: Baselines;
  /** What is worth knowing of the drawing on this machine, besides what `load` told. */
  findings: Finding[];
  /** The lines of the beam, where the machine has a kerf width. */
  beam: Beam | null;
  /** What is cut once for two parts: stretches of contours that share cuts. Null where nobody has looked for them. */
  common: Geometry | null;
}

/** What a plan came to; `progress.path` is always set. */
export interface PlanResult extends Started {
  reason: DoneReason;
  progress: Progress;
}

/** A plan under way. */
export interface PlanHandle {
  /** Resolves when the search begins, with the job as it would run without it. */
  readonly started: Promise<Started>;
  /** Resolves when the plan ends, however it does; rejects with one sentence when there can be none. */
  readonly done: Promise<PlanResult>;
  /** Pauses the search; the best plan so far is kept. */
  pause(): void;
  /** Continues a paused search. */
  resume(): void;
  /** Ends the plan at once; the best found is kept. */
  stop(): void;
}

/** The messages that concern a plan. */
export type PlanMessage = Extract<FromWorker, { type: 'started' | 'progress' | 'bound' | 'done' | 'failed' }>;

/** A plan from its start to its end. */
export class RunningPlan {
  readonly handle: PlanHandle;
  paused = false;
  ended = false;
  begun: Started | null = null;
  /** The best path told so far: what a new worker starts from. */
  path: BestPath | null = null;

  private last: Progress | null = null;
  private readonly started = deferred<Started>();
  private readonly done = deferred<PlanResult>();

  constructor(
    readonly id: number,
    readonly options: PlanOptions,
    private readonly onProgress: (progress: Progress) => unknown,
    private readonly post: (message: { type: 'pause' | 'resume' | 'stop' }) => void,
  ) {
    // Whoever waits for the end alone hears of a failure there.
    this.started.promise.catch(() => {});
    this.handle = {
      started: this.started.promise,
      done: this.done.promise,
      pause: () => this.steer('pause'),
      resume: () => this.steer('resume'),
      stop: () => this.steer('stop'),
    };
  }

  /** Goes on where another plan ended. */
  follow(before: RunningPlan): void {
    this.path = before.path;
    if (before.begun !== null) this.begin(before.begun);
  }

  hear(message: PlanMessage): void {
    if (this.ended) return;
    switch (message.type) {
      case 'started':
        this.begin({ seed: message.seed, method: message.method, baselines: message.baselines, findings: message.findings, beam: message.beam, common: message.common });
        return;
      case 'progress':
        this.keep(message.progress);
        this.report(message.progress);
        return;
      case 'bound':
        if (this.last === null) return;
        this.last = { ...this.last, summary: bounded(this.last.summary, message.lowerBound) };
        this.report({ ...this.last, path: null });
        return;
      case 'done':
        this.keep(message.progress);
        this.end(message.reason);
        return;
      case 'failed':
        this.fail(new Error(message.message));
        return;
    }
  }

  /** The worker is gone: what was told is what there is. */
  interrupt(reason: Error): void {
    if (this.path === null) this.fail(reason);
    else this.end('replaced');
  }

  fail(reason: unknown): void {
    this.ended = true;
    this.started.reject(reason);
    if (reason instanceof ClosedError) this.done.promise.catch(() => {});
    this.done.reject(reason);
  }

  // A callback that throws, or rejects when it is asynchronous, fails its own plan; the worker need not go on with it.
  private report(progress: Progress): void {
    const fail = (error: unknown) => {
      this.steer('stop');
      if (!this.ended) this.fail(error);
    };
    try {
      const reported = this.onProgress(progress);
      if (reported instanceof Promise) reported.catch(fail);
    } catch (error) {
      fail(error);
    }
  }

  private begin(started: Started): void {
    this.begun = started;
    this.started.resolve(started);
  }

  private keep(progress: Progress): void {
    this.last = progress;
    this.path = progress.path ?? this.path;
  }

  private end(reason: DoneReason): void {
    this.ended = true;
    if (this.begun === null || this.last === null) return;
    this.done.resolve({ ...this.begun, reason, progress: { ...this.last, path: this.path } });
  }

  private steer(type: 'pause' | 'resume' | 'stop'): void {
    if (this.ended) return;
    this.paused = type === 'pause';
    this.post({ type });
  }
}

interface Deferred<T> {
  promise: Promise<T>;
  resolve: (value: T) => void;
  reject: (reason: unknown) => void;
}

function deferred<T>(): Deferred<T> {
  let resolve!: Deferred<T>['resolve'];
  let reject!: Deferred<T>['reject'];
  const promise = new Promise<T>((yes, no) => ((resolve = yes), (reject = no)));
  return { promise, resolve, reject };
}
