/** The contents of a drawing as JSON: `kerfway.inspect/1`. */

import { activeContours } from './contours.js';
import type { Loaded } from './protocol.js';

/** The contents of a drawing without geometry, with the most important totals first. */
export function inspectReport({ geometry: _, ignored, ...loaded }: Loaded): object {
  const contours = activeContours(loaded);
  const closed = contours.filter((c) => c.closed).length;
  const totals = {
    closed,
    open: contours.length - closed,
    ignored: ignored.layers.length,
    cut_length: lengthOf(loaded, 'cut'),
    mark_length: lengthOf(loaded, 'mark'),
  };
  return { schema: 'kerfway.inspect/1', totals, ...loaded };
}

/** The length of all contours with an operation, mm. */
export function lengthOf({ contours }: Pick<Loaded, 'contours'>, operation: string): number {
  return contours.filter((c) => c.operation === operation).reduce((sum, c) => sum + c.length, 0);
}
