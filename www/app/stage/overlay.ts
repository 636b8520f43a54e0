/**
 * What is drawn over the bitmaps with every frame: the size of the sheet, the contour under the pointer and the selected one, partitions,
 * pre-cuts, the head. All of it takes a handful of strokes, in device pixels.
 */

import { extent, width } from '../core/format.js';
import type { BestPath, Insight } from 'kerfway';
import type { Moment } from '../playback/timeline.js';
import type { Palette } from './palette.js';
import type { Travel, View } from './raster-messages.js';
import type { Shapes } from './shapes.js';
import { traceAir, traceChain } from './trace.js';
import { words } from '../core/words/index.js';

type Pen = CanvasRenderingContext2D;

/** CSS pixels between the contours and the edge of the sheet that is drawn around them. */
const PAD = 14;

/** The sheet as an area around what is drawn. */
export function drawSheet(pen: Pen, view: View, palette: Palette, bounds: readonly number[]): void {
  const { x0, y0, x1, y1 } = onScreen(view, bounds);
  const r = view.ratio, pad = PAD * r;
  pen.fillStyle = palette.sheet;
  pen.fillRect(x0 - pad, y0 - pad, x1 - x0 + 2 * pad, y1 - y0 + 2 * pad);
  pen.strokeStyle = palette.line;
  pen.lineWidth = r;
  pen.strokeRect(Math.round(x0 - pad) + 0.5, Math.round(y0 - pad) + 0.5, Math.round(x1 - x0 + 2 * pad), Math.round(y1 - y0 + 2 * pad));
}

/** The width and height of what is drawn, at the edges of the sheet. */
export function drawSizes(pen: Pen, view: View, palette: Palette, bounds: readonly number[]): void {
  const { x0, y0, x1, y1 } = onScreen(view, bounds);
  const r = view.ratio, pad = PAD * r;
  const [wide, high] = [bounds[2]! - bounds[0]!, bounds[3]! - bounds[1]!];
  pen.font = `${12 * view.text}px system-ui, sans-serif`;
  pen.textAlign = 'center';
  pen.textBaseline = 'top';
  if (x1 - x0 > 60 * r) label(pen, palette.text, palette.ground, width(wide, high), (x0 + x1) / 2, y1 + pad + 6 * r, r);
  if (y1 - y0 > 60 * r) {
    pen.save();
    pen.translate(x0 - pad - 6 * r, (y0 + y1) / 2);
    pen.rotate(-Math.PI / 2);
    pen.textBaseline = 'bottom';
    label(pen, palette.text, palette.ground, width(high, wide), 0, 0, r);
    pen.restore();
  }
  pen.textAlign = 'start';
}

/** A box of the sheet in device pixels. */
function onScreen(view: View, [left = 0, bottom = 0, right = 0, top = 0]: readonly number[]) {
  return { x0: view.x + left * view.scale, x1: view.x + right * view.scale, y0: view.y - top * view.scale, y1: view.y - bottom * view.scale };
}

/** A text that interrupts the lines which it meets, such as the edge of the bed. */
function label(pen: Pen, color: string, ground: string, text: string, x: number, y: number, ratio: number): void {
  pen.lineJoin = 'round';
  pen.lineWidth = 6 * ratio;
  pen.strokeStyle = ground;
  pen.strokeText(text, x, y);
  pen.fillStyle = color;
  pen.fillText(text, x, y);
}

/** Widths of its label that the bed has to have: in the middle is the width of the sheet. */
const ROOM = 3;

