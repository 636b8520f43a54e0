/** The default budget of a quote: reproducible, and large enough for the number of contours. */

import { activeContours } from './contours.js';
import type { Budget, Loaded } from './protocol.js';

/** A server that plans again with the same seed and moves confirms the hash of a report. */
const SEED = 1;
/** Moves for each contour. With as many, the air of a quote is within 1 % of that of a search ten times as long: `npm run bench -- quote`. */
const MOVES_PER_CONTOUR = 5_000;
/** Small drawings get this many, which takes a fraction of a second. */
const LEAST_MOVES = 100_000;

/** Moves that grow with the number of contours, and the seed. It depends on the drawing alone. */
export function quoteBudget(loaded: Pick<Loaded, 'contours'>): Budget & { seed: number } {
  return { moves: Math.max(LEAST_MOVES, MOVES_PER_CONTOUR * activeContours(loaded).length), seed: SEED };
}
