/**
 * The options of `inspect`, `plan`, `quote` and `render`. Options of reading and of planning are in one object; this file
 * separates them by name and checks them.
 */

import { viewed } from './bytes.js';
import { check, checkOne, isRecord, optional, shown, type Field, type Range, type Shape } from './check.js';
import { KerfwayError, notBytes } from './errors.js';
import { SHAPES } from './fields.js';
import { copied } from './plain-data.js';
import type { QuoteTerms } from './quote.js';
import type { CheckedOn, Loaded, LoadOptions, OutputKind, PlanOptions, Progress } from './protocol.js';

/** The default budget in seconds, when neither seconds nor moves are given. */
export const DEFAULT_SECONDS = 10;

/** Options of every function that reads a drawing. */
export interface JobOptions {
  /** The file's name in reports and outputs. Default: the name of a `File`, otherwise `drawing.dxf`. */
  name?: string;
  /** Aborts the job: the promise rejects at once with the signal's reason (an `AbortError`), and nothing is kept. */
  signal?: AbortSignal;
}

/** Options of `inspect`. */
export interface InspectOptions extends LoadOptions, JobOptions {}

/** All options that affect a plan. */
export interface PlanningOptions extends LoadOptions, PlanOptions {}

/** Options of `plan`. */
export interface PlanJobOptions<K extends OutputKind = never> extends PlanningOptions, JobOptions {
  /** Called with the contents of the drawing, before the search begins. */
  onLoaded?: (loaded: Loaded) => void;
  /** Called on every improvement, and four times a second without one. */
  onProgress?: (progress: Progress) => void;
  /** The formats in which the finished plan is written, as `outputs` of the result. Default: none. */
  outputs?: readonly K[];
}

/** Options of `quote`. */
export interface QuoteOptions extends Omit<PlanningOptions, 'material'>, JobOptions, QuoteTerms {
  /** Called on every improvement, and four times a second without one. */
  onProgress?: (progress: Progress) => void;
}

/** Options of `render`. */
export interface RenderOptions {
  /** The width of a PNG in pixels. Default 1600. */
  width?: number;
  /** Aborts the job, as in `JobOptions`. */
  signal?: AbortSignal;
}

/** Options of `check`. */
export interface CheckOptions extends CheckedOn, Pick<JobOptions, 'signal'> {}

const { reading: READING, planning: PLANNING, terms: TERMS } = SHAPES;

const shapeOf = (owner: string, ...fields: Field[]): Shape => ({ owner, item: 'option', value: 'The option', fields });

/** The options of planning without `member`, which only `MultiSearch` sets. */
const PLANNING_OPTIONS = PLANNING.fields.filter(({ name }) => name !== 'member');
const JOB = [optional('name', 'text'), optional('signal', 'signal')];
/** The formats in which a plan can be written. */
export const OUTPUTS: readonly OutputKind[] = ['gcode', 'svg', 'dxf', 'json', 'png', 'lbrn2', 'rd', 'remainder'];
/** The width of a picture. */
const WIDTH: Range = { least: 64, most: 8192, or_zero: false, unit: 'pixels', why: 'smaller ones show nothing, larger ones take a gigabyte' };

/** The work of a proof. */
const WORK: Range = { least: 1, most: 1e9, or_zero: false, unit: 'million numbers', why: 'more takes years' };

/** The options of each function. */
const KNOWN = {
  load: READING,
  reload: READING,
  prove: shapeOf('A proof', ...PLANNING.fields.filter(({ name }) => name === 'seconds'), optional('work', { whole: WORK })),
  continue: shapeOf('A budget', ...PLANNING.fields.filter(({ name }) => name === 'seconds' || name === 'moves')),
  inspect: shapeOf('inspect', ...READING.fields, ...JOB),
  plan: shapeOf('plan', ...READING.fields, ...PLANNING_OPTIONS, ...JOB,
    optional('onLoaded', 'callback'), optional('onProgress', 'callback'), optional('outputs', { list: { choice: OUTPUTS } })),
  quote: shapeOf('quote', ...READING.fields, ...PLANNING_OPTIONS.filter(({ name }) => name !== 'material'), ...JOB, ...TERMS.fields, optional('onProgress', 'callback')),
  verifyQuote: shapeOf('verifyQuote', optional('signal', 'signal')),
  render: shapeOf('render', optional('width', { whole: WIDTH }), optional('signal', 'signal')),
  frameCall: shapeOf('The frame', optional('signal', 'signal')),
  checkedOn: shapeOf('check', ...PLANNING.fields.filter(({ name }) => name === 'machine')),
  sampleProgram: shapeOf('sampleProgram', ...PLANNING.fields.filter(({ name }) => name === 'machine')),
  check: shapeOf('check', ...PLANNING.fields.filter(({ name }) => name === 'machine'), optional('signal', 'signal')),
  planning: shapeOf('Planning', ...PLANNING_OPTIONS),
  readingAndPlanning: shapeOf('Planning', ...READING.fields, ...PLANNING_OPTIONS),
  terms: TERMS,
} satisfies Record<string, Shape>;

