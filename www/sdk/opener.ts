/** Opening a planner, the same on every host: they differ in how the wasm is read and how a worker starts. */

import type { StartWorker } from './line.js';
import { Planner, type PlannerOptions } from './planner.js';

/** The `createPlanner` of a host. What `read` gives is compiled once, whoever asks: all workers share it. */
export function opener(read: () => Promise<WebAssembly.Module>, start: StartWorker): (options?: PlannerOptions) => Promise<Planner> {
  let own: Promise<WebAssembly.Module> | undefined;
  const compiled = (wasm: PlannerOptions['wasm']): WebAssembly.Module | Promise<WebAssembly.Module> => {
    if (wasm instanceof WebAssembly.Module) return wasm;
    if (wasm !== undefined) return WebAssembly.compile(wasm);
    own ??= read();
    return own;
  };
  return async (options = {}) => Planner.open({ module: await compiled(options.wasm), start, onReplaced: options.onReplaced });
}
