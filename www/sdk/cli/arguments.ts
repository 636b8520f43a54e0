/** Parses the arguments of a command. Wrong usage is refused with a sentence that says what would be right. */

import { parseArgs } from 'node:util';
import { ANCHORS, pointOf } from '../anchors.js';
import { nearest } from '../check.js';
import { CORNER_KINDS } from '../corners.js';
import { checkOptions } from '../options.js';
import { LEAD_KINDS } from '../leads.js';
import type { ContourChoice, LayerChoice, LoadOptions, MachineProfile, Operation, Place, PlanOptions } from '../protocol.js';
import { checkedAsWritten } from './as-written.js';
import { optionsOf } from './commands.js';
import { chosenOnce, namedOnce } from './given-once.js';
import { WrongUse } from './io.js';
import { COMMON_CUTS, GROUPS, OPERATIONS, PASS_ORDERS, STARTS, TURNS, UNITS } from './option-groups.js';
import { lookAt } from './target.js';

type Values = Record<string, string | boolean | string[] | undefined>;

/** Parsed arguments: files or patterns, and options. */
export interface Words {
  words: string[];
  values: Values;
}

/** Parses the arguments of a command, of which at least one is not an option. */
export function parsed(command: string, args: string[], what = 'a DXF or SVG file'): Words {
  const given = words(command, args);
  if (given.words.length === 0) throw new WrongUse(`Name ${what}.`);
  return given;
}

/** Parses the arguments of a command that has options only. */
export function parsedOptions(command: string, args: string[]): Words {
  const given = words(command, args);
  const [word] = given.words;
  if (word !== undefined) throw new WrongUse(`${command} takes options only, not ${word}.`);
  return given;
}

function words(command: string, args: string[]): Words {
  const options = Object.fromEntries(
    Object.entries(optionsOf(command)).map(([name, { value, repeat }]) => [
      name,
      { type: value === undefined ? ('boolean' as const) : ('string' as const), multiple: repeat === true },
    ]),
  );
  try {
    const { values, positionals, tokens } = parseArgs({ args, options, allowPositionals: true, strict: true, tokens: true });
    namedOnce(tokens, new Set(Object.entries(optionsOf(command)).flatMap(([name, { value }]) => (value === 'OUT' ? [name] : []))));
    // A variable of a shell that is not set.
    if (positionals.includes('')) throw new WrongUse('The name of a file is empty.');
    const [empty] = Object.entries(values).find(([, value]) => [value].flat().includes('')) ?? [];
    if (empty !== undefined) throw new WrongUse(`--${empty} needs a value.`);
    return { words: positionals, values: values as Values };
  } catch (error) {
    if (error instanceof WrongUse) throw error;
    const { code, message } = error as NodeJS.ErrnoException;
    const name = /'(-[^\s']+)/.exec(message)?.[1] ?? 'An option';
    if (code === 'ERR_PARSE_ARGS_UNKNOWN_OPTION') {
      const file = args.find((word) => word.startsWith(name) && lookAt(word) !== null);
      throw new WrongUse(`kerfway ${command} has no option ${name}.${file === undefined ? meant(name, Object.keys(options)) : ` The file of this name is written ./${file}.`}`);
    }
    if (options[name.slice(2)]?.type === 'boolean') throw new WrongUse(`${name} takes no value.`);
    const next = args[args.indexOf(name) + 1];
    throw new WrongUse(`${name} needs a value.${next !== undefined && /^-[\d.]/.test(next) ? ` A negative one is written ${name}=${next}.` : ''}`);
  }
}

const beforeEquals = (word: string) => word.slice(0, word.indexOf('='));

function meant(name: string, known: readonly string[]): string {
  const near = nearest(name, known.map((option) => `--${option}`));
  return near === null ? '' : ` Did you mean ${near}?`;
}

/** The argument of a command that takes exactly one. */
export function oneWord({ words: [word = '', second] }: Words): string {
  if (second !== undefined) throw new WrongUse(`Only one is allowed: ${second} is one too many.`);
  return word;
}