/** Selects the options of reading. */
export function reading(options: LoadOptions): LoadOptions {
  return picked(options, READING.fields);
}

/** Selects what is stated about the job of a quote. */
export function terms(options: QuoteTerms): QuoteTerms {
  return picked(options, TERMS.fields);
}

/** Selects the options of planning. */
export function planning(options: PlanOptions): PlanOptions {
  return picked(options, PLANNING_OPTIONS);
}

/** A copy of the options. Throws a `KerfwayError` unless the function knows them, and each has the right type and is in range. */
export function checkOptions<T extends object>(options: T, kind: keyof typeof KNOWN): T {
  check(KNOWN[kind], options);
  return copied(options);
}

/** Throws a `KerfwayError` unless this is a machine profile or the name of a preset. */
function checkMachine(machine: unknown): void {
  check(KNOWN.planning, { machine });
}

/** Throws a `KerfwayError` unless this is a machine profile. The name of a preset is none. */
export function checkProfile(machine: unknown): void {
  if (!isRecord(machine)) throw new KerfwayError('wrong-type', `The option "machine" is ${shown(machine)}. Give a machine profile.`, { field: 'machine' });
  checkMachine(machine);
}

/** Throws a `KerfwayError` unless this is a function that can be called back. */
export function checkCallback(name: string, callback: unknown): void {
  checkOne('The option', name, 'callback', callback);
}

/** Throws a `KerfwayError` unless these are plans that were run, with their seconds. Times that cannot be are refused where the plans are read. */
export function checkMeasured(measured: unknown): void {
  checkOne('The option', 'measured', { list: 'any' }, measured);
  const wrong = (measured as unknown[]).findIndex((job) => !isRecord(job) || typeof job['plan'] !== 'string' || typeof job['seconds'] !== 'number');
  if (wrong < 0) return;
  const field = `measured[${wrong}]`;
  throw new KerfwayError('wrong-type', `The option "${field}" is not a plan that was run. Give an object with the plan, as text, and its seconds.`, { field });
}

/** Throws a `KerfwayError` unless this is an output format, and a width that a picture can have. */
export function checkOutput(kind: unknown, width: unknown): void {
  checkOne('The option', 'kind', { choice: OUTPUTS }, kind);
  checkOptions({ width }, 'render');
}

/** Throws a `KerfwayError` unless this is a format that a finished plan can still be written in: as JSON it is written when it is planned. */
export function checkRendered(kind: unknown): void {
  checkOne('The option', 'kind', { choice: OUTPUTS.filter((k) => k !== 'json') }, kind);
}

/** Throws a `KerfwayError` unless this is the text of a program, or nothing. */
export function checkProgram(program: unknown): void {
  if (program !== null && typeof program !== 'string') throw new KerfwayError('wrong-type', 'The program is not given as text. Give a string, or the bytes of a file.', { field: 'program' });
}

/** Where planners run and where their files are, as `createPlanner`, `createPool` and `configure` get it. */
const PLACES = [optional('worker', 'flag'), optional('locate', 'callback'), optional('wasmUrl', 'address'), optional('workerUrl', 'address'),
  optional('wasm', 'any'), optional('outputsWasm', 'any'), optional('onReplaced', 'callback')];
const PLANNER = shapeOf('The planner', ...PLACES);
/** The numbers of a pool are checked where it is made. */
const POOL = shapeOf('The pool', optional('size', 'any'), optional('queue', 'any'), optional('deadline', 'any'), ...PLACES);

/** Throws a `KerfwayError` unless these say where a planner runs, and how large a pool is. */
export function checkPlaces(options: object, isPool = false): void {
  check(isPool ? POOL : PLANNER, options);
}

/** The bytes of a file. Throws a `TypeError` for anything else, and a `KerfwayError` unless its name is a text. */
export function checkFile(bytes: unknown, name: unknown): ArrayBuffer | Uint8Array {
  const read = viewed(bytes);
  if (read === null) throw notBytes();
  checkOne('The option', 'name', 'text', name);
  return read;
}

/** The options among these fields. What is given as undefined is not given: it must not hide a default. */
function picked<T extends object>(options: T, fields: readonly Field[]): T {
  const isGiven = ([name, value]: [string, unknown]) => value !== undefined && fields.some((f) => f.name === name);
  return Object.fromEntries(Object.entries(options).filter(isGiven)) as T;
}

/** The options without those that are `undefined`: the planner takes an option for given if its name is there. */
export function given<T extends object>(options: T): T {
  return Object.fromEntries(Object.entries(options ?? {}).filter(([, value]) => value !== undefined)) as T;
}
