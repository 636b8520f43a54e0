/** The service of one machine: a pool of planners in this process. */

import { createPool } from '../node.js';
import { done, type Job } from './jobs.js';
import type { Answer, Backend } from './backend.js';
import type { ServerSettings } from './settings.js';

export function poolBackend({ workers, deadline }: ServerSettings): Backend {
  const pool = createPool({ size: workers, deadline });
  return {
    // The service takes no more requests than may run and wait, so the pool has no more.
    full: async () => false,
    take: async (job: Job, bytes: Uint8Array, signal: AbortSignal): Promise<Answer> => ({ status: 200, body: await done(pool, job, bytes, signal) }),
    find: async () => null,
    waiting: () => pool.waiting,
    close: async () => pool.close(),
  };
}
