/**
 * Kerfway in Node: the same planner as in a browser, in a worker thread. See `index.ts`.
 *
 * A bundler may put this code into a single file, away from the worker and the wasm file. Then it plans in the caller's
 * thread, with the wasm that is inside `inline.js`, as `kerfway/portable` does.
 */

import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { availableParallelism } from 'node:os';
import { fileURLToPath } from 'node:url';
import { Worker } from 'node:worker_threads';
import { entry, type Entry } from './entry.js';
import { located, wasmAt, workerAt, type Places } from './places.js';
import { loadedFile } from './wasm-file.js';
import type { WasmBytes } from './wasm-module.js';
import type { StartWorker } from './worker-connection.js';

export * from './types.js';

// In a variable, because bundlers that see `new URL('...', import.meta.url)` try to bundle the file, some without success.
const here: string | undefined = import.meta.url;

/** A file of the package; `null` if it is not there, because the code was bundled away from it. */
function fileBeside(name: string): URL | null {
  try {
    const url = new URL(name, here);
    return existsSync(fileURLToPath(url)) ? url : null;
  } catch {
    return null;
  }
}

/** A worker inherits what Node was started with, but refuses to start from a file with `--input-type`; it needs none of it. */
const inherited = process.execArgv.some((arg) => arg.startsWith('--input-type')) ? { execArgv: [] } : {};

const threads = (url: string | URL): StartWorker => (onMessage, onDeath) => {
  const worker = new Worker(url instanceof URL || !url.startsWith('file:') ? url : new URL(url), inherited);
  worker.on('message', onMessage);
  worker.on('error', (error) => onDeath(`The planner broke down (${error.message}).`));
  worker.on('exit', () => onDeath('The planner ended unexpectedly.'));
  return { post: (message) => worker.postMessage(message), close: () => void worker.terminate() };
};

const workerFile = fileBeside('./node-worker.js');

async function workers(places: Places): Promise<StartWorker> {
  const url = workerAt(places, 'node-worker.js') ?? workerFile;
  return url === null ? (await import('./in-thread.js')).inThread(() => readOutputs(places)) : threads(url);
}

const bytesOf = (url: string | URL) => readFile(url instanceof URL || !url.startsWith('file:') ? url : new URL(url));

async function read(places: Places): Promise<WebAssembly.Module> {
  const url = wasmAt(places) ?? fileBeside('./pkg/kerfway_bg.wasm');
  if (url === null) return WebAssembly.compile((await import('./inline.js')).wasm());
  return loadedFile('kerfway', async () => WebAssembly.compile(await bytesOf(url)));
}

async function readOutputs(places: Places): Promise<WasmBytes> {
  const url = located(places, 'kerfway_outputs_bg.wasm') ?? fileBeside('./pkg/kerfway_outputs_bg.wasm');
  return url === null ? (await import('./inline.js')).outputsWasm() : bytesOf(url);
}

const own = entry({ read, readOutputs, workers, processors: () => (workerFile === null ? 1 : availableParallelism()) });

/** Opens a planner and resolves when its worker thread is ready. Close it when done: an open planner keeps the process alive. */
export const createPlanner: Entry['createPlanner'] = own.createPlanner;

/** Reads a drawing in a worker thread of its own and describes its contents: see {@link Functions.inspect}. */
export const inspect: Entry['inspect'] = own.inspect;

/** Plans a drawing in a worker thread of its own; the promise also reports progress: see {@link Functions.plan}. */
export const plan: Entry['plan'] = own.plan;

/** Plans a drawing and reports what a quote needs: see {@link Functions.quote}. */
export const quote: Entry['quote'] = own.quote;

/** Confirms a report that somebody else has made: see {@link Functions.verifyQuote}. */
export const verifyQuote: Entry['verifyQuote'] = own.verifyQuote;

/** Writes a finished plan in another format, such as G-code, DXF, SVG or PNG: see {@link Functions.render}. */
export const render: Entry['render'] = own.render;

/** Reads a G-code program back and says what it would do on a machine: see {@link Functions.check}. */
export const check: Entry['check'] = own.check;

/** Makes a pool of worker threads that plan many files: see {@link Pool}. */
export const createPool: Entry['createPool'] = own.createPool;

/** Says where all planners that are opened from now on run and where their files are: see {@link Configuration}. */
export const configure: Entry['configure'] = own.configure;