/** The bed of the machine, with its size below the corner. Its edge is red where the job does not lie on it. */
export function drawBed(pen: Pen, view: View, palette: Palette, bed: readonly number[], fits: boolean): void {
  const { x0, y0, x1, y1 } = onScreen(view, bed);
  const r = view.ratio;
  pen.strokeStyle = fits ? palette.faint : palette.red;
  pen.lineWidth = (fits ? 1 : 2) * r;
  pen.setLineDash([8 * r, 4 * r]);
  pen.strokeRect(x0, y0, x1 - x0, y1 - y0);
  pen.setLineDash([]);
  pen.font = `${12 * view.text}px system-ui, sans-serif`;
  pen.textBaseline = 'top';
  pen.textAlign = 'right';
  const text = words.stage.bed(extent(bed[2]! - bed[0]!, bed[3]! - bed[1]!));
  // Below, where no contours are, unless it would meet the width of the sheet there or be cut off.
  if (x1 <= pen.canvas.width && x1 - x0 > ROOM * pen.measureText(text).width) label(pen, fits ? palette.text : palette.red, palette.ground, text, x1, y1 + 4 * r, r);
  pen.textAlign = 'start';
  pen.textBaseline = 'alphabetic';
}

/** A contour that stands out. */
export function drawEmphasis(pen: Pen, view: View, palette: Palette, shapes: Shapes, chain: number, strong: boolean): void {
  pen.lineJoin = pen.lineCap = 'round';
  pen.beginPath();
  traceChain(pen, view, shapes, chain);
  pen.globalAlpha = strong ? 0.28 : 0.18;
  pen.lineWidth = 9 * view.ratio;
  pen.strokeStyle = palette.accent;
  pen.stroke();
  pen.globalAlpha = 1;
  pen.lineWidth = (strong ? 2.4 : 1.8) * view.ratio;
  pen.stroke();
}

/** All other selected contours, in one stroke. */
export function drawSelection(pen: Pen, view: View, palette: Palette, shapes: Shapes, chains: readonly number[]): void {
  pen.lineJoin = pen.lineCap = 'round';
  pen.beginPath();
  for (const chain of chains) if (chain < shapes.count) traceChain(pen, view, shapes, chain);
  pen.globalAlpha = 0.22;
  pen.lineWidth = 7 * view.ratio;
  pen.strokeStyle = palette.accent;
  pen.stroke();
  pen.globalAlpha = 1;
  pen.lineWidth = 1.8 * view.ratio;
  pen.stroke();
}

/** The box that is being drawn to select what is in it. */
export function drawBox(pen: Pen, ratio: number, palette: Palette, [x0, y0, x1, y1]: readonly [number, number, number, number]): void {
  pen.fillStyle = pen.strokeStyle = palette.accent;
  pen.globalAlpha = 0.1;
  pen.fillRect(x0 * ratio, y0 * ratio, (x1 - x0) * ratio, (y1 - y0) * ratio);
  pen.globalAlpha = 1;
  pen.lineWidth = ratio;
  pen.setLineDash([4 * ratio, 3 * ratio]);
  pen.strokeRect(x0 * ratio, y0 * ratio, (x1 - x0) * ratio, (y1 - y0) * ratio);
  pen.setLineDash([]);
}

/** The step from the colour of one partition to the next, as a share of the ramp: with the golden ratio, neighbours never look alike. */
const TURN = 0.618034;

/** The partitions of a method that makes them, each in its own colour, and rings where the head leaves a contour for a partition. */
export function drawPartitions(pen: Pen, view: View, palette: Palette, shapes: Shapes, partitions: NonNullable<Insight['partitions']>): void {
  const r = view.ratio;
  const contours: number[][] = Array.from({ length: partitions.parents.length + 1 }, () => []);
  partitions.of.forEach((partition, contour) => contours[partition]?.push(contour));
  pen.lineJoin = 'round';
  pen.lineWidth = 2 * r;
  contours.forEach((list, partition) => {
    pen.strokeStyle = palette.ramp[Math.floor(((partition * TURN) % 1) * palette.ramp.length)]!;
    pen.beginPath();
    for (const contour of list) if (contour < shapes.count) traceChain(pen, view, shapes, contour);
    pen.stroke();
  });
  pen.strokeStyle = palette.accent;
  pen.fillStyle = palette.sheet;
  pen.beginPath();
  for (const { at } of partitions.parents) {
    const x = view.x + at[0] * view.scale, y = view.y - at[1] * view.scale;
    pen.moveTo(x + 4 * r, y);
    pen.arc(x, y, 4 * r, 0, 2 * Math.PI);
  }
  pen.fill();
  pen.stroke();
}

