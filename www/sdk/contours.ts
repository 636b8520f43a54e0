import type { ContourInfo, Loaded } from './protocol.js';

/** The contours that are cut or marked. Skipped contours stay in `contours`, so that the ids of the others do not change. */
export function activeContours(loaded: Pick<Loaded, 'contours'>): ContourInfo[] {
  return loaded.contours.filter((contour) => contour.operation !== 'ignore');
}
