/** What is decided for a selection besides its rule: parts that are kept together, the number of micro-joints, the lead, the corners. */

import type { ContourChoice, Loaded, LoadOptions } from 'kerfway';
import { around } from '../core/nesting.js';
import { namedBy } from './rules.js';

/** Those of some contours that lie in no other of them. */
const outermost = (loaded: Loaded, contours: readonly number[]) => namedBy(loaded, contours, 'first');

/** The group that consists of exactly these contours and what lies inside them; undefined if there is none. */
export function groupOf(load: LoadOptions, loaded: Loaded, contours: readonly number[]): readonly number[] | undefined {
  const named = outermost(loaded, contours);
  return load.together?.find((group) => group.length === named.length && named.every((c) => group.includes(c)));
}

/** The options with contours kept together as one group. They leave the groups they are in, as do contours inside them or around them. */
export function withGroup(load: LoadOptions, loaded: Loaded, contours: readonly number[]): LoadOptions {
  const named = new Set(outermost(loaded, contours));
  const outside = new Set([...named].flatMap((c) => [...around(loaded.contours, c)]));
  const stays = (c: number) => {
    if (named.has(c) || outside.has(c)) return false;
    for (const o of around(loaded.contours, c)) if (named.has(o)) return false;
    return true;
  };
  const others = (load.together ?? []).map((group) => group.filter(stays)).filter((group) => group.length > 0);
  return { ...load, together: [...others, [...named]] };
}

/** The options without a group. */
export function withoutGroup(load: LoadOptions, group: readonly number[]): LoadOptions {
  return { ...load, together: (load.together ?? []).filter((g) => g !== group) };
}

/** The cuts among contours that can have joints and leads: closed ones. */
export function closedCuts({ contours }: Loaded, chosen: readonly number[]): number[] {
  return chosen.filter((c) => contours[c]?.closed === true && contours[c].operation === 'cut');
}

/** What a choice names: the pieces that would fall, so the outermost of the selection, for joints; every contour for leads and corners. */
export function choosing(loaded: Loaded, contours: readonly number[], what: 'joints' | 'lead' | 'corners'): number[] {
  return closedCuts(loaded, what === 'joints' ? outermost(loaded, contours) : contours);
}

/** The choice that contours have in common; null: by the rules of the machine; undefined: they differ. */
export function commonChoice<K extends 'joints' | 'lead' | 'corners'>(load: LoadOptions, contours: readonly number[], what: K): ContourChoice[K] | null {
  const own = new Map(load.contours?.map((c) => [c.contour, c]) ?? []);
  const values = new Set(contours.map((c) => own.get(c)?.[what] ?? null));
  return values.size === 1 ? [...values][0] : undefined;
}

/** The options with a choice for contours; null: by the rules of the machine again. A number of joints takes the place of joints by hand. */
export function withChoice<K extends 'joints' | 'lead' | 'corners'>(load: LoadOptions, contours: readonly number[], what: K, value: NonNullable<ContourChoice[K]> | null): LoadOptions {
  const own = new Map(load.contours?.map((c) => [c.contour, c]) ?? []);
  for (const contour of contours) {
    const { [what]: _before, ...rest } = own.get(contour) ?? { contour };
    own.set(contour, { ...rest, contour, ...(value === null ? {} : { [what]: value }) });
  }
  const chosen = new Set(contours);
  const joints = what === 'joints' ? load.joints?.filter((j) => !chosen.has(j.contour)) : load.joints;
  const all = [...own.values()].filter((c) => c.joints !== undefined || c.lead !== undefined || c.corners !== undefined);
  return { ...load, ...(joints === undefined ? {} : { joints }), contours: all.sort((a, b) => a.contour - b.contour) };
}
