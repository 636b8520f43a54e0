/**
 * What the drawing worker paints. Each painter is a generator that yields after a batch of strokes, so that the worker
 * can drop it when the view has moved on. Dots, arrows and numbers thin out with zoom: a coarse grid over the screen
 * lets one through where there is room.
 */

import { chainLength, cutLength, isWhole, placeAfter, walk, type Place, type Shapes } from './shapes.js';
import { traceAir, traceArrow, traceChain, traceElement, type Pen } from './trace.js';
import { RAMP_STEPS } from './ramp.js';
import { Role, type Travel, type View } from './raster-messages.js';
import type { BestPath } from 'kerfway';
import type { Palette } from './palette.js';

/** Everything there is to draw. */
export interface Subject {
  shapes: Shapes;
  roles: Uint8Array;
  ignored: Shapes;
  /** The outlines of parts, where `shapes` are the lines of a beam beside them. */
  drawn: Shapes | null;
  /** Stretches that are cut once for two parts. */
  common: Shapes | null;
  path: BestPath | null;
  travel: Travel;
  changed: Uint8Array | null;
  palette: Palette;
  ramp: boolean;
  air: boolean;
}

/** Elements stroked at once. Larger paths cost the rasteriser more per element, smaller ones more calls. */
const BATCH = 256;
/** The band along a cut that two parts share, CSS pixels; the legend shows the same. */
const COMMON_WIDTH = 6;
const COMMON_ALPHA = 0.3;
/** A contour smaller than this many pixels is a dot. */
const DOT = 1.2;

/** Strokes what `add` traces for each of `count` things, in batches; `add` says how many elements it traced. */
function* strokeAll(pen: Pen, count: number, add: (i: number) => number): Generator<void> {
  let held = 0;
  pen.beginPath();
  for (let i = 0; i < count; i += 1) {
    held += add(i);
    if (held >= BATCH) {
      pen.stroke();
      pen.beginPath();
      held = 0;
      yield;
    }
  }
  pen.stroke();
  yield;
}

/** Strokes those chains that `take` picks. */
function strokeChains(pen: Pen, view: View, shapes: Shapes, take: (chain: number) => boolean): Generator<void> {
  const { boxes, offsets } = shapes;
  return strokeAll(pen, shapes.count, (c) => {
    if (!take(c)) return 0;
    const x0 = view.x + boxes[c * 4]! * view.scale, x1 = view.x + boxes[c * 4 + 2]! * view.scale;
    const y0 = view.y - boxes[c * 4 + 3]! * view.scale, y1 = view.y - boxes[c * 4 + 1]! * view.scale;
    if (x1 < -4 || y1 < -4 || x0 > view.width + 4 || y0 > view.height + 4) return 0;
    if (x1 - x0 < DOT && y1 - y0 < DOT) {
      pen.rect(x0, y0, DOT / 2, DOT / 2);
      return 1;
    }
    traceChain(pen, view, shapes, c);
    return offsets[c + 1]! - offsets[c]!;
  });
}

/** Size of a contour on screen, CSS pixels, in the mean of a sample of them. */
function meanSize(subject: Subject, view: View): number {
  const { boxes, count } = subject.shapes;
  let sum = 0;
  const stride = Math.max(1, Math.floor(count / 256));
  let seen = 0;
  for (let c = 0; c < count; c += stride, seen += 1) sum += boxes[c * 4 + 2]! - boxes[c * 4]! + boxes[c * 4 + 3]! - boxes[c * 4 + 1]!;
  return seen ? ((sum / seen / 2) * view.scale) / view.ratio : 0;
}

/** Line width of contours: full where they are large on screen, finer where thousands crowd. */
function contourWidth(subject: Subject, view: View): number {
  return Math.min(1.4, Math.max(0.7, meanSize(subject, view) / 14)) * view.ratio;
}

