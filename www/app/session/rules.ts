/** Rules for contours: cut before all others, cut after all others, mark, or skip; and sequences that are cut in their order. */

import type { ContourInfo, Loaded, LoadOptions } from 'kerfway';
import { around } from '../core/nesting.js';
import type { State } from './state.js';

/** The rules, by their names in `LoadOptions`. A contour has one rule at most. */
export const RULES = ['first', 'last', 'mark', 'exclude'] as const;
export type Rule = (typeof RULES)[number];

/** The lists whose order may be fixed. */
export type Pin = 'first' | 'last';

/** The rule of a contour, or null. */
export function ruleOf(load: LoadOptions, contour: number): Rule | null {
  return RULES.find((rule) => load[rule]?.includes(contour)) ?? null;
}

/** The options with another rule for contours; `null` removes their rules. A list with a fixed order keeps it, with what is new at its end. */
export function withRule(load: LoadOptions, contours: readonly number[], rule: Rule | null): LoadOptions {
  const changed = new Set(contours);
  const lists = Object.fromEntries(RULES.map((name) => [name, (load[name] ?? []).filter((c) => !changed.has(c))])) as Record<Rule, number[]>;
  if (rule !== null) lists[rule].push(...contours);
  let next: LoadOptions = { ...load, ...lists };
  for (const pin of ['first', 'last'] as const) if (isOrdered(load, pin)) next = withSequence(next, load[pin] ?? [], lists[pin]);
  if (rule === 'exclude') next = withoutTurns(next, changed);
  return next;
}

/** The options without any rule for single contours. */
export function withoutRules({ first: _first, last: _last, mark: _mark, exclude: _exclude, sequences: _sequences, together: _together, joints: _joints, contours: _contours, ...others }: LoadOptions): LoadOptions {
  return others;
}

/** Whether there is a rule for a single contour. */
export function namesContours({ sequences, together, joints, contours, ...others }: LoadOptions): boolean {
  return [sequences, together, joints, contours, ...RULES.map((rule) => others[rule])].some((list) => list !== undefined && list.length > 0);
}

/** Whether a list of pinned contours is cut in its order. */
export function isOrdered({ sequences = [], ...load }: LoadOptions, pin: Pin): boolean {
  const list = load[pin] ?? [];
  return list.length > 1 && sequences.some((s) => sameList(s, list));
}

/** The options with the pinned contours in this order. */
export function withPinOrder(load: LoadOptions, pin: Pin, order: readonly number[]): LoadOptions {
  return withSequence({ ...load, [pin]: [...order] }, load[pin] ?? [], order);
}

/** The options with the order of a pinned list left to the search again. */
export function withoutPinOrder(load: LoadOptions, pin: Pin): LoadOptions {
  return withSequence(load, load[pin] ?? [], []);
}

/** The sequences that are not the order of a pinned list. */
export function freeSequences(load: LoadOptions): number[][] {
  const pinned = [load.first ?? [], load.last ?? []];
  return (load.sequences ?? []).filter((s) => !pinned.some((list) => sameList(s, list)));
}

/** The options with a sequence in place of another one; a sequence of less than two contours says nothing and is removed. */
export function withSequence(load: LoadOptions, before: readonly number[], after: readonly number[]): LoadOptions {
  const others = withoutTurns({ ...load, sequences: (load.sequences ?? []).filter((s) => !sameList(s, before)) }, new Set(after));
  const { sequences = [] } = others;
  return { ...others, sequences: after.length > 1 ? [...sequences, [...after]] : sequences };
}

function withoutTurns(load: LoadOptions, contours: ReadonlySet<number>): LoadOptions {
  const sequences = (load.sequences ?? []).map((s) => s.filter((c) => !contours.has(c))).filter((s) => s.length > 1);
  return { ...load, sequences };
}

const sameList = (a: readonly number[], b: readonly number[]) => a.length === b.length && a.every((c, i) => c === b[i]);

/** A move in the cutting order. `order`: the contours as they are cut now, each once. */
export interface Shift {
  order: readonly number[];
  contour: number;
  /** The place in the order before which it comes; the length of the order for the end. */
  to: number;
}

