/**
 * What an improvement changed: the stops that are reached by a new air move, which glows for a moment. The comparison is one pass over typed
 * arrays.
 */

import type { BestPath } from 'kerfway';
import { firstStops } from './shapes.js';

/** When more than this share of the stops has changed, the whole path is new, and nothing in it should stand out. */
const WHOLE = 0.35;
/** Places that are farther apart than this are different places, mm. */
const SAME = 1e-3;

/** 1 for each stop whose air move is new. Null when nothing or nearly everything is new. */
export function changedStops(before: BestPath | null, after: BestPath): Uint8Array | null {
  const stops = after.contours.length;
  if (!before || before.contours.length !== stops || stops === 0) return null;
  let most = 0;
  for (let k = 0; k < stops; k += 1) most = Math.max(most, before.contours[k]!, after.contours[k]!);
  // A contour that is cut in several stretches is represented by its first stop.
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
