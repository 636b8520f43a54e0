/**
 * Kerfway in one module graph without workers, files or addresses: for bundled servers, route handlers, functions in a cloud, and
 * every bundler. It has the wasm inside and plans in the caller's thread, in slices between which the event loop runs.
 *
 *     import { quote } from 'kerfway/portable';
 *     const report = await quote(new Uint8Array(await request.arrayBuffer()), { name: 'plate.dxf' });
 *
 * Where code may not be compiled at run time, give it a compiled module first: `configure({ wasm: module })`. In workerd the
 * entry does so itself. One instance of the wasm serves all planners: after a breakdown, start the process again.
 *
 * @module kerfway/portable
 */

import { entry, type Entry } from './entry.js';
import { inThread } from './in-thread.js';
import { outputsWasm, wasm } from './inline.js';

export * from './types.js';

// One thread does all the work, so a second planner of a pool would gain nothing.
const readOutputs = async () => outputsWasm();
const own = entry({ read: () => WebAssembly.compile(wasm()), readOutputs, workers: () => inThread(readOutputs), processors: () => 1 });

/** Opens a planner in this thread. Close it when done. */
export const createPlanner: Entry['createPlanner'] = own.createPlanner;

/** Reads a drawing and describes its contents: see {@link Functions.inspect}. */
export const inspect: Entry['inspect'] = own.inspect;

/** Plans a drawing; the promise also reports progress: see {@link Functions.plan}. */
export const plan: Entry['plan'] = own.plan;

/** Plans a drawing and reports what a quote needs: see {@link Functions.quote}. */
export const quote: Entry['quote'] = own.quote;

/** Confirms a report that somebody else has made: see {@link Functions.verifyQuote}. */
export const verifyQuote: Entry['verifyQuote'] = own.verifyQuote;

/** Writes a finished plan in another format, such as G-code, DXF or SVG: see {@link Functions.render}. */
export const render: Entry['render'] = own.render;

/** Reads a G-code program back and says what it would do on a machine: see {@link Functions.check}. */
export const check: Entry['check'] = own.check;

/** Makes a queue of calls, which one planner of this thread answers: see {@link Pool}. */
export const createPool: Entry['createPool'] = own.createPool;

/** Gives all planners that are opened from now on the same compiled wasm: see {@link Configuration}. */
export const configure: Entry['configure'] = own.configure;
