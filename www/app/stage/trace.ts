/** Adds contours and air moves to a canvas path. From the sheet to the screen, coordinates are scaled and shifted, and y is flipped. */

import type { BestPath } from 'kerfway';
import { chainLength, cutLength, isWhole, leadShapes, placeAfter, STRIDE, walk, type Shapes } from './shapes.js';
import type { Travel, View } from './raster-messages.js';

/** The context of a canvas, on the page or in a worker. */
export type Pen = CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D;
/** The part of a view that tracing needs. */
export type Frame = Pick<View, 'scale' | 'x' | 'y'>;

/** Arcs shorter than this many pixels are drawn as a line, because nobody sees the difference. */
const ARC_PIXELS = 0.7;

/** Adds a whole chain, `joined` to what was added before by a line. */
export function traceChain(pen: Pen, frame: Frame, shapes: Shapes, chain: number, joined = false): void {
  const first = shapes.offsets[chain]!, end = shapes.offsets[chain + 1]!;
  if (end <= first) return;
  const s = shapes.segments;
  const i = first * STRIDE;
  pen[joined ? 'lineTo' : 'moveTo'](frame.x + s[i]! * frame.scale, frame.y - s[i + 1]! * frame.scale);
  for (let e = first; e < end; e += 1) traceElement(pen, frame, shapes, e, 0, 1);
}

/** Adds element `e` between two parts of its length, in that order. The path must end at the first of them. */
export function traceElement(pen: Pen, frame: Frame, shapes: Shapes, e: number, from: number, to: number): void {
  const s = shapes.segments;
  const i = e * STRIDE;
  const sweep = s[i + 6]!;
  const { scale } = frame;
  if (sweep === 0) {
    const x = s[i]! + (s[i + 2]! - s[i]!) * to, y = s[i + 1]! + (s[i + 3]! - s[i + 1]!) * to;
    pen.lineTo(frame.x + x * scale, frame.y - y * scale);
    return;
  }
  const radius = shapes.arcs[e * 2]!, start = shapes.arcs[e * 2 + 1]!;
  const a0 = start + sweep * from, a1 = start + sweep * to;
  const cx = frame.x + s[i + 4]! * scale, cy = frame.y - s[i + 5]! * scale;
  if (radius * scale * Math.min(2, Math.abs(a1 - a0)) < ARC_PIXELS) {
    pen.lineTo(cx + radius * scale * Math.cos(a1), cy - radius * scale * Math.sin(a1));
    return;
  }
  pen.arc(cx, cy, radius * scale, -a0, -a1, a1 > a0);
}

/**
 * Adds the air move from one point to another. It is straight, or each axis moves at its own top speed: then the move is slanted until one
 * axis has arrived, and parallel to the other axis after that.
 */
export function traceAir(pen: Pen, frame: Frame, travel: Travel, x0: number, y0: number, x1: number, y1: number): void {
  pen.moveTo(frame.x + x0 * frame.scale, frame.y - y0 * frame.scale);
  if (travel.perAxis) {
    const [vx, vy] = travel.perAxis;
    const time = Math.min(Math.abs(x1 - x0) / vx, Math.abs(y1 - y0) / vy);
    const bx = x0 + Math.sign(x1 - x0) * vx * time, by = y0 + Math.sign(y1 - y0) * vy * time;
    pen.lineTo(frame.x + bx * frame.scale, frame.y - by * frame.scale);
  }
  pen.lineTo(frame.x + x1 * frame.scale, frame.y - y1 * frame.scale);
}

/** Adds a small triangle at a screen point, pointing along a screen direction. */
export function traceArrow(pen: Pen, x: number, y: number, dx: number, dy: number, size: number): void {
  pen.moveTo(x + dx * size, y + dy * size);
  pen.lineTo(x - dx * size * 0.7 - dy * size * 0.75, y - dy * size * 0.7 + dx * size * 0.75);
  pen.lineTo(x - dx * size * 0.7 + dy * size * 0.75, y - dy * size * 0.7 - dx * size * 0.75);
  pen.closePath();
}

/** Adds everything that a stop cuts. */
export function traceStop(pen: Pen, frame: Frame, shapes: Shapes, path: BestPath, stop: number): void {
  const chain = path.contours[stop]!;
  traceLeads(pen, frame, path, stop, Infinity, Infinity);
  if (isWhole(path, stop)) traceChain(pen, frame, shapes, chain);
  else traceCut(pen, frame, shapes, path, stop, cutLength(path, stop, chainLength(shapes, chain)));
}

/** Adds the first `into` mm of the lead-in of a stop, and the first `out` mm of its lead-out. */
export function traceLeads(pen: Pen, frame: Frame, path: BestPath, stop: number, into: number, out: number): void {
  const leads = leadShapes(path);
  if (!leads) return;
  for (const [chain, distance] of [[2 * stop, into], [2 * stop + 1, out]] as const) {
    const first = leads.offsets[chain]!;
    if (leads.offsets[chain + 1]! <= first || distance <= 0) continue;
    const i = first * STRIDE;
    pen.moveTo(frame.x + leads.segments[i]! * frame.scale, frame.y - leads.segments[i + 1]! * frame.scale);
    walk(leads, chain, 0, false, Math.min(distance, chainLength(leads, chain)), (e, from, to) => traceElement(pen, frame, leads, e, from, to));
  }
}

/** Adds the first `distance` mm of what a stop cuts. */
export function traceCut(pen: Pen, frame: Frame, shapes: Shapes, path: BestPath, stop: number, distance: number): void {
  const chain = path.contours[stop]!;
  let [x, y] = [path.points[stop * 4]!, path.points[stop * 4 + 1]!];
  // With a lead-in, the head arrives beside the contour.
  if (leadShapes(path)) ({ x, y } = placeAfter(shapes, chain, path.along[stop]!, path.reversed[stop] === 1, 0, { x, y, dx: 0, dy: 0 }));
  pen.moveTo(frame.x + x * frame.scale, frame.y - y * frame.scale);
  walk(shapes, chain, path.along[stop]!, path.reversed[stop] === 1, distance, (e, from, to) => traceElement(pen, frame, shapes, e, from, to));
}