/** Options of distances, with the names that the API has for them. */
const TOLERANCES = [['join-tolerance', 'joinTolerance'], ['curve-tolerance', 'tolerance'], ['copy-tolerance', 'copyTolerance']] as const;

export function loadOptions(values: Values): LoadOptions {
  const options: LoadOptions = {};
  const units = text(values, 'units');
  if (units !== undefined) options.units = oneOf('--units', units, UNITS);
  const dpi = positive(values, 'dpi');
  if (dpi !== undefined) options.dpi = dpi;
  for (const [name, option] of TOLERANCES) {
    const tolerance = number(values, name);
    if (tolerance !== undefined) options[option] = tolerance;
  }
  const layers = (values['layer'] as string[] | undefined) ?? [];
  if (layers.length > 0) options.layers = layers.map(layerChoice);
  chosenOnce('layer', layers, (word) => layerChoice(word).name);
  const groups = (values['group'] as string[] | undefined) ?? [];
  chosenOnce('group', groups, beforeEquals);
  if (groups.length > 0) {
    options.groups = groups.map((word) => {
      const { name, operation } = choice('--group', word);
      return { name: oneOf('--group', name, GROUPS), operation };
    });
  }
  if (values['keep-border'] === true && values['ignore-border'] === true) throw new WrongUse('--keep-border and --ignore-border: the border is cut or it is not. Give one of them.');
  if (values['keep-border'] === true) options.keepBorder = true;
  if (values['ignore-border'] === true) options.ignoreOutline = true;
  const turn = text(values, 'turn');
  if (turn !== undefined) options.turn = Number(oneOf('--turn', turn, TURNS));
  const passes = text(values, 'pass-order');
  if (passes !== undefined) options.passOrder = oneOf('--pass-order', passes, PASS_ORDERS);
  if (values['order-by-layer'] === true) options.orderByLayer = true;
  if (values['part-by-part'] === true) options.partByPart = true;
  const common = text(values, 'common-cuts');
  if (common !== undefined) options.commonCuts = oneOf('--common-cuts', common, COMMON_CUTS);
  for (const list of ['first', 'last', 'exclude', 'mark'] as const) {
    const contours = (values[list] as string[] | undefined) ?? [];
    if (contours.length > 0) options[list] = contours.map((word) => wholeNumber(list, word));
  }
  for (const [one, other] of [['first', 'last'], ['exclude', 'mark']] as const) {
    const both = options[one]?.find((contour) => options[other]?.includes(contour));
    if (both !== undefined) throw new WrongUse(`--${one} ${both} and --${other} ${both}: a contour cannot be both. Give one of them.`);
  }
  for (const [name, list] of [['sequence', 'sequences'], ['together', 'together']] as const) {
    const lists = (values[name] as string[] | undefined) ?? [];
    if (lists.length > 0) options[list] = lists.map((given) => given.split(',').map((word) => wholeNumber(name, word, given)));
  }
  const joints = (values['joint-at'] as string[] | undefined) ?? [];
  if (joints.length > 0) options.joints = joints.map(jointChoice);
  const choices = contourChoices(values);
  if (choices.length > 0) options.contours = choices;
  return checkedAsWritten(values, () => (checkOptions(options, 'load'), options));
}

/** `ID=N` and `ID=KIND`: what is decided for single contours. */
function contourChoices(values: Values): ContourChoice[] {
  const choices = new Map<number, ContourChoice>();
  const take = (option: string, word: string, choice: (value: string) => Partial<ContourChoice>) => {
    const [id = '', value = '', more] = word.split('=');
    if (value === '' || more !== undefined) throw new WrongUse(`--${option} ${word}: give the id of a contour and a value, as 3=${{ 'lead-of': 'arc', 'corners-of': 'loop' }[option] ?? '2'}.`);
    const contour = wholeNumber(option, id, word);
    choices.set(contour, { ...choices.get(contour), contour, ...choice(value) });
  };
  for (const option of ['joints-of', 'corners-of', 'lead-of']) chosenOnce(option, (values[option] as string[] | undefined) ?? [], beforeEquals);
  for (const word of (values['joints-of'] as string[] | undefined) ?? []) take('joints-of', word, (value) => ({ joints: wholeNumber('joints-of', value, word) }));
  for (const word of (values['corners-of'] as string[] | undefined) ?? []) take('corners-of', word, (value) => ({ corners: oneOf('--corners-of', value, CORNER_KINDS) }));
  for (const word of (values['lead-of'] as string[] | undefined) ?? []) take('lead-of', word, (value) => ({ lead: oneOf('--lead-of', value, [...LEAD_KINDS, 'center'] as const) }));
  return [...choices.values()];
}

