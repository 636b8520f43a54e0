/** Registers the custom elements once. Their planners are opened by `createPlanner`. */

import type { Planner } from '../planner.js';
import { DrawingElement } from './drawing.js';
import { KerfwayPlanner } from './planner.js';
import { KerfwayQuote } from './quote.js';

export function defineElements(createPlanner: () => Promise<Planner>): void {
  DrawingElement.createPlanner ??= createPlanner;
  const registry = globalThis.customElements as CustomElementRegistry | undefined;
  for (const [name, element] of [['kerfway-planner', KerfwayPlanner], ['kerfway-quote', KerfwayQuote]] as const) {
    if (registry?.get(name) === undefined) registry?.define(name, element);
  }
}
