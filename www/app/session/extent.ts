/** The size of a drawing, skipped contours included: the paper on the stage, and the size that people check. */

import { activeContours, type Loaded } from 'kerfway';
import { prepare } from '../stage/shapes.js';

export type Box = [xmin: number, ymin: number, xmax: number, ymax: number];

/** The box around a whole drawing, mm. */
export function extentOf(loaded: Loaded): Box {
  const box: Box = activeContours(loaded).length > 0 ? [...loaded.bounds] : [Infinity, Infinity, -Infinity, -Infinity];
  const { boxes } = prepare(loaded.ignored.geometry);
  for (let i = 0; i < boxes.length; i += 4) {
    box[0] = Math.min(box[0], boxes[i]!);
    box[1] = Math.min(box[1], boxes[i + 1]!);
    box[2] = Math.max(box[2], boxes[i + 2]!);
    box[3] = Math.max(box[3], boxes[i + 3]!);
  }
  return box.every(Number.isFinite) ? box : [0, 0, 1, 1];
}
