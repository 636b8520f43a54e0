// What the server and the workers share: the queue, the folder of the drawings, and the options of a job.

import { createHash } from 'node:crypto';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export const QUEUE = 'quotes';
export const connection = { url: process.env.REDIS_URL ?? 'redis://localhost:6379', maxRetriesPerRequest: null };

/** The folder with the drawings that wait for a worker, each named after its job. Workers on several computers need a shared folder. */
export const DRAWINGS = process.env.DRAWINGS ?? join(tmpdir(), 'kerfway-drawings');
export const drawingOf = (id) => join(DRAWINGS, `${id}.dxf`);

/** The budget is in moves and not in seconds, so that the same drawing gets the same report and hash from every worker. */
export const BUDGET = { moves: 10_000, seed: 1 };
/** The size limit of a drawing. */
export const LARGEST = '20mb';
/** The number of drawings that may wait. More are refused, because a late answer is useless. */
export const MOST_WAITING = 2_000;
/** The time limit of a drawing, in milliseconds. */
export const PATIENCE = 60_000;

/** The options of every job. A faulty drawing is not tried again; a job that took too long is, after two and after four seconds. */
export const JOB = {
  attempts: 3,
  backoff: { type: 'exponential', delay: 2_000 },
  // Results are kept for a day.
  removeOnComplete: { age: 86_400 },
  removeOnFail: { age: 86_400 },
};

/**
 * A worker sends a sign of life every two seconds. After four seconds without one it counts as dead, and another worker gets
 * its drawing. A drawing that killed two workers is given up.
 */
export const WORKING = { lockDuration: 4_000, stalledInterval: 2_000, maxStalledCount: 1 };

/** The same drawing with the same options is one job, however often it is sent. */
export function idOf(drawing, options) {
  return createHash('sha256').update(JSON.stringify(options)).update('\0').update(drawing).digest('hex');
}

/** Begins the reason of a failed job whose drawing is the cause. The rest of the reason is one sentence for the sender. */
export const UNUSABLE = 'unusable: ';