/** All contours: in ink, or coloured by their place in the order. */
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
  if (subject.ramp && path) {
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

/** Strokes the air moves into the stops up to `to` (and home after the last), those that `take` picks. */
function* strokeAir(pen: Pen, view: View, subject: Subject, to: number, take: (stop: number) => boolean): Generator<void> {
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

/** Lets one thing through per cell of the screen. */
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

/** Air moves with their direction, entries, cutting directions, order numbers. */
export function* paintPath(pen: Pen, view: View, subject: Subject): Generator<void> {
  const { path, palette, travel } = subject;
  if (!path) return;
  const r = view.ratio;
  const p = path.points;
  const stops = path.contours.length;
  pen.lineWidth = (stops > 2000 ? 0.8 : 1.15) * r; // Thousands of air moves in full width are a blue sheet.
  pen.strokeStyle = pen.fillStyle = palette.accent;
  if (subject.air) {
    yield* strokeAir(pen, view, subject, stops, () => true);
    yield* airArrows(pen, view, subject);
  }
  const mean = meanSize(subject, view);
  const dot = Math.min(2.3, Math.max(0.8, mean / 8)) * r;
  const room = new Room(view, 8 * r, 8 * r);
  pen.beginPath();
  // Where contours are as small as dots, dots say nothing.
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
  const hx = view.x + travel.home[0] * view.scale, hy = view.y - travel.home[1] * view.scale;
  pen.lineWidth = 1.5 * r;
  pen.strokeStyle = palette.accent;
  pen.fillStyle = palette.sheet;
  pen.beginPath();
  pen.rect(hx - 4 * r, hy - 4 * r, 8 * r, 8 * r);
  pen.fill();
  pen.stroke();
}

/** An arrow half way along each air move that is long enough to carry one. */
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

/** An arrow a little after each entry, the way the contour is cut. */
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

/** Place in the order, beside entries of contours large enough on screen. */
function* numbers(pen: Pen, view: View, subject: Subject): Generator<void> {
  const { shapes, path, palette } = subject;
  const r = view.ratio;
  const room = new Room(view, 40 * r, 22 * r);
  pen.font = `${11 * r}px system-ui, sans-serif`;
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

/** What has been cut before stop `upto`, with the air moves between. */
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
  if (subject.air) {
    pen.strokeStyle = palette.accent;
    pen.lineWidth = view.ratio;
    yield* strokeAir(pen, view, subject, upto - 1, () => true);
  }
  pen.strokeStyle = palette.ink;
  pen.lineWidth = contourWidth(subject, view) * 1.25;
  yield* strokeChains(pen, view, shapes, (c) => done[c] === 1);
  for (const k of parts) {
    pen.beginPath();
    traceStop(pen, view, shapes, path, k);
    pen.stroke();
    if (k % BATCH === 0) yield;
  }
}

/** The air moves that the last improvement changed. */
export function* paintGlow(pen: Pen, view: View, subject: Subject): Generator<void> {
  const { changed, palette } = subject;
  if (!changed) return;
  pen.lineWidth = 5 * view.ratio;
  pen.lineCap = 'round';
  pen.strokeStyle = palette.accent;
  yield* strokeAir(pen, view, subject, changed.length, (k) => changed[k] === 1);
}

/** Adds all that a stop cuts to a path. */
export function traceStop(pen: Pen, view: Pick<View, 'scale' | 'x' | 'y'>, shapes: Shapes, path: BestPath, stop: number): void {
  const chain = path.contours[stop]!;
  if (isWhole(path, stop)) traceChain(pen, view, shapes, chain);
  else traceCut(pen, view, shapes, path, stop, cutLength(path, stop, chainLength(shapes, chain)));
}

/** Adds the first `distance` mm of a stop's cut to a path. */
export function traceCut(pen: Pen, view: Pick<View, 'scale' | 'x' | 'y'>, shapes: Shapes, path: BestPath, stop: number, distance: number): void {
  const chain = path.contours[stop]!;
  pen.moveTo(view.x + path.points[stop * 4]! * view.scale, view.y - path.points[stop * 4 + 1]! * view.scale);
  walk(shapes, chain, path.along[stop]!, path.reversed[stop] === 1, distance, (e, from, to) => traceElement(pen, view, shapes, e, from, to));
}
