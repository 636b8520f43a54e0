/** Air moves: straight from stop to stop, or by way points around pieces that may have tipped. */

import type { BestPath } from 'kerfway';
import type { Frame, Pen } from './trace.js';
import { traceAir } from './trace.js';
import type { Travel } from './raster-messages.js';

export type Point = readonly [number, number];

/** What an air move does about pieces that may have tipped, or that it is or ends with a cut through waste: `BestPath.ways`. */
export const AROUND = 1, LIFTED = 2, CROSSES = 3, CHAIN = 4, EDGE = 5;

/** What the air move to a stop does; the stop after the last is home. */
export const wayTo = (path: BestPath, stop: number): number => path.ways?.[stop] ?? 0;

/** Whether the head moves to a stop with the beam off. */
export const isAir = (path: BestPath, stop: number): boolean => wayTo(path, stop) !== CHAIN;

/** The places of the air move to a stop: where it begins, way points, where it ends. The stop after the last is home. */
export function legTo(path: BestPath, travel: Travel, stop: number): Point[] {
  const p = path.points;
  const stops = path.contours.length;
  const from: Point = stop === 0 ? travel.home : [p[stop * 4 - 2]!, p[stop * 4 - 1]!];
  const to: Point = stop === stops ? travel.home : [p[stop * 4]!, p[stop * 4 + 1]!];
  return wayTo(path, stop) === AROUND || wayTo(path, stop) === EDGE ? [from, ...viaOf(path, stop), to] : [from, to];
}

/** Adds an air move to a canvas path. */
export function traceLeg(pen: Pen, frame: Frame, travel: Travel, leg: readonly Point[]): void {
  for (let k = 1; k < leg.length; k += 1) traceAir(pen, frame, travel, ...leg[k - 1]!, ...leg[k]!);
}

/** The place after a share of the length of an air move, and the part of it before that. */
export function partOf(leg: readonly Point[], share: number): Point[] {
  const lengths = leg.slice(1).map(([x, y], k) => Math.hypot(x - leg[k]![0], y - leg[k]![1]));
  let left = share * lengths.reduce((a, b) => a + b, 0);
  const part: Point[] = [leg[0]!];
  for (const [k, length] of lengths.entries()) {
    const [a, b] = [leg[k]!, leg[k + 1]!];
    const f = length > 0 ? Math.min(1, left / length) : 1;
    part.push([a[0] + (b[0] - a[0]) * f, a[1] + (b[1] - a[1]) * f]);
    left -= length;
    if (left <= 0) break;
  }
  return part;
}

/** The way points to a stop. They are in the order of the stops. */
function viaOf({ via, viaOf: of }: BestPath, stop: number): Point[] {
  let low = 0, high = of.length;
  while (low < high) {
    const mid = (low + high) >> 1;
    if (of[mid]! < stop) low = mid + 1;
    else high = mid;
  }
  const found: Point[] = [];
  for (let k = low; k < of.length && of[k] === stop; k += 1) found.push([via[2 * k]!, via[2 * k + 1]!]);
  return found;
}
