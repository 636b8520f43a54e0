/** The planner in a worker thread of Node. */

import { readFile } from 'node:fs/promises';
import { parentPort } from 'node:worker_threads';
import { optionalFile } from './optional-file.js';
import type { ToWorker } from './protocol.js';
import { type Host, Session } from './session.js';

/** Reads and compiles the wasm file of a module that wasm-bindgen wrote. */
function ready<M extends { initSync(wasm: { module: BufferSource }): unknown }>(name: string, load: () => Promise<M>): Promise<M> {
  return optionalFile(name, async () => {
    const module = await load();
    module.initSync({ module: await readFile(new URL(`./pkg/${name}_bg.wasm`, import.meta.url)) });
    return module;
  });
}

const host: Host = {
  post: (message, transfer = []) => parentPort?.postMessage(message, transfer),
  research: () => ready('kerfway_research', () => import('./pkg/kerfway_research.js')),
  png: () => ready('kerfway_png', () => import('./pkg/kerfway_png.js')),
};

const session = new Session(host);
parentPort?.on('message', (message: ToWorker) => session.receive(message));
