/**
 * A person's own machines. They are saved in this browser, and exported to files (`kerfway.machine/1`). Only the shape of a file is checked
 * here; the planner checks its values when the machine is used.
 */

import type { MachineProfile } from 'kerfway';
import { keep } from '../core/kept.js';
import { words } from '../core/words/index.js';

const KEY = 'kerfway.machines';
const CHOSEN = 'kerfway.machine';
const SCHEMA = 'kerfway.machine/1';

/** The name of the machine that was chosen last in this browser; null where none was, or nothing can be stored. */
export function rememberedMachine(): string | null {
  try {
    return localStorage.getItem(CHOSEN);
  } catch {
    return null;
  }
}

/** Remembers the chosen machine. Returns false where the browser stores nothing: the choice then lasts as long as the page. */
export function rememberMachine(name: string): boolean {
  return keep(CHOSEN, name);
}

/** The machines saved in this browser. */
export function savedMachines(): MachineProfile[] {
  try {
    const list: unknown = JSON.parse(localStorage.getItem(KEY) ?? '[]');
    return Array.isArray(list) ? list.filter(isProfile) : [];
  } catch {
    return [];
  }
}

/** Saves a machine in place of another with its name. Returns false where the browser stores nothing. */
export function saveMachine(profile: MachineProfile): boolean {
  return store([...savedMachines().filter((m) => m.name !== profile.name), profile]);
}

/** Deletes a saved machine. Returns false where the browser stores nothing. */
export function deleteMachine(name: string): boolean {
  return store(savedMachines().filter((m) => m.name !== name));
}

/** A copy with another title, and a name made from the letters and digits of that title, in any script. */
export function named(profile: MachineProfile, title: string): MachineProfile {
  const slug = title.normalize('NFC').toLowerCase().replace(/[^\p{L}\p{M}\p{N}]+/gu, '-').replace(/^-|-$/g, '');
  return withOwnName({ ...structuredClone(profile), name: `my-${slug || 'machine'}`, title });
}

/** A machine that takes the place of none with another title: where its name is taken, it gets a number. */
export function withOwnName(profile: MachineProfile): MachineProfile {
  const others = new Set(savedMachines().filter((m) => m.title !== profile.title).map((m) => m.name));
  let name = profile.name;
  for (let n = 2; others.has(name); n += 1) name = `${profile.name}-${n}`;
  return { ...profile, name };
}

/** The text of an exported machine. */
export function asFile(profile: MachineProfile): string {
  return `${JSON.stringify({ schema: SCHEMA, profile }, null, 2)}\n`;
}

/** The profile in an exported file. Throws an error with one sentence when there is none. */
export function fromFile(text: string): MachineProfile {
  let content: unknown;
  try {
    content = JSON.parse(text);
  } catch {
    throw new Error(words.machine.noJson);
  }
  const { schema, profile } = (content ?? {}) as { schema?: unknown; profile?: unknown };
  if (schema !== SCHEMA) throw new Error(words.machine.noSchema(SCHEMA));
  if (!isProfile(profile)) throw new Error(words.machine.incomplete);
  return profile;
}

function store(list: MachineProfile[]): boolean {
  return keep(KEY, JSON.stringify(list));
}

function isProfile(value: unknown): value is MachineProfile {
  if (typeof value !== 'object' || value === null) return false;
  const { version, name, title, home, rapid, cut, mark, materials } = value as Partial<MachineProfile>;
  const process = (p: unknown) => typeof (p as { speed?: unknown } | undefined)?.speed === 'number';
  return version === 1 && typeof name === 'string' && typeof title === 'string' && Array.isArray(home)
    && Array.isArray(rapid?.speed) && process(cut) && process(mark) && Array.isArray(materials ?? []);
}
