/**
 * Paints the path over the contours: air moves with their direction, entries, cutting directions, numbers. Dots, arrows and numbers thin out
 * where they would crowd: a coarse grid over the screen lets one through per cell.
 */

import type { View } from '../raster-messages.js';
import { chainLength, jointShapes, leadShapes, loopShapes, placeAfter, type Place } from '../shapes.js';
import { traceArrow, type Pen } from '../trace.js';
import { strokeAir } from './air.js';
import { BATCH, contourWidth, meanSize, strokeChains, type Subject } from './strokes.js';
import { isAir } from '../legs.js';
import { paintRisky, paintTips } from './tips.js';

/** A grid over the screen that lets one thing through per cell. */
class Room {
  private readonly taken: Uint8Array;
  private readonly columns: number;

  constructor(private readonly view: View, private readonly wide: number, private readonly high: number) {
    this.columns = Math.ceil(view.width / wide) + 1;
    this.taken = new Uint8Array(this.columns * (Math.ceil(view.height / high) + 1));
  }

  take(x: number, y: number): boolean {
    if (x < 0 || y < 0 || x >= this.view.width || y >= this.view.height) return false;
    const cell = Math.floor(y / this.high) * this.columns + Math.floor(x / this.wide);
    if (this.taken[cell]) return false;
    this.taken[cell] = 1;
    return true;
  }
}

export function* paintPath(pen: Pen, view: View, subject: Subject): Generator<void> {
  const { path, palette } = subject;
  if (!path) return;
  const r = view.ratio;
  const p = path.points;
  const stops = path.contours.length;
  // Thousands of air moves at full width would cover the sheet.
  pen.lineWidth = (stops > 2000 ? 0.8 : 1.15) * r;
  yield* paintTips(pen, view, subject, stops);
  // Colours show the order then, so that the air moves step back.
  pen.strokeStyle = pen.fillStyle = subject.colors === 'order' ? palette.faint : palette.accent;
  if (subject.air) {
    yield* strokeAir(pen, view, subject, stops, (k) => isAir(path, k));
    yield* airArrows(pen, view, subject);
    yield* paintRisky(pen, view, subject, stops);
  }
  pen.strokeStyle = pen.fillStyle = palette.accent;
  const leads = leadShapes(path);
  if (leads) {
    // The beam is on along a lead: it is drawn as a cut, over its air moves.
    pen.strokeStyle = palette.ink;
    pen.lineWidth = contourWidth(subject, view);
    yield* strokeChains(pen, view, leads, (chain) => leads.offsets[chain + 1]! > leads.offsets[chain]!);
    pen.strokeStyle = palette.accent;
  }
  if (path.loops.length > 0) {
    pen.strokeStyle = palette.ink;
    pen.lineWidth = contourWidth(subject, view);
    yield* strokeChains(pen, view, loopShapes(path), () => true);
    pen.strokeStyle = palette.accent;
  }
  yield* joints(pen, view, subject);
  const mean = meanSize(subject, view);
  const dot = Math.min(2.3, Math.max(0.8, mean / 8)) * r;
  const room = new Room(view, 8 * r, 8 * r);
  pen.beginPath();
  // Dots are useless where the contours themselves are as small as dots.
  for (let k = 0; k < (mean > 3 ? stops : 0); k += 1) {
    const x = view.x + p[k * 4]! * view.scale, y = view.y - p[k * 4 + 1]! * view.scale;
    if (!room.take(x, y)) continue;
    pen.moveTo(x + dot, y);
    pen.arc(x, y, dot, 0, 2 * Math.PI);
    if (k % BATCH === 0) {
      pen.fill();
      pen.beginPath();
      yield;
    }
  }
  pen.fill();
  yield* cutArrows(pen, view, subject);
  yield* numbers(pen, view, subject);
}

