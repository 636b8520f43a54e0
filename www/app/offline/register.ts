/** Puts the page by for when there is no network, once its first work is done. */

/** Milliseconds after loading: the first plan comes first. */
const LATER = 4000;

export function keepForOffline(): void {
  if (!('serviceWorker' in navigator)) return;
  setTimeout(() => {
    // Without one the page works as before, only not offline: private windows, pages opened from disk.
    navigator.serviceWorker.register('./offline.js').catch(() => {});
  }, LATER);
}
