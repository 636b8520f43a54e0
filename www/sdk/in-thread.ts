/**
 * The planner in the caller's own thread, where no worker can be started. A search works in short slices and lets the event loop
 * run between them. Reading a drawing and writing an output do not pause, and a search cannot be ended from outside while a
 * slice runs.
 */

import { KerfwayError } from './errors.js';
import type { FromWorker } from './protocol.js';
import { type Host, Session } from './session.js';
import type { StartWorker } from './worker-connection.js';

const NO_FILE = 'The planner in the caller\'s thread consists of the core only';

/** Starts a session in this thread. Its messages arrive in a later turn of the event loop, as those of a worker do. */
export const inThread: StartWorker = (onMessage) => {
  let open = true;
  const deliver = (handle: () => void) => setTimeout(() => open && handle(), 0);
  const host: Host = {
    post: (message: FromWorker) => void deliver(() => onMessage(message)),
    research: async () => {
      throw new KerfwayError('not-in-this-build', `${NO_FILE}: it reads no SVG and has no methods from papers. Use the entry kerfway, with its workers, for them.`);
    },
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
