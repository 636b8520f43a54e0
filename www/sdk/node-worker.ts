/** The planner in a worker thread of Node. */

import { readFile } from 'node:fs/promises';
import { parentPort } from 'node:worker_threads';
import { loadedFile } from './wasm-file.js';
import type { ToWorker } from './protocol.js';
import { type Host, Session } from './session.js';
import type { WasmBytes, WasmModule } from './wasm-module.js';

type Wasm = WasmModule | WasmBytes;

/** Reads and compiles the wasm file of a module that wasm-bindgen wrote; `given` replaces the file. */
function ready<M extends { initSync(wasm: { module: Wasm }): unknown }>(name: string, load: () => Promise<M>, given?: Wasm): Promise<M> {
  return loadedFile(name, async () => {
    const module = await load();
    module.initSync({ module: given ?? (await readFile(new URL(`./pkg/${name}_bg.wasm`, import.meta.url))) });
    return module;
  });
}

const host: Host = {
  post: (message, transfer = []) => parentPort?.postMessage(message, transfer),
  research: () => ready('kerfway_research', () => import('./pkg/kerfway_research.js')),
  outputs: (given) => ready('kerfway_outputs', () => import('./pkg/kerfway_outputs.js'), given),
  png: () => ready('kerfway_png', () => import('./pkg/kerfway_png.js')),
};

const session = new Session(host);
parentPort?.on('message', (message: ToWorker) => session.receive(message));
