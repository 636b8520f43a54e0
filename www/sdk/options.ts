/**
 * The options of `inspect`, `plan`, `quote` and `render`: how the drawing is read and how it is planned, side by side in one
 * object, and told apart here by name.
 */

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

const READING: Record<keyof LoadOptions, true> = {
  units: true, tolerance: true, keepDamaged: true, joinTolerance: true, layers: true, orderByLayer: true,
  ignoreOutline: true, partByPart: true, commonCuts: true, first: true, last: true, exclude: true,
};

const PLANNING: Record<keyof PlanOptions, true> = {
  machine: true, method: true, parameters: true, seed: true, warm: true, workers: true, seconds: true, moves: true,
};

const JOB: Record<keyof JobOptions, true> = { name: true, signal: true };

/** The names each function knows. */
const KNOWN = {
  inspect: { ...READING, ...JOB } satisfies Record<keyof InspectOptions, true>,
  plan: { ...READING, ...PLANNING, ...JOB, onLoaded: true, onProgress: true, outputs: true } satisfies Record<keyof PlanJobOptions, true>,
  quote: { ...READING, ...PLANNING, ...JOB, material: true, onProgress: true } satisfies Record<keyof QuoteOptions, true>,
};

/** The options of reading among those of a job. */
export function reading(options: LoadOptions): LoadOptions {
  return picked(options, READING);
}

/** The options of planning among those of a job. */
export function planning(options: PlanOptions): PlanOptions {
  return picked(options, PLANNING);
}

/** Refuses names that are no option, in one sentence: a misspelt one would be left out without a word. */
export function checkNames(options: object, kind: keyof typeof KNOWN): void {
  const known = KNOWN[kind];
  const strange = Object.keys(options).find((name) => !Object.hasOwn(known, name));
  if (strange !== undefined) throw new TypeError(`${kind} has no option ${strange}: there are ${Object.keys(known).join(', ')}.`);
}

function picked<T extends object>(options: T, names: Record<keyof T, true>): T {
  return Object.fromEntries(Object.entries(options).filter(([name]) => Object.hasOwn(names, name))) as T;
}
