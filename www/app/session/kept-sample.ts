/**
 * Which sample is open in this tab, and how it is read. Samples are not stored as jobs are, but a reload, such as for another language, brings them
 * back with what was decided about them.
 */

import type { LoadOptions } from 'kerfway';
import type { Session } from './session.js';
import { type Sample, SAMPLES } from './samples.js';

const KEY = 'kerfway.sample';

/** Remembers the sample that is open, and forgets it when something else is. */
export function keepSample({ store }: Session): void {
  let [name, load] = ['', {} as LoadOptions];
  store.on('change', ({ sample, loaded, ...now }) => {
    if (loaded === null || (now.name === name && now.load === load)) return;
    [name, load] = [now.name, now.load];
    try {
      if (sample) sessionStorage.setItem(KEY, JSON.stringify({ file: name, load }));
      else sessionStorage.removeItem(KEY);
    } catch {
      // Without storage, the page begins with the first sample again.
    }
  });
}

/** The sample of this tab from before a reload; null in a new tab. */
export function keptSample(): { sample: Sample; load: LoadOptions } | null {
  try {
    const { file, load } = JSON.parse(sessionStorage.getItem(KEY) ?? '{}') as { file?: string; load?: LoadOptions };
    const sample = SAMPLES.find((s) => s.file === file);
    return sample === undefined || load === undefined ? null : { sample, load };
  } catch {
    return null;
  }
}
