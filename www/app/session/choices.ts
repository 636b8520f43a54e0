/**
 * What a person has chosen, and the way back: undo and redo over the reading, the machine and the search. A drawing
 * opened anew begins a new history, as choices about its contours mean nothing to another one.
 */

import type { LoadOptions, MachineProfile } from 'kerfway';
import type { Search } from './state.js';

/** What may be decided of single contours. Of each, one at most. */
export const FATES = ['first', 'last', 'exclude'] as const;
export type Fate = (typeof FATES)[number];

/** What is decided of a contour. */
export function fateOf(load: LoadOptions, contour: number): Fate | null {
  return FATES.find((fate) => load[fate]?.includes(contour)) ?? null;
}

/** Options with another fate of a contour. */
export function decided({ first = [], last = [], exclude = [], ...others }: LoadOptions, contour: number, fate: Fate | null): LoadOptions {
  const without = (list: number[]) => list.filter((c) => c !== contour);
  const lists = { first: without(first), last: without(last), exclude: without(exclude) };
  if (fate !== null) lists[fate].push(contour);
  return { ...others, ...lists };
}

/** Options in which nothing is decided of any contour. */
export function undecided({ first: _first, last: _last, exclude: _exclude, ...others }: LoadOptions): LoadOptions {
  return others;
}

export interface Choices {
  load: LoadOptions;
  machine: MachineProfile | null;
  search: Search;
}

/** Milliseconds in which what is typed counts as one choice. */
const TYPING = 1000;
/** Choices kept at most: more than anybody goes back, and some kB each. */
const MOST = 200;

export class History {
  private past: Choices[] = [];
  private future: Choices[] = [];
  private typedAt = -Infinity;

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }

  /** `now` is about to change; what is typed in one go changes it once. */
  keep(now: Choices, typed = false): void {
    const at = performance.now();
    const going = typed && at - this.typedAt < TYPING;
    this.typedAt = typed ? at : -Infinity;
    if (going) return;
    this.past = [...this.past, now].slice(-MOST);
    this.future = [];
  }

  /** What `now` goes back to. */
  undo(now: Choices): Choices | null {
    return this.step(this.past, this.future, now);
  }

  /** What `now` goes on to again. */
  redo(now: Choices): Choices | null {
    return this.step(this.future, this.past, now);
  }

  clear(): void {
    [this.past, this.future] = [[], []];
  }

  private step(from: Choices[], to: Choices[], now: Choices): Choices | null {
    const there = from.pop() ?? null;
    if (there !== null) to.push(now);
    this.typedAt = -Infinity;
    return there;
  }
}

/** Whether two readings find the same contours, so that the numbers of contours mean the same. */
export function sameContours(a: LoadOptions, b: LoadOptions): boolean {
  const key = ({ units, tolerance, keepDamaged, joinTolerance, layers }: LoadOptions) =>
    JSON.stringify([units, tolerance, keepDamaged, joinTolerance, layers]);
  return key(a) === key(b);
}
