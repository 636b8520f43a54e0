/** Which message of a worker answers which request. */

import type { FromWorker } from './protocol.js';

/** The response to each kind of request. */
export interface Responses {
  load: Extract<FromWorker, { type: 'loaded' }>;
  offer: Extract<FromWorker, { type: 'offered' }>;
  output: Extract<FromWorker, { type: 'output' }>;
  papers: Extract<FromWorker, { type: 'papers' }>;
  quote: Extract<FromWorker, { type: 'quote' }>;
  check: Extract<FromWorker, { type: 'check' }>;
  sample: Extract<FromWorker, { type: 'sample' }>;
  calibrate: Extract<FromWorker, { type: 'calibrate' }>;
  restore: Extract<FromWorker, { type: 'done' }>;
}

/** The types of messages that settle a request. */
export const FINAL: ReadonlySet<string> = new Set(['loaded', 'offered', 'output', 'papers', 'quote', 'check', 'sample', 'calibrate', 'done', 'failed']);
