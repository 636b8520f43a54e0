/**
 * The worker's side of the protocol: one drawing, one plan at a time. It knows neither Web Workers nor worker threads;
 * a `Host` sends its messages and finds the PNG renderer.
 */

import { initSync, Job, machines, methods } from './pkg/kerfway.js';
import { DEFAULT_SECONDS } from './options.js';
import type { FromWorker, LoadOptions, Membership, OutputKind, PlanOptions, ToWorker } from './protocol.js';
import type { Material } from './quote.js';
import { Search } from './search.js';

/** What a session needs of the place it runs in. */
export interface Host {
  post(message: FromWorker, transfer?: ArrayBuffer[]): void;
  /** The wasm file that proves bounds, loaded when first asked for. */
  lab(): Promise<typeof import('./pkg/kerfway_lab.js')>;
  /** The methods of papers, loaded when first asked for. */
  papers(): Promise<typeof import('./pkg/kerfway_papers.js')>;
  /** The planner that knows pierce groups and the kerf, loaded when a sheet may have some, or the machine has one. */
  plate(): Promise<typeof import('./pkg/kerfway_plate.js')>;
  /** What makes quotes, loaded when first asked for. */
  quote(): Promise<typeof import('./pkg/kerfway_quote.js')>;
  /** The PNG renderer, loaded when first asked for: plan JSON and width in pixels to a picture. */
  png(): Promise<(planJson: string, width: number) => Uint8Array>;
}

/** Pixels across when nobody says how wide a picture should be. */
const PNG_WIDTH = 1600;

/** Answers messages, each `load`, `plan` and `output` with one final message of the same id. */
export class Session {
  private job: Job | null = null;
  private search: Search | null = null;
  /** What was loaded, for the planner that knows pierce groups; `null` when it has taken over. */
  private source: { bytes: Uint8Array; name: string; options: LoadOptions } | null = null;
  /** Open cuts may be what is left of contours that share a side with others. */
  private openCuts = false;
  /** What comes in while that planner is loaded. */
  private held: ToWorker[] | null = null;

  constructor(private readonly host: Host) {}

  receive(message: ToWorker): void {
    if (this.held !== null) {
      this.held.push(message);
      return;
    }
    try {
      this.answer(message);
    } catch (error) {
      this.fail('id' in message ? message.id : -1, error);
    }
  }

  private answer(message: ToWorker): void {
    switch (message.type) {
      case 'init':
        initSync({ module: message.planner });
        this.host.post({ type: 'ready', methods: methods(), machines: machines() });
        return;
      case 'load':
        this.search?.stop();
        this.search = null;
        this.job?.free();
        this.job = null;
        this.source = { bytes: new Uint8Array(message.bytes), name: message.name, options: given(message.options) };
        this.job = new Job(this.source.bytes, message.name, this.source.options);
        this.tellLoaded(message.id);
        return;
      case 'reload':
        this.search?.stop();
        this.search = null;
        this.loaded().reload(given(message.options));
        if (this.source !== null) this.source.options = given(message.options);
        this.tellLoaded(message.id);
        return;
      case 'plan':
        this.search?.stop();
        this.search = null;
        if (this.asksForPlate(message.options)) void this.planAsPlate(message.id, message.options);
        else this.plan(message.id, message.options);
        return;
      case 'continue':
        if (this.search === null) throw new Error('There is no plan to go on with. Start one first.');
        this.search.stop();
        this.search.extend(message.id, message.budget);
        return;
      case 'meet':
        this.search?.meet(message.path);
        return;
      case 'pause':
        this.search?.pause();
        return;
      case 'resume':
        this.search?.resume();
        return;
      case 'stop':
        this.search?.stop();
        return;
      case 'papers':
        void this.reply(message.id, () => this.papers(message.id));
        return;
      case 'quote':
        void this.reply(message.id, () => this.quote(message.id, message.material));
        return;
      case 'output':
        void this.reply(message.id, () => this.output(message.id, message.kind, message.width));
        return;
    }
  }

  private loaded(): Job {
    if (this.job === null) throw new Error('No drawing is loaded yet. Load one first.');
    return this.job;
  }

  private tellLoaded(id: number): void {
    const job = this.loaded();
    const loaded = { ...job.report(), geometry: job.geometry(), ignored: job.ignored() };
    this.openCuts = loaded.contours.some((c) => !c.closed && c.operation === 'cut');
    const arrays = [loaded.geometry, loaded.ignored.geometry].flatMap((g) => [g.segments, g.offsets]);
    this.host.post({ type: 'loaded', id, loaded }, buffers([...arrays, loaded.ignored.layers]));
  }

  // For the kerf's width; or pre-cuts, which are what lets contours that share a side be one.
  private asksForPlate({ machine }: PlanOptions): boolean {
    if (this.source === null) return false;
    const profile = typeof machine === 'object' ? machine : machines().find((m) => m.name === machine);
    const mayShare = this.openCuts && this.source.options.commonCuts !== 'off';
    return Boolean(profile?.kerf_width) || (mayShare && Boolean(profile?.pre_cut_time));
  }

