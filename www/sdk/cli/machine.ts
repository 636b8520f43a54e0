/** The machine and the dialect of a command: presets and shipped documents by name, or files of one's own. */

import type { Planner } from '../node.js';
import { reportOf } from '../errors.js';
import { checkProfile } from '../options.js';
import type { Corners, Dialect, Heat, MachineProfile, Tips } from '../protocol.js';
import { CORNER_KINDS } from '../corners.js';
import { JOINT_KINDS, JOINT_SIDES, jointRules, SIZE_TESTS, type JointPattern } from '../joints.js';
import { LEAD_KINDS, LEAD_POSITIONS, leadRules, type LeadChoice } from '../leads.js';
import { number, oneOf, text, type Words } from './arguments.js';
import { checkedAsWritten } from './as-written.js';
import { changedJoints, changedLeads } from './own-rules.js';
import { textOf, Unusable, WrongUse } from './io.js';
import { RISKY_MOVES } from './option-groups.js';

const OPTION_OF_TIPS = ['nozzle-radius', 'tip-margin', 'slats', 'tips-below', 'drops-below', 'cross-over'];
const DEFAULT_MACHINE = 'co2-100w';

/** The machine of the options `--machine`, `--dialect` and those of the kerf, leads, joints, levers and skeleton cuts. `own`: the one to take where `--machine` names none. */
export async function machineOf({ values }: Words, planner: Planner, own?: MachineProfile): Promise<MachineProfile> {
  const word = text(values, 'machine');
  const machine = withSkeleton(values, withLevers(values, withJoints(values, withLeads(values, withKerf(values, word === undefined && own !== undefined ? own : await named(word ?? DEFAULT_MACHINE, planner))))));
  const dialect = text(values, 'dialect');
  return dialect === undefined ? machine : { ...machine, dialect: await dialectOf(dialect, machine, planner) };
}

/** The machine with the kerf width that is asked for, whatever its materials have. */
function withKerf(values: Words['values'], machine: MachineProfile): MachineProfile {
  const kerf_width = number(values, 'kerf-width');
  if (kerf_width === undefined) return machine;
  const materials = machine.materials?.map(({ kerf_width: _, ...material }) => material);
  return valid(values, { ...machine, kerf_width, ...(materials && { materials }) });
}

/** The machine with the leads that the options ask for: other ones with `--lead`, its own with what the others change. */
function withLeads(values: Words['values'], machine: MachineProfile): MachineProfile {
  const given: Partial<LeadChoice> = {
    ...chosen(values, { kind: ['lead', LEAD_KINDS], out: ['lead-out', LEAD_KINDS], position: ['lead-position', LEAD_POSITIONS] }),
    ...measured(values, { length: 'lead-length', radius: 'lead-radius', angle: 'lead-angle', clearance: 'lead-clearance', centerBelow: 'lead-center-below', overcut: 'overcut' }),
  };
  if (Object.keys(given).length === 0) return machine;
  const { kind, ...others } = given;
  if (kind === undefined && machine.leads?.rules.length) return valid(values, { ...machine, leads: changedLeads(machine.leads, others) });
  // An overcut alone, or a lead-out alone, is no wish for a lead-in.
  return valid(values, { ...machine, leads: leadRules({ kind: 'none', ...given }) });
}

/** The machine with the joints that the options ask for: other ones with `--joints`, its own with what the others change. */
function withJoints(values: Words['values'], machine: MachineProfile): MachineProfile {
  const given: Partial<JointPattern> = {
    ...chosen(values, { side: ['joint-side', JOINT_SIDES], kind: ['joint-kind', JOINT_KINDS], test: ['joint-test', SIZE_TESTS] }),
    ...measured(values, { count: 'joints', width: 'joint-width', spacing: 'joint-spacing', cornerClearance: 'joint-corners' }),
  };
  const least = sizes(values, 'joint-size-min'), most = sizes(values, 'joint-size-max');
  if (least !== undefined) given.sizeMin = least;
  if (most !== undefined) given.sizeMax = most;
  if (Object.keys(given).length === 0) return machine;
  const isOwn = given.count === undefined && machine.joints?.rules.length;
  return valid(values, { ...machine, joints: isOwn ? changedJoints(machine.joints!, given) : jointRules(given) });
}

