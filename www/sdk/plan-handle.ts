/** A running plan: the handle that its caller has, and its state in the planner. */

import { bounded } from './bound.js';
import { ClosedError, KerfwayError } from './errors.js';
import type { Baselines, Beam, BestPath, DoneReason, Finding, FromWorker, Geometry, PlanOptions, Progress, ToWorker } from './protocol.js';

/** What is known when a plan starts. */
export interface Started {
  /** The seed of the search. */
  seed: number;
  /** The name of the method. */
  method: string;
  /** The plans without a search. */
  baselines: Baselines;
  /** Findings about the drawing on this machine, in addition to those of `load`. */
  findings: Finding[];
  /** The contours as the beam follows them, if the machine has a kerf width. */
  beam: Beam | null;
  /** The common cuts: stretches of contours that are cut once for two parts. Null when they were not searched for. */
  common: Geometry | null;
  /** The placement: from the coordinates of the drawing, in which geometry and paths are given, to those of the machine, mm. Outputs are in machine coordinates. */
  shift: [number, number];
}

/** The result of a plan; `progress.path` is always set. */
export interface PlanResult extends Started {
  reason: DoneReason;
  progress: Progress;
}

/** A running plan. */
export interface PlanHandle {
  /** Resolves when the search begins. */
  readonly started: Promise<Started>;
  /** Resolves when the plan ends for any reason; rejects with one sentence when the drawing cannot be planned. */
  readonly done: Promise<PlanResult>;
  /** Pauses the search; the best plan so far is kept. */
  pause(): void;
  /** Continues a paused search. */
  resume(): void;
  /** Ends the plan at once; the best plan so far is kept. */
  stop(): void;
}

/** The messages about a plan. */
export type PlanMessage = Extract<FromWorker, { type: 'started' | 'progress' | 'bound' | 'done' | 'failed' }>;

/** A plan from its start to its end. */
export class RunningPlan {
  readonly handle: PlanHandle;
  paused = false;
  ended = false;
  begun: Started | null = null;
  options: PlanOptions = {};
  /** The best path reported so far, from which a new worker starts. */
  path: BestPath | null = null;

  private last: Progress | null = null;
  private readonly started = deferred<Started>();
  private readonly done = deferred<PlanResult>();

  constructor(
    readonly id: number,
    private readonly onProgress: (progress: Progress) => unknown,
    private readonly post: (message: ToWorker) => void,
  ) {
    // A caller that only waits for `done` gets a failure there, so it must not count as unhandled here.
    this.started.promise.catch(() => {});
    this.handle = {
      started: this.started.promise,
      done: this.done.promise,
      pause: () => this.request('pause'),
      resume: () => this.request('resume'),
      stop: () => this.request('stop'),
    };
  }

  /** Continues from where another plan ended, or is being ended: this one begins as that did. If that never begins, the worker refuses this one. */
  follow(before: RunningPlan): void {
    [this.path, this.last] = [before.path, before.last];
    before.started.promise.then((started) => this.begin(started), () => {});
  }

  receive(message: PlanMessage): void {
    if (this.ended) return;
    switch (message.type) {
      case 'started':
        this.begin({ seed: message.seed, method: message.method, baselines: message.baselines, findings: message.findings, beam: message.beam, common: message.common, shift: message.shift });
        return;
      case 'progress':
        this.keep(message.progress);
        void this.report(message.progress);
        return;
      case 'bound':
        if (this.last === null) return;
        this.last = { ...this.last, summary: bounded(this.last.summary, message.lowerBound) };
        void this.report({ ...this.last, path: null });
        return;
      case 'done': {
        const isBetter = this.last !== null && message.progress.summary.total_time < this.last.summary.total_time;
        this.keep(message.progress);
        if (isBetter) void this.report(message.progress);
        this.end(message.reason);
        return;
      }
      case 'failed':
        this.fail(KerfwayError.of(message.error));
        return;
    }
  }

  /** The worker has taken over a better path after the search. Returns the plan's progress, to which all its workers contributed. */
  improve({ summary, path }: Progress): Progress {
    const progress = { ...(this.last as Progress), summary, path };
    this.keep(progress);
    return progress;
  }

  /** The worker is gone: the plan ends with the best path reported so far. It fails if there is none, or if its planner was closed. */
  interrupt(reason: Error): void {
    if (this.path === null || reason instanceof ClosedError) this.fail(reason);
    else this.end('replaced');
  }

  fail(reason: unknown): void {
    this.ended = true;
    this.started.reject(reason);
    if (reason instanceof ClosedError) this.done.promise.catch(() => {});
    this.done.reject(reason);
  }

  // A callback that throws (or rejects, when it is asynchronous) fails its own plan, and the search stops. One that throws does so at once,
  // so that a plan whose last progress it refuses does not succeed.
  private async report(progress: Progress): Promise<void> {
    try {
      await this.onProgress(progress);
    } catch (error) {
      this.request('stop');
      if (!this.ended) this.fail(error);
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
    if (this.ended) return;
    this.ended = true;
    if (this.begun === null || this.last === null) this.fail(new KerfwayError('planner-died', 'The plan ended before it had a path.'));
    else this.done.resolve({ ...this.begun, reason, progress: { ...this.last, path: this.path } });
  }

  private request(type: 'pause' | 'resume' | 'stop'): void {
    if (this.ended) return;
    this.paused = type === 'pause';
    this.post({ type, id: this.id });
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
