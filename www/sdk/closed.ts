/** What is rejected because a planner or pool was closed. */

/** The planner or pool was closed by its owner, who need not hear of it again. */
export class ClosedError extends Error {}

/**
 * What the work comes to. When nobody waits for it, a failure counts as unhandled and ends a Node process, as it should; but
 * not when the reason is a close.
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
