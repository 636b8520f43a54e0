/** The default budget of a quote: reproducible, and large enough for the number of contours. */

import { activeContours } from './contours.js';
import type { Loaded } from './protocol.js';

/** A server that plans again with the same seed and moves confirms the hash of a report. */
const SEED = 1;
/** Moves for each contour of a drawing of up to 100 contours. With 5,000, air is up to 5 % above that of a search ten times as long. */
const MOVES_PER_CONTOUR = 250_000;
/** Larger drawings get as many as one of 100 contours, which takes some seconds: 4 million leave 1.5 % more air on some of them. */
const MOVES_OF_HUNDRED = 100 * MOVES_PER_CONTOUR;
/** Moves for each contour of a drawing of more than 1,000 contours. With 15,000, a sheet of 2,000 has 1.6 % more air than with ten times as many. */
const LEAST_PER_CONTOUR = 25_000;

/** Moves that grow with the number of contours, and the seed. It depends on the drawing alone. */
export function quoteBudget(loaded: Pick<Loaded, 'contours'>): { moves: number; seed: number } {
  const contours = activeContours(loaded).length;
  const moves = Math.max(Math.min(MOVES_PER_CONTOUR * contours, MOVES_OF_HUNDRED), LEAST_PER_CONTOUR * contours);
  return { moves, seed: SEED };
}
