/** Kerfway in Node: the same planner as in a browser, in a worker thread. See `index.ts`. */

import { readFile } from 'node:fs/promises';
import { availableParallelism } from 'node:os';
import { Worker } from 'node:worker_threads';
import { entry, type Entry } from './entry.js';
import type { StartWorker } from './worker-connection.js';

export * from './types.js';

const start: StartWorker = (onMessage, onDeath) => {
  const worker = new Worker(new URL('./node-worker.js', import.meta.url));
  worker.on('message', onMessage);
  worker.on('error', (error) => onDeath(`The planner broke down (${error.message}).`));
  worker.on('exit', () => onDeath('The planner ended unexpectedly.'));
  return { post: (message) => worker.postMessage(message), close: () => void worker.terminate() };
};

const read = async (): Promise<WebAssembly.Module> => WebAssembly.compile(await readFile(new URL('./pkg/kerfway_bg.wasm', import.meta.url)));

const own = entry(read, start, availableParallelism);

/** Opens a planner and resolves when its worker thread is ready. Close it when done: an open planner keeps the process alive. */
export const createPlanner: Entry['createPlanner'] = own.createPlanner;

/** Reads a drawing in a worker thread of its own and describes its contents: see {@link Functions.inspect}. */
export const inspect: Entry['inspect'] = own.inspect;

/** Plans a drawing in a worker thread of its own; the promise also reports progress: see {@link Functions.plan}. */
export const plan: Entry['plan'] = own.plan;

/** Plans a drawing and reports what a quote needs: see {@link Functions.quote}. */
export const quote: Entry['quote'] = own.quote;

/** Writes a finished plan as G-code, DXF, SVG or PNG: see {@link Functions.render}. */
export const render: Entry['render'] = own.render;

/** Reads a G-code program back and says what it would do on a machine: see {@link Functions.check}. */
export const check: Entry['check'] = own.check;

/** Makes a pool of worker threads that plan many files: see {@link Pool}. */
export const createPool: Entry['createPool'] = own.createPool;
