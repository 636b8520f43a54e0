/** Which contours lie around others. */

import type { ContourInfo } from 'kerfway';

/** How far contours may be nested: the bound ends the walk if the data is wrong. */
const DEEPEST = 64;

/** The contours around one, from the inside outwards. */
export function* around(contours: readonly ContourInfo[], contour: number): Generator<number, void> {
  let outer = contours[contour]?.inside ?? null;
  for (let depth = 0; outer !== null && depth < DEEPEST; depth += 1) {
    yield outer;
    outer = contours[outer]?.inside ?? null;
  }
}
