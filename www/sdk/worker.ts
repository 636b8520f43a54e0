/** The planner in a Web Worker. */

import { optionalFile } from './optional-file.js';
import type { ToWorker } from './protocol.js';
import { type Host, Session } from './session.js';

/** The part of a dedicated worker's global scope that is used here. TypeScript's own types of it clash with those of a page. */
interface WorkerScope {
  postMessage(message: unknown, transfer: ArrayBuffer[]): void;
  onmessage: (event: MessageEvent<ToWorker>) => void;
}

const scope = self as unknown as WorkerScope;

/** Fetches and compiles the wasm file of a module that wasm-bindgen wrote. */
function ready<M extends { default(): Promise<unknown> }>(name: string, load: () => Promise<M>): Promise<M> {
  return optionalFile(name, async () => {
    const module = await load();
    await module.default();
    return module;
  });
}

const host: Host = {
  post: (message, transfer = []) => scope.postMessage(message, transfer),
  research: () => ready('kerfway_research', () => import('./pkg/kerfway_research.js')),
  png: () => ready('kerfway_png', () => import('./pkg/kerfway_png.js')),
};

const session = new Session(host);
scope.onmessage = ({ data }) => session.receive(data);
