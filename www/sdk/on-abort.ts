/**
 * Calls that end when a signal aborts. However many calls share a signal, it has one listener: Node warns of a leak when a signal has
 * more than ten, which a batch with one signal has soon.
 */

interface Listener {
  readonly calls: Set<() => void>;
  readonly run: () => void;
}

const listeners = new WeakMap<AbortSignal, Listener>();

/** Calls `abort` when the signal aborts, unless the function that it returns was called before. */
export function onAbort(signal: AbortSignal, abort: () => void): () => void {
  const listener = listeners.get(signal) ?? listening(signal);
  listener.calls.add(abort);
  return () => {
    listener.calls.delete(abort);
    if (listener.calls.size > 0) return;
    signal.removeEventListener('abort', listener.run);
    listeners.delete(signal);
  };
}

function listening(signal: AbortSignal): Listener {
  const calls = new Set<() => void>();
  const run = () => [...calls].forEach((abort) => abort());
  const listener = { calls, run };
  signal.addEventListener('abort', run);
  listeners.set(signal, listener);
  return listener;
}
