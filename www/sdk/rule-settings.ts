/** The settings from which rules of leads and of joints are made: what is not given has its default. */

import { check, optional, shown } from './check.js';
import { KerfwayError } from './errors.js';
import { given } from './options.js';

/** Throws a `KerfwayError` for a setting that there is not, or of another type. Values that no machine has are refused where its profile is checked. */
export function withDefaults<T extends object>(owner: string, defaults: Readonly<T>, settings: Partial<T>): T {
  const fields = Object.entries(defaults).map(([name, value]) => optional(name, typeof value === 'string' ? 'text' : Array.isArray(value) ? { pair: 'any' } : 'any'));
  check({ owner, item: 'setting', value: 'The setting', fields }, settings);
  const own = given(settings);
  for (const [name, value] of Object.entries(own)) {
    const isOther = typeof (defaults as Record<string, unknown>)[name] === 'number' && typeof value !== 'number';
    if (isOther) throw new KerfwayError('wrong-type', `The setting "${name}" is ${shown(value)}. Give a number.`, { field: name });
  }
  return { ...defaults, ...own };
}
