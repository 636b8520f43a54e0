/**
 * Kerfway in a browser: reads a DXF file and searches for the fastest cutting path.
 *
 *     import { plan } from 'kerfway';
 *     const { summary, outputs } = await plan(await file.arrayBuffer(), { name: file.name, seconds: 5, outputs: ['gcode'] });
 *
 * `createPlanner` is the lower level: one worker that keeps a drawing, answers several requests and can continue a plan.
 *
 * @module kerfway
 */

import { entry, type Entry } from './entry.js';
import { webWorkers } from './web-worker.js';

export * from './types.js';

// Streaming compilation needs the content type application/wasm, which some servers do not send.
async function fetchModule(url: URL): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`The planner could not be loaded: ${url} answers ${response.status}.`);
  const typed = response.headers.get('content-type')?.startsWith('application/wasm') ?? false;
  return typed ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

// Bundlers recognise the worker by exactly this expression, so it must not be rewritten.
const start = webWorkers(() => new Worker(new URL('./worker.js', import.meta.url), { type: 'module' }));

const own = entry(() => fetchModule(new URL('./pkg/kerfway_bg.wasm', import.meta.url)), start, () => navigator.hardwareConcurrency);

/** Opens a planner and resolves when its worker is ready. Close it when done: an open planner keeps its memory. */
export const createPlanner: Entry['createPlanner'] = own.createPlanner;

/** Reads a drawing in a worker of its own and describes its contents: see {@link Functions.inspect}. */
export const inspect: Entry['inspect'] = own.inspect;

/** Plans a drawing in a worker of its own; the promise also reports progress: see {@link Functions.plan}. */
export const plan: Entry['plan'] = own.plan;

/** Plans a drawing and reports what a quote needs: see {@link Functions.quote}. */
export const quote: Entry['quote'] = own.quote;

/** Writes a finished plan as G-code, DXF, SVG or PNG: see {@link Functions.render}. */
export const render: Entry['render'] = own.render;

/** Reads a G-code program back and says what it would do on a machine: see {@link Functions.check}. */
export const check: Entry['check'] = own.check;

/** Makes a pool of workers that plan many files: see {@link Pool}. */
export const createPool: Entry['createPool'] = own.createPool;
