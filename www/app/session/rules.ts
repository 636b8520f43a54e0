/** Rules for single contours: cut before all others, cut after all others, or skip. */

import type { ContourInfo, Loaded, LoadOptions } from 'kerfway';
import type { State } from './state.js';

/** The rules, by their names in `LoadOptions`. A contour has one rule at most. */
export const RULES = ['first', 'last', 'exclude'] as const;
export type Rule = (typeof RULES)[number];

/** The rule of a contour, or null. */
export function ruleOf(load: LoadOptions, contour: number): Rule | null {
  return RULES.find((rule) => load[rule]?.includes(contour)) ?? null;
}

/** The options with another rule for one contour; `null` removes its rule. */
export function withRule({ first = [], last = [], exclude = [], ...others }: LoadOptions, contour: number, rule: Rule | null): LoadOptions {
  const without = (list: number[]) => list.filter((c) => c !== contour);
  const lists = { first: without(first), last: without(last), exclude: without(exclude) };
  if (rule !== null) lists[rule].push(contour);
  return { ...others, ...lists };
}

/** The options without any rule. */
export function withoutRules({ first: _first, last: _last, exclude: _exclude, ...others }: LoadOptions): LoadOptions {
  return others;
}

/** Whether two readings of a drawing find the same contours, so that the numbers of contours keep their meaning. */
export function sameContours(a: LoadOptions, b: LoadOptions): boolean {
  // The border and groups keep their contours whatever is done with them.
  const key = ({ units, dpi, tolerance, keepDamaged, joinTolerance, layers }: LoadOptions) =>
    JSON.stringify([units, dpi, tolerance, keepDamaged, joinTolerance, layers?.map(({ name, operation }) => [name, operation])]);
  return key(a) === key(b);
}

/** The contours whose numbers the path refers to: those of the beam where it does not follow the drawn lines, otherwise those of the drawing. */
export function pathContours({ loaded, beam }: Pick<State, 'loaded' | 'beam'>): readonly ContourInfo[] {
  return beam?.contours ?? (loaded as Loaded | null)?.contours ?? [];
}
