/**
 * A line to a worker: opens it, hands it the compiled planner, carries messages, and notices when the worker dies or
 * says nothing for too long.
 */

import type { FromWorker, ToWorker } from './protocol.js';

/** A worker, whatever kind the platform has. */
export interface WorkerLike {
  post(message: ToWorker): void;
  close(): void;
}

/** Starts a worker; what it says goes to `heard`, its death to `died`. */
export type StartWorker = (heard: (message: FromWorker) => void, died: (why: string) => void) => WorkerLike;

/**
 * Seconds without a word after which a worker counts as hung. While a search runs it speaks four times a second;
 * reading the largest file that is allowed takes some ten seconds, on a slow phone a few times that.
 */
export const PATIENCE = { searching: 15, working: 120 };

/** What the worker is at, as far as the owner of the line knows. */
export type Activity = 'idle' | 'working' | 'searching';

export class Line {
  private readonly worker: WorkerLike;
  private open = true;
  private activity: Activity = 'idle';
  private silence = 0;
  private watch: ReturnType<typeof setInterval> | null = null;

  constructor(
    start: StartWorker,
    module: WebAssembly.Module,
    private readonly heard: (message: FromWorker) => void,
    private readonly died: (why: string) => void,
    private readonly patience = PATIENCE,
  ) {
    this.worker = start(
      (message) => this.hear(message),
      (why) => this.die(why),
    );
    this.worker.post({ type: 'init', planner: module });
  }

  post(message: ToWorker): void {
    if (this.open) this.worker.post(message);
  }

  close(): void {
    this.open = false;
    this.expect('idle');
    this.worker.close();
  }

  /** Says what the worker should be at: silence is judged by it. */
  expect(activity: Activity): void {
    if (activity === this.activity) return;
    this.activity = activity;
    this.silence = 0;
    if (this.watch !== null) clearInterval(this.watch);
    this.watch = activity === 'idle' ? null : setInterval(() => this.tick(activity), 1000);
  }

  private hear(message: FromWorker): void {
    if (!this.open) return;
    this.silence = 0;
    if (message.type === 'broken') this.die(message.message);
    else this.heard(message);
  }

  // Counted in ticks, not by the clock: a laptop that slept has not waited.
  private tick(activity: 'working' | 'searching'): void {
    this.silence += 1;
    if (this.silence > this.patience[activity]) this.die('The planner no longer answers.');
  }

  private die(why: string): void {
    if (!this.open) return;
    this.close();
    this.died(why);
  }
}
