/** What the beam does at corners, by name: it turns there, cuts a loop through waste, or an arc. */

import type { CornerKind } from './protocol.js';

export const CORNER_KINDS: readonly CornerKind[] = ['stop', 'loop', 'round'];
