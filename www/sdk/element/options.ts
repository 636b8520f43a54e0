/** Reads the options of a plan from the attributes of an element. */

import type { PlanningOptions } from '../options.js';
import type { Unit } from '../protocol.js';

/** Attributes that are numbers. */
const NUMBERS = ['dpi', 'seconds', 'moves', 'seed', 'workers'] as const;

/** The number in an attribute. Other text gives NaN, which the planner refuses with a sentence that names the option. */
export function numberIn(text: string): number {
  return text.trim() === '' ? NaN : Number(text);
}

/** The options that the element's attributes give. */
export function attributed(element: Element): PlanningOptions {
  const options: PlanningOptions = {};
  const [machine, method, units] = ['machine', 'method', 'units'].map((name) => element.getAttribute(name));
  if (machine) options.machine = machine;
  if (method) options.method = method;
  if (units) options.units = units as Unit;
  if (element.hasAttribute('allow-off-bed')) options.allowOffBed = true;
  for (const name of NUMBERS) {
    const text = element.getAttribute(name);
    if (text !== null) options[name] = numberIn(text);
  }
  return options;
}
