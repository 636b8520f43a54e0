/** Makes the function `createPlanner` of an entry point. Entry points differ in how they read the wasm and start a worker. */

import { wasmAt, type Places } from './places.js';
import { Planner, type PlannerOptions } from './planner.js';
import type { StartWorker } from './worker-connection.js';
import { loadedFile } from './wasm-file.js';
import type { WasmBytes, WasmModule } from './wasm-module.js';

/** What an entry point knows of its platform. */
export interface Platform {
  /** Reads and compiles the wasm file. */
  read(places: Places): Promise<WasmModule>;
  /** The wasm that writes outputs, where it is in the script; otherwise workers load its file when it is needed. */
  outputs?: WasmBytes;
  /** Reads that file, for a planner in the caller's thread. */
  readOutputs(places: Places): Promise<WasmModule | WasmBytes>;
  /** The function that starts workers. */
  workers(places: Places): StartWorker | Promise<StartWorker>;
  /** The default size of a pool. */
  processors(): number;
}

/** The function that opens planners; its options were checked. A module is compiled once for each place, and shared by all its workers. */
export function plannerFactory(platform: Platform): (options: PlannerOptions) => Promise<Planner> {
  const shared = new Map<string, Promise<WasmModule>>();
  const read = (places: Places): Promise<WasmModule> => {
    const place = String(wasmAt(places) ?? '');
    const compiled = shared.get(place) ?? platform.read(places);
    shared.set(place, compiled);
    // A file that could not be loaded is asked for again by the next planner.
    compiled.catch(() => shared.delete(place));
    return compiled;
  };
  const compiled = (options: PlannerOptions): WasmModule | Promise<WasmModule> => {
    const { wasm } = options;
    if (wasm === undefined) return read(options);
    return wasm instanceof WebAssembly.Module ? wasm : loadedFile('kerfway', () => WebAssembly.compile(wasm as BufferSource));
  };
  return async (options) => {
    const here = async () => (await import('./in-thread.js')).inThread(() => platform.readOutputs(options));
    const start = await (options.worker === false ? here() : platform.workers(options));
    const outputs = options.outputsWasm ?? platform.outputs;
    return Planner.open({ module: (await compiled(options)) as WebAssembly.Module, outputs, start, onReplaced: options.onReplaced });
  };
}