/** From the centre of a mark to its sides, CSS pixels. */
const MARK = 3.5;

/** Diamonds at pre-cuts, and squares where a cut pauses in a sharp corner. */
export function drawCutMarks(pen: Pen, view: View, palette: Palette, path: BestPath): void {
  const size = MARK * view.ratio;
  const marks = (places: Float64Array, corners: readonly (readonly [number, number])[]) => {
    pen.beginPath();
    for (let i = 0; i + 1 < places.length; i += 2) {
      const x = view.x + places[i]! * view.scale, y = view.y - places[i + 1]! * view.scale;
      if (x < -size || y < -size || x > view.width + size || y > view.height + size) continue;
      corners.forEach(([dx, dy], k) => (k === 0 ? pen.moveTo(x + dx * size, y + dy * size) : pen.lineTo(x + dx * size, y + dy * size)));
      pen.closePath();
    }
    pen.fill();
    pen.stroke();
  };
  pen.lineWidth = 1.5 * view.ratio;
  pen.fillStyle = palette.sheet;
  pen.strokeStyle = palette.accent;
  marks(path.preCuts, [[0, -1.3], [1.3, 0], [0, 1.3], [-1.3, 0]]);
  marks(path.pauses, [[-0.8, -0.8], [0.8, -0.8], [0.8, 0.8], [-0.8, 0.8]]);
}

/** The air moves into and out of a stop, in a heavier line. */
export function drawTravel(pen: Pen, view: View, palette: Palette, path: BestPath, travel: Travel, stop: number): void {
  const p = path.points;
  const last = path.contours.length - 1;
  pen.strokeStyle = palette.accent;
  pen.lineWidth = 2.4 * view.ratio;
  pen.beginPath();
  const [hx, hy] = travel.home;
  if (stop === 0) traceAir(pen, view, travel, hx, hy, p[0]!, p[1]!);
  else traceAir(pen, view, travel, p[stop * 4 - 2]!, p[stop * 4 - 1]!, p[stop * 4]!, p[stop * 4 + 1]!);
  if (stop < last) traceAir(pen, view, travel, p[stop * 4 + 2]!, p[stop * 4 + 3]!, p[stop * 4 + 4]!, p[stop * 4 + 5]!);
  else if (travel.returnHome) traceAir(pen, view, travel, p[stop * 4 + 2]!, p[stop * 4 + 3]!, hx, hy);
  pen.stroke();
}

/** Where the head starts: a square, over everything that lies there. */
export function drawStart(pen: Pen, view: View, palette: Palette, { home: [x, y] }: Travel): void {
  const half = 4 * view.ratio;
  pen.lineWidth = 1.5 * view.ratio;
  pen.strokeStyle = palette.accent;
  pen.fillStyle = palette.sheet;
  pen.beginPath();
  pen.rect(view.x + x * view.scale - half, view.y - y * view.scale - half, 2 * half, 2 * half);
  pen.fill();
  pen.stroke();
}

/** The head: a ring with a dot, filled while the beam is on, larger while it is lifted over pieces that may have tipped. */
export function drawHead(pen: Pen, view: View, palette: Palette, { x, y, cutting, lifted }: Moment): void {
  const r = view.ratio;
  const px = view.x + x * view.scale, py = view.y - y * view.scale;
  pen.beginPath();
  pen.arc(px, py, (lifted ? 11 : 7) * r, 0, 2 * Math.PI);
  pen.fillStyle = cutting ? palette.accent : palette.sheet;
  pen.fill();
  pen.lineWidth = 2 * r;
  pen.strokeStyle = cutting ? palette.sheet : palette.accent;
  pen.stroke();
  if (cutting) return;
  pen.beginPath();
  pen.arc(px, py, 2 * r, 0, 2 * Math.PI);
  pen.fillStyle = palette.accent;
  pen.fill();
}
