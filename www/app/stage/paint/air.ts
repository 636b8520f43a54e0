/** Paints air moves. */

import type { View } from '../raster-messages.js';
import { traceAir, type Pen } from '../trace.js';
import { strokeAll, type Subject } from './strokes.js';

/** Strokes the air moves into the stops up to `to` that `take` picks. The stop after the last one is home. */
export function* strokeAir(pen: Pen, view: View, subject: Subject, to: number, take: (stop: number) => boolean): Generator<void> {
  const { path, travel } = subject;
  if (!path) return;
  const p = path.points;
  const stops = path.contours.length;
  yield* strokeAll(pen, Math.min(to, travel.returnHome ? stops : stops - 1) + 1, (k) => {
    if (!take(k)) return 0;
    const [x0, y0] = k === 0 ? travel.home : [p[k * 4 - 2]!, p[k * 4 - 1]!];
    const [x1, y1] = k === stops ? travel.home : [p[k * 4]!, p[k * 4 + 1]!];
    if (offScreen(view, x0, y0, x1, y1)) return 0;
    traceAir(pen, view, travel, x0, y0, x1, y1);
    return 1;
  });
}

function offScreen(view: View, x0: number, y0: number, x1: number, y1: number): boolean {
  const left = view.x + Math.min(x0, x1) * view.scale, right = view.x + Math.max(x0, x1) * view.scale;
  const top = view.y - Math.max(y0, y1) * view.scale, bottom = view.y - Math.min(y0, y1) * view.scale;
  return right < 0 || bottom < 0 || left > view.width || top > view.height;
}

/** Paints the air moves that the last improvement changed. */
export function* paintGlow(pen: Pen, view: View, subject: Subject): Generator<void> {
  const { changed, palette } = subject;
  if (!changed) return;
  pen.lineWidth = 5 * view.ratio;
  pen.lineCap = 'round';
  pen.strokeStyle = palette.accent;
  yield* strokeAir(pen, view, subject, changed.length, (k) => changed[k] === 1);
}
