/** Starting workers in a browser. */

import type { StartWorker } from './line.js';

/** Workers as `create` makes them. */
export function webWorkers(create: () => Worker): StartWorker {
  return (heard, died) => {
    const worker = create();
    worker.onmessage = (event) => heard(event.data);
    worker.onmessageerror = () => died('The planner sent something that cannot be read.');
    // What was thrown stands in the browser's console; people are told what it means for them.
    worker.onerror = (event) => died(`The planner broke down${event.message ? '' : ' (its script did not load)'}.`);
    return { post: (message) => worker.postMessage(message), close: () => worker.terminate() };
  };
}
