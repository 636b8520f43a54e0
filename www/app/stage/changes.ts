/**
 * What an improvement changed: the stops whose way in is new, so that it can glow for a moment. One pass over typed
 * arrays, with tables kept from one improvement to the next.
 */

import type { BestPath } from 'kerfway';
import { firstStops } from './shapes.js';

/** When more than this share of the stops changed at once, the path as a whole is new: nothing in it stands out. */
const WHOLE = 0.35;
/** A place further off than this is another place, mm. */
const SAME = 1e-3;

/** 1 for each stop whose air move is new; null when nothing or nearly everything is. */
export function changedStops(before: BestPath | null, after: BestPath): Uint8Array | null {
  const stops = after.contours.length;
  if (!before || before.contours.length !== stops || stops === 0) return null;
  let most = 0;
  for (let k = 0; k < stops; k += 1) most = Math.max(most, before.contours[k]!, after.contours[k]!);
  // Where contours are left unfinished their first stops tell.
  const stopOf = firstStops(before, most + 1), first = firstStops(after, most + 1);
  const changed = new Uint8Array(stops);
  let sum = 0;
  for (let k = 0; k < stops; k += 1) {
    if (first[after.contours[k]!] !== k) continue;
    const was = stopOf[after.contours[k]!]!;
    const sameBefore = k === 0 ? was === 0 : was > 0 && before.contours[was - 1] === after.contours[k - 1];
    const samePlaces = was >= 0 && near(before, was * 4, after, k * 4) && (k === 0 || (was > 0 && near(before, was * 4 - 2, after, k * 4 - 2)));
    if (sameBefore && samePlaces) continue;
    changed[k] = 1;
    sum += 1;
  }
  return sum > 0 && sum <= Math.max(4, stops * WHOLE) ? changed : null;
}

function near(a: BestPath, i: number, b: BestPath, j: number): boolean {
  return Math.abs(a.points[i]! - b.points[j]!) < SAME && Math.abs(a.points[i + 1]! - b.points[j + 1]!) < SAME;
}
