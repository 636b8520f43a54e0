/** How each contour of a drawing is drawn. */

import type { ContourInfo } from 'kerfway';
import { around } from '../core/nesting.js';
import { Role } from './raster-messages.js';

/** The role of each contour. The border of the sheet is not a part, so contours directly inside it are outer ones. */
export function rolesOf(contours: readonly ContourInfo[], border: number | null): Uint8Array {
  const roles = new Uint8Array(contours.length);
  contours.forEach((contour, k) => (roles[k] = roleOf(contours, border, contour)));
  return roles;
}

function roleOf(contours: readonly ContourInfo[], border: number | null, contour: ContourInfo): number {
  if (contour.operation !== 'cut') return contour.operation === 'mark' ? Role.mark : Role.none;
  if (contour.skeleton === true) return Role.inner;
  if (contour.inside === null) return Role.outer;
  let inner = false;
  for (const outer of around(contours, contour.id)) {
    if (outer === border) break;
    inner = !inner;
  }
  return inner ? Role.inner : Role.outer;
}