/** The settings that are given as words, by name: each with its option and the words there are. */
function chosen<T extends Record<string, [option: string, known: readonly string[]]>>(values: Words['values'], settings: T): { [K in keyof T]?: T[K][1][number] } {
  const given: { [K in keyof T]?: T[K][1][number] } = {};
  for (const [name, [option, known]] of Object.entries(settings)) {
    const word = text(values, option);
    if (word !== undefined) given[name as keyof T] = oneOf(`--${option}`, word, known);
  }
  return given;
}

/** The settings that are given as numbers, by name: each with its option. */
function measured<T extends Record<string, string>>(values: Words['values'], settings: T): { [K in keyof T]?: number } {
  const given: { [K in keyof T]?: number } = {};
  for (const [name, option] of Object.entries(settings)) {
    const value = number(values, option);
    if (value !== undefined) given[name as keyof T] = value;
  }
  return given;
}

/** The machine, if its fields are right; otherwise an option is wrong. */
function valid(values: Words['values'], machine: MachineProfile): MachineProfile {
  return checkedAsWritten(values, () => (checkProfile(machine), machine));
}

/** A size in x and y: one number for both, or two. */
function sizes(values: Words['values'], name: string): [number, number] | undefined {
  const word = text(values, name);
  if (word === undefined) return undefined;
  const [x = NaN, y = x, more] = word.split(',').map((part) => (part.trim() === '' ? NaN : Number(part)));
  if (!Number.isFinite(x) || !Number.isFinite(y) || more !== undefined) throw new WrongUse(`--${name} ${word}: give one length in mm for x and y, or two as X,Y.`);
  return [x, y];
}

/** Width of a bridge, mm: what holds small parts and is broken by hand. */
const BRIDGE = 2;

