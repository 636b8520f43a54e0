/**
 * The options of `inspect`, `plan`, `quote` and `render`: how the drawing is read and how it is planned, side by side in one
 * object, and told apart here by name.
 */

import { check, checkOne, optional, type Field, type Range, type Shape } from './check.js';
import { SHAPES } from './fields.js';
import type { Material } from './quote.js';
import type { Loaded, LoadOptions, OutputKind, PlanOptions, Progress } from './protocol.js';

/** Seconds of a search that is given neither seconds nor moves. */
export const DEFAULT_SECONDS = 10;

/** A drawing's bytes. */
export type Bytes = ArrayBuffer | Uint8Array;

/** A drawing's bytes, or what reads them when it is their turn: a pool then holds no more files than it works on. */
export type Source = Bytes | (() => Bytes | Promise<Bytes>);

/** What every job may be told. */
export interface JobOptions {
  /** The file's name, told in reports and outputs. Default `drawing.dxf`. */
  name?: string;
  /** Aborts: the promise rejects at once with the signal's reason (an `AbortError`), and nothing is kept. */
  signal?: AbortSignal;
}

/** Options of `inspect`. */
export interface InspectOptions extends LoadOptions, JobOptions {}

/** Everything that decides a plan. */
export interface PlanningOptions extends LoadOptions, PlanOptions {}

/** Options of `plan`. */
export interface PlanJobOptions<K extends OutputKind = never> extends PlanningOptions, JobOptions {
  /** Told what the drawing holds, before the search begins. */
  onLoaded?: (loaded: Loaded) => void;
  /** Told of every improvement, and four times a second without one. */
  onProgress?: (progress: Progress) => void;
  /** What is written of the finished plan, as `outputs` of the result. Default: nothing. */
  outputs?: readonly K[];
}

/** Options of `quote`. */
export interface QuoteOptions extends PlanningOptions, JobOptions {
  /** What the sheet is made of: with thickness and density the parts are weighed. */
  material?: Material;
  /** Told of every improvement, and four times a second without one. */
  onProgress?: (progress: Progress) => void;
}

/** Options of `render`. */
export interface RenderOptions {
  /** Of a PNG, pixels across. Default 1600. */
  width?: number;
  /** Aborts, as in `JobOptions`. */
  signal?: AbortSignal;
}

const { reading: READING, planning: PLANNING, material: MATERIAL } = SHAPES;

const shapeOf = (owner: string, ...fields: Field[]): Shape => ({ owner, item: 'option', value: 'The option', fields });

/** The place of a worker among others is not for callers. */
const PLANNING_OPTIONS = PLANNING.fields.filter(({ name }) => name !== 'member');
const JOB = [optional('name', 'text'), optional('signal', 'signal')];
/** What a plan can be written as. */
export const OUTPUTS: readonly OutputKind[] = ['gcode', 'svg', 'dxf', 'json', 'png'];
/** Pixels across a picture. */
const WIDTH: Range = { least: 64, most: 8192, or_zero: false, unit: 'pixels', why: 'smaller ones show nothing, larger ones take a gigabyte' };

/** What each function may be told. */
const KNOWN = {
  load: READING,
  reload: READING,
  continue: shapeOf('A budget', ...PLANNING.fields.filter(({ name }) => name === 'seconds' || name === 'moves')),
  inspect: shapeOf('inspect', ...READING.fields, ...JOB),
  plan: shapeOf('plan', ...READING.fields, ...PLANNING_OPTIONS, ...JOB,
    optional('onLoaded', 'callback'), optional('onProgress', 'callback'), optional('outputs', { list: { choice: OUTPUTS } })),
  quote: shapeOf('quote', ...READING.fields, ...PLANNING_OPTIONS, ...JOB,
    optional('material', { object: MATERIAL.fields }), optional('onProgress', 'callback')),
  render: shapeOf('render', optional('width', { whole: WIDTH }), optional('signal', 'signal')),
  planning: shapeOf('Planning', ...PLANNING_OPTIONS),
  readingAndPlanning: shapeOf('Planning', ...READING.fields, ...PLANNING_OPTIONS),
  material: MATERIAL,
} satisfies Record<string, Shape>;

/** The options of reading among those of a job. */
export function reading(options: LoadOptions): LoadOptions {
  return picked(options, READING.fields);
}

/** The options of planning among those of a job. */
export function planning(options: PlanOptions): PlanOptions {
  return picked(options, PLANNING_OPTIONS);
}

/** Throws one sentence unless these are options that the function knows, each of its kind and in its range. */
export function checkOptions(options: object, kind: keyof typeof KNOWN): void {
  check(KNOWN[kind], options);
}

/** Throws one sentence unless this is a machine profile, or the name of a machine. */
export function checkMachine(machine: unknown): void {
  check(KNOWN.planning, { machine });
}

/** Throws one sentence unless this is what a plan can be written as, so wide. */
export function checkOutput(kind: unknown, width: unknown): void {
  checkOne('The option', 'kind', { choice: OUTPUTS }, kind);
  checkOptions({ width }, 'render');
}

/** Throws one sentence unless these are the bytes of a file and its name. */
export function checkFile(bytes: unknown, name: unknown): void {
  // By their tag: a buffer may come from another frame or context.
  const is = Object.prototype.toString.call(bytes);
  if (is !== '[object ArrayBuffer]' && is !== '[object SharedArrayBuffer]' && !ArrayBuffer.isView(bytes)) {
    throw new TypeError('The drawing is not given as bytes. Give an ArrayBuffer or a Uint8Array.');
  }
  checkOne('The option', 'name', 'text', name);
}

function picked<T extends object>(options: T, fields: readonly Field[]): T {
  return Object.fromEntries(Object.entries(options).filter(([name]) => fields.some((f) => f.name === name))) as T;
}
