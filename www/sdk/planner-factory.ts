/** Makes the function `createPlanner` of an entry point. Entry points differ in how they read the wasm and start a worker. */

import { Planner, type PlannerOptions } from './planner.js';
import type { StartWorker } from './worker-connection.js';

/** The function `createPlanner`. The module that `read` returns is compiled once and shared by all workers. */
export function plannerFactory(read: () => Promise<WebAssembly.Module>, start: StartWorker): (options?: PlannerOptions) => Promise<Planner> {
  let shared: Promise<WebAssembly.Module> | undefined;
  const compiled = (wasm: PlannerOptions['wasm']): WebAssembly.Module | Promise<WebAssembly.Module> => {
    if (wasm instanceof WebAssembly.Module) return wasm;
    if (wasm !== undefined) return WebAssembly.compile(wasm);
    shared ??= read();
    return shared;
  };
  return async (options = {}) => Planner.open({ module: await compiled(options.wasm), start, onReplaced: options.onReplaced });
}
