/** Paints the pieces that may have tipped, and the moves that cross them with the head down. */

import type { View } from '../raster-messages.js';
import { traceChain, type Pen } from '../trace.js';
import { CHAIN, CROSSES, EDGE, LIFTED, wayTo } from '../legs.js';
import { strokeAir } from './air.js';
import { BATCH, type Subject } from './strokes.js';

/** Fills the pieces that may tip and are free before stop `upto`. */
export function* paintTips(pen: Pen, view: View, { path, shapes: beam, drawn, palette }: Subject, upto: number): Generator<void> {
  if (!path?.tips?.length) return;
  const shapes = drawn ?? beam;
  pen.fillStyle = palette.amber;
  pen.globalAlpha = 0.16;
  pen.beginPath();
  let held = 0;
  for (let k = 0; k < path.tips.length; k += 1) {
    const contour = path.tips[k]!;
    if (path.freedBy[k]! >= upto) continue;
    if (contour < shapes.count) traceChain(pen, view, shapes, contour);
    // A strip between parts lies between the cuts across its ends, which follow each other.
    else for (const end of [contour, contour + 1]) if (end < beam.count) traceChain(pen, view, beam, end, end > contour);
    held += 1;
    if (held % BATCH === 0) {
      pen.fill();
      pen.beginPath();
      yield;
    }
  }
  pen.fill();
  pen.globalAlpha = 1;
}

/** Strokes the air moves before stop `to` with the head lifted, dashed, those that cross tipped pieces, in red, and cuts through waste, as contours are drawn. */
export function* paintRisky(pen: Pen, view: View, subject: Subject, to: number): Generator<void> {
  const { path, palette } = subject;
  if (!path?.ways?.length) return;
  pen.lineWidth = 2.4 * view.ratio;
  // The beam is on along a cut through waste, which is straight whatever the axes do.
  pen.strokeStyle = palette.ink;
  yield* strokeAir(pen, view, { ...subject, travel: { ...subject.travel, perAxis: null } }, to, (k) => wayTo(path, k) === CHAIN || wayTo(path, k) === EDGE, true);
  pen.strokeStyle = palette.red;
  yield* strokeAir(pen, view, subject, to, (k) => wayTo(path, k) === CROSSES);
  pen.lineWidth = 1.6 * view.ratio;
  pen.strokeStyle = palette.amber;
  pen.setLineDash([5 * view.ratio, 4 * view.ratio]);
  yield* strokeAir(pen, view, subject, to, (k) => wayTo(path, k) === LIFTED);
  pen.setLineDash([]);
}
