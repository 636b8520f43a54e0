/**
 * The first ten seconds of a first visit fetch only what is needed to see a plan, and have a budget for it (scripts/build.mjs). The writers of
 * programs come after them, or as soon as somebody uses the page; the file for proofs, which is larger than all the rest, only then.
 */

/** Milliseconds after the page was opened: the ten seconds that are weighed, and two to spare. */
const LATER = 12_000;

const USES = ['pointerdown', 'keydown', 'drop'] as const;

/** Resolves when somebody has pressed a key or a pointer or dropped a file. */
export const isUsed = new Promise<void>((resolve) => {
  for (const use of USES) addEventListener(use, () => resolve(), { once: true, capture: true });
});

/** Resolves when the writers may be fetched: when somebody uses the page, after twelve seconds, and at once when the page is stored in this browser already. */
export const mayFetchWriters = new Promise<void>((resolve) => {
  if (navigator.serviceWorker?.controller) resolve();
  setTimeout(resolve, Math.max(0, LATER - performance.now()));
  void isUsed.then(resolve);
});
