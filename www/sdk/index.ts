/**
 * Kerfway in a browser: reads a DXF or SVG file and searches for the fastest cutting path.
 *
 *     import { plan } from 'kerfway';
 *     const { summary, outputs } = await plan(file, { seconds: 5, outputs: ['gcode'] });
 *
 * `createPlanner` is the lower level: one worker that keeps a drawing, answers several requests and can continue a plan.
 *
 * @module kerfway
 */

import { type Entry, opening, working } from './entry.js';
import { KerfwayError } from './errors.js';
import { located, wasmAt, workerAt, type Places } from './places.js';
import { webWorkers } from './web-worker.js';

export * from './types.js';

const REMEDY = 'Serve the files of the package and say where they are (locate), or import kerfway/portable, which needs no files.';

// Streaming compilation needs the content type application/wasm, which some servers do not send.
async function fetchModule(url: string | URL): Promise<WebAssembly.Module> {
  const response = await fetch(url).catch((error: Error) => {
    throw new KerfwayError('not-started', `The planner could not be loaded: ${url} cannot be fetched (${error.message}). ${REMEDY}`);
  });
  if (!response.ok) throw new KerfwayError('not-started', `The planner could not be loaded: ${url} answers ${response.status}. ${REMEDY}`);
  const type = response.headers.get('content-type') ?? '';
  if (type.startsWith('application/wasm')) return WebAssembly.compileStreaming(response);
  // A server that answers every address with its page sends no wasm.
  if (type.startsWith('text/html')) throw new KerfwayError('not-started', `The planner could not be loaded: ${url} is a web page, not the wasm file. ${REMEDY}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

const read = (places: Places) => fetchModule(wasmAt(places) ?? new URL('./pkg/kerfway_bg.wasm', import.meta.url));
const readOutputs = async (places: Places) => fetchModule(located(places, 'kerfway_outputs_bg.wasm') ?? new URL('./pkg/kerfway_outputs_bg.wasm', import.meta.url));

// Bundlers recognise the worker by exactly this expression, so it must not be rewritten.
const beside = () => new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });

const workers = (places: Places) => {
  const url = workerAt(places);
  return webWorkers(url === undefined ? beside : () => new Worker(url, { type: 'module' }), REMEDY);
};

const platform = { read, readOutputs, workers, processors: () => navigator.hardwareConcurrency };
const planners = opening(platform);
// A page that opens planners itself is bundled without the rest.
const own = /* @__PURE__ */ working(planners, platform);

/** Opens a planner and resolves when its worker is ready. Close it when done: an open planner keeps its memory. */
export const createPlanner: Entry['createPlanner'] = planners.createPlanner;

/** Reads a drawing in a worker of its own and describes its contents: see {@link Functions.inspect}. */
export const inspect: Entry['inspect'] = own.inspect;

/** Plans a drawing in a worker of its own; the promise also reports progress: see {@link Functions.plan}. */
export const plan: Entry['plan'] = own.plan;

/** Plans a drawing and reports what a quote needs: see {@link Functions.quote}. */
export const quote: Entry['quote'] = own.quote;

/** Confirms a report that somebody else has made: see {@link Functions.verifyQuote}. */
export const verifyQuote: Entry['verifyQuote'] = own.verifyQuote;

/** Writes a finished plan in another format, such as G-code, DXF, SVG or PNG: see {@link Functions.render}. */
export const render: Entry['render'] = own.render;

/** Reads a G-code program back and says what it would do on a machine: see {@link Functions.check}. */
export const check: Entry['check'] = own.check;

/** Makes a pool of workers that plan many files: see {@link Pool}. */
export const createPool: Entry['createPool'] = own.createPool;

/** Says where all planners that are opened from now on run and where their files are: see {@link Configuration}. */
export const configure: Entry['configure'] = planners.configure;
