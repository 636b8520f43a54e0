/** The attributes of the elements as options of a plan. */

import type { PlanningOptions } from '../options.js';
import type { Unit } from '../protocol.js';

/** Options that are numbers in attributes. */
const NUMBERS = ['seconds', 'moves', 'seed', 'workers'] as const;

/** The number that an attribute says. Text that is none becomes NaN, which the planner refuses by its name. */
export function numberIn(text: string): number {
  return text.trim() === '' ? NaN : Number(text);
}

/** What the element's attributes say. */
export function attributed(element: Element): PlanningOptions {
  const options: PlanningOptions = {};
  const [machine, method, units] = ['machine', 'method', 'units'].map((name) => element.getAttribute(name));
  if (machine) options.machine = machine;
  if (method) options.method = method;
  if (units) options.units = units as Unit;
  for (const name of NUMBERS) {
    const text = element.getAttribute(name);
    if (text !== null) options[name] = numberIn(text);
  }
  return options;
}
