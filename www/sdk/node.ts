/** Kerfway under Node: the same planner as in a browser, in a worker thread. See `index.ts`. */

import { readFile } from 'node:fs/promises';
import { Worker } from 'node:worker_threads';
import type { StartWorker } from './line.js';
import { opener } from './opener.js';

export { Planner, type PlannerOptions } from './planner.js';
export type { PlanHandle, PlanResult, Started } from './plan-handle.js';
export type * from './protocol.js';

const start: StartWorker = (heard, died) => {
  const worker = new Worker(new URL('./node-worker.js', import.meta.url));
  worker.on('message', heard);
  worker.on('error', (error) => died(`The planner broke down (${error.message}).`));
  worker.on('exit', () => died('The planner ended unexpectedly.'));
  return { post: (message) => worker.postMessage(message), close: () => void worker.terminate() };
};

const read = async (): Promise<WebAssembly.Module> => WebAssembly.compile(await readFile(new URL('./pkg/kerfway_bg.wasm', import.meta.url)));

/** A planner with its worker ready. Close it when done: an open one keeps the process alive. */
export const createPlanner = opener(read, start);
