/**
 * Kerfway in a browser: DXF in, the fastest cutting path found so far out.
 *
 *     import { plan } from 'kerfway';
 *     const { summary, outputs } = await plan(await file.arrayBuffer(), { name: file.name, seconds: 5, outputs: ['gcode'] });
 *
 * `createPlanner` is the level below: one worker that keeps a drawing, is asked again and again, and goes on with plans.
 */

import { functionsOn, type Functions } from './functions.js';
import { lendingNew } from './lend.js';
import type { StartWorker } from './line.js';
import { opener } from './opener.js';
import { poolOf, type Pool, type PoolOptions } from './pool.js';

export * from './types.js';

// Streaming needs the type application/wasm, which some servers do not send.
async function fetchModule(url: URL): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`The planner could not be loaded: ${url} answers ${response.status}.`);
  const typed = response.headers.get('content-type')?.startsWith('application/wasm') ?? false;
  return typed ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

const start: StartWorker = (heard, died) => {
  // Bundlers find the worker by this very expression: it stays bare.
  const worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
  worker.onmessage = (event) => heard(event.data);
  worker.onmessageerror = () => died('The planner sent something that cannot be read.');
  // What was thrown stands in the browser's console; people are told what it means for them.
  worker.onerror = (event) => died(`The planner broke down${event.message ? '' : ' (its script did not load)'}.`);
  return { post: (message) => worker.postMessage(message), close: () => worker.terminate() };
};

/** A planner with its worker ready. The drawing never leaves the machine. */
export const createPlanner = opener(() => fetchModule(new URL('./pkg/kerfway_bg.wasm', import.meta.url)), start);

const functions = functionsOn(lendingNew(createPlanner));

/** What a drawing holds, found out in a worker of its own: see {@link Functions.inspect}. */
export const inspect: Functions['inspect'] = functions.inspect;

/** Plans a drawing in a worker of its own, as a promise that tells news meanwhile: see {@link Functions.plan}. */
export const plan: Functions['plan'] = functions.plan;

/** Writes a finished plan as G-code, DXF, SVG or PNG: see {@link Functions.render}. */
export const render: Functions['render'] = functions.render;

/** The same functions on workers that are kept, for many files. */
export function createPool({ size = navigator.hardwareConcurrency, queue }: PoolOptions = {}): Pool {
  return poolOf(createPlanner, size, queue);
}