  private async planAsPlate(id: number, options: PlanOptions & Membership): Promise<void> {
    const { source } = this;
    this.held = [];
    try {
      // Without it, as in a single file, every contour is cut by itself; a kerf's width is refused.
      const plate = await this.host.plate().catch(() => null);
      if (plate !== null && source !== null) {
        const job = new plate.Job(source.bytes, source.name, source.options);
        this.job?.free();
        this.job = job;
        this.source = null;
      }
      this.plan(id, options);
    } catch (error) {
      this.fail(id, error);
    }
    const held = this.held;
    this.held = null;
    for (const message of held) this.receive(message);
  }

  private plan(id: number, options: PlanOptions & Membership): void {
    const job = this.loaded();
    const budget = options.moves === undefined && options.seconds === undefined ? { seconds: DEFAULT_SECONDS } : {};
    const seed = options.seed ?? inventSeed();
    const { method, parameters, ...others } = given(options);
    const paper = method !== undefined && !methods().some((m) => m.name === method) ? method : null;
    if (paper === null && parameters !== undefined) throw new Error('Only methods from papers have parameters.');
    if (paper !== null && (options.workers ?? 1) > 1) throw new Error('Methods from papers work alone: leave out the number of workers.');
    const text = JSON.stringify(parameters ?? {});
    const started = job.start({ ...others, ...given({ method, parameters: paper === null ? undefined : text }), ...budget, seed });
    const invite = paper === null ? null : async () => new (await this.host.papers()).Guest(job.packed(), paper, text, seed);
    const lines = [started.common, started.beam?.geometry].filter((g) => g !== null && g !== undefined);
    this.host.post({ type: 'started', id, ...started }, buffers(lines.flatMap((g) => [g.segments, g.offsets])));
    this.search = new Search(job, {
      progress: (progress) => this.host.post({ type: 'progress', ...progress }, pathBuffers(progress.progress)),
      done: (done) => this.host.post({ type: 'done', ...done }, pathBuffers(done.progress)),
      meeting: (met) => this.host.post({ type: 'meeting', ...met }, pathBuffers(met.progress)),
      bound: (bound) => this.host.post({ type: 'bound', ...bound }),
      prover: async (of) => new (await this.host.lab()).Prover(of.packed()),
      failed: (of, error) => this.fail(of, error),
    }, options.workers, invite, options.warm !== undefined);
    this.search.run(id, { ...options, ...budget });
  }

  // What is loaded or written first: the answer goes out when it is there.
  private async reply(id: number, make: () => Promise<[FromWorker, ArrayBuffer[]?]>): Promise<void> {
    try {
      this.host.post(...(await make()));
    } catch (error) {
      this.fail(id, error);
    }
  }

  private async papers(id: number): Promise<[FromWorker]> {
    return [{ type: 'papers', id, methods: (await this.host.papers()).paperMethods() }];
  }

  private async quote(id: number, material: Material): Promise<[FromWorker]> {
    const json = this.loaded().output('json');
    return [{ type: 'quote', id, quote: (await this.host.quote()).quoteOf(json, JSON.stringify(material)) }];
  }

  private async output(id: number, kind: OutputKind, width = PNG_WIDTH): Promise<[FromWorker, ArrayBuffer[]?]> {
    if (kind !== 'png') return [{ type: 'output', id, kind, data: this.loaded().output(kind) }];
    const json = this.loaded().output('json');
    const data = (await this.host.png())(json, width);
    return [{ type: 'output', id, kind, data }, buffers([data])];
  }

  // Errors of ours carry one sentence for people. Anything that comes from the wasm machine itself (a trap, memory
  // that ran out) has left the instance unusable.
  private fail(id: number, error: unknown): void {
    if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError) {
      this.search = null;
      this.host.post({ type: 'broken', message: `The planner broke down (${error.message}).` });
      return;
    }
    this.host.post({ type: 'failed', id, message: error instanceof Error ? error.message : String(error) });
  }
}

/** Any of 2^32, from the system's source of randomness; told in the result, so that the plan can be made again. */
function inventSeed(): number {
  return crypto.getRandomValues(new Uint32Array(1))[0] ?? 0;
}

/** Options without those that are `undefined`: to the core they are not given. */
function given<T extends object>(options: T): T {
  return Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined)) as T;
}

function pathBuffers({ path }: { path: import('./protocol.js').BestPath | null }): ArrayBuffer[] {
  return path === null ? [] : buffers([path.contours, path.points, path.along, path.until, path.reversed, path.times, path.preCuts, path.pauses]);
}

function buffers(arrays: ArrayBufferView[]): ArrayBuffer[] {
  return arrays.map((a) => a.buffer as ArrayBuffer);
}
