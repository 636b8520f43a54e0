/** Paints all contours: those that are cut or marked, the ignored ones, and stretches that are cut once for two parts. */

import { LAYER_COLORS } from '../layer-colors.js';
import { RAMP_STEPS } from '../ramp.js';
import { Role, type View } from '../raster-messages.js';
import type { Pen } from '../trace.js';
import { contourWidth, strokeChains, type Subject } from './strokes.js';

/** Width of the band along a cut that two parts share, CSS pixels; the legend shows the same. */
const COMMON_WIDTH = 6;
const COMMON_ALPHA = 0.3;

/** Contours are drawn in ink, or coloured by their place in the order. */
export function* paintSheet(pen: Pen, view: View, subject: Subject): Generator<void> {
  const { shapes, roles, palette, path } = subject;
  const width = contourWidth(subject, view);
  pen.lineJoin = 'round';
  pen.setLineDash([4 * view.ratio, 3 * view.ratio]);
  pen.lineWidth = view.ratio;
  pen.strokeStyle = palette.faint;
  yield* strokeChains(pen, view, subject.ignored, () => true);
  pen.setLineDash([]);
  if (subject.common) {
    pen.globalAlpha = COMMON_ALPHA;
    pen.lineWidth = COMMON_WIDTH * view.ratio;
    pen.strokeStyle = palette.accent;
    yield* strokeChains(pen, view, subject.common, () => true);
    pen.globalAlpha = 1;
    pen.lineWidth = view.ratio;
    pen.strokeStyle = palette.faint;
  }
  if (subject.drawn) yield* strokeChains(pen, view, subject.drawn, (c) => roles[c] !== Role.mark);
  if (subject.colors === 'layers') {
    pen.lineWidth = width * 1.2;
    for (const [color, value] of LAYER_COLORS.entries()) {
      pen.strokeStyle = value || palette.ink;
      yield* strokeChains(pen, view, shapes, (c) => subject.layers[c] === color && roles[c] !== Role.none);
    }
    return;
  }
  if (subject.colors === 'order' && path) {
    const step = new Uint8Array(shapes.count).fill(RAMP_STEPS);
    const stops = path.contours.length;
    for (let k = 0; k < stops; k += 1) step[path.contours[k]!] = Math.min(RAMP_STEPS - 1, Math.floor((k * RAMP_STEPS) / stops));
    pen.lineWidth = width * 1.25;
    for (let s = 0; s < RAMP_STEPS; s += 1) {
      pen.strokeStyle = palette.ramp[s]!;
      yield* strokeChains(pen, view, shapes, (c) => step[c] === s);
    }
    return;
  }
  pen.strokeStyle = palette.inkSoft;
  pen.lineWidth = width;
  yield* strokeChains(pen, view, shapes, (c) => roles[c] === Role.inner);
  pen.lineWidth = width * 0.7;
  yield* strokeChains(pen, view, shapes, (c) => roles[c] === Role.mark);
  pen.strokeStyle = palette.ink;
  pen.lineWidth = width * 1.1;
  yield* strokeChains(pen, view, shapes, (c) => roles[c] === Role.outer);
}