/** `ID@SHARE`: a contour, and the place of a joint on it. */
function jointChoice(word: string): { contour: number; at: number } {
  const [id = '', share = '', more] = word.split('@');
  const at = share.trim() === '' ? NaN : Number(share);
  if (more !== undefined || !(at >= 0 && at <= 1)) throw new WrongUse(`--joint-at ${word}: give the id of a contour and a share of its length from 0 to 1, as 3@0.25.`);
  return { contour: wholeNumber('joint-at', id, word), at };
}

/** Where the job lies on the bed. */
export function placingOptions(values: Values, machine: MachineProfile): PlanOptions {
  const options: PlanOptions = {};
  const place = text(values, 'place');
  if (place !== undefined) options.place = placeOf(place, machine);
  const start = text(values, 'start');
  if (start !== undefined) options.start = oneOf('--start', start, STARTS);
  if (values['allow-off-bed'] === true) options.allowOffBed = true;
  return checkedAsWritten(values, () => (checkOptions(options, 'planning'), options));
}

/** `POINT@PLACE`: each is a named point or coordinates. */
function placeOf(word: string, { name, bed }: MachineProfile): Place {
  const [from = '', to = '', ...rest] = word.split('@');
  const wrong = () => new WrongUse(`--place ${word}: write POINT@PLACE, for example lower-left@10,10. Points are ${ANCHORS.join(', ')}, or X,Y in mm.`);
  const [source, target] = [pointNamed(from), pointNamed(to)];
  if (source === null || target === null || rest.length > 0) throw wrong();
  if (typeof target === 'string' && !bed) throw new WrongUse(`--place ${word}: the machine ${name} has no bed. Give the place as X,Y in mm.`);
  const at = typeof target === 'string' ? pointOf(target, bed as [number, number, number, number]) : target;
  return typeof source === 'string' ? { point: source, at } : { from: source, at };
}

function pointNamed(word: string): (typeof ANCHORS)[number] | [number, number] | null {
  const anchor = ANCHORS.find((a) => a === word);
  if (anchor !== undefined) return anchor;
  const numbers = word.split(',').map((n) => (n.trim() === '' ? NaN : Number(n)));
  return numbers.length === 2 && numbers.every(Number.isFinite) ? [numbers[0]!, numbers[1]!] : null;
}

function choice(option: string, word: string): { name: string; operation: Operation } {
  const at = word.lastIndexOf('=');
  if (at < 1) throw new WrongUse(`${option} ${word}: write NAME=cut, NAME=mark or NAME=ignore.`);
  return { name: word.slice(0, at), operation: oneOf(option, word.slice(at + 1), OPERATIONS) };
}

/** The settings of a layer as they are written, with the field of each. */
const SETTINGS = { speed: 'speed', power: 'power', 'min-power': 'minPower', passes: 'passes', 'z-step': 'zStep' } as const;

/** The name may contain anything, so what follows it is looked for from the end. */
const LAYER = new RegExp(`^(.+)=(${OPERATIONS.join('|')})((?:,[\\w-]+=[^,=]*)*)$`, 's');