/** The machine with the levers that the options ask for. */
function withLevers(values: Words['values'], machine: MachineProfile): MachineProfile {
  const [overcut, height, down, speed, reach, again, chain, clearance] = ['moving-pierce', 'lift', 'stay-down', 'z-speed', 'fly', 'fly-overcut', 'chains', 'chain-clearance'].map((option) => number(values, option));
  const [bridge, width, apart, most] = ['bridges', 'bridge-width', 'bridge-clearance', 'bridge-most'].map((option) => number(values, option));
  const cut = values['cut-bridges'] === true;
  const [offered, moved] = [number(values, 'offer-shifts'), number(values, 'shift-parts')];
  const atRest = values['lift-at-rest'] === true, tips = tipsOf(values, machine), heat = heatOf(values, machine), corners = cornersOf(values, machine);
  if ([overcut, height, down, speed, reach, again, chain, clearance, tips, heat, corners, offered, moved, bridge, width, apart, most].every((value) => value === undefined) && !atRest && !cut && values['edge-starts'] !== true && values['shared-cuts'] !== true) return machine;
  const levers = { ...machine.levers };
  if (tips !== undefined) levers.tips = tips;
  if (heat !== undefined) levers.heat = heat;
  if (corners !== undefined) levers.corners = corners;
  if (values['shared-cuts'] === true) levers.common_cuts = { ...levers.common_cuts };
  // A shift that is made need not be offered.
  const shift = moved ?? offered;
  if (shift !== undefined) levers.common_cuts = { ...levers.common_cuts, shift, ...(moved !== undefined && { shift_parts: true }) };
  if (overcut !== undefined) levers.moving_pierce = { overcut };
  // Without a reach, the overcut changes that of the machine's own fly cuts.
  const flown = reach === undefined ? levers.fly : { reach };
  if (flown == null && again !== undefined) throw new WrongUse('--fly-overcut: the machine does not cut on the run. Give the longest way between two cuts with --fly.');
  if (flown != null) levers.fly = { ...flown, ...(again !== undefined && { overcut: again }) };
  const chained = chain === undefined ? levers.chains : { reach: chain };
  const edges = values['edge-starts'] === true;
  if (chained == null && (clearance !== undefined || edges)) throw new WrongUse(`--${edges ? 'edge-starts' : 'chain-clearance'}: the machine does not join contours. Give the longest cut through waste with --chains.`);
  if (chained != null) levers.chains = { ...chained, ...(clearance !== undefined && { clearance }), ...(edges && { edge_starts: true }) };
  // Without a reach, the other options change the machine's own bridges.
  const bridged = bridge === undefined ? levers.bridges : { width: BRIDGE, reach: bridge };
  const [named] = Object.entries({ 'bridge-width': width, 'bridge-clearance': apart, 'bridge-most': most, 'cut-bridges': cut || undefined }).find(([, value]) => value !== undefined) ?? [];
  if (bridged == null && named !== undefined) throw new WrongUse(`--${named}: the machine does not connect parts. Give the longest bridge with --bridges.`);
  if (bridged != null) levers.bridges = { ...bridged, ...(width !== undefined && { width }), ...(apart !== undefined && { clearance: apart }), ...(most !== undefined && { most }), ...(cut && { cut_later: true }) };
  // Without a height, the other options change the machine's own lift.
  const lifted = height === undefined ? levers.lift : { height };
  if (lifted == null && (down !== undefined || atRest)) throw new WrongUse(`--${atRest ? 'lift-at-rest' : 'stay-down'}: the machine does not lift its head. Give the height with --lift.`);
  if (lifted != null) levers.lift = { ...lifted, ...(down !== undefined && { stay_down: down }), ...(atRest && { at_rest: true }) };
  if (levers.heat != null && levers.fly != null) throw new WrongUse('--heat and --fly: contours that are cut on the run follow each other at once. Ask for one of them.');
  if (levers.heat != null && machine.pre_cut_time != null) throw new WrongUse('--heat: the machine has pre_cut_time. Cuts that are left unfinished are not planned with heat in mind.');
  const z_speed = speed ?? machine.z_speed;
  if (levers.lift == null && levers.tips != null && levers.tips.risky_moves !== 'ignore') throw new WrongUse('--tips avoid: the machine does not lift its head. Give the height with --lift, or use --tips ignore.');
  if (levers.lift != null && z_speed == null) throw new WrongUse('--lift: the machine has no speed for lifting the head. Give it with --z-speed.');
  return valid(values, { ...machine, levers, ...(z_speed != null && { z_speed }) });
}

/** The machine with the skeleton cuts that the options ask for. */
function withSkeleton(values: Words['values'], machine: MachineProfile): MachineProfile {
  const given = measured(values, { clearance: 'skeleton-clearance', joint_spacing: 'skeleton-joints', remainder: 'keep-strip' });
  const spacing = sizes(values, 'skeleton');
  if (spacing === undefined && Object.keys(given).length === 0) return machine;
  const pieces = spacing && { spacing_x: spacing[0], spacing_y: spacing[1] };
  if (pieces === undefined && given.remainder === undefined && machine.skeleton == null) throw new WrongUse('--skeleton-clearance and --skeleton-joints are for skeleton cuts. Ask for them with --skeleton or --keep-strip.');
  return valid(values, { ...machine, skeleton: { ...machine.skeleton, ...pieces, ...given } });
}

