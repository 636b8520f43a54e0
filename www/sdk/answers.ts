/** What requests to a worker are answered with. */

import type { FromWorker } from './protocol.js';

/** The answers to requests, by what was asked. */
export interface Answers {
  load: Extract<FromWorker, { type: 'loaded' }>;
  output: Extract<FromWorker, { type: 'output' }>;
  papers: Extract<FromWorker, { type: 'papers' }>;
  quote: Extract<FromWorker, { type: 'quote' }>;
  restore: Extract<FromWorker, { type: 'done' }>;
}

/** The messages that answer a request for good. */
export const FINAL: ReadonlySet<string> = new Set(['loaded', 'output', 'papers', 'quote', 'done', 'failed']);
