/** What is done at the corners of contours. */

import type { CornerKind } from './protocol.js';

/** What the beam does at a corner: it turns there, cuts a loop through waste, or an arc. */
export const CORNER_KINDS: readonly CornerKind[] = ['stop', 'loop', 'round'];
