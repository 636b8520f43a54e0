/** Kerfway under Node: the same planner as in a browser, in a worker thread. See `index.ts`. */

import { readFile } from 'node:fs/promises';
import { availableParallelism } from 'node:os';
import { Worker } from 'node:worker_threads';
import { entry, type Entry } from './entry.js';
import type { StartWorker } from './line.js';

export * from './types.js';

const start: StartWorker = (heard, died) => {
  const worker = new Worker(new URL('./node-worker.js', import.meta.url));
  worker.on('message', heard);
  worker.on('error', (error) => died(`The planner broke down (${error.message}).`));
  worker.on('exit', () => died('The planner ended unexpectedly.'));
  return { post: (message) => worker.postMessage(message), close: () => void worker.terminate() };
};

const read = async (): Promise<WebAssembly.Module> => WebAssembly.compile(await readFile(new URL('./pkg/kerfway_bg.wasm', import.meta.url)));

const own = entry(read, start, availableParallelism);

/** A planner with its worker thread ready. Close it when done: an open one keeps the process alive. */
export const createPlanner: Entry['createPlanner'] = own.createPlanner;

/** What a drawing holds, found out in a worker thread of its own: see {@link Functions.inspect}. */
export const inspect: Entry['inspect'] = own.inspect;

/** Plans a drawing in a worker thread of its own, as a promise that tells news meanwhile: see {@link Functions.plan}. */
export const plan: Entry['plan'] = own.plan;

/** Plans a drawing and reports what a quote needs of it: see {@link Functions.quote}. */
export const quote: Entry['quote'] = own.quote;

/** Writes a finished plan as G-code, DXF, SVG or PNG: see {@link Functions.render}. */
export const render: Entry['render'] = own.render;

/** The same functions on worker threads that are kept, for many files: see {@link Pool}. */
export const createPool: Entry['createPool'] = own.createPool;
