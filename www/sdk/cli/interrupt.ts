/**
 * Signals while a search runs. The first one ends the search, whose result is kept, and the second one ends the program.
 * After Ctrl+C (SIGINT) the command goes on with the next drawing; after SIGTERM it ends.
 */

const SIGNALS = ['SIGINT', 'SIGTERM'] as const;

export type Interruption = (typeof SIGNALS)[number];

let terminated = false;

/** Whether SIGTERM has ended a search, so that no other one may begin. */
export const toldToEnd = (): boolean => terminated;

/** Does some work. `stop` is called on the first signal. */
export async function untilInterrupted<T>(stop: (signal: Interruption) => unknown, work: () => Promise<T>): Promise<T> {
  const interrupt = (signal: Interruption): void => {
    unlisten();
    terminated ||= signal === 'SIGTERM';
    stop(signal);
  };
  const unlisten = (): void => SIGNALS.forEach((signal) => process.off(signal, interrupt));
  for (const signal of SIGNALS) process.on(signal, interrupt);
  try {
    return await work();
  } finally {
    unlisten();
  }
}
