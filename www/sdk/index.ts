/**
 * Kerfway in a browser: DXF in, the fastest cutting path found so far out.
 *
 *     import { createPlanner } from 'kerfway';
 *     const planner = await createPlanner();
 *     const drawing = await planner.load(await file.arrayBuffer(), file.name);
 *     const plan = planner.plan({ seconds: 5 }, (progress) => console.log(progress.summary.total_time));
 *     await plan.done;
 *     const gcode = await planner.output('gcode');
 */

import type { StartWorker } from './line.js';
import { opener } from './opener.js';

export { Planner, type PlannerOptions } from './planner.js';
export type { PlanHandle, PlanResult, Started } from './plan-handle.js';
export type * from './protocol.js';

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
