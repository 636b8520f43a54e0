/**
 * What all painters of the drawing worker share. A painter is a generator that yields after each batch of strokes, so that the worker can drop
 * it when the view has moved on.
 */

import type { BestPath } from 'kerfway';
import type { Palette } from '../palette.js';
import type { Colors, Travel, View } from '../raster-messages.js';
import type { Shapes } from '../shapes.js';
import { traceChain, type Pen } from '../trace.js';

/** Everything that a painter draws. */
export interface Subject {
  shapes: Shapes;
  roles: Uint8Array;
  ignored: Shapes;
  /** The drawn outlines, where `shapes` are the lines that the beam follows beside them. */
  drawn: Shapes | null;
  /** Stretches that are cut once for two parts. */
  common: Shapes | null;
  path: BestPath | null;
  travel: Travel;
  /** 1 for each stop that the last improvement changed. */
  changed: Uint8Array | null;
  palette: Palette;
  colors: Colors;
  /** By contour: the index of the colour of its layer. */
  layers: Uint8Array;
  air: boolean;
}

/** Elements that are stroked at once. Larger paths cost the rasteriser more per element, smaller ones more calls. */
export const BATCH = 256;
/** A contour smaller than this many pixels is drawn as a dot. */
const DOT = 1.2;

/** Strokes what `add` traces for each of `count` things, in batches. `add` returns how many elements it traced. */
export function* strokeAll(pen: Pen, count: number, add: (i: number) => number): Generator<void> {
  let held = 0;
  pen.beginPath();
  for (let i = 0; i < count; i += 1) {
    held += add(i);
    if (held >= BATCH) {
      pen.stroke();
      pen.beginPath();
      held = 0;
      yield;
    }
  }
  pen.stroke();
  yield;
}

/** Strokes the chains that `take` picks and that are on screen. */
export function strokeChains(pen: Pen, view: View, shapes: Shapes, take: (chain: number) => boolean): Generator<void> {
  const { boxes, offsets } = shapes;
  return strokeAll(pen, shapes.count, (c) => {
    if (!take(c)) return 0;
    const x0 = view.x + boxes[c * 4]! * view.scale, x1 = view.x + boxes[c * 4 + 2]! * view.scale;
    const y0 = view.y - boxes[c * 4 + 3]! * view.scale, y1 = view.y - boxes[c * 4 + 1]! * view.scale;
    if (x1 < -4 || y1 < -4 || x0 > view.width + 4 || y0 > view.height + 4) return 0;
    if (x1 - x0 < DOT && y1 - y0 < DOT) {
      pen.rect(x0, y0, DOT / 2, DOT / 2);
      return 1;
    }
    traceChain(pen, view, shapes, c);
    return offsets[c + 1]! - offsets[c]!;
  });
}

/** The mean size of a contour on screen, CSS pixels, from a sample. */
export function meanSize(subject: Subject, view: View): number {
  const { boxes, count } = subject.shapes;
  let sum = 0;
  const stride = Math.max(1, Math.floor(count / 256));
  let seen = 0;
  for (let c = 0; c < count; c += stride, seen += 1) sum += boxes[c * 4 + 2]! - boxes[c * 4]! + boxes[c * 4 + 3]! - boxes[c * 4 + 1]!;
  return seen ? ((sum / seen / 2) * view.scale) / view.ratio : 0;
}

/** Line width of contours, device pixels: full where they are large on screen, thinner where there are thousands. */
export function contourWidth(subject: Subject, view: View): number {
  return Math.min(1.4, Math.max(0.7, meanSize(subject, view) / 14)) * view.ratio;
}
