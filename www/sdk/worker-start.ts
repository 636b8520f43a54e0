/**
 * The start of a worker. A worker that dies while it starts is started again: memory may be short for a moment, or the machine
 * goes to sleep.
 */

import { type ClosedError, KerfwayError } from './errors.js';

/** How often a worker is started before the planner gives up. */
const STARTS = 2;

export class WorkerStart {
  /** Settles the promise of the running attempt. */
  private attempt: { resolve: () => void; reject: (error: Error) => void } | null = null;

  /** Whether a worker is starting. */
  get running(): boolean {
    return this.attempt !== null;
  }

  /** Starts a worker with `open`, again if it dies. `closed` returns the reason for giving up, once the planner is closed. */
  async run(open: () => void, closed: () => ClosedError | null): Promise<void> {
    for (let left = STARTS; ; ) {
      left -= 1;
      try {
        return await new Promise<void>((resolve, reject) => {
          this.attempt = { resolve, reject };
          open();
        });
      } catch (error) {
        const reason = closed();
        if (reason !== null) throw reason;
        if (left === 0) throw new KerfwayError('not-started', `The planner could not be started. ${(error as Error).message} It was tried ${STARTS} times.`);
      }
    }
  }

  /** The worker is ready. */
  succeed(): void {
    this.attempt?.resolve();
    this.attempt = null;
  }

  /** The worker has died, or is no longer wanted. */
  fail(reason: Error): void {
    this.attempt?.reject(reason);
  }
}
