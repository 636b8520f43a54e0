/** The contours of a drawing that was read. */

import { isList, isRecord } from './check.js';
import { KerfwayError } from './errors.js';
import type { ContourInfo, Loaded } from './protocol.js';

/** Throws a `KerfwayError` unless these lists and objects of a drawing that was read are there. */
export function checkLoaded(loaded: unknown, ...needed: (keyof Loaded)[]): void {
  if (isRecord(loaded) && needed.every((name) => (name === 'geometry' ? isRecord : isList)(loaded[name]))) return;
  throw new KerfwayError('wrong-type', 'This is no drawing that was read: give what load or inspect returns.', { field: 'loaded' });
}

/** The contours that are cut or marked. Skipped contours stay in `contours`, so that the ids of the others do not change. */
export function activeContours(loaded: Pick<Loaded, 'contours'>): ContourInfo[] {
  checkLoaded(loaded, 'contours');
  return loaded.contours.filter((contour) => contour.operation !== 'ignore');
}