/** `NAME=cut,speed=20,passes=2`: the name may contain equals signs and commas, so the operation is looked for from the end. */
function layerChoice(word: string): LayerChoice {
  const found = LAYER.exec(word) ?? /^(.+)=(\w+)()$/s.exec(word);
  if (found === null) throw new WrongUse(`--layer ${word}: write NAME=cut, NAME=mark or NAME=ignore, and settings after commas: NAME=cut,speed=20,passes=2.`);
  const [, name = '', operation = '', rest = ''] = found;
  const layer: LayerChoice = { name, operation: oneOf(`--layer ${name}:`, operation, OPERATIONS) };
  for (const pair of rest.split(',').slice(1)) {
    const [key = '', value = ''] = pair.split('=');
    const setting = oneOf(`--layer ${word}: setting`, key, [...(Object.keys(SETTINGS) as (keyof typeof SETTINGS)[]), 'air']);
    if (layer[setting === 'air' ? setting : SETTINGS[setting]] !== undefined) throw new WrongUse(`--layer ${word}: ${key} is given twice.`);
    if (setting === 'air') layer.air = oneOf(`--layer ${word}: air`, value, ['on', 'off']) === 'on';
    else layer[SETTINGS[setting]] = numberOf(word, key, value);
  }
  return layer;
}

function numberOf(word: string, key: string, value: string): number {
  const n = value.trim() === '' ? NaN : Number(value);
  if (!Number.isFinite(n)) throw new WrongUse(`--layer ${word}: ${key} is "${value}". Give a number.`);
  return n;
}

/** The NAME=VALUE pairs of all --set: numbers, true and false are converted, any other value is text. */
export function parameters(values: Values): Record<string, unknown> | undefined {
  const given = (values['set'] as string[] | undefined) ?? [];
  chosenOnce('set', given, beforeEquals);
  const pairs = given.map((word) => {
    const at = word.indexOf('=');
    if (at < 1) throw new WrongUse(`--set ${word}: write NAME=VALUE; kerfway methods lists the names.`);
    const value = word.slice(at + 1);
    return [word.slice(0, at), valueOf(value)];
  });
  return pairs.length === 0 ? undefined : (Object.fromEntries(pairs) as Record<string, unknown>);
}

/** Leading zeros are allowed, unlike in JSON. */
function valueOf(word: string): unknown {
  if (word === 'true' || word === 'false') return word === 'true';
  return /^-?\d+(\.\d+)?(e[+-]?\d+)?$/i.test(word) ? Number(word) : word;
}

export function text(values: Values, name: string): string | undefined {
  return values[name] as string | undefined;
}

/** A whole number from 0 to the largest that JavaScript represents exactly. */
export function whole(values: Values, name: string): number | undefined {
  const word = text(values, name);
  return word === undefined ? undefined : wholeNumber(name, word);
}

/** `given`: what was given for the option, if the number is a part of it. */
function wholeNumber(name: string, word: string, given = word): number {
  const n = Number(word);
  if (!/^\d+$/.test(word) || !Number.isSafeInteger(n)) {
    const rule = given === word ? 'give a' : `"${word}" is no`;
    throw new WrongUse(`--${name} ${given}: ${rule} whole number from 0 to ${Number.MAX_SAFE_INTEGER}.`);
  }
  return n;
}

export function seconds(values: Values): number | undefined {
  const word = text(values, 'seconds');
  if (word === undefined) return undefined;
  const n = Number(word);
  if (word.trim() === '' || !Number.isFinite(n) || n < 0) {
    throw new WrongUse(`--seconds ${word}: give a number of seconds, 0 or more.`);
  }
  return n;
}

/** Any number. */
export function number(values: Values, name: string): number | undefined {
  const word = text(values, name);
  if (word === undefined) return undefined;
  const n = Number(word);
  if (word.trim() === '' || !Number.isFinite(n)) throw new WrongUse(`--${name} ${word}: give a number.`);
  return n;
}

/** A number above 0. */
export function positive(values: Values, name: string): number | undefined {
  const word = text(values, name);
  if (word === undefined) return undefined;
  const n = Number(word);
  if (word.trim() === '' || !Number.isFinite(n) || n <= 0) throw new WrongUse(`--${name} ${word}: give a number above 0.`);
  return n;
}

export function oneOf<T extends string>(what: string, word: string, choices: readonly T[]): T {
  const found = choices.find((c) => c === word);
  if (found === undefined) throw new WrongUse(`${what} ${word}: choose one of ${choices.join(', ')}.`);
  return found;
}
