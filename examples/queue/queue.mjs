// What the server and the workers agree on: where the queue is, where drawings lie, and what may be asked of a worker.

import { createHash } from 'node:crypto';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export const QUEUE = 'quotes';
export const connection = { url: process.env.REDIS_URL ?? 'redis://localhost:6379', maxRetriesPerRequest: null };

/** Drawings that wait for a worker, each named by its job. With workers on several machines: a folder that all of them see. */
export const DRAWINGS = process.env.DRAWINGS ?? join(tmpdir(), 'kerfway-drawings');
export const drawingOf = (id) => join(DRAWINGS, `${id}.dxf`);

/** A budget in moves, not in seconds: the same drawing gets the same answer, hash and all, whoever works on it. */
export const BUDGET = { moves: 10_000, seed: 1 };
/** The largest drawing taken. */
export const LARGEST = '20mb';
/** Drawings that may wait. More are turned away: an answer that comes too late is of use to nobody. */
export const MOST_WAITING = 2_000;
/** Milliseconds a drawing may take. */
export const PATIENCE = 60_000;

/** Of every job. What is wrong with a drawing stays wrong; only what took too long is tried again, after two seconds and four. */
export const JOB = {
  attempts: 3,
  backoff: { type: 'exponential', delay: 2_000 },
  // Answers are kept for a day.
  removeOnComplete: { age: 86_400 },
  removeOnFail: { age: 86_400 },
};

/**
 * A worker says every two seconds that it is alive. One that does not for four is taken for dead, and its drawing goes to
 * another; a drawing that two workers died of is given up.
 */
export const WORKING = { lockDuration: 4_000, stalledInterval: 2_000, maxStalledCount: 1 };

/** The same drawing with the same wishes is one job, however often it is sent. */
export function idOf(drawing, wishes) {
  return createHash('sha256').update(JSON.stringify(wishes)).update('\0').update(drawing).digest('hex');
}