/** What the options say of pieces that may tip: the machine's own with what they change; undefined without such options. */
function tipsOf(values: Words['values'], machine: MachineProfile): Tips | undefined {
  const word = text(values, 'tips');
  const given: Tips = measured(values, {
    nozzle_radius: 'nozzle-radius', margin: 'tip-margin', tips_below: 'tips-below', drops_below: 'drops-below', cross_over: 'cross-over',
  });
  const slats = sizes(values, 'slats');
  // One number is the pitch alone: the slats run along x.
  if (slats !== undefined) given.slats = { pitch: slats[0], angle: text(values, 'slats')?.includes(',') === true ? (slats[1] * Math.PI) / 180 : 0 };
  if (word === undefined && Object.keys(given).length === 0) return undefined;
  const own = machine.levers?.tips;
  if (word === undefined && own == null) throw new WrongUse(`--${OPTION_OF_TIPS.find((option) => values[option] !== undefined)}: say what is done about tipped pieces with --tips avoid or --tips ignore.`);
  return { ...own, ...given, ...(word !== undefined && { risky_moves: oneOf('--tips', word, RISKY_MOVES) }) };
}

/** What the options say of corners: the machine's own with what they change; undefined without such options. */
function cornersOf(values: Words['values'], machine: MachineProfile): Corners | undefined {
  const given: Corners = {
    ...chosen(values, { outer: ['corners', CORNER_KINDS], hole: ['hole-corners', CORNER_KINDS] }),
    ...measured(values, { loop_radius: 'loop-radius', clearance: 'loop-clearance', round_radius: 'round-radius', deviation: 'corner-deviation' }),
  };
  // Where only single contours are chosen, all others turn in their corners.
  const own = machine.levers?.corners ?? ((values['corners-of'] as string[] | undefined)?.length ? {} : undefined);
  return own === undefined && Object.keys(given).length === 0 ? undefined : { ...own, ...given };
}

/** What the options say of heat: the machine's own with what they change; undefined without such options. */
function heatOf(values: Words['values'], machine: MachineProfile): Heat | undefined {
  const word = text(values, 'heat'), pair = sizes(values, 'heat'), charge = number(values, 'heat-charge'), plate = sizes(values, 'small-holes');
  if (pair === undefined && charge === undefined && plate === undefined) return undefined;
  const own = machine.levers?.heat;
  if (word !== undefined && !word.includes(',')) throw new WrongUse(`--heat ${word}: give the distance in mm and the seconds, as MM,S.`);
  if (charge !== undefined && pair === undefined && own == null) throw new WrongUse('--heat-charge: say which cuts are too near each other with --heat MM,S.');
  // One number is the thickness alone.
  const ratio = text(values, 'small-holes')?.includes(',') === true ? plate?.[1] : undefined;
  const small = plate && { thickness: plate[0], ...(ratio !== undefined && { ratio }) };
  return {
    distance: 0, seconds: 0, ...own, ...(pair && { distance: pair[0], seconds: pair[1] }), ...(charge !== undefined && { charge }), ...(small && { small_holes: small }),
  };
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
  checkFrom(word, profile);
  return profile as MachineProfile;
}

/** The shipped dialect with this name, or the document in the file with this name. */
async function dialectOf(word: string, machine: MachineProfile, { dialects }: Planner): Promise<MachineProfile['dialect']> {
  if (dialects.some((d) => d.name === word)) return word;
  if (!isFile(word)) throw unknown('dialect', word, dialects);
  const document = await json(word, 'a dialect is an object like those of kerfway/dialects.');
  if (typeof document !== 'object') throw new Unusable(`${word} holds no dialect: it is an object like those of kerfway/dialects.`);
  checkFrom(word, { ...machine, dialect: document });
  return document as Dialect;
}

const isFile = (word: string) => /[./\\]/.test(word);

async function json(word: string, remedy: string): Promise<unknown> {
  const content = await textOf(word);
  try {
    return JSON.parse(content);
  } catch {
    throw new Unusable(`${word} is not JSON: ${remedy}`);
  }
}

/** Checks a machine that comes from a file, which the name of a preset is not. */
function checkFrom(file: string, machine: unknown): void {
  try {
    checkProfile(machine);
  } catch (error) {
    throw new Unusable(`${file}: ${(error as Error).message}`, reportOf(error));
  }
}

function unknown(option: string, word: string, known: readonly { name: string }[]): WrongUse {
  return new WrongUse(`--${option} ${word}: choose one of ${known.map((k) => k.name).join(', ')}, or name a file ending in .json.`);
}
