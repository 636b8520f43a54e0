/**
 * Plain data: copies of options, and finished plans as JSON. Typed arrays make no arrays in JSON: `JSON.stringify` writes `{"0":1,"1":2}`. A plan therefore
 * says itself how it is written, and paths are accepted in either form.
 */

import type { PlanOptions, WarmPath } from './protocol.js';

/** Adds `toJSON` to a plan, which writes its typed arrays as arrays. It is not enumerable, so that copies are plain data. */
export function asJson<T extends object>(plan: T): T {
  return Object.defineProperty(plan, 'toJSON', { value: () => plain(plan) });
}

function plain(value: unknown): unknown {
  if (ArrayBuffer.isView(value)) return Array.from(value as Uint8Array);
  if (Array.isArray(value)) return value.map(plain);
  if (typeof value !== 'object' || value === null) return value;
  return Object.fromEntries(Object.entries(value).map(([name, inner]) => [name, plain(inner)]));
}

/**
 * A copy of plain data, such as the options of a call, which its caller may change while the call waits. Of a proxy, which no message can
 * carry, it copies what is behind it. Callbacks and signals stay as they are, and so does a DataView, which no option takes.
 */
export function copied<T>(value: T): T {
  if (value instanceof DataView) return value;
  if (ArrayBuffer.isView(value)) return (value as unknown as Uint8Array).slice() as T;
  if (Array.isArray(value)) return value.map(copied) as T;
  if (typeof value !== 'object' || value === null || 'addEventListener' in value) return value;
  return Object.fromEntries(Object.entries(value).map(([name, inner]) => [name, copied(inner)])) as T;
}

/** The options with a path whose arrays are lists, whatever JSON made of them. */
export function withWarmPath<T extends Pick<PlanOptions, 'warm'>>(options: T): T {
  const warm: unknown = options?.warm;
  if (typeof warm !== 'object' || warm === null) return options;
  return { ...options, warm: Object.fromEntries(Object.entries(warm).map(([name, list]) => [name, listed(list)])) as unknown as WarmPath };
}

/** The list of an object that `JSON.parse` made of a typed array; any other value as it is. */
function listed(value: unknown): unknown {
  if (typeof value !== 'object' || value === null || Array.isArray(value) || ArrayBuffer.isView(value)) return value;
  const entries = Object.entries(value);
  return entries.every(([name], k) => name === String(k)) ? entries.map(([, number]) => number as unknown) : value;
}

/** Whether a value has what rendering needs of a finished plan. */
export function isPlanned(value: unknown): boolean {
  if (typeof value !== 'object' || value === null) return false;
  const { options, loaded, path } = value as Record<string, unknown>;
  return [options, loaded, path].every((part) => typeof part === 'object' && part !== null);
}
