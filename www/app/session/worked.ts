/** The contours of a drawing that are cut or marked: those left out one by one stay in the list, for their numbers. */

import type { ContourInfo, Loaded } from 'kerfway';

export function worked({ contours }: Loaded): ContourInfo[] {
  return contours.filter((c) => c.operation !== 'ignore');
}
