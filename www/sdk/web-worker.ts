/** Starting workers in a browser. */

import type { StartWorker } from './worker-connection.js';

/** Starts the workers that `create` makes. */
export function webWorkers(create: () => Worker): StartWorker {
  return (onMessage, onDeath) => {
    const worker = create();
    worker.onmessage = (event) => onMessage(event.data);
    worker.onmessageerror = () => onDeath('The planner sent a message that cannot be read.');
    // The browser's console shows the error itself; the sentence says what it means.
    worker.onerror = (event) => onDeath(`The planner broke down${event.message ? '' : ' (its script did not load)'}.`);
    return { post: (message) => worker.postMessage(message), close: () => worker.terminate() };
  };
}
