/** What another reading of a drawing would change: where ends would join or come apart, and what would disappear. */

import type { Loaded } from 'kerfway';
import { STRIDE } from '../stage/shapes.js';
import { worked } from './worked.js';

/** A place on the sheet, mm, and what would happen there. */
export interface Mark {
  kind: 'joins' | 'opens' | 'goes';
  x: number;
  y: number;
}

export interface Outlook {
  marks: Mark[];
  /** Gaps that would be closed. */
  joins: number;
  /** Joints that would come apart. */
  opens: number;
  /** Pieces that would disappear: copies, overlaps, what has no length. */
  goes: number;
  /** Contours now and then. */
  contours: [now: number, then: number];
  /** Open ones among them. */
  open: [now: number, then: number];
  /** Lines and arcs that all is made of. */
  elements: [now: number, then: number];
}

/** Findings of what is not cut because of something else. */
const GONE = new Set(['duplicate-removed', 'overlap-removed', 'zero-length']);
/** Marks kept at most: more are a smear on any screen. */
const MOST = 4000;

/** Compares two readings; `join`: how far apart ends may be in the second one, mm. */
export function outlook(now: Loaded, then: Loaded, join: number): Outlook {
  const [ends, endsThen] = [freeEnds(now, join), freeEnds(then, 0)];
  const joined = missing(ends, endsThen), opened = missing(endsThen, freeEnds(now, 0));
  const [gone, goneThen] = [goneIn(now), goneIn(then)];
  const sum = (of: typeof gone) => of.reduce((n, f) => n + f.count, 0);
  const places = new Set(gone.map(({ at }) => String(at)));
  const marks: Mark[] = [
    ...joined.map(([x, y]): Mark => ({ kind: 'joins', x, y })), ...opened.map(([x, y]): Mark => ({ kind: 'opens', x, y })),
    ...goneThen.flatMap(({ at }): Mark[] => (at && !places.has(String(at)) ? [{ kind: 'goes', x: at[0], y: at[1] }] : [])),
  ];
  const open = (loaded: Loaded) => worked(loaded).filter((c) => !c.closed).length;
  return {
    marks: marks.slice(0, MOST), goes: Math.max(0, sum(goneThen) - sum(gone)),
    // Two ends a gap.
    joins: Math.ceil(joined.length / 2), opens: Math.ceil(opened.length / 2),
    contours: [worked(now).length, worked(then).length], open: [open(now), open(then)],
    elements: [elements(now), elements(then)],
  };
}

type Place = readonly [x: number, y: number];

/** Ends of open contours, by where they are; of contours no longer than `scrap` none, as they may be left out altogether. */
function freeEnds({ contours, geometry: { segments, offsets } }: Loaded, scrap: number): Map<string, Place> {
  const ends = new Map<string, Place>();
  for (const { id, closed, length } of contours) {
    const [first, end] = [offsets[id], offsets[id + 1]];
    if (closed || length <= scrap || first === undefined || end === undefined || end <= first) continue;
    const last = (end - 1) * STRIDE;
    for (const [x, y] of [[segments[first * STRIDE]!, segments[first * STRIDE + 1]!], [segments[last + 2]!, segments[last + 3]!]] as const) ends.set(`${x.toFixed(4)} ${y.toFixed(4)}`, [x, y]);
  }
  return ends;
}

function missing(from: Map<string, Place>, than: Map<string, Place>): Place[] {
  return [...from].filter(([key]) => !than.has(key)).map(([, place]) => place);
}

const goneIn = ({ findings }: Loaded) => findings.filter((f) => GONE.has(f.code));

const elements = ({ geometry, ignored }: Loaded) => (geometry.offsets.at(-1) ?? 0) + (ignored.geometry.offsets.at(-1) ?? 0);
