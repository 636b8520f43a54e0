/** Why a contour is cut where it is in the order, in one line. */

import type { BestPath } from 'kerfway';
import { count, millimetres } from '../core/format.js';
import { around } from '../core/nesting.js';
import { words } from '../core/words/index.js';
import { isOrdered, pathContours } from './rules.js';
import type { State } from './state.js';

/** `stop`: where it is in the order; `stopOf` gives that of other contours. */
export function whyHere(state: State, path: BestPath, contour: number, stop: number, stopOf: (contour: number) => number | null): string {
  return [reason(state, contour, stopOf), wayThere(path, stop)].filter(Boolean).join(' ');
}

function reason(state: State, contour: number, stopOf: (contour: number) => number | null): string {
  const { load, loaded } = state;
  const contours = pathContours(state);
  const info = contours[contour];
  if (!info || !loaded) return '';
  const w = words.contour.why;
  if (info.skeleton === true) return w.skeleton;
  // What holds for the contours around it holds for it.
  const line = [contour, ...around(contours, contour)];
  for (const c of line) {
    const sequence = load.sequences?.find((s) => s.includes(c));
    const before = sequence?.[sequence.indexOf(c) - 1];
    const at = before === undefined ? null : stopOf(before);
    if (at !== null) return w.arranged(count(at + 1));
  }
  if (line.some((c) => load.together?.some((group) => group.includes(c)))) return w.together;
  if (line.some((c) => load.first?.includes(c))) return isOrdered(load, 'first') ? w.firstInOrder : w.first;
  if (load.last?.includes(contour)) return isOrdered(load, 'last') ? w.lastInOrder : w.last;
  if (info.operation === 'mark') return w.mark;
  const inner = contours.filter((c) => c.inside === contour && c.operation !== 'ignore').length;
  if (inner > 0) return w.outer(inner, count(inner));
  if (info.inside !== null && info.inside !== loaded.outline) return w.inner;
  if (load.orderByLayer) return w.layer(info.layer);
  return load.partByPart ? w.byPart : '';
}

function wayThere({ points, contours }: BestPath, stop: number): string {
  const w = words.contour.why;
  if (stop === 0) return w.begin;
  const way = Math.hypot(points[stop * 4]! - points[stop * 4 - 2]!, points[stop * 4 + 1]! - points[stop * 4 - 1]!);
  const nearest = nearestLater(points, contours.length, stop);
  return w.way(count(stop), millimetres(way), way <= nearest + 1e-6);
}

/** The distance from where the head comes from to the nearest entry of any later stop, mm. */
function nearestLater(points: Float64Array, stops: number, stop: number): number {
  let least = Infinity;
  for (let k = stop; k < stops; k += 1) least = Math.min(least, Math.hypot(points[k * 4]! - points[stop * 4 - 2]!, points[k * 4 + 1]! - points[stop * 4 - 1]!));
  return least;
}
