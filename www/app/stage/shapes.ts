/**
 * Contours as flat arrays, and the geometry that the stage needs: boxes, lengths, points and directions along a contour. An element has seven
 * numbers: x0, y0, x1, y1, centre x, centre y, sweep; in mm and rad, counter-clockwise positive; sweep 0 is a line. No function makes an object
 * per element, because 10,000 contours are visited with every frame.
 */

import type { BestPath, Geometry } from 'kerfway';
import { inSlices } from '../core/slices.js';

/** Numbers per element. */
export const STRIDE = 7;

/** Geometry with what drawing and picking need, computed once. */
export interface Shapes extends Geometry {
  /** The number of chains. */
  count: number;
  /** xmin, ymin, xmax, ymax of each chain. */
  boxes: Float64Array;
  /** Radius and starting angle of each element; 0, 0 for lines. */
  arcs: Float64Array;
  /** Length of each element, mm. */
  lengths: Float64Array;
}

/** A point with the direction of travel through it. */
export interface Place {
  x: number;
  y: number;
  dx: number;
  dy: number;
}

const PREPARED = new WeakMap<Geometry, Shapes>();

/** The geometry with its boxes, radii, angles and lengths, which are computed once. */
export function prepare(geometry: Geometry): Shapes {
  const known = PREPARED.get(geometry);
  if (known) return known;
  const shapes = empty(geometry);
  for (let chain = 0; chain < shapes.count; chain += 1) measureChain(shapes, chain);
  PREPARED.set(geometry, shapes);
  return shapes;
}

/** The same, little by little: 100,000 chains take a tenth of a second. */
export async function prepareSlowly(geometry: Geometry): Promise<void> {
  const shapes = empty(geometry);
  await inSlices(shapes.count, (chain) => measureChain(shapes, chain));
  PREPARED.set(geometry, shapes);
}

function empty({ segments, offsets }: Geometry): Shapes {
  const count = Math.max(0, offsets.length - 1);
  const elements = Math.floor(segments.length / STRIDE);
  return { segments, offsets, count, boxes: new Float64Array(count * 4), arcs: new Float64Array(elements * 2), lengths: new Float64Array(elements) };
}

function measureChain({ segments, offsets, boxes, arcs, lengths }: Shapes, chain: number): void {
  const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let e = offsets[chain]!; e < offsets[chain + 1]!; e += 1) measure(segments, e, arcs, lengths, box);
  boxes.set(box, chain * 4);
}

function measure(s: Float64Array, e: number, arcs: Float64Array, lengths: Float64Array, box: [number, number, number, number]): void {
  const i = e * STRIDE;
  const x0 = s[i]!, y0 = s[i + 1]!, x1 = s[i + 2]!, y1 = s[i + 3]!, sweep = s[i + 6]!;
  widen(box, x0, y0);
  widen(box, x1, y1);
  if (sweep === 0) {
    lengths[e] = Math.hypot(x1 - x0, y1 - y0);
    return;
  }
  const cx = s[i + 4]!, cy = s[i + 5]!;
  const radius = Math.hypot(x0 - cx, y0 - cy);
  const start = Math.atan2(y0 - cy, x0 - cx);
  arcs[e * 2] = radius;
  arcs[e * 2 + 1] = start;
  lengths[e] = radius * Math.abs(sweep);
  // The box of an arc may exceed its ends only at the quarter points that it passes.
  const low = Math.min(start, start + sweep), high = Math.max(start, start + sweep);
  for (let q = Math.ceil(low / (Math.PI / 2)); q * (Math.PI / 2) <= high; q += 1) {
    const a = q * (Math.PI / 2);
    widen(box, cx + radius * Math.cos(a), cy + radius * Math.sin(a));
  }
}

function widen(box: [number, number, number, number], x: number, y: number): void {
  if (x < box[0]) box[0] = x;
  if (y < box[1]) box[1] = y;
  if (x > box[2]) box[2] = x;
  if (y > box[3]) box[3] = y;
}

/** Length of a chain, mm. */
export function chainLength(shapes: Shapes, chain: number): number {
  let sum = 0;
  for (let e = shapes.offsets[chain]!; e < shapes.offsets[chain + 1]!; e += 1) sum += shapes.lengths[e]!;
  return sum;
}

const LEADS = new WeakMap<BestPath, Shapes | null>();

/** The leads of a path: the lead-in of stop k is chain 2k, its lead-out chain 2k + 1. `null` for a path without leads. */
export function leadShapes(path: BestPath): Shapes | null {
  const known = LEADS.get(path);
  if (known !== undefined) return known;
  const shapes = path.leads.length === 0 ? null : prepare({ segments: path.leads, offsets: path.leadOffsets });
  LEADS.set(path, shapes);
  return shapes;
}

const JOINTS = new WeakMap<BestPath, Shapes>();

/** The micro-joints of a path: each is a chain. */
export function jointShapes(path: BestPath): Shapes {
  const shapes = JOINTS.get(path) ?? prepare({ segments: path.joints, offsets: path.jointOffsets });
  JOINTS.set(path, shapes);
  return shapes;
}

const LOOPS = new WeakMap<BestPath, Shapes>();

/** The loops at corners of a path: each is a chain. */
export function loopShapes(path: BestPath): Shapes {
  const shapes = LOOPS.get(path) ?? prepare({ segments: path.loops, offsets: path.loopOffsets });
  LOOPS.set(path, shapes);
  return shapes;
}

/** Whether a stop cuts its whole contour at once. */
export function isWhole(path: BestPath, stop: number): boolean {
  return path.along[stop] === path.until[stop];
}

