/**
 * Checks options and other objects of callers against tables of their fields (`fields.ts`), before a worker gets them. A
 * misspelt name, a wrong type or a number out of range is refused with one sentence that names the field. The core checks
 * again with the same tables: see `src/fields`.
 */

import { KerfwayError, type ErrorParams } from './errors.js';
import type { ErrorCode } from './generated/types.js';

/** The numbers that a field may have, with the reason for the limits. */
export interface Range {
  least: number;
  most: number;
  /** Whether 0 is allowed as well. */
  or_zero: boolean;
  unit: string;
  why: string;
}

/** The type of a value. Callbacks, signals, addresses and `any` exist in JavaScript only. */
export type Kind =
  | 'address'
  | 'any'
  | 'flag'
  | 'text'
  | 'parameters'
  | 'callback'
  | 'signal'
  | { choice: readonly string[] }
  | { number: Range }
  | { whole: Range }
  | { pair: Kind }
  | { four: Kind }
  | { list: Kind }
  | { object: readonly Field[] }
  | { nameOr: Shape };

export interface Field {
  name: string;
  kind: Kind;
  required: boolean;
  nullable: boolean;
}

/** The fields of an object, with the words that error sentences use. */
export interface Shape {
  owner: string;
  item: string;
  value: string;
  fields: readonly Field[];
}

/** A field that may be absent. */
export const optional = (name: string, kind: Kind): Field => ({ name, kind, required: false, nullable: false });

/** Throws a `KerfwayError` unless `value` is an object with the right fields. A field that is undefined counts as absent. */
export function check(shape: Shape, value: unknown): void {
  checkObject(shape, '', shape.fields, value);
}

/** Throws a `KerfwayError` unless `value` is of this kind. `what` begins the sentence, for example `The option`. */
export function checkOne(what: string, name: string, kind: Kind, value: unknown): void {
  checkValue({ owner: what, item: '', value: what, fields: [] }, name, { kind, nullable: false }, value);
}

function checkObject(shape: Shape, prefix: string, fields: readonly Field[], value: unknown): void {
  if (!isRecord(value)) {
    const sentence = `${shape.owner} is ${shown(value)}. Give an object with named ${shape.item}s.`;
    throw prefix === '' ? new KerfwayError('wrong-type', sentence) : refused(shape, prefix.slice(0, -1), value, 'Give an object.');
  }
  for (const [name, given] of Object.entries(value)) {
    if (given === undefined) continue;
    const field = fields.find((f) => f.name === name);
    if (field === undefined) throw unknown(shape, prefix, name, fields);
    if (!(field.nullable && given === null)) checkValue(shape, `${prefix}${name}`, field, given);
  }
  const missing = fields.find((f) => f.required && value[f.name] === undefined);
  if (missing === undefined) return;
  const path = `${prefix}${missing.name}`;
  throw new KerfwayError('missing-field', `${shape.owner} lacks the ${shape.item} "${path}".`, { field: path });
}

function checkValue(shape: Shape, path: string, { kind, nullable }: Pick<Field, 'kind' | 'nullable'>, value: unknown): void {
  const fail = (rule: string) => refused(shape, path, value, rule);
  const failRange = (range: Range, rule: string) => {
    const { least, most, unit } = range;
    return typeof value === 'number' ? refused(shape, path, value, rule, 'out-of-range', { least, most, unit }) : fail(rule);
  };
  const orNull = nullable ? ', or null' : '';
  const each = (of: Kind, list: ArrayLike<unknown>) => {
    for (let k = 0; k < list.length; k += 1) checkValue(shape, `${path}[${k}]`, { kind: of, nullable: false }, list[k]);
  };
  if (kind === 'flag') {
    if (typeof value !== 'boolean') throw fail(`Give true or false${orNull}.`);
  } else if (kind === 'text') {
    if (typeof value !== 'string') throw fail(`Give a text${orNull}.`);
  } else if (kind === 'parameters') {
    checkParameters(shape, path, value);
  } else if (kind === 'any') {
    return;
  } else if (kind === 'address') {
    if (typeof value !== 'string' && !(value instanceof URL)) throw fail('Give an address: a text or a URL.');
  } else if (kind === 'callback') {
    if (typeof value !== 'function') throw fail('Give a function.');
  } else if (kind === 'signal') {
    // Recognised by its members, because a signal may come from another frame or context.
    if (!isRecord(value) || typeof value['aborted'] !== 'boolean' || typeof value['addEventListener'] !== 'function' || typeof value['throwIfAborted'] !== 'function') throw fail('Give the signal of an AbortController.');
  } else if ('choice' in kind) {
    if (!kind.choice.includes(value as string)) throw refused(shape, path, value, `Choose one of: ${kind.choice.join(', ')}.`, 'not-a-choice', { choices: [...kind.choice] });
  } else if ('number' in kind) {
    if (!holds(kind.number, value)) throw failRange(kind.number, numberRule(kind.number, 'a number', orNull));
  } else if ('whole' in kind) {
    if (!holds(kind.whole, value) || !Number.isSafeInteger(value)) throw failRange(kind.whole, numberRule(kind.whole, 'a whole number', orNull));
  } else if ('pair' in kind) {
    if (!isList(value) || value.length !== 2) throw fail(`Give a list of two${orNull}.`);
    each(kind.pair, value);
  } else if ('four' in kind) {
    if (!isList(value) || value.length !== 4) throw fail(`Give a list of four${orNull}.`);
    each(kind.four, value);
  } else if ('list' in kind) {
    if (!isList(value)) throw fail(`Give a list${orNull}.`);
    each(kind.list, value);
  } else if ('object' in kind) {
    checkObject(shape, `${path}.`, kind.object, value);
  } else if (isRecord(value)) {
    check(kind.nameOr, value);
  } else if (typeof value !== 'string') {
    throw fail('Give a name or an object.');
  }
}

