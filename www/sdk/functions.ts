/**
 * The functions of the package: `inspect`, `plan`, `quote`, `verifyQuote`, `render` and `check`. Each uses a planner for one drawing. A
 * `WithPlanner` provides it: a new one for every call, or one of a pool. Browsers and Node share this code.
 */

import { quietAtClose } from './closed.js';
import { stopIfRefusedOffBed } from './doubt.js';
import { KerfwayError, reportOf } from './errors.js';
import { checkOptions, checkProgram, checkRendered, DEFAULT_SECONDS, planning, reading, terms } from './options.js';
import { readBytes, type Bytes, type Source } from './bytes.js';
import type { CheckOptions, InspectOptions, JobOptions, PlanJobOptions, PlanningOptions, QuoteOptions, RenderOptions } from './options.js';
import type { Started } from './plan-handle.js';
import type { Planner } from './planner.js';
import { ProgressStream } from './progress-stream.js';
import type { Material, Quote, QuoteTerms } from './quote.js';
import { quoteBudget } from './quote-budget.js';
import { compared, optionsOf, planningOf, termsOf, type Verification } from './verify-quote.js';
import { asJson, isPlanned, withWarmPath } from './plain-data.js';
import type { BestPath, BinaryKind, DoneReason, Loaded, LoadOptions, MachineProfile, OutputKind, PlanOptions, ProgramCheck, Progress, Summary } from './protocol.js';

/**
 * Runs some work on a planner. Rejects with the reason of the signal as soon as it aborts. `seconds` is the budget of the
 * search in the work, which a deadline grants in addition.
 */
export type WithPlanner = <T>(work: (planner: Planner) => Promise<T>, signal?: AbortSignal, seconds?: number) => Promise<T>;

/** The outputs by kind: text, or bytes. */
export type Outputs<K extends OutputKind> = { [Kind in K]: Kind extends BinaryKind ? Uint8Array : string };

/**
 * The result of a plan. It is plain data: it can be stored, sent to another thread, or rendered later. `JSON.stringify` writes
 * its typed arrays as arrays, and `render` takes what `JSON.parse` makes of that.
 */
export interface Planned<K extends OutputKind = never> extends Started {
  /** Why the search ended. */
  reason: DoneReason;
  /** The contents of the drawing. */
  loaded: Loaded;
  /** Times and lengths of the best plan. */
  summary: Summary;
  /** The path of the best plan. */
  path: BestPath;
  /** Number of moves that the search made. */
  moves: number;
  /** Seconds that the search took. */
  seconds: number;
  /** The outputs that the option `outputs` requested. */
  outputs: Outputs<K>;
  /** The options of reading and planning that were given. */
  options: PlanningOptions;
}

/**
 * A running plan: a promise of its result, and until then an iterable of its progress for `for await`. Leaving the loop
 * with `break` stops the search, as `stop` does: the promise then resolves with the best plan found so far.
 */
export interface PlanRun<K extends OutputKind = never> extends Promise<Planned<K>>, AsyncIterable<Progress> {
  /** Ends the search and keeps the best plan. To discard everything, abort the signal. */
  stop(): void;
}

/** The functions of the package, which a pool has too. */
export interface Functions {
  /** Describes a drawing: contours, parts, layers, units, findings. Rejects with a `KerfwayError` when it is unusable. */
  inspect(source: Source, options?: InspectOptions): Promise<Loaded>;
  /**
   * Plans a drawing within a budget of seconds or moves (10 seconds by default). Rejects with a `KerfwayError` when the
   * drawing or an option is unusable, and with the signal's reason when it aborts.
   *
   *     const { summary, outputs } = await plan(bytes, { machine: 'co2-100w', seconds: 5, outputs: ['gcode'] });
   *
   *     const run = plan(bytes, { seconds: 60 });
   *     for await (const { summary } of run) if (summary.gap !== null && summary.gap < 0.01) break;
   *     const { path } = await run;
   */
  plan<K extends OutputKind = never>(source: Source, options?: PlanJobOptions<K>): PlanRun<K>;
  /**
   * Plans a drawing and reports what a quote needs. By default the number of moves grows with the contours and the seed is 1.
   * Then, and with `moves` and `seed` given, the hash of the report is the same everywhere, so a server can confirm the
   * report of a browser. The report has no prices: those are up to the caller.
   */
  quote(source: Source, options?: QuoteOptions): Promise<Quote>;
  /**
   * Confirms a report that somebody else has made: plans the drawing again as the report says, and compares every field. Rejects
   * with a `KerfwayError` when it is no report, or asks for far more moves than a quote of this drawing takes.
   */
  verifyQuote(source: Source, report: Quote, options?: Pick<JobOptions, 'signal'>): Promise<Verification>;
  /**
   * Writes a finished plan of the same drawing in another format. The plan JSON describes the search itself and is
   * written by `plan` only.
   */
  render<K extends Exclude<OutputKind, 'json'>>(source: Source, planned: Omit<Planned, 'outputs'>, kind: K, options?: RenderOptions): Promise<Outputs<K>[K]>;
  /**
   * Reads a G-code program back by the rules of a machine's dialect: does it fit the bed, is each contour cut once, is the beam off
   * on every rapid, and how long does it take. Programs of others can be checked too.
   *
   *     const { passed, problems } = await check(text, { machine: 'co2-100w' });
   */
  check(program: string | Bytes, options?: CheckOptions): Promise<ProgramCheck>;
}

