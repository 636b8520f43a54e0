/** Who does the work of the service: planners in this process, or the workers of a queue. */

import type { Job } from './jobs.js';

/** The answer to an upload. */
export type Answer = { status: 200; body: object } | { status: 202; body: { id: string; state: string } };

export interface Backend {
  /** Whether a further request would have to wait too long. `arriving`: the number of uploads before it that are not complete yet. */
  full(arriving: number): Promise<boolean>;
  /** Does a job, or puts it into the queue. */
  take(job: Job, bytes: Uint8Array, signal: AbortSignal): Promise<Answer>;
  /** The answer to a job that was put into the queue; `null` if there is no such job. */
  find(id: string): Promise<Answer | null>;
  /** Number of requests that wait. */
  waiting(): number;
  close(): Promise<void>;
}
