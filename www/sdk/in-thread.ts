/**
 * The planner in the caller's own thread, where no worker can be started. A search works in short slices and lets the event loop
 * run between them. Reading a drawing and writing an output do not pause, and a search cannot be ended from outside while a
 * slice runs.
 */

import { KerfwayError } from './errors.js';
import { loadedFile } from './wasm-file.js';
import * as outputs from './pkg/kerfway_outputs.js';
import type { FromWorker } from './protocol.js';
import { type Host, Session } from './session.js';
import type { WasmBytes, WasmModule } from './wasm-module.js';
import type { StartWorker } from './worker-connection.js';

const NO_FILE = 'The planner in the caller\'s thread has no wasm files but the planner and the writers';

/**
 * Makes the function that starts a session in this thread. Its messages arrive in a later turn of the event loop, as those of a
 * worker do. `read` reads the wasm file that writes outputs.
 */
export const inThread = (read: () => Promise<WasmModule | WasmBytes>): StartWorker => (onMessage) => {
  let open = true;
  const deliver = (handle: () => void) => setTimeout(() => open && handle(), 0);
  const host: Host = {
    post: (message: FromWorker) => void deliver(() => onMessage(message)),
    research: async () => {
      throw new KerfwayError('not-in-this-build', `${NO_FILE}: it reads no SVG, has no methods from papers, and does not plan the levers fly, chains, bridges, common_cuts, tips, heat and corners. Use the entry kerfway, with its workers, for them.`);
    },
    outputs: (given) => loadedFile('kerfway_outputs', async () => {
      await outputs.default({ module_or_path: given ?? (await read()) });
      return outputs;
    }),
    png: async () => {
      throw new KerfwayError('not-in-this-build', `${NO_FILE}: it writes no PNG. Render SVG instead, or use the entry kerfway, with its workers.`);
    },
  };
  const session = new Session(host);
  return {
    post: (message) => void deliver(() => session.receive(message)),
    close: () => {
      open = false;
      session.close();
    },
  };
};
