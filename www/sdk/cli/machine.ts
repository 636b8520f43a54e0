/** The machine and the dialect of a command: presets and shipped documents by name, or files of one's own. */

import type { Planner } from '../node.js';
import { checkMachine } from '../options.js';
import type { Dialect, MachineProfile } from '../protocol.js';
import { JOINT_KINDS, JOINT_SIDES, jointRules, SIZE_TESTS, type JointPattern } from '../joints.js';
import { LEAD_KINDS, LEAD_POSITIONS, leadRules, type LeadChoice } from '../leads.js';
import { number, oneOf, text, type Words } from './arguments.js';
import { bytesOf, Unusable, WrongUse } from './io.js';

const DEFAULT_MACHINE = 'co2-100w';

/** The machine of the options `--machine`, `--dialect` and those of leads, joints and levers. `own`: the one to take where `--machine` names none. */
export async function machineOf({ values }: Words, planner: Planner, own?: MachineProfile): Promise<MachineProfile> {
  const word = text(values, 'machine');
  const machine = withLevers(values, withJoints(values, withLeads(values, word === undefined && own !== undefined ? own : await named(word ?? DEFAULT_MACHINE, planner))));
  const dialect = text(values, 'dialect');
  return dialect === undefined ? machine : { ...machine, dialect: await dialectOf(dialect, machine, planner) };
}

/** The machine with the leads that the options ask for. */
function withLeads(values: Words['values'], machine: MachineProfile): MachineProfile {
  const given: Partial<LeadChoice> = {};
  const [kind, out, position] = ['lead', 'lead-out', 'lead-position'].map((option) => text(values, option));
  if (kind !== undefined) given.kind = oneOf('--lead', kind, LEAD_KINDS);
  if (out !== undefined) given.out = oneOf('--lead-out', out, LEAD_KINDS);
  if (position !== undefined) given.position = oneOf('--lead-position', position, LEAD_POSITIONS);
  const numbers = { length: 'lead-length', radius: 'lead-radius', angle: 'lead-angle', clearance: 'lead-clearance', centerBelow: 'lead-center-below', overcut: 'overcut' } as const;
  for (const [name, option] of Object.entries(numbers)) {
    const value = number(values, option);
    if (value !== undefined) given[name as keyof typeof numbers] = value;
  }
  if (Object.keys(given).length === 0) return machine;
  // An overcut alone, or a lead-out alone, is no wish for a lead-in.
  const leads = leadRules({ kind: 'none', ...given });
  const changed = { ...machine, leads };
  checked(() => checkMachine(changed), WrongUse, '');
  return changed;
}

/** The machine with the joints that the options ask for. */
function withJoints(values: Words['values'], machine: MachineProfile): MachineProfile {
  const given: Partial<JointPattern> = {};
  const [side, kind, test] = ['joint-side', 'joint-kind', 'joint-test'].map((option) => text(values, option));
  if (side !== undefined) given.side = oneOf('--joint-side', side, JOINT_SIDES);
  if (kind !== undefined) given.kind = oneOf('--joint-kind', kind, JOINT_KINDS);
  if (test !== undefined) given.test = oneOf('--joint-test', test, SIZE_TESTS);
  const numbers = { count: 'joints', width: 'joint-width', spacing: 'joint-spacing', cornerClearance: 'joint-corners' } as const;
  for (const [name, option] of Object.entries(numbers)) {
    const value = number(values, option);
    if (value !== undefined) given[name as keyof typeof numbers] = value;
  }
  const least = sizes(values, 'joint-size-min'), most = sizes(values, 'joint-size-max');
  if (least !== undefined) given.sizeMin = least;
  if (most !== undefined) given.sizeMax = most;
  if (Object.keys(given).length === 0) return machine;
  const changed = { ...machine, joints: jointRules(given) };
  checked(() => checkMachine(changed), WrongUse, '');
  return changed;
}

/** A size in x and y: one number for both, or two. */
function sizes(values: Words['values'], name: string): [number, number] | undefined {
  const word = text(values, name);
  if (word === undefined) return undefined;
  const [x = NaN, y = x, more] = word.split(',').map((part) => (part.trim() === '' ? NaN : Number(part)));
  if (!Number.isFinite(x) || !Number.isFinite(y) || more !== undefined) throw new WrongUse(`--${name} ${word}: give one length in mm for x and y, or two as X,Y.`);
  return [x, y];
}

/** The machine with the levers that the options ask for. */
function withLevers(values: Words['values'], machine: MachineProfile): MachineProfile {
  const overcut = number(values, 'moving-pierce');
  if (overcut === undefined) return machine;
  const changed = { ...machine, levers: { ...machine.levers, moving_pierce: { overcut } } };
  checked(() => checkMachine(changed), WrongUse, '');
  return changed;
}

/** The files with a machine profile or a dialect that the options name. */
export function machineFiles({ values }: Words, { machines, dialects }: Planner): string[] {
  const files = (option: string, known: readonly { name: string }[]) => {
    const word = text(values, option);
    return word === undefined || known.some((k) => k.name === word) ? [] : [word];
  };
  return [...files('machine', machines), ...files('dialect', dialects)];
}

/** The preset with this name, or the profile in the file with this name. */
async function named(word: string, { machines }: Planner): Promise<MachineProfile> {
  const preset = machines.find((m) => m.name === word);
  if (preset !== undefined) return preset;
  if (!isFile(word)) throw unknown('machine', word, machines);
  const content = await json(word, 'a machine profile is an object like those of the presets.') as MachineProfile | { schema: string; profile: MachineProfile } | null;
  // A profile that the page has exported is wrapped in an object with its schema.
  const profile = content !== null && typeof content === 'object' && 'profile' in content ? content.profile : content;
  checked(() => checkMachine(profile), Unusable, `${word}: `);
  return profile as MachineProfile;
}

/** The shipped dialect with this name, or the document in the file with this name. */
async function dialectOf(word: string, machine: MachineProfile, { dialects }: Planner): Promise<MachineProfile['dialect']> {
  if (dialects.some((d) => d.name === word)) return word;
  if (!isFile(word)) throw unknown('dialect', word, dialects);
  const document = await json(word, 'a dialect is an object like those of kerfway/dialects.');
  if (typeof document !== 'object') throw new Unusable(`${word} holds no dialect: it is an object like those of kerfway/dialects.`);
  checked(() => checkMachine({ ...machine, dialect: document as Dialect }), Unusable, `${word}: `);
  return document as Dialect;
}

const isFile = (word: string) => /[./\\]/.test(word);

async function json(word: string, remedy: string): Promise<unknown> {
  const bytes = await bytesOf(word);
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw new Unusable(`${word} is not JSON: ${remedy}`);
  }
}

/** Runs a check and turns its error into a failure of the command line. */
export function checked(check: () => void, Failure: typeof Unusable | typeof WrongUse, where: string): void {
  try {
    check();
  } catch (error) {
    throw new Failure(`${where}${(error as Error).message}`);
  }
}

function unknown(option: string, word: string, known: readonly { name: string }[]): WrongUse {
  return new WrongUse(`--${option} ${word}: choose one of ${known.map((k) => k.name).join(', ')}, or name a file ending in .json.`);
}
