/**
 * The service of several machines: BullMQ on Redis or Valkey. `kerfway serve --queue` puts jobs there, `kerfway work` takes them. A
 * job's id is the hash of the drawing and its options, so the same request is one job, however often it is sent. Drawings are
 * kept beside their jobs in the queue's server until these are finished; results expire.
 */

import { createHash } from 'node:crypto';
import type { Worker } from 'bullmq';
import type { Redis } from 'ioredis';
import { KerfwayError, reportOf } from '../errors.js';
import type { ErrorReport } from '../generated/types.js';
import { createPool } from '../node.js';
import type { Answer, Backend } from './backend.js';
import { done, type Job } from './jobs.js';
import type { Log } from './log.js';
import type { ServerSettings } from './settings.js';

const QUEUE = 'kerfway';

/** How often a job is tried when something other than its drawing is to blame, with the pause before the second try in ms. */
const ATTEMPTS = 3;
const BACKOFF = { type: 'exponential', delay: 2_000 };

/**
 * A worker sends a sign of life every two seconds. After four seconds without one it counts as dead, and another one gets its
 * job. A drawing that killed two workers is given up.
 */
const WORKING = { lockDuration: 4_000, stalledInterval: 2_000, maxStalledCount: 1 };

type Libraries = Pick<typeof import('bullmq'), 'Queue' | 'Worker' | 'UnrecoverableError'> & Pick<typeof import('ioredis'), 'Redis'>;

/** Loads BullMQ and its client, which are needed with a queue only and not a part of the package. */
async function libraries(): Promise<Libraries> {
  try {
    const { Queue, UnrecoverableError, Worker } = await import('bullmq');
    const { Redis } = await import('ioredis');
    return { Queue, UnrecoverableError, Worker, Redis };
  } catch {
    throw new KerfwayError('not-started', 'A queue needs the packages bullmq and ioredis. Install them beside kerfway: npm install bullmq ioredis.');
  }
}

const connection = (address: string) => ({ url: address, maxRetriesPerRequest: null });
const drawingKey = (id: string) => `kerfway:drawing:${id}`;

/** A connection of our own: for the drawings, which BullMQ does not keep, and for what the service asks of the queue. */
async function redisAt(address: string, log: Log): Promise<Redis> {
  const { Redis } = await libraries();
  const redis = new Redis(address, { maxRetriesPerRequest: null });
  redis.on('error', (error) => log('error', 'queue', { message: error.message }));
  return redis;
}

/** The hash of a drawing and everything that is wanted of it. */
export function idOf(job: Job, bytes: Uint8Array): string {
  const sorted = JSON.stringify(job, (_, value: unknown) =>
    typeof value === 'object' && value !== null && !Array.isArray(value) ? Object.fromEntries(Object.entries(value).sort(([a], [b]) => (a < b ? -1 : 1))) : value,
  );
  return createHash('sha256').update(sorted).update('\0').update(bytes).digest('hex');
}

/** The service's side of the queue. */
export async function queueBackend(address: string, { waiting, expires }: ServerSettings, log: Log): Promise<Backend> {
  const { Queue } = await libraries();
  const keep = { age: expires };
  const redis = await redisAt(address, log);
  const queue = new Queue<Job>(QUEUE, { connection: redis, defaultJobOptions: { attempts: ATTEMPTS, backoff: BACKOFF, removeOnComplete: keep, removeOnFail: keep } });
  queue.on('error', (error) => log('error', 'queue', { message: error.message }));
  let last = 0;
  const answered = async <T>(work: Promise<T>): Promise<T> => {
    try {
      return await inTime(work);
    } catch (error) {
      if (error instanceof KerfwayError) throw error;
      log('error', 'queue', { message: (error as Error).message });
      throw new KerfwayError('queue-unavailable', 'The queue does not answer. Try again in a moment.');
    }
  };
  return {
    full: async (arriving) => {
      last = await answered(queue.getWaitingCount());
      return last + arriving >= waiting;
    },
    take: async (job, bytes): Promise<Answer> => {
      const id = idOf(job, bytes);
      const put = async () => {
        const known = await queue.getJob(id);
        const state = known === undefined ? null : await known.getState();
        // A job that failed for a reason that may pass is tried again by another request.
        if (known !== undefined && state === 'failed' && failureOf(known.failedReason).retryable) await known.remove();
        else if (state !== null) return state;
        await redis.set(drawingKey(id), Buffer.from(bytes), 'EX', expires);
        await queue.add(job.kind, job, { jobId: id });
        return 'waiting';
      };
      return { status: 202, body: { id, state: await answered(put()) } };
    },
    find: async (id): Promise<Answer | null> => {
      const look = async (): Promise<Answer | null> => {
        // The state first: what is read after it is at least as new.
        const state = await queue.getJobState(id);
        const job = await queue.getJob(id);
        if (job === undefined) return null;
        if (state === 'failed') throw KerfwayError.of(failureOf(job.failedReason));
        return state === 'completed' ? { status: 200, body: job.returnvalue as object } : { status: 202, body: { id, state } };
      };
      return answered(look());
    },
    waiting: () => last,
    // The connection is ours, so BullMQ says no farewell on it, to which a server that is gone would never answer.
    close: async () => {
      await queue.close();
      redis.disconnect();
    },
  };
}