/** A gap in the contour at each micro-joint with a ring around it, as joints are too small to see. */
function* joints(pen: Pen, view: View, { path, palette }: Subject): Generator<void> {
  const shapes = jointShapes(path!);
  if (shapes.count === 0) return;
  const r = view.ratio;
  const room = new Room(view, 7 * r, 7 * r);
  const place: Place = { x: 0, y: 0, dx: 0, dy: 0 };
  pen.lineWidth = 1.4 * r;
  pen.fillStyle = palette.sheet;
  for (let k = 0; k < shapes.count; k += 1) {
    const length = chainLength(shapes, k);
    placeAfter(shapes, k, 0, false, length / 2, place);
    const x = view.x + place.x * view.scale, y = view.y - place.y * view.scale;
    if (!room.take(x, y)) continue;
    pen.beginPath();
    pen.arc(x, y, Math.max(3.4 * r, (length / 2) * view.scale), 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
    if (k % BATCH === 0) yield;
  }
}

/** An arrow in the middle of each air move that is long enough for one. */
function* airArrows(pen: Pen, view: View, subject: Subject): Generator<void> {
  const { points: p, contours } = subject.path!;
  const r = view.ratio;
  const room = new Room(view, 26 * r, 26 * r);
  pen.beginPath();
  for (let k = 1; k < contours.length; k += 1) {
    const dx = (p[k * 4]! - p[k * 4 - 2]!) * view.scale, dy = -(p[k * 4 + 1]! - p[k * 4 - 1]!) * view.scale;
    const length = Math.hypot(dx, dy);
    if (length < 44 * r || subject.travel.perAxis) continue;
    const x = view.x + p[k * 4 - 2]! * view.scale + dx / 2, y = view.y - p[k * 4 - 1]! * view.scale + dy / 2;
    if (room.take(x, y)) traceArrow(pen, x, y, dx / length, dy / length, 3.6 * r);
  }
  pen.fill();
  yield;
}

/** An arrow a little after each entry, in the direction of the cut. */
function* cutArrows(pen: Pen, view: View, subject: Subject): Generator<void> {
  const { shapes, path, palette } = subject;
  const r = view.ratio;
  const room = new Room(view, 20 * r, 20 * r);
  const place: Place = { x: 0, y: 0, dx: 0, dy: 0 };
  pen.fillStyle = palette.ink;
  pen.beginPath();
  for (let k = 0; k < path!.contours.length; k += 1) {
    const c = path!.contours[k]!;
    const size = (shapes.boxes[c * 4 + 2]! - shapes.boxes[c * 4]! + shapes.boxes[c * 4 + 3]! - shapes.boxes[c * 4 + 1]!) * view.scale;
    if (size < 56 * r) continue;
    placeAfter(shapes, c, path!.along[k]!, path!.reversed[k] === 1, (10 * r) / view.scale, place);
    const x = view.x + place.x * view.scale, y = view.y - place.y * view.scale;
    if (!room.take(x, y)) continue;
    traceArrow(pen, x, y, place.dx, -place.dy, 3.6 * r);
    if (k % BATCH === 0) {
      pen.fill();
      pen.beginPath();
      yield;
    }
  }
  pen.fill();
  yield;
}

/** The place in the order, beside the entries of contours that are large enough on screen. */
function* numbers(pen: Pen, view: View, subject: Subject): Generator<void> {
  const { shapes, path, palette } = subject;
  const r = view.ratio;
  const room = new Room(view, 40 * r, 22 * r);
  // Not over the start marker.
  room.take(view.x + subject.travel.home[0] * view.scale + 6 * r, view.y - subject.travel.home[1] * view.scale - 7 * r);
  pen.font = `${11 * view.text}px system-ui, sans-serif`;
  pen.textBaseline = 'middle';
  pen.lineWidth = 3 * r;
  pen.lineJoin = 'round';
  pen.strokeStyle = palette.sheet;
  pen.fillStyle = palette.accent;
  let drawn = 0;
  for (let k = 0; k < path!.contours.length; k += 1) {
    const c = path!.contours[k]!;
    const b = shapes.boxes;
    if (Math.min(b[c * 4 + 2]! - b[c * 4]!, b[c * 4 + 3]! - b[c * 4 + 1]!) * view.scale < 40 * r) continue;
    const x = view.x + path!.points[k * 4]! * view.scale, y = view.y - path!.points[k * 4 + 1]! * view.scale;
    if (!room.take(x, y)) continue;
    const text = String(k + 1);
    pen.strokeText(text, x + 6 * r, y - 7 * r);
    pen.fillText(text, x + 6 * r, y - 7 * r);
    drawn += 1;
    if (drawn % 64 === 0) yield;
  }
}
