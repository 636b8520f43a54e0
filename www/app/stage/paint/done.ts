/** Paints what has been cut at a moment of the playback. */

import type { View } from '../raster-messages.js';
import { isWhole, leadShapes } from '../shapes.js';
import { traceStop, type Pen } from '../trace.js';
import { strokeAir } from './air.js';
import { BATCH, contourWidth, strokeChains, type Subject } from './strokes.js';
import { isAir } from '../legs.js';
import { paintRisky, paintTips } from './tips.js';

/** Everything that is cut before stop `upto`, with the air moves between. */
export function* paintDone(pen: Pen, view: View, subject: Subject, upto: number): Generator<void> {
  const { shapes, path, palette } = subject;
  if (!path) return;
  const done = new Uint8Array(shapes.count);
  const parts: number[] = [];
  for (let k = 0; k < Math.min(upto, path.contours.length); k += 1) {
    if (isWhole(path, k)) done[path.contours[k]!] = 1;
    else parts.push(k);
  }
  pen.lineJoin = 'round';
  yield* paintTips(pen, view, subject, upto);
  if (subject.air) {
    pen.strokeStyle = palette.accent;
    pen.lineWidth = view.ratio;
    yield* strokeAir(pen, view, subject, upto - 1, (k) => isAir(path, k));
    yield* paintRisky(pen, view, subject, upto - 1);
  }
  pen.strokeStyle = palette.ink;
  pen.lineWidth = contourWidth(subject, view) * 1.25;
  yield* strokeChains(pen, view, shapes, (c) => done[c] === 1);
  const leads = leadShapes(path);
  if (leads) yield* strokeChains(pen, view, leads, (chain) => chain < 2 * upto && leads.offsets[chain + 1]! > leads.offsets[chain]!);
  for (const k of parts) {
    pen.beginPath();
    traceStop(pen, view, shapes, path, k);
    pen.stroke();
    if (k % BATCH === 0) yield;
  }
}
