/** The planner in a Web Worker. */

import { loadedFile } from './wasm-file.js';
import type { ToWorker } from './protocol.js';
import { type Host, Session } from './session.js';
import type { WasmBytes, WasmModule } from './wasm-module.js';

type Wasm = WasmModule | WasmBytes;

/** The part of a dedicated worker's global scope that is used here. TypeScript's own types of it clash with those of a page. */
interface WorkerScope {
  postMessage(message: unknown, transfer: ArrayBuffer[]): void;
  onmessage: (event: MessageEvent<ToWorker>) => void;
}

const scope = self as unknown as WorkerScope;

/** Fetches and compiles the wasm file of a module that wasm-bindgen wrote; `given` replaces the file. */
function ready<M extends { default(given?: { module_or_path: Wasm }): Promise<unknown> }>(name: string, load: () => Promise<M>, given?: Wasm): Promise<M> {
  return loadedFile(name, async () => {
    const module = await load();
    await module.default(given && { module_or_path: given });
    return module;
  });
}

const host: Host = {
  post: (message, transfer = []) => scope.postMessage(message, transfer),
  research: () => ready('kerfway_research', () => import('./pkg/kerfway_research.js')),
  outputs: (given) => ready('kerfway_outputs', () => import('./pkg/kerfway_outputs.js'), given),
  png: () => ready('kerfway_png', () => import('./pkg/kerfway_png.js')),
};

const session = new Session(host);
scope.onmessage = ({ data }) => session.receive(data);
