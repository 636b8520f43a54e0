/** Measuring on the sheet: two points, which snap to the ends and centres of elements, and the distance between them. */

import { millimetres, size } from '../core/format.js';
import type { Palette } from './palette.js';
import type { View } from './raster-messages.js';
import { STRIDE, type Shapes } from './shapes.js';

export interface Point {
  x: number;
  y: number;
}

/** The points that are measured between, mm; the second one is missing until it is chosen. */
export type Measured = readonly [Point, Point?] | null;

/** The end or centre of an element within `reach` mm of a place, otherwise the place itself. */
export function snap(shapes: Shapes, x: number, y: number, reach: number): Point {
  const { segments } = shapes;
  let best = reach * reach;
  let found: Point = { x, y };
  const look = (px: number, py: number) => {
    const d = (px - x) ** 2 + (py - y) ** 2;
    if (d < best) [best, found] = [d, { x: px, y: py }];
  };
  for (let i = 0; i < segments.length; i += STRIDE) {
    look(segments[i]!, segments[i + 1]!);
    look(segments[i + 2]!, segments[i + 3]!);
    if (segments[i + 6] !== 0) look(segments[i + 4]!, segments[i + 5]!);
  }
  return found;
}

/** The distance in words, with its parts along x and y. */
export function inWords([a, b]: readonly [Point, Point]): string {
  return `${millimetres(Math.hypot(b.x - a.x, b.y - a.y))} (x ${size(Math.abs(b.x - a.x))}, y ${size(Math.abs(b.y - a.y))})`;
}

/** Draws the points, the line between them and its length. */
export function drawMeasured(pen: CanvasRenderingContext2D, view: View, palette: Palette, [a, b]: NonNullable<Measured>): void {
  const at = ({ x, y }: Point) => [view.x + x * view.scale, view.y - y * view.scale] as const;
  const r = view.ratio;
  pen.strokeStyle = pen.fillStyle = palette.accent;
  pen.lineWidth = 2 * r;
  pen.beginPath();
  for (const point of [a, b]) {
    if (!point) continue;
    const [x, y] = at(point);
    pen.moveTo(x - 6 * r, y);
    pen.lineTo(x + 6 * r, y);
    pen.moveTo(x, y - 6 * r);
    pen.lineTo(x, y + 6 * r);
  }
  if (b) {
    pen.moveTo(...at(a));
    pen.lineTo(...at(b));
  }
  pen.stroke();
  if (!b) return;
  const [[x0, y0], [x1, y1]] = [at(a), at(b)];
  pen.font = `600 ${13 * view.text}px system-ui, sans-serif`;
  pen.textAlign = 'center';
  pen.textBaseline = 'bottom';
  pen.lineWidth = 4 * r;
  pen.strokeStyle = palette.sheet;
  pen.strokeText(inWords([a, b]), (x0 + x1) / 2, (y0 + y1) / 2 - 6 * r);
  pen.fillText(inWords([a, b]), (x0 + x1) / 2, (y0 + y1) / 2 - 6 * r);
  pen.textAlign = 'start';
  pen.textBaseline = 'alphabetic';
}