/** Milliseconds after which a queue counts as gone. */
const PATIENCE = 5_000;

function inTime<T>(work: Promise<T>): Promise<T> {
  work.catch(() => {});
  return new Promise((resolve, reject) => {
    const timer = setTimeout(() => reject(new Error(`no answer within ${PATIENCE} ms`)), PATIENCE);
    work.then(resolve, reject).finally(() => clearTimeout(timer));
  });
}

/** Notices when the server of a queue no longer answers, and says so in the log. */
interface Watch {
  /** Resolves as soon as the server owes an answer for too long. */
  gone(): Promise<void>;
  end(): void;
}

/** Asks the server of a queue for a sign of life again and again: one that hangs keeps its connections, and reports no error. */
function watch(redis: Redis, log: Log): Watch {
  let [ended, silent] = [false, false];
  const waiting: (() => void)[] = [];
  const ask = async () => {
    // One question at a time: what is not answered is kept. An error is an answer, too.
    const answer = redis.ping().catch(() => {});
    silent = !(await inTime(answer).then(() => true, () => false));
    if (!silent) return;
    for (const resolve of waiting.splice(0)) resolve();
    if (!ended) log('error', 'queue', { message: `The queue does not answer within ${PATIENCE / 1000} seconds. Jobs wait until it does.` });
    await answer;
    if (!ended) log('info', 'queue', { message: 'The queue answers again.' });
  };
  const watching = async () => {
    while (!ended) {
      await ask();
      await new Promise((resolve) => setTimeout(resolve, PATIENCE).unref());
    }
  };
  void watching();
  return {
    gone: () => (silent ? Promise.resolve() : new Promise((resolve) => waiting.push(resolve))),
    end: () => (ended = true),
  };
}

/** The report of a job that failed. */
function failureOf(reason: string | undefined): ErrorReport {
  try {
    const report = JSON.parse(reason ?? '') as ErrorReport;
    if (typeof report.code === 'string') return report;
  } catch {}
  if (/stalled/.test(reason ?? '')) return new KerfwayError('planner-died', 'Two workers died of this drawing. It may need more memory than there is.').toJSON();
  return new KerfwayError('internal', reason ?? '').toJSON();
}

/** A process that takes jobs from the queue. */
export interface QueueWorker {
  /**
   * Finishes the running jobs and ends. Without a connection to the queue it ends at once, and within seconds if the queue does not answer; then the
   * process has to be ended too, because BullMQ waits for an answer.
   */
  stop(): Promise<void>;
}

/** Takes jobs from the queue, several at once. */
export async function queueWorker(address: string, { workers, deadline }: Pick<ServerSettings, 'workers' | 'deadline'>, log: Log): Promise<QueueWorker> {
  const { UnrecoverableError, Worker } = await libraries();
  const redis = await redisAt(address, log);
  // Planners run in threads of their own, so that this thread can keep sending signs of life.
  const pool = createPool({ size: workers, deadline });
  const work = async (job: { id?: string; data: Job }): Promise<object> => {
    const id = job.id ?? '';
    try {
      const bytes = await redis.getBuffer(drawingKey(id));
      if (bytes === null) throw new KerfwayError('not-found', 'The drawing of this job has expired.');
      return await done(pool, job.data, new Uint8Array(bytes), new AbortController().signal);
    } catch (error) {
      const report = reportOf(error);
      if (report.code === 'internal') log('error', 'fault', { id, message: report.message, stack: (error as Error).stack });
      // Trying again does not mend a drawing; anything else may pass.
      throw report.retryable ? new Error(JSON.stringify(report)) : new UnrecoverableError(JSON.stringify(report));
    }
  };
  const worker: Worker<Job> = new Worker<Job>(QUEUE, work, { connection: connection(address), concurrency: workers, ...WORKING });
  const forget = async (id: string | undefined) => {
    if (id !== undefined) await redis.del(drawingKey(id));
  };
  worker.on('completed', (job) => {
    log('info', 'job', { id: job.id, kind: job.name, state: 'completed', ms: (job.finishedOn ?? 0) - (job.processedOn ?? 0) });
    forget(job.id).catch(() => {});
  });
  worker.on('failed', (job, error) => {
    log('warn', 'job', { id: job?.id, kind: job?.name, state: 'failed', message: error.message });
    if (job?.finishedOn !== undefined) forget(job.id).catch(() => {});
  });
  worker.on('error', (error) => log('error', 'queue', { message: error.message }));
  log('info', 'working', { workers });
  const queue = watch(redis, log);
  return {
    stop: async () => {
      // Without its server the worker would wait for ever, and results of running jobs would have nowhere to go.
      await Promise.race([worker.close(redis.status !== 'ready'), queue.gone()]);
      queue.end();
      pool.close();
      redis.disconnect();
      log('info', 'stopped');
    },
  };
}
