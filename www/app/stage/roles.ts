/** How each contour of a drawing is drawn. */

import type { ContourInfo } from 'kerfway';
import { Role } from './raster-messages.js';

/** How far a contour may be nested: the bound ends the loop if the data is wrong. */
const DEEPEST = 64;

/** The role of each contour. The border of the sheet is not a part, so contours directly inside it are outer ones. */
export function rolesOf(contours: readonly ContourInfo[], border: number | null): Uint8Array {
  return Uint8Array.from(contours, (contour) => {
    if (contour.operation !== 'cut') return contour.operation === 'mark' ? Role.mark : Role.none;
    let inner = false;
    let around = contour.inside;
    for (let depth = 0; around !== null && around !== border && depth < DEEPEST; depth += 1) {
      inner = !inner;
      around = contours[around]?.inside ?? null;
    }
    return inner ? Role.inner : Role.outer;
  });
}