/** Name of a drawing that is given without one. */
const NAME = 'drawing.dxf';

/** The budget of a drawing for which neither seconds nor moves are given; without one, the planner's own default. */
export type DefaultBudget = (loaded: Loaded) => PlanningOptions;

/** `quote` as the service calls it, with a default budget of its own. */
export type QuoteWithin = (source: Source, options: QuoteOptions, ownBudget: DefaultBudget) => Promise<Quote>;

export function createFunctions(withPlanner: WithPlanner, defaultBudget: DefaultBudget = () => ({})): Functions {
  return {
    inspect(source, options = {}) {
      return quietAtClose(async () => {
        const own = checkOptions(options, 'inspect');
        return withPlanner((planner) => loadedBy(planner, source, own), own.signal);
      });
    },

    plan<K extends OutputKind = never>(source: Source, given: PlanJobOptions<K> = {}) {
      let options = given;
      let stop: (() => void) | null = null;
      let stopped = false;
      const stopSearch = () => {
        stopped = true;
        stop?.();
      };
      const stream = new ProgressStream(stopSearch);
      const report = (progress: Progress) => {
        stream.push(progress);
        return options.onProgress?.(progress);
      };
      const work = async (planner: Planner) => {
        const loaded = await loadedBy(planner, source, options);
        await options.onLoaded?.(loaded);
        options.signal?.throwIfAborted();
        const search = budgeted(options, loaded, defaultBudget);
        const handle = planner.plan(search, report);
        stop = () => handle.stop();
        if (stopped) stop();
        await stopIfRefusedOffBed(handle, options.outputs ?? [], options);
        const { progress, ...rest } = await handle.done;
        const { path, summary, moves, seconds } = progress;
        if (path === null) throw new KerfwayError('planner-died', 'The plan ended before it had a path.');
        const outputs = await outputsOf(planner, options.outputs ?? []);
        return asJson({ ...rest, loaded, summary, path, moves, seconds, outputs, options: { ...reading(options), ...search } });
      };
      const run = async () => {
        try {
          options = checkOptions(withWarmPath(given), 'plan');
          const byDefault = options.moves === undefined ? DEFAULT_SECONDS : 0;
          const planned = await withPlanner(work, options.signal, options.seconds ?? byDefault);
          stream.end();
          return planned;
        } catch (error) {
          stream.end({ error });
          throw error;
        }
      };
      const done = quietAtClose(run);
      return Object.assign(done, { stop: stopSearch, [Symbol.asyncIterator]: () => read(done, stream) });
    },

    quote(source: Source, given: QuoteOptions = {}, ownBudget: DefaultBudget = quoteBudget) {
      let options = given;
      const work = async (planner: Planner) => {
        const loaded = await loadedBy(planner, source, options);
        const { material, ...rest } = options;
        const setting = settingFor(material, options.machine, planner.machines);
        return reported(planner, budgeted({ ...rest, ...setting }, loaded, ownBudget), terms(options), options.onProgress);
      };
      return quietAtClose(async () => {
        options = checkOptions(withWarmPath(given), 'quote');
        return withPlanner(work, options.signal, options.seconds);
      });
    },

    verifyQuote(source, report, given = {}) {
      let options = given;
      let made: ReturnType<typeof optionsOf>;
      const work = async (planner: Planner): Promise<Verification> => {
        const loaded = await loadedBy(planner, source, { ...made.reading, ...options, name: String(made.quote.input.name) });
        if (loaded.sha256 !== made.quote.input.sha256) return { valid: false, differences: ['input'], report: null };
        return compared(made.quote, await reported(planner, planningOf(made.quote, loaded), termsOf(made.quote)));
      };
      return quietAtClose(async () => {
        options = checkOptions(given, 'verifyQuote');
        // Before its turn comes: what is no report needs no planner.
        made = optionsOf(report);
        return withPlanner(work, options.signal);
      });
    },

    check(program, options = {}) {
      return quietAtClose(async () => {
        const { signal, ...on } = checkOptions(options, 'check');
        const text = typeof program === 'string' ? program : new TextDecoder().decode((await readBytes(program).catch(asProgram)).bytes);
        return withPlanner((planner) => planner.check(text, on), signal);
      });
    },

    render(source, planned, kind, given = {}) {
      let own = given;
      const work = async (planner: Planner) => {
        const { options, loaded, seed, method, path } = planned;
        const again = await loadedBy(planner, source, { ...reading(options), signal: own.signal, name: loaded.name });
        if (again.sha256 !== loaded.sha256) throw new KerfwayError('other-drawing', 'This is not the drawing that was planned: its bytes differ.');
        const { workers: _, seconds: __, ...rest } = planning(options);
        await planner.plan({ ...rest, seed, method, warm: path, moves: 0 }).done;
        return planner.output(kind, own.width) as Promise<Outputs<typeof kind>[typeof kind]>;
      };
      return quietAtClose(async () => {
        own = checkOptions(given, 'render');
        checkRendered(kind);
        if (!isPlanned(planned)) throw new KerfwayError('wrong-type', 'This is no finished plan: give the result of plan, or what JSON.parse makes of its JSON.', { field: 'planned' });
        return withPlanner(work, own.signal);
      });
    },
  };
}

