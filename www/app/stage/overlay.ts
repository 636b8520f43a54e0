/**
 * What lies above the bitmaps and changes by the frame: the sheet's measures, the contour under the pointer and the
 * selected one, findings, the head. Device pixels throughout; a handful of strokes a frame.
 */

import { size as sizeText } from '../core/format.js';
import type { Finding, Insight } from 'kerfway';
import type { Mark } from '../session/outlook.js';
import type { Palette } from './palette.js';
import type { View } from './raster-messages.js';
import type { Shapes } from './shapes.js';
import { traceAir, traceChain } from './trace.js';
import type { Travel } from './raster-messages.js';
import type { BestPath } from 'kerfway';

type Pen = CanvasRenderingContext2D;

/** Markers of findings nearer to each other than this many CSS pixels are drawn as one. */
const CROWD = 14;

/** The sheet as an area with its width and height written at its edges. */
export function drawSheet(pen: Pen, view: View, palette: Palette, bounds: readonly number[]): void {
  const r = view.ratio;
  const x0 = view.x + bounds[0]! * view.scale, x1 = view.x + bounds[2]! * view.scale;
  const y0 = view.y - bounds[3]! * view.scale, y1 = view.y - bounds[1]! * view.scale;
  const pad = 14 * r;
  pen.fillStyle = palette.sheet;
  pen.fillRect(x0 - pad, y0 - pad, x1 - x0 + 2 * pad, y1 - y0 + 2 * pad);
  pen.strokeStyle = palette.line;
  pen.lineWidth = r;
  pen.strokeRect(Math.round(x0 - pad) + 0.5, Math.round(y0 - pad) + 0.5, Math.round(x1 - x0 + 2 * pad), Math.round(y1 - y0 + 2 * pad));
  pen.fillStyle = palette.faint;
  pen.font = `${12 * r}px system-ui, sans-serif`;
  pen.textAlign = 'center';
  pen.textBaseline = 'top';
  if (x1 - x0 > 60 * r) pen.fillText(`${sizeText(bounds[2]! - bounds[0]!)} mm`, (x0 + x1) / 2, y1 + pad + 6 * r);
  if (y1 - y0 > 60 * r) {
    pen.save();
    pen.translate(x0 - pad - 6 * r, (y0 + y1) / 2);
    pen.rotate(-Math.PI / 2);
    pen.textBaseline = 'bottom';
    pen.fillText(`${sizeText(bounds[3]! - bounds[1]!)} mm`, 0, 0);
    pen.restore();
  }
  pen.textAlign = 'start';
}

/** A contour made to stand out, with the air move into it. */
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

/** Turn of the colours from one partition to the next, as a part of all of them: by the golden ratio no two near in number are alike. */
const TURN = 0.618034;

/** Partitions of a method that makes them, each in a colour of its own, and rings where contours are left for them. */
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

/** From the middle of a mark to its sides, CSS pixels. */
const MARK = 3.5;

/** Where pre-cuts are made: diamonds; where a cut pauses in a sharp corner: squares. */
export function drawMarks(pen: Pen, view: View, palette: Palette, path: BestPath): void {
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

/** The air moves into and out of a stop, drawn heavier. */
export function drawWays(pen: Pen, view: View, palette: Palette, path: BestPath, travel: Travel, stop: number): void {
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

/** Findings: triangles for what to look at, octagons for what cannot be cut, so that they differ without colour. */
export function drawFindings(pen: Pen, view: View, palette: Palette, findings: readonly Finding[], chosen: Finding | null): void {
  const r = view.ratio;
  const taken = new Set<number>();
  for (const finding of findings) {
    if (!finding.at || (finding.severity === 'info' && finding !== chosen)) continue;
    const x = view.x + finding.at[0] * view.scale, y = view.y - finding.at[1] * view.scale;
    if (x < -20 || y < -20 || x > view.width + 20 || y > view.height + 20) continue;
    const cell = Math.floor(x / (CROWD * r)) * 65536 + Math.floor(y / (CROWD * r));
    if (taken.has(cell) && finding !== chosen) continue;
    taken.add(cell);
    drawMarker(pen, x, y, finding.severity === 'error', finding.severity === 'error' ? palette.red : palette.amber, palette.sheet, r);
    if (finding === chosen) {
      pen.strokeStyle = finding.severity === 'error' ? palette.red : palette.amber;
      pen.lineWidth = 2 * r;
      pen.beginPath();
      pen.arc(x, y, 15 * r, 0, 2 * Math.PI);
      pen.stroke();
    }
  }
}

function drawMarker(pen: Pen, x: number, y: number, error: boolean, color: string, ground: string, r: number): void {
  pen.beginPath();
  const corners = error ? 8 : 3;
  const size = (error ? 7.5 : 8.5) * r;
  const turn = error ? Math.PI / 8 : -Math.PI / 2;
  for (let i = 0; i < corners; i += 1) {
    const a = turn + (i * 2 * Math.PI) / corners;
    pen.lineTo(x + size * Math.cos(a), y + size * Math.sin(a));
  }
  pen.closePath();
  pen.fillStyle = color;
  pen.strokeStyle = ground;
  pen.lineWidth = 1.5 * r;
  pen.stroke();
  pen.fill();
  pen.fillStyle = ground;
  pen.fillRect(x - 0.8 * r, y - 3.4 * r, 1.6 * r, 4 * r);
  pen.fillRect(x - 0.8 * r, y + 1.8 * r, 1.6 * r, 1.6 * r);
}

/** What another reading would change: rings where ends would join, two bars where they would part, crosses where something disappears. */
export function drawOutlook(pen: Pen, view: View, palette: Palette, marks: readonly Mark[]): void {
  const r = view.ratio;
  const taken = new Set<number>();
  pen.lineCap = 'round';
  for (const { kind, x: mx, y: my } of marks) {
    const x = view.x + mx * view.scale, y = view.y - my * view.scale;
    if (x < -20 || y < -20 || x > view.width + 20 || y > view.height + 20) continue;
    const cell = Math.floor(x / (CROWD * r)) * 65536 + Math.floor(y / (CROWD * r));
    if (taken.has(cell)) continue;
    taken.add(cell);
    pen.beginPath();
    const line = (x0: number, y0: number, x1: number, y1: number) => {
      pen.moveTo(x + x0 * r, y + y0 * r);
      pen.lineTo(x + x1 * r, y + y1 * r);
    };
    if (kind === 'joins') pen.arc(x, y, 8 * r, 0, 2 * Math.PI);
    else if (kind === 'opens') {
      line(-4, -8, -4, 8);
      line(4, -8, 4, 8);
    } else {
      line(-6, -6, 6, 6);
      line(-6, 6, 6, -6);
    }
    pen.strokeStyle = palette.sheet;
    pen.lineWidth = 6 * r;
    pen.stroke();
    pen.strokeStyle = kind === 'joins' ? palette.accent : palette.amber;
    pen.lineWidth = 2.5 * r;
    pen.stroke();
  }
}

/** The head: a ring with a dot, filled while the beam is on. */
export function drawHead(pen: Pen, view: View, palette: Palette, x: number, y: number, cutting: boolean): void {
  const r = view.ratio;
  const px = view.x + x * view.scale, py = view.y - y * view.scale;
  pen.beginPath();
  pen.arc(px, py, 7 * r, 0, 2 * Math.PI);
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
