/** The contours of a drawing that are cut or marked: those left out one by one stay in the list, for their ids. */

import type { ContourInfo, Loaded } from './protocol.js';

export function worked({ contours }: Pick<Loaded, 'contours'>): ContourInfo[] {
  return contours.filter((c) => c.operation !== 'ignore');
}
