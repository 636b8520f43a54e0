/** Ctrl+C while a search runs: the first one ends the search and keeps its result, and the second one ends the program. */

/** Does some work. `stop` is called on the first SIGINT. */
export async function untilInterrupted<T>(stop: () => unknown, work: () => Promise<T>): Promise<T> {
  process.once('SIGINT', stop);
  try {
    return await work();
  } finally {
    process.removeListener('SIGINT', stop);
  }
}