/**
 * The options with a contour cut between its new neighbours: they and it become a sequence, together with the sequences that they are in already.
 * Null where that is not possible, because what lies inside a contour is cut before it.
 */
export function shifted(load: LoadOptions, loaded: Loaded, { order, contour, to }: Shift): LoadOptions | null {
  const isInside = (c: number, outer: number) => {
    if (c === outer) return true;
    for (const o of around(loaded.contours, c)) if (o === outer) return true;
    return false;
  };
  const rest = order.filter((c) => c !== contour);
  const at = to - (order.indexOf(contour) < to ? 1 : 0);
  const earlier = rest.slice(0, at), later = rest.slice(at);
  // A hole cannot come after the contour around it. What lies inside the contour comes before it wherever it is.
  if (earlier.some((c) => isInside(contour, c))) return null;
  const before = earlier.findLast((c) => !isInside(c, contour));
  const after = later.find((c) => !isInside(c, contour) && !isInside(contour, c));
  const sequences = load.sequences ?? [];
  const neighbours = [before, contour, after].filter((c): c is number => c !== undefined);
  const joined = new Set([...neighbours, ...sequences.filter((s) => s.some((c) => c !== contour && neighbours.includes(c))).flat()]);
  const place = new Map([...earlier, contour, ...later].map((c, i) => [c, i]));
  const merged = [...joined].filter((c) => place.has(c)).sort((a, b) => place.get(a)! - place.get(b)!);
  // What lies inside a neighbour and is cut earlier keeps its place: it would have to wait for the contour otherwise.
  const inner = [...earlier, ...later].filter((c) => !joined.has(c) && !isInside(c, contour) && merged.some((outer, i) => outer !== contour && i > 0 && isInside(c, outer) && place.get(c)! < place.get(merged[i - 1]!)!));
  merged.push(...inner);
  merged.sort((a, b) => place.get(a)! - place.get(b)!);
  const pins = (['first', 'last'] as const).filter((pin) => load[pin]?.includes(contour));
  // A contour that is moved away from a pinned list leaves it, unless its new neighbours are in it.
  const kept = pins.every((pin) => [before, after].some((c) => c !== undefined && load[pin]?.includes(c)));
  const freed = kept ? load : withRule(load, [contour], null);
  return withSequence(freed, [], merged);
}

/** The contours that a rule has to name so that it holds for all of a selection: pins carry what lies inside the outermost. */
export function namedBy(loaded: Loaded, contours: readonly number[], rule: Rule): number[] {
  if (rule === 'exclude' || rule === 'mark') return [...contours];
  const chosen = new Set(contours);
  const isWithin = (c: number) => {
    for (const o of around(loaded.contours, c)) if (chosen.has(o)) return true;
    return false;
  };
  return contours.filter((c) => !isWithin(c));
}

/** Whether a rule holds for all of a selection. */
export function holds(load: LoadOptions, loaded: Loaded, contours: readonly number[], rule: Rule): boolean {
  return namedBy(loaded, contours, rule).every((c) => ruleOf(load, c) === rule);
}

/** Whether two readings of a drawing find the same contours, so that the numbers of contours keep their meaning. */
export function sameContours(a: LoadOptions, b: LoadOptions): boolean {
  // The border and groups keep their contours whatever is done with them.
  const key = ({ units, dpi, tolerance, keepDamaged, joinTolerance, copyTolerance, layers }: LoadOptions) =>
    JSON.stringify([units, dpi, tolerance, keepDamaged, joinTolerance, copyTolerance, layers?.map(({ name, operation }) => [name, operation])]);
  return key(a) === key(b);
}

/** Whether a contour of the path was drawn, so that a person can decide about it: skeleton cuts were not. */
export const isDrawn = (loaded: Loaded, contour: number) => contour < loaded.contours.length;

/** The contours whose numbers the path refers to: those of the beam where it does not follow the drawn lines, otherwise those of the drawing. */
export function pathContours({ loaded, beam }: Pick<State, 'loaded' | 'beam'>): readonly ContourInfo[] {
  return beam?.contours ?? (loaded as Loaded | null)?.contours ?? [];
}