/** The length that a stop cuts, mm. `whole` is the length of its contour. A stretch may run against the stored direction of the contour. */
export function cutLength(path: BestPath, stop: number, whole: number): number {
  if (isWhole(path, stop)) return whole;
  const ahead = path.until[stop]! - path.along[stop]!;
  const length = path.reversed[stop] === 1 ? -ahead : ahead;
  return length > 0 ? length : length + whole;
}

/** The first stop of each contour, by contour; -1 for contours without a stop. A contour that is cut in several stretches has several stops. */
export function firstStops(path: BestPath, contours: number): Int32Array {
  const first = new Int32Array(contours).fill(-1);
  for (let k = path.contours.length - 1; k >= 0; k -= 1) first[path.contours[k]!] = k;
  return first;
}

/** The point of element `e` at `part` (0 to 1) of its length, with its stored direction of travel. */
export function onElement(shapes: Shapes, e: number, part: number, out: Place): Place {
  const s = shapes.segments;
  const i = e * STRIDE;
  const sweep = s[i + 6]!;
  if (sweep === 0) {
    const dx = s[i + 2]! - s[i]!, dy = s[i + 3]! - s[i + 1]!;
    const length = shapes.lengths[e]! || 1;
    out.x = s[i]! + dx * part;
    out.y = s[i + 1]! + dy * part;
    out.dx = dx / length;
    out.dy = dy / length;
    return out;
  }
  const radius = shapes.arcs[e * 2]!;
  const angle = shapes.arcs[e * 2 + 1]! + sweep * part;
  const turn = Math.sign(sweep);
  out.x = s[i + 4]! + radius * Math.cos(angle);
  out.y = s[i + 5]! + radius * Math.sin(angle);
  out.dx = -Math.sin(angle) * turn;
  out.dy = Math.cos(angle) * turn;
  return out;
}

/**
 * Follows a chain from `along` (mm from its stored start) for `distance` mm, forwards or backwards, and past the start of a closed chain. Calls
 * `visit` with each element on the way, and the share of its length (0 to 1) where the stretch begins and ends, in the order of travel.
 */
export function walk(
  shapes: Shapes, chain: number, along: number, reversed: boolean, distance: number,
  visit: (element: number, from: number, to: number) => void,
): void {
  const first = shapes.offsets[chain]!, last = shapes.offsets[chain + 1]! - 1;
  if (last < first) return;
  let e = first;
  let rest = Math.max(0, along);
  while (e < last && rest > shapes.lengths[e]!) {
    rest -= shapes.lengths[e]!;
    e += 1;
  }
  let part = shapes.lengths[e]! > 0 ? Math.min(1, rest / shapes.lengths[e]!) : 0;
  let left = distance;
  // Once around, and the rest of the first element; the bound also holds for chains of zero length.
  for (let steps = last - first + 2; steps > 0 && left > 1e-9; steps -= 1) {
    const length = shapes.lengths[e]!;
    const room = reversed ? part * length : (1 - part) * length;
    const run = Math.min(room, left);
    if (run > 0) visit(e, part, part + ((reversed ? -1 : 1) * run) / length);
    left -= run;
    if (reversed) {
      e = e === first ? last : e - 1;
      part = 1;
    } else {
      e = e === last ? first : e + 1;
      part = 0;
    }
  }
}

/** The point `distance` mm after the entry at `along`, with the direction of travel. */
export function placeAfter(shapes: Shapes, chain: number, along: number, reversed: boolean, distance: number, out: Place): Place {
  let element = -1, part = 0;
  walk(shapes, chain, along, reversed, Math.max(distance, 1e-6), (e, _from, to) => {
    element = e;
    part = to;
  });
  if (element < 0) {
    out.dx = out.dy = 0;
    return out;
  }
  onElement(shapes, element, part, out);
  if (reversed) {
    out.dx = -out.dx;
    out.dy = -out.dy;
  }
  return out;
}

/** The part of an element, 0 to 1, that is nearest to a point. */
export function partAt(shapes: Shapes, e: number, x: number, y: number): number {
  const s = shapes.segments;
  const i = e * STRIDE;
  const sweep = s[i + 6]!;
  if (sweep === 0) {
    const dx = s[i + 2]! - s[i]!, dy = s[i + 3]! - s[i + 1]!;
    const square = dx * dx + dy * dy;
    return square > 0 ? Math.min(1, Math.max(0, ((x - s[i]!) * dx + (y - s[i + 1]!) * dy) / square)) : 0;
  }
  const round = 2 * Math.PI;
  const turn = (Math.atan2(y - s[i + 5]!, x - s[i + 4]!) - shapes.arcs[e * 2 + 1]!) * Math.sign(sweep);
  const ahead = ((turn % round) + round) % round;
  // Beyond its ends, an arc is nearest at one of them.
  if (ahead > Math.abs(sweep)) return ahead - Math.abs(sweep) < round - ahead ? 1 : 0;
  return ahead / Math.abs(sweep);
}

/** Squared distance from a point to element `e`, mm2. */
export function distance2(shapes: Shapes, e: number, x: number, y: number): number {
  const s = shapes.segments;
  const i = e * STRIDE;
  const x0 = s[i]!, y0 = s[i + 1]!, x1 = s[i + 2]!, y1 = s[i + 3]!, sweep = s[i + 6]!;
  const t = partAt(shapes, e, x, y);
  if (sweep === 0) return (x0 + t * (x1 - x0) - x) ** 2 + (y0 + t * (y1 - y0) - y) ** 2;
  if (t > 0 && t < 1) return (Math.hypot(x - s[i + 4]!, y - s[i + 5]!) - shapes.arcs[e * 2]!) ** 2;
  return Math.min((x - x0) ** 2 + (y - y0) ** 2, (x - x1) ** 2 + (y - y1) ** 2);
}
