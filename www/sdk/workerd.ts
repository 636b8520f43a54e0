/**
 * Kerfway in workerd (Cloudflare Workers): as `kerfway/portable`, with the wasm files imported as modules, because that
 * platform compiles nothing at run time. Bundlers that know the condition `workerd` choose this entry by themselves.
 */

import { entry, type Entry } from './entry.js';
import { inThread } from './in-thread.js';
import wasm from './pkg/kerfway_bg.wasm';
import outputs from './pkg/kerfway_outputs_bg.wasm';

export * from './types.js';

// What the declaration calls bytes is a compiled module here.
const read = async () => wasm as unknown as WebAssembly.Module;

const readOutputs = async () => outputs as unknown as WebAssembly.Module;

const own = entry({ read, readOutputs, workers: () => inThread(readOutputs), processors: () => 1 });

export const createPlanner: Entry['createPlanner'] = own.createPlanner;
export const inspect: Entry['inspect'] = own.inspect;
export const plan: Entry['plan'] = own.plan;
export const quote: Entry['quote'] = own.quote;
export const verifyQuote: Entry['verifyQuote'] = own.verifyQuote;
export const render: Entry['render'] = own.render;
export const createPool: Entry['createPool'] = own.createPool;
export const configure: Entry['configure'] = own.configure;
export const check: Entry['check'] = own.check;
