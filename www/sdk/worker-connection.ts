/**
 * The connection to a worker: starts it, sends it the compiled planner, exchanges messages with it, and notices when it
 * dies or stays silent for too long.
 */

import { KerfwayError } from './errors.js';
import { Pieces } from './pieces.js';
import type { FromWorker, ToWorker } from './protocol.js';
import type { WasmBytes, WasmModule } from './wasm-module.js';

/** The wasm that a worker is given when it starts. */
export interface WasmFiles {
  /** The compiled planner. */
  module: WasmModule;
  /** The writers of outputs, for workers that cannot load them themselves. */
  outputs?: WasmModule | WasmBytes | undefined;
}

/** A worker of any platform. */
export interface WorkerLike {
  post(message: ToWorker): void;
  close(): void;
}

/** Starts a worker. Its messages go to `onMessage`; its death goes to `onDeath`, with the reason in a sentence. */
export type StartWorker = (onMessage: (message: FromWorker) => void, onDeath: (why: string) => void) => WorkerLike;

/**
 * Seconds of silence after which a worker counts as hung. A search sends a message four times a second; reading the
 * largest allowed file takes about ten seconds, and a few times that on a slow phone.
 */
export const SILENCE_LIMITS = { searching: 15, working: 120 };

/** What the worker is doing, as far as the owner of the connection knows. */
export type Activity = 'idle' | 'working' | 'searching';

export class WorkerConnection {
  private readonly worker: WorkerLike;
  private readonly pieces = new Pieces();
  private open = true;
  private activity: Activity = 'idle';
  /** Seconds since the last message. */
  private silence = 0;
  private timer: ReturnType<typeof setInterval> | null = null;

  constructor(
    start: StartWorker,
    { module, outputs }: WasmFiles,
    private readonly onMessage: (message: FromWorker) => void,
    private readonly onDeath: (why: string) => void,
    private readonly limits = SILENCE_LIMITS,
  ) {
    this.worker = start(
      (message) => this.receive(message),
      (why) => this.died(why),
    );
    this.worker.post({ type: 'init', planner: module, outputs });
  }

  post(message: ToWorker): void {
    if (!this.open) return;
    try {
      this.worker.post(message);
    } catch (error) {
      throw new KerfwayError('wrong-type', `This cannot be sent to the worker: give plain data. ${(error as Error).message}`);
    }
  }

  close(): void {
    this.open = false;
    this.expect('idle');
    this.worker.close();
  }

  /** Sets what the worker should be doing, which decides how long it may stay silent. */
  expect(activity: Activity): void {
    if (activity === this.activity) return;
    this.activity = activity;
    this.silence = 0;
    if (this.timer !== null) clearInterval(this.timer);
    this.timer = activity === 'idle' ? null : setInterval(() => this.tick(activity), 1000);
  }

  private receive(message: FromWorker): void {
    if (!this.open) return;
    this.silence = 0;
    if (message.type === 'broken') {
      this.died(message.message);
      return;
    }
    const whole = this.pieces.receive(message);
    if (whole !== null) this.onMessage(whole);
  }

  // Counted in ticks and not by the clock, because a laptop that was asleep has not waited.
  private tick(activity: 'working' | 'searching'): void {
    this.silence += 1;
    if (this.silence > this.limits[activity]) this.died('The planner no longer answers.');
  }

  private died(why: string): void {
    if (!this.open) return;
    this.close();
    this.onDeath(why);
  }
}