/** Numbers, texts and flags by name. Their names are checked by the method. */
function checkParameters(shape: Shape, path: string, value: unknown): void {
  if (!isRecord(value)) throw refused(shape, path, value, 'Give an object with the parameters that differ from their defaults.');
  for (const [name, given] of Object.entries(value)) {
    const plain = given === null || ['boolean', 'string', 'undefined'].includes(typeof given) || Number.isFinite(given);
    if (!plain) throw refused(shape, `${path}.${clean(name)}`, given, 'Give a finite number, a text, true or false.');
  }
}

function holds({ least, most, or_zero }: Range, value: unknown): boolean {
  return typeof value === 'number' && ((value >= least && value <= most) || (or_zero && value === 0));
}

function numberRule({ least, most, or_zero, unit, why }: Range, what: string, orNull: string): string {
  const range = least < most ? `${what} from ${least} to ${most}` : String(least);
  return `Give ${range}${unit === '' ? '' : ` ${unit}`}${or_zero ? ', or 0' : ''}${orNull}: ${why}.`;
}

function refused(shape: Shape, path: string, value: unknown, rule: string, code: ErrorCode = 'wrong-type', more: ErrorParams = {}): KerfwayError {
  const said = typeof value === 'string' ? clean(value) : shown(value);
  return new KerfwayError(code, `${shape.value} "${path}" is ${shown(value)}. ${rule}`, { field: path, value: said, ...more });
}

function unknown(shape: Shape, prefix: string, name: string, fields: readonly Field[]): KerfwayError {
  const near = nearest(name, fields.map((f) => f.name));
  const path = `${prefix}${clean(name)}`;
  const hint = near === null ? `There are: ${fields.map((f) => f.name).join(', ')}.` : `Did you mean "${prefix}${near}"?`;
  const params: ErrorParams = near === null ? { field: path } : { field: path, near: `${prefix}${near}` };
  return new KerfwayError('unknown-field', `${shape.owner} has no ${shape.item} "${path}". ${hint}`, params);
}

/** The number of characters of a text that a sentence shows, enough to recognise it. */
const SHOWN = 40;

/** Prepares a caller's text for a sentence: shortened, and without control characters, which a terminal would obey. */
function clean(text: string): string {
  const short = text.length > SHOWN ? `${text.slice(0, SHOWN)}…` : text;
  return short.replace(/[\u0000-\u001f\u007f-\u009f]/g, '\ufffd');
}

/** A value as a sentence shows it. */
export function shown(value: unknown): string {
  if (typeof value === 'string') return `"${clean(value)}"`;
  if (value === null || ['number', 'boolean', 'undefined'].includes(typeof value)) return String(value);
  if (typeof value === 'bigint') return `${clean(String(value))}n`;
  if (typeof value !== 'object') return `a ${typeof value}`;
  return isRecord(value) ? 'an object' : 'a list';
}

/** Whether a value is an object with fields: no list, no `Map` or `Set`, and not null. */
export function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === 'object' && value !== null && !(Symbol.iterator in value);
}

/** Whether a value is a list: an array, or a typed array. */
export function isList(value: unknown): value is ArrayLike<unknown> {
  return Array.isArray(value) || (ArrayBuffer.isView(value) && 'length' in value);
}

/** The number of characters that are compared, which bounds the work for hostile names. */
const LONGEST = 64;

/** The name among `known` that was probably meant: see `src/fields/nearest.rs`. */
export function nearest(name: string, known: readonly string[]): string | null {
  const key = (text: string) => text.replace(/[_ -]/g, '').slice(0, LONGEST).toLowerCase();
  const wanted = key(name);
  const most = Math.min(Math.max(Math.floor(wanted.length / 3), 2), wanted.length - 1);
  let best: { near: string | null; apart: number } = { near: null, apart: most + 1 };
  for (const near of known) {
    const apart = distance(wanted, key(near));
    if (apart < best.apart) best = { near, apart };
  }
  return best.near;
}

/** The optimal string alignment distance: how many characters to insert, delete, replace or swap with the next one. */
function distance(a: string, b: string): number {
  let before: number[] = [];
  let last = Array.from({ length: b.length + 1 }, (_, k) => k);
  const at = (row: number[], k: number) => row[k] ?? Infinity;
  for (let i = 0; i < a.length; i += 1) {
    const row = [i + 1];
    for (let j = 0; j < b.length; j += 1) {
      const swapped = i > 0 && j > 0 && a[i] === b[j - 1] && a[i - 1] === b[j];
      row.push(Math.min(at(last, j) + (a[i] === b[j] ? 0 : 1), at(last, j + 1) + 1, at(row, j) + 1, swapped ? at(before, j - 1) + 1 : Infinity));
    }
    [before, last] = [last, row];
  }
  return at(last, b.length);
}
