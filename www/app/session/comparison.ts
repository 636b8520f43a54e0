/** Compares two readings of a drawing: where ends would join or come apart, and what would disappear. */

import { activeContours, type Loaded } from 'kerfway';
import { STRIDE } from '../stage/shapes.js';

/** A place on the sheet, mm, and what would happen there. */
export interface ChangeMark {
  kind: 'joins' | 'opens' | 'removal';
  x: number;
  y: number;
}

export interface Comparison {
  marks: ChangeMark[];
  /** Gaps that would be closed. */
  joins: number;
  /** Joints that would come apart. */
  opens: number;
  /** Pieces that would disappear: duplicates, overlaps, elements of zero length. */
  removals: number;
  contours: [now: number, then: number];
  openContours: [now: number, then: number];
  /** Lines and arcs. */
  elements: [now: number, then: number];
}

/** Findings about geometry that was removed. */
const REMOVED = new Set(['duplicate-removed', 'overlap-removed', 'zero-length']);
/** How many marks are kept: more are a smear on any screen. */
const MOST = 4000;

/** Compares two readings. `join`: how far apart two ends may be in the second one and still belong to one contour, mm. */
export function compareReadings(now: Loaded, then: Loaded, join: number): Comparison {
  const joined = difference(freeEnds(now, join), freeEnds(then, 0));
  const opened = difference(freeEnds(then, 0), freeEnds(now, 0));
  const [removedNow, removedThen] = [removedIn(now), removedIn(then)];
  const sum = (findings: typeof removedNow) => findings.reduce((n, f) => n + f.count, 0);
  const known = new Set(removedNow.map(({ at }) => String(at)));
  const marks: ChangeMark[] = [
    ...joined.map(([x, y]): ChangeMark => ({ kind: 'joins', x, y })), ...opened.map(([x, y]): ChangeMark => ({ kind: 'opens', x, y })),
    ...removedThen.flatMap(({ at }): ChangeMark[] => (at && !known.has(String(at)) ? [{ kind: 'removal', x: at[0], y: at[1] }] : [])),
  ];
  const open = (loaded: Loaded) => activeContours(loaded).filter((c) => !c.closed).length;
  return {
    marks: marks.slice(0, MOST), removals: Math.max(0, sum(removedThen) - sum(removedNow)),
    // Every gap has two ends.
    joins: Math.ceil(joined.length / 2), opens: Math.ceil(opened.length / 2),
    contours: [activeContours(now).length, activeContours(then).length], openContours: [open(now), open(then)],
    elements: [elements(now), elements(then)],
  };
}

type Place = readonly [x: number, y: number];

/** The ends of open contours, by their place. Contours no longer than `shortest` are skipped, because the other reading may remove them. */
function freeEnds({ contours, geometry: { segments, offsets } }: Loaded, shortest: number): Map<string, Place> {
  const ends = new Map<string, Place>();
  for (const { id, closed, length } of contours) {
    const [first, end] = [offsets[id], offsets[id + 1]];
    if (closed || length <= shortest || first === undefined || end === undefined || end <= first) continue;
    const last = (end - 1) * STRIDE;
    for (const [x, y] of [[segments[first * STRIDE]!, segments[first * STRIDE + 1]!], [segments[last + 2]!, segments[last + 3]!]] as const) ends.set(`${x.toFixed(4)} ${y.toFixed(4)}`, [x, y]);
  }
  return ends;
}

/** The places in `from` that are not in `other`. */
function difference(from: Map<string, Place>, other: Map<string, Place>): Place[] {
  return [...from].filter(([key]) => !other.has(key)).map(([, place]) => place);
}

const removedIn = ({ findings }: Loaded) => findings.filter((f) => REMOVED.has(f.code));

const elements = ({ geometry, ignored }: Loaded) => (geometry.offsets.at(-1) ?? 0) + (ignored.geometry.offsets.at(-1) ?? 0);
