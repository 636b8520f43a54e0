/**
 * Kerfway in a browser: DXF in, the fastest cutting path found so far out.
 *
 *     import { plan } from 'kerfway';
 *     const { summary, outputs } = await plan(await file.arrayBuffer(), { name: file.name, seconds: 5, outputs: ['gcode'] });
 *
 * `createPlanner` is the level below: one worker that keeps a drawing, is asked again and again, and goes on with plans.
 *
 * @module kerfway
 */

import { entry, type Entry } from './entry.js';
import { webWorkers } from './web-worker.js';

export * from './types.js';

// Streaming needs the type application/wasm, which some servers do not send.
async function fetchModule(url: URL): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`The planner could not be loaded: ${url} answers ${response.status}.`);
  const typed = response.headers.get('content-type')?.startsWith('application/wasm') ?? false;
  return typed ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

// Bundlers find the worker by this very expression: it stays bare.
const start = webWorkers(() => new Worker(new URL('./worker.js', import.meta.url), { type: 'module' }));

const own = entry(() => fetchModule(new URL('./pkg/kerfway_bg.wasm', import.meta.url)), start, () => navigator.hardwareConcurrency);

/** A planner with its worker ready. Close it when done: an open one keeps its memory. */
export const createPlanner: Entry['createPlanner'] = own.createPlanner;

/** What a drawing holds, found out in a worker of its own: see {@link Functions.inspect}. */
export const inspect: Entry['inspect'] = own.inspect;

/** Plans a drawing in a worker of its own, as a promise that tells news meanwhile: see {@link Functions.plan}. */
export const plan: Entry['plan'] = own.plan;

/** Plans a drawing and reports what a quote needs of it: see {@link Functions.quote}. */
export const quote: Entry['quote'] = own.quote;

/** Writes a finished plan as G-code, DXF, SVG or PNG: see {@link Functions.render}. */
export const render: Entry['render'] = own.render;

/** The same functions on workers that are kept, for many files: see {@link Pool}. */
export const createPool: Entry['createPool'] = own.createPool;
