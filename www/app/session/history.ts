/**
 * Undo and redo of a person's choices: how the drawing is read, the machine, the search. The plan that was found for them comes back with them.
 * Opening another drawing starts a new history, because choices about contours mean nothing in another drawing.
 */

import type { LoadOptions, MachineProfile } from 'kerfway';
import type { KeptPlan } from './kept-plan.js';
import type { Placing } from './placing.js';
import type { Search } from './state.js';

export interface Choices {
  /** The plan that was found for them; null if there is none, or if it is too long ago. */
  plan: KeptPlan | null;
  load: LoadOptions;
  machine: MachineProfile | null;
  search: Search;
  placing: Placing;
  material: string | null;
}

/** Milliseconds within which successive keystrokes count as one choice. */
const TYPING = 1000;
/** How many choices are kept: more than anybody goes back, at a few kB each. */
const MOST = 200;
/** How many of them keep their plan: on a sheet of 10,000 contours a plan takes half a megabyte. */
const PLANS = 20;

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

  /** Records the choices before a change. With `typed`, keystrokes in quick succession are recorded once. */
  record(before: Choices, typed = false): void {
    const at = performance.now();
    const continues = typed && at - this.typedAt < TYPING;
    this.typedAt = typed ? at : -Infinity;
    if (continues) return;
    this.past = withPlans([...this.past, before].slice(-MOST));
    this.future = [];
  }

  /** The choices before the last change, or null; `now` can be redone. */
  undo(now: Choices): Choices | null {
    return this.step(this.past, this.future, now);
  }

  /** The choices that were undone last, or null. */
  redo(now: Choices): Choices | null {
    return this.step(this.future, this.past, now);
  }

  clear(): void {
    [this.past, this.future] = [[], []];
  }

  private step(from: Choices[], to: Choices[], now: Choices): Choices | null {
    const found = from.pop() ?? null;
    if (found !== null) to.push(now);
    this.typedAt = -Infinity;
    return found;
  }
}

/** Keeps the plans of the last choices only. */
function withPlans(past: Choices[]): Choices[] {
  const recent = past.length - PLANS;
  return past.map((choices, k) => (k < recent && choices.plan !== null ? { ...choices, plan: null } : choices));
}
