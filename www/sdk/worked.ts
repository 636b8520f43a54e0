/** The contours of a drawing that are cut or marked. Contours that the option `exclude` names stay in `contours`, because an id is an index into it. */

import type { ContourInfo, Loaded } from './protocol.js';

export function worked({ contours }: Pick<Loaded, 'contours'>): ContourInfo[] {
  return contours.filter((c) => c.operation !== 'ignore');
}
