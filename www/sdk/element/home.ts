/** Where the head starts, as seen from the drawing: the picture of an element is in its coordinates, and the job may be placed elsewhere. */

import { pointOf } from '../anchors.js';
import type { Loaded, PlanOptions } from '../protocol.js';

/** Where the head starts, and whether it returns there. */
export interface Home {
  home: [number, number];
  return_home: boolean;
}

/** `options`: those that the drawing is planned with. */
export function homeAround({ home, return_home }: Home, { place, start }: PlanOptions, { bounds }: Loaded): Home {
  const [x, y] = start === 'current' ? [0, 0] : home;
  if (!place) return { home: [x, y], return_home };
  const [fromX, fromY] = place.from ?? pointOf(place.point ?? 'lower-left', bounds);
  return { home: [x - place.at[0] + fromX, y - place.at[1] + fromY], return_home };
}
