/** Stores the page for use without a network, when its first work is done. */

/** Milliseconds after loading, so that the first plan comes first. */
const LATER = 4000;

export function keepForOffline(): void {
  if (!('serviceWorker' in navigator)) return;
  setTimeout(() => {
    // Where there is no service worker (private windows, pages opened from disk), the page works, but not offline.
    navigator.serviceWorker.register('./offline.js').catch(() => {});
  }, LATER);
}
