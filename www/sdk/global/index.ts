/**
 * Kerfway in a single file for a script tag, including wasm and worker: `Kerfway.plan` and the other functions of the package,
 * `<kerfway-planner>` and `<kerfway-quote>`. It also works from a file on disk. Its worker is started from a blob, so a
 * Content-Security-Policy must allow `worker-src blob:`.
 *
 *     <script src="kerfway.global.js"></script>
 *     <kerfway-planner seconds="5"></kerfway-planner>
 */

import { defineElements } from '../element/define.js';
import { entry } from '../entry.js';
import wasm from '../pkg/kerfway_bg.wasm';
import outputs from '../pkg/kerfway_outputs_bg.wasm';
import { webWorkers } from '../web-worker.js';
import text from './planner.worker';

let address: string | null = null;

const workers = () =>
  webWorkers(() => {
    address ??= URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
    return new Worker(address);
  });

export const { configure, createPlanner, createPool, inspect, plan, quote, render, check, verifyQuote } = entry({
  read: () => WebAssembly.compile(wasm),
  outputs,
  readOutputs: async () => outputs,
  workers,
  processors: () => navigator.hardwareConcurrency,
});
export * from '../types.js';

defineElements(() => createPlanner());
