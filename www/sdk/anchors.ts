/** The nine points by which a box is placed: its corners, the middles of its sides, its centre. */

import { checkOne } from './check.js';
import type { Anchor } from './protocol.js';

/** The names of all nine, from the lower left to the upper right. */
export const ANCHORS: readonly Anchor[] = [
  'lower-left', 'lower-center', 'lower-right', 'center-left', 'center', 'center-right', 'upper-left', 'upper-center', 'upper-right',
];

/** A point of a box (xmin, ymin, xmax, ymax). */
export function pointOf(anchor: Anchor, box: readonly [number, number, number, number]): [number, number] {
  checkOne('The option', 'anchor', { choice: ANCHORS }, anchor);
  checkOne('The option', 'box', { four: 'any' }, box);
  const [x0, y0, x1, y1] = box;
  const index = ANCHORS.indexOf(anchor);
  const along = (from: number, to: number, k: number) => (k === 0 ? from : k === 1 ? (from + to) / 2 : to);
  return [along(x0, x1, index % 3), along(y0, y1, Math.floor(index / 3))];
}
