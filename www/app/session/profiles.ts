/**
 * A person's own machines: kept in this browser, and as files (`kerfway.machine/1`) to take elsewhere. What a file holds
 * is checked by the planner when it is used; here only its shape is.
 */

import type { MachineProfile } from 'kerfway';
import { words } from '../core/words/index.js';

const KEY = 'kerfway.machines';
const SCHEMA = 'kerfway.machine/1';

/** Those kept in this browser. */
export function kept(): MachineProfile[] {
  try {
    const list: unknown = JSON.parse(localStorage.getItem(KEY) ?? '[]');
    return Array.isArray(list) ? list.filter(isProfile) : [];
  } catch {
    return [];
  }
}

/** Keeps one, in place of another of its name; false where the browser keeps nothing. */
export function keep(profile: MachineProfile): boolean {
  return store([...kept().filter((m) => m.name !== profile.name), profile]);
}

export function forget(name: string): boolean {
  return store(kept().filter((m) => m.name !== name));
}

/** One under a name of its own: the title made a name. */
export function named(profile: MachineProfile, title: string): MachineProfile {
  const slug = title.toLowerCase().replace(/[^a-z0-9]+/g, '-').replace(/^-|-$/g, '');
  return { ...structuredClone(profile), name: `my-${slug || 'machine'}`, title };
}

export function asFile(profile: MachineProfile): string {
  return `${JSON.stringify({ schema: SCHEMA, profile }, null, 2)}\n`;
}

/** The profile in a file; throws one sentence. */
export function fromFile(text: string): MachineProfile {
  let content: unknown;
  try {
    content = JSON.parse(text);
  } catch {
    throw new Error(words.machine.noJson);
  }
  const { schema, profile } = content as { schema?: unknown; profile?: unknown };
  if (schema !== SCHEMA) throw new Error(words.machine.noSchema(SCHEMA));
  if (!isProfile(profile)) throw new Error(words.machine.incomplete);
  return profile;
}

function store(list: MachineProfile[]): boolean {
  try {
    localStorage.setItem(KEY, JSON.stringify(list));
    return true;
  } catch {
    return false;
  }
}

function isProfile(value: unknown): value is MachineProfile {
  if (typeof value !== 'object' || value === null) return false;
  const { version, name, title, home, rapid, cut, mark } = value as Partial<MachineProfile>;
  const process = (p: unknown) => typeof (p as { speed?: unknown } | undefined)?.speed === 'number';
  return version === 1 && typeof name === 'string' && typeof title === 'string' && Array.isArray(home)
    && Array.isArray(rapid?.speed) && process(cut) && process(mark);
}
