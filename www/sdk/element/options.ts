/** Reads what a host gives an element: attributes, properties, and files. */

import type { Source } from '../bytes.js';
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

/** Takes a property that a host has set before the element was defined, which the class would replace or hide. */
export function early<E extends Element, K extends string & keyof E>(element: E, name: K): E[K] | undefined {
  const value = Object.getOwnPropertyDescriptor(element, name)?.value as E[K] | undefined;
  Reflect.deleteProperty(element, name);
  return value;
}

/** The name of a file; other sources have none. */
export function nameOf(source: Source): string {
  return typeof source === 'object' && source !== null && 'name' in source && typeof source.name === 'string' ? source.name : 'drawing.dxf';
}
