/**
 * Kerfway in one file for a script tag, wasm and worker included: `Kerfway.plan` and the rest of the package's functions,
 * `<kerfway-planner>` and `<kerfway-quote>`. It works from a file on disk, too. Its worker is made of text: a Content-Security-Policy must
 * say `worker-src blob:`.
 *
 *     <script src="kerfway.global.js"></script>
 *     <kerfway-planner seconds="5"></kerfway-planner>
 */

import { defineElements } from '../element/define.js';
import { entry } from '../entry.js';
import wasm from '../pkg/kerfway_bg.wasm';
import { webWorkers } from '../web-worker.js';
import text from './planner.worker';

let address: string | null = null;

const start = webWorkers(() => {
  address ??= URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
  return new Worker(address);
});

export const { createPlanner, createPool, inspect, plan, quote, render } = entry(() => WebAssembly.compile(wasm), start, () => navigator.hardwareConcurrency);

defineElements(() => createPlanner());
