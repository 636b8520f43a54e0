// A worker process: takes drawings from the queue, one at a time, and answers each with a quote report.

import { readFile, rm } from 'node:fs/promises';
import { UnrecoverableError, Worker } from 'bullmq';
import { createPool } from 'kerfway';
import { whyUnusable } from '../express/request.mjs';
import { BUDGET, connection, drawingOf, PATIENCE, QUEUE, UNUSABLE, WORKING } from './queue.mjs';

// One planner for all drawings, in a thread of its own, so that this thread can keep sending signs of life to the queue.
const pool = createPool({ size: 1 });

const worker = new Worker(QUEUE, quoted, { connection, concurrency: 1, name: String(process.pid), ...WORKING });
worker.on('error', (error) => console.error(`worker ${process.pid}: ${error.message}`));

// A finished job no longer needs its drawing.
worker.on('completed', (job) => rm(drawingOf(job.id), { force: true }));
worker.on('failed', (job) => job?.finishedOn !== undefined && rm(drawingOf(job.id), { force: true }));

async function quoted(job) {
  const signal = AbortSignal.timeout(PATIENCE);
  try {
    return await pool.quote(() => readFile(drawingOf(job.id)), { ...job.data, ...BUDGET, signal });
  } catch (error) {
    const tooLong = `${UNUSABLE}The drawing takes longer than ${PATIENCE / 1000} seconds.`;
    if (signal.aborted) throw new Error(tooLong);
    const drawing = await readFile(drawingOf(job.id)).catch(() => null);
    const unusable = drawing === null ? null : await whyUnusable(pool, drawing, signal);
    if (signal.aborted) throw new Error(tooLong);
    // Trying again would not repair the drawing; another error may pass.
    if (unusable !== null) throw new UnrecoverableError(UNUSABLE + unusable);
    console.error(error);
    throw error;
  }
}

// Running jobs are finished first.
process.on('SIGTERM', async () => {
  await worker.close();
  pool.close();
});
