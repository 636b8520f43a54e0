/**
 * The package in four functions: `inspect`, `plan`, `quote` and `render`. Each borrows a planner for one drawing; who lends it
 * (a new one for every call, or a pool) is decided elsewhere. A browser and Node differ in nothing here.
 */

import { News } from './news.js';
import { quietAtClose } from './closed.js';
import { checkOptions, planning, reading } from './options.js';
import type { InspectOptions, PlanJobOptions, PlanningOptions, QuoteOptions, RenderOptions, Source } from './options.js';
import type { Started } from './plan-handle.js';
import type { Planner } from './planner.js';
import type { Quote } from './quote.js';
import type { BestPath, DoneReason, Loaded, OutputKind, Progress, Summary } from './protocol.js';

/** Lends a planner for some work. Rejects with the reason of the signal as soon as it aborts. */
export type Lend = <T>(work: (planner: Planner) => Promise<T>, signal?: AbortSignal) => Promise<T>;

/** What was written: text, or the bytes of a picture. */
export type Outputs<K extends OutputKind> = { [Kind in K]: Kind extends 'png' ? Uint8Array : string };

/** What a plan came to. Plain data: it can be kept, sent to another thread, or rendered later. */
export interface Planned<K extends OutputKind = never> extends Started {
  reason: DoneReason;
  /** What the drawing holds. */
  loaded: Loaded;
  /** Sums of the best plan found. */
  summary: Summary;
  /** Its path. */
  path: BestPath;
  /** Moves the search did. */
  moves: number;
  /** Seconds the search took. */
  seconds: number;
  /** What was asked for in the option `outputs`. */
  outputs: Outputs<K>;
  /** How it was read and planned, as asked. */
  options: PlanningOptions;
}

/**
 * A plan under way: a promise of what it comes to, and meanwhile news for `for await`. Leaving the loop by `break`
 * stops the search, as `stop` does: the promise then resolves with the best found so far.
 */
export interface PlanRun<K extends OutputKind = never> extends Promise<Planned<K>>, AsyncIterable<Progress> {
  /** Ends the search and keeps the best found. To throw everything away, abort the signal. */
  stop(): void;
}

/** The functions, on planners that are lent. */
export interface Functions {
  /** What a drawing holds: contours, parts, layers, units, findings. Rejects with one sentence when it is unusable. */
  inspect(source: Source, options?: InspectOptions): Promise<Loaded>;
  /**
   * Plans a drawing for the seconds or moves given (10 seconds when neither is). Rejects with one sentence when the
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
   * Plans a drawing and reports what a quote needs of it. With `moves` and `seed` its hash is the same everywhere: a server
   * confirms by it what a browser said. Prices stay with the caller.
   */
  quote(source: Source, options?: QuoteOptions): Promise<Quote>;
  /**
   * Writes a finished plan of the same drawing in another form. The plan JSON, which tells of the search itself, is
   * written by `plan` only.
   */
  render<K extends Exclude<OutputKind, 'json'>>(source: Source, planned: Omit<Planned, 'outputs'>, kind: K, options?: RenderOptions): Promise<Outputs<K>[K]>;
}

const NAME = 'drawing.dxf';

export function functionsOn(lend: Lend): Functions {
  return {
    inspect(source, options = {}) {
      return quietAtClose(async () => {
        checkOptions(options, 'inspect');
        return lend(async (planner) => planner.load(await bytesOf(source), options.name ?? NAME, reading(options)), options.signal);
      });
    },

    plan(source, options = {}) {
      let stop: (() => void) | null = null;
      let stopped = false;
      const halt = () => {
        stopped = true;
        stop?.();
      };
      const news = new News(halt);
      const tell = (progress: Progress) => {
        news.tell(progress);
        return options.onProgress?.(progress);
      };
      const work = async (planner: Planner) => {
        const loaded = await planner.load(await bytesOf(source), options.name ?? NAME, reading(options));
        await options.onLoaded?.(loaded);
        const handle = planner.plan(planning(options), tell);
        stop = () => handle.stop();
        if (stopped) stop();
        const { progress, ...rest } = await handle.done;
        const { path, summary, moves, seconds } = progress;
        if (path === null) throw new Error('The plan ended before it had a path.');
        const outputs = await outputsOf(planner, options.outputs ?? []);
        return { ...rest, loaded, summary, path, moves, seconds, outputs, options: { ...reading(options), ...planning(options) } };
      };
      const run = async () => {
        try {
          checkOptions(options, 'plan');
          const planned = await lend(work, options.signal);
          news.end();
          return planned;
        } catch (error) {
          news.end({ error });
          throw error;
        }
      };
      const done = quietAtClose(run);
      return Object.assign(done, { stop: halt, [Symbol.asyncIterator]: () => read(done, news) });
    },

    quote(source, options = {}) {
      const work = async (planner: Planner) => {
        await planner.load(await bytesOf(source), options.name ?? NAME, reading(options));
        await planner.plan(planning(options), options.onProgress).done;
        return planner.quote(options.material);
      };
      return quietAtClose(async () => {
        checkOptions(options, 'quote');
        return lend(work, options.signal);
      });
    },

    render(source, planned, kind, given = {}) {
      const work = async (planner: Planner) => {
        const { options, loaded, seed, method, path } = planned;
        const again = await planner.load(await bytesOf(source), loaded.name, reading(options));
        if (again.sha256 !== loaded.sha256) throw new Error('This is not the drawing that was planned: its bytes differ.');
        const { workers: _, seconds: __, ...rest } = planning(options);
        await planner.plan({ ...rest, seed, method, warm: path, moves: 0 }).done;
        return planner.output(kind, given.width) as Promise<Outputs<typeof kind>[typeof kind]>;
      };
      return quietAtClose(async () => {
        checkOptions(given, 'render');
        return lend(work, given.signal);
      });
    },
  };
}

// Who reads the news hears of a failure there; a promise nobody waits for must then not count as unhandled.
function read(done: Promise<unknown>, news: News): AsyncIterator<Progress> {
  done.catch(() => {});
  return news[Symbol.asyncIterator]();
}

async function bytesOf(source: Source): Promise<ArrayBuffer | Uint8Array> {
  return typeof source === 'function' ? source() : source;
}

async function outputsOf<K extends OutputKind>(planner: Planner, kinds: readonly K[]): Promise<Outputs<K>> {
  const written: [K, string | Uint8Array][] = [];
  for (const kind of kinds) written.push([kind, await planner.output(kind)]);
  return Object.fromEntries(written) as Outputs<K>;
}
