/**
 * Which sample is open in this tab, how it is read, and on which machine. Samples are not stored as jobs are, but a reload, such as for another
 * language, brings them back with what was decided about them.
 */

import type { LoadOptions } from 'kerfway';
import type { OwnMachine, Session } from './session.js';
import { type Sample, SAMPLES } from './samples.js';

const KEY = 'kerfway.sample';

/** What was decided about a sample. `own`: the machine that somebody has chosen for it; null where it has the usual one. */
export interface Decided {
  load: LoadOptions;
  own: OwnMachine | null;
}

/** Remembers the sample that is open, and forgets it when something else is. */
export function keepSample(session: Session): void {
  let seen: unknown[] = [];
  session.store.on('change', ({ sample, loaded, name, load, machine, material }) => {
    const now = [name, load, machine, material];
    if (loaded === null || now.every((value, k) => value === seen[k])) return;
    seen = now;
    try {
      if (sample) sessionStorage.setItem(KEY, JSON.stringify({ file: name, load, own: session.chosenMachine() }));
      else sessionStorage.removeItem(KEY);
    } catch {
      // Without storage, the page begins with the first sample again.
    }
  });
}

/** The sample of this tab from before a reload; null in a new tab. */
export function keptSample(): { sample: Sample; decided: Decided } | null {
  try {
    const { file, load, own = null } = JSON.parse(sessionStorage.getItem(KEY) ?? '{}') as Partial<Decided> & { file?: string };
    const sample = SAMPLES.find((s) => s.file === file);
    return sample === undefined || load === undefined ? null : { sample, decided: { load, own } };
  } catch {
    return null;
  }
}