// A reader gets a failure from the stream, so the promise, which it need not await, must not count as unhandled.
function read(done: Promise<unknown>, stream: ProgressStream): AsyncIterator<Progress> {
  done.catch(() => {});
  return stream[Symbol.asyncIterator]();
}

/** The material to plan with: the one a quote names, if the machine has a library. Without one, its own setting is used, and the report says so. */
export function settingFor(material: Material | undefined, machine: PlanOptions['machine'], presets: readonly MachineProfile[]): Pick<PlanOptions, 'material'> {
  const name = material?.name;
  const profile = typeof machine === 'object' ? machine : presets.find((m) => m.name === (machine ?? presets[0]?.name));
  return name && profile?.materials?.length ? { material: name } : {};
}

/**
 * The report of a plan. Fails if the worker died: the one that took its place has the path but not the search, so nobody could make its report
 * again.
 */
async function reported(planner: Planner, options: PlanOptions, about: QuoteTerms, onProgress?: (progress: Progress) => void): Promise<Quote> {
  await planner.plan(options, onProgress).done;
  const report = await planner.quote(about);
  if (planner.replaced !== null) throw new KerfwayError('planner-died', planner.replaced);
  return report;
}

/** The options of a search with the default budget where none is given. */
export function budgeted(options: PlanningOptions, loaded: Loaded, defaultBudget: DefaultBudget = () => ({})): PlanningOptions {
  const isFree = options.moves === undefined && options.seconds === undefined;
  return { ...(isFree ? defaultBudget(loaded) : {}), ...planning(options) };
}

/** The same error about a program, which may be a text as well. */
function asProgram(error: unknown): never {
  if (reportOf(error).code === 'not-bytes') checkProgram(undefined);
  throw error;
}

// A job may share its planner with the next one. Once it is aborted, it must not load or plan anything more.
async function loadedBy(planner: Planner, source: Source, options: LoadOptions & Pick<JobOptions, 'name' | 'signal'>): Promise<Loaded> {
  const { bytes, name } = await readBytes(source);
  options.signal?.throwIfAborted();
  const loaded = await planner.load(bytes, options.name ?? name ?? NAME, reading(options));
  options.signal?.throwIfAborted();
  return loaded;
}

async function outputsOf<K extends OutputKind>(planner: Planner, kinds: readonly K[]): Promise<Outputs<K>> {
  const written: [K, string | Uint8Array][] = [];
  for (const kind of kinds) written.push([kind, await planner.output(kind)]);
  return Object.fromEntries(written) as Outputs<K>;
}
