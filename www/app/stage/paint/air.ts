/** Paints air moves. */

import type { View } from '../raster-messages.js';
import { legTo, traceLeg } from '../legs.js';
import type { Pen } from '../trace.js';
import { strokeAll, type Subject } from './strokes.js';

/** Strokes the air moves into the stops up to `to` that `take` picks. The stop after the last one is home. `end`: only the last straight part of each. */
export function* strokeAir(pen: Pen, view: View, subject: Subject, to: number, take: (stop: number) => boolean, end = false): Generator<void> {
  const { path, travel } = subject;
  if (!path) return;
  const stops = path.contours.length;
  yield* strokeAll(pen, Math.min(to, travel.returnHome ? stops : stops - 1) + 1, (k) => {
    if (!take(k)) return 0;
    const leg = end ? legTo(path, travel, k).slice(-2) : legTo(path, travel, k);
    const [[x0, y0], [x1, y1]] = [leg[0]!, leg.at(-1)!];
    if (leg.length === 2 && offScreen(view, x0, y0, x1, y1)) return 0;
    traceLeg(pen, view, travel, leg);
    return leg.length - 1;
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
