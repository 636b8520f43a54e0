/**
 * The options of a request. They are the options of the package, checked by the same tables: as JSON in the field `options`, in
 * the form or the query, or one by one in the query (`machine=co2-100w&material.thickness=3`).
 */

import { check, optional, type Field, type Kind } from '../check.js';
import { KerfwayError } from '../errors.js';
import { SHAPES } from '../fields.js';
import { DEFAULT_SECONDS, OUTPUTS } from '../options.js';
import type { OutputKind } from '../protocol.js';
import type { ServerSettings } from './settings.js';

/** What the service does with a drawing. */
export const JOB_KINDS = ['inspect', 'plan', 'quote'] as const;
export type JobKind = (typeof JOB_KINDS)[number];

/** Options that a request must not choose: they decide about the service's own computer, or make no sense over HTTP. */
const NOT_FOR_REQUESTS = ['workers', 'member', 'warm', 'signal', 'onLoaded', 'onProgress'];

/** The fields that a request of each kind may have. */
export function fieldsOf(kind: JobKind): readonly Field[] {
  const { reading, planning, terms } = SHAPES;
  const plan = planning.fields.filter((f) => !NOT_FOR_REQUESTS.includes(f.name));
  const outputs: Field = { name: 'outputs', kind: { list: { choice: OUTPUTS } }, required: false, nullable: false };
  if (kind === 'inspect') return reading.fields;
  if (kind === 'plan') return [...reading.fields, ...plan, outputs];
  // A quote states its material with thickness and density; a plan chooses a setting of the machine by its name.
  return [...reading.fields, ...plan.filter((f) => !terms.fields.some((t) => t.name === f.name)), ...terms.fields];
}

/** Parameters of the query that are no options of the package. */
const OWN: Record<JobKind, readonly string[]> = { inspect: ['name', 'options', 'thumbnails'], plan: ['name', 'options', 'acceptGuess'], quote: ['name', 'options'] };

/** The options of a request, checked. */
export function requestOptions(kind: JobKind, query: URLSearchParams, form: ReadonlyMap<string, string>, settings: ServerSettings): Record<string, unknown> {
  const fields = fieldsOf(kind);
  const options: Record<string, unknown> = {};
  for (const source of [query, form]) {
    const text = source.get('options');
    if (text !== null && text !== undefined) for (const [name, value] of Object.entries(parsed(text))) own(options, name, value);
  }
  for (const source of [query, form]) {
    const known = new Set<string>();
    for (const [name, text] of source) {
      const again = known.has(name);
      if (again && !holdsLists(fields.find((f) => f.name === name)?.kind)) throw givenTwice(name, name);
      known.add(name);
      if (OWN[kind].includes(name)) continue;
      set(options, fields, name.split('.'), text, { path: name, again });
    }
  }
  const strange = NOT_FOR_REQUESTS.find((name) => Object.hasOwn(options, name));
  if (strange !== undefined) throw new KerfwayError('unknown-field', `${kind} has no option "${strange}" in this service.`, { field: strange });
  check({ owner: kind, item: 'option', value: 'The option', fields: [...fields, optional('name', 'text')] }, options);
  atMost(options, 'seconds', settings.mostSeconds, 's');
  atMost(options, 'moves', settings.mostMoves, '');
  if (kind === 'plan' && isUnbudgeted(options)) options['seconds'] = Math.min(DEFAULT_SECONDS, settings.mostSeconds);
  return options;
}

/** Whether a request says neither how long it searches nor with how many moves. */
export const isUnbudgeted = (options: Record<string, unknown>) => options['seconds'] === undefined && options['moves'] === undefined;

function parsed(text: string): Record<string, unknown> {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    throw new KerfwayError('not-json', 'The field "options" is not JSON.', { field: 'options' });
  }
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value as Record<string, unknown>;
  throw new KerfwayError('wrong-type', 'The field "options" is no object. Give the options by name, as JSON.', { field: 'options' });
}

/** Sets a field, whatever its name: an assignment to `__proto__` would set none. */
function own(options: Record<string, unknown>, name: string, value: unknown): void {
  Object.defineProperty(options, name, { value, enumerable: true, configurable: true, writable: true });
}

/**
 * Sets a single option from its text. An unknown one is set as it is, so that the check names it. `again`: a further list of an option that holds
 * lists.
 */
function set(options: Record<string, unknown>, fields: readonly Field[], [name = '', ...rest]: string[], text: string, given: { path: string; again: boolean }): void {
  const field = fields.find((f) => f.name === name);
  const kind = field?.kind;
  if (rest.length > 0 && typeof kind === 'object' && 'object' in kind) {
    const inner = (options[name] ??= {});
    if (typeof inner !== 'object') throw givenTwice(name, given.path);
    set(inner as Record<string, unknown>, kind.object, rest, text, given);
  } else if (rest.length > 0 || kind === undefined) own(options, [name, ...rest].join('.'), text);
  else if (holdsLists(kind)) own(options, name, [...(given.again ? (options[name] as unknown[]) : []), valueOf(kind.list, text)]);
  else own(options, name, valueOf(kind, text));
}

const givenTwice = (name: string, field: string) => new KerfwayError('wrong-type', `The option "${name}" is given twice.`, { field });

/** Whether an option is a list of lists: `together=3,4&together=7,8` are two lists. */
function holdsLists(kind: Kind | undefined): kind is { list: Kind } {
  return typeof kind === 'object' && 'list' in kind && typeof kind.list === 'object' && 'list' in kind.list;
}

/** The value that a text stands for. One that cannot be read stays a text, which the check refuses by name. */
function valueOf(kind: Kind, text: string): unknown {
  if (kind === 'flag') return text === 'true' ? true : text === 'false' ? false : text;
  if (typeof kind === 'string' || 'choice' in kind || 'nameOr' in kind) return text;
  if ('number' in kind || 'whole' in kind) return text.trim() === '' || Number.isNaN(Number(text)) ? text : Number(text);
  const inner = 'list' in kind ? kind.list : 'pair' in kind ? kind.pair : 'four' in kind ? kind.four : null;
  return inner === null ? text : text.split(',').map((part) => valueOf(inner, part.trim()));
}

function atMost(options: Record<string, unknown>, field: string, most: number, unit: string): void {
  const value = options[field];
  if (typeof value === 'number' && value > most) {
    throw new KerfwayError('out-of-range', `The option "${field}" is ${value}. This service takes up to ${most}${unit === '' ? '' : ` ${unit}`}.`, { field, value: String(value), least: 0, most, unit });
  }
}

/** The kinds of output that a plan asks for. */
export function outputsIn(options: Record<string, unknown>): readonly OutputKind[] {
  return (options['outputs'] as OutputKind[] | undefined) ?? [];
}
