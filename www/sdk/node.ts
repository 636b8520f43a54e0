/** Kerfway under Node: the same planner as in a browser, in a worker thread. See `index.ts`. */

import { readFile } from 'node:fs/promises';
import { Worker } from 'node:worker_threads';
import type { StartWorker } from './line.js';
import { Planner, type PlannerOptions } from './planner.js';

export { Planner, type PlannerOptions } from './planner.js';
export type { PlanHandle, PlanResult, Started } from './plan-handle.js';
export type * from './protocol.js';

/** A planner with its worker ready. Close it when done: an open one keeps the process alive. */
export async function createPlanner(options: PlannerOptions = {}): Promise<Planner> {
  return Planner.open({ module: await compiled(options.wasm), start, onReplaced: options.onReplaced });
}

/** Compiled once, whoever asks: all workers share it. */
let own: Promise<WebAssembly.Module> | undefined;

function compiled(wasm: PlannerOptions['wasm']): WebAssembly.Module | Promise<WebAssembly.Module> {
  if (wasm instanceof WebAssembly.Module) return wasm;
  if (wasm !== undefined) return WebAssembly.compile(wasm);
  own ??= readFile(new URL('./pkg/kerfway_bg.wasm', import.meta.url)).then((bytes) => WebAssembly.compile(bytes));
  return own;
}

const start: StartWorker = (heard, died) => {
  const worker = new Worker(new URL('./node-worker.js', import.meta.url));
  worker.on('message', heard);
  worker.on('error', (error) => died(`The planner broke down (${error.message}).`));
  worker.on('exit', () => died('The planner ended unexpectedly.'));
  return { post: (message) => worker.postMessage(message), close: () => void worker.terminate() };
};
