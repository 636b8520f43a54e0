/** Stores the page for use without a network, when its first work is done. */

import { mayFetchWriters } from './first-visit.js';

/** Milliseconds after loading, so that the first plan comes first. */
const LATER = 4000;

export function keepForOffline(): void {
  if (!('serviceWorker' in navigator)) return;
  // The first time, the language was loaded before there was a service worker that stores it.
  const language = performance.getEntriesByType('resource').map((r) => r.name).filter((name) => /\/language-[^/]*\.js$/.test(name));
  if (!navigator.serviceWorker.controller) {
    navigator.serviceWorker.addEventListener('controllerchange', () => language.forEach((file) => void fetch(file).catch(() => {})), { once: true });
  }
  setTimeout(() => {
    // Where there is no service worker (private windows, pages opened from disk), the page works, but not offline.
    navigator.serviceWorker.register('./offline.js').catch(() => {});
  }, LATER);
  void Promise.all([navigator.serviceWorker.ready, mayFetchWriters]).then(([{ active }]) => active?.postMessage('later'));
}
