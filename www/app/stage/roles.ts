/** How each contour of a drawing is drawn. */

import type { ContourInfo } from 'kerfway';
import { around } from '../core/nesting.js';
import { Role } from './raster-messages.js';

/** The role of each contour. The border of the sheet is not a part, so contours directly inside it are outer ones. */
export function rolesOf(contours: readonly ContourInfo[], border: number | null): Uint8Array {
  return Uint8Array.from(contours, (contour) => {
    if (contour.operation !== 'cut') return contour.operation === 'mark' ? Role.mark : Role.none;
    let inner = false;
    for (const outer of around(contours, contour.id)) {
      if (outer === border) break;
      inner = !inner;
    }
    return inner ? Role.inner : Role.outer;
  });
}
