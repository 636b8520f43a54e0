/** Rejections because a planner or pool was closed. */

import { ClosedError } from './errors.js';

export { ClosedError };

/**
 * The result of the work. If nobody waits for it, a failure counts as unhandled and ends a Node process, as it should. A
 * `ClosedError` never counts as unhandled.
 */
export function quietAtClose<T>(work: () => Promise<T>): Promise<T> {
  const done: Promise<T> = (async () => {
    try {
      return await work();
    } catch (error) {
      if (error instanceof ClosedError) queueMicrotask(() => done.catch(() => {}));
      throw error;
    }
  })();
  return done;
}
