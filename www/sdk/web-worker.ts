/** Starting workers in a browser. */

import type { StartWorker } from './worker-connection.js';

/** Starts the workers that `create` makes. `remedy` says what to do when a worker's script cannot be loaded. */
export function webWorkers(create: () => Worker, remedy = ''): StartWorker {
  return (onMessage, onDeath) => {
    const worker = create();
    worker.onmessage = (event) => onMessage(event.data);
    worker.onmessageerror = () => onDeath('The planner sent a message that cannot be read.');
    // The browser's console shows the error itself; the sentence says what it means.
    worker.onerror = (event) => onDeath(event.message ? 'The planner broke down.' : `The script of the planner's worker did not load. ${remedy}`.trim());
    return { post: (message) => worker.postMessage(message), close: () => worker.terminate() };
  };
}
