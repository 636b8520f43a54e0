/** The contours of a drawing that are cut or marked: those left out one by one stay in the list, for their numbers. */

import type { ContourInfo, Loaded } from 'kerfway';
import type { State } from './state.js';

export function worked({ contours }: Loaded): ContourInfo[] {
  return contours.filter((c) => c.operation !== 'ignore');
}

/** The contours that the path names: those of the drawing, or the lines of the beam beside them. */
export function cutContours({ loaded, beam }: State): ContourInfo[] {
  return beam?.contours ?? loaded?.contours ?? [];
}
