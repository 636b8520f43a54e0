/**
 * The worker's side of the protocol: one drawing, one plan at a time. It knows neither Web Workers nor worker threads;
 * a `Host` sends its messages and finds the PNG renderer.
 */

import * as planner from './pkg/kerfway.js';
import { DEFAULT_SECONDS } from './options.js';
import type { Job } from './pkg/kerfway.js';
import type { FromWorker, LoadOptions, Membership, OutputKind, PlanOptions, ToWorker } from './protocol.js';
import type { Material, Quote } from './quote.js';
import { Search } from './search.js';

/** The planner with the methods of papers and benchmark instances: it does all that `kerfway.wasm` does, and more. */
type Research = typeof import('./pkg/kerfway_research.js');
type Png = typeof import('./pkg/kerfway_png.js');

/** What a session needs of the place it runs in. */
export interface Host {
  post(message: FromWorker, transfer?: ArrayBuffer[]): void;
  /** The research build, loaded when a method of a paper is first asked for. */
  research(): Promise<Research>;
  /** The PNG renderer, loaded when first asked for. */
  png(): Promise<Png>;
}

/** Pixels across when nobody says how wide a picture should be. */
const PNG_WIDTH = 1600;

/** Answers messages, each `load`, `plan` and `output` with one final message of the same id. */
export class Session {
  private job: Job | null = null;
  private search: Search | null = null;
  /** The build at work. */
  private build: typeof planner | Research = planner;
  private png: Png | null = null;
  /** How the drawing was loaded, for loading it again in the research build. */
  private source: { name: string; options: LoadOptions } = { name: '', options: {} };
  /** Messages that come in while the research build is loaded. */
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
        planner.initSync({ module: message.planner });
        this.host.post({ type: 'ready', methods: planner.methods(), machines: planner.machines() });
        return;
      case 'load':
        this.search?.stop();
        this.search = null;
        this.job?.free();
        this.job = null;
        this.source = { name: message.name, options: given(message.options) };
        this.job = new this.build.Job(new Uint8Array(message.bytes), message.name, this.source.options);
        this.tellLoaded(message.id);
        return;
      case 'reload':
        this.search?.stop();
        this.search = null;
        this.loaded().reload(given(message.options));
        this.source.options = given(message.options);
        this.tellLoaded(message.id);
        return;
      case 'plan':
        this.search?.stop();
        this.search = null;
        if (this.needsResearch(message.options)) void this.planInResearch(message.id, message.options);
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
        this.host.post({ type: 'quote', id: message.id, quote: this.quote(message.material) });
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
    const arrays = [loaded.geometry, loaded.ignored.geometry].flatMap((g) => [g.segments, g.offsets]);
    this.host.post({ type: 'loaded', id, loaded }, buffers([...arrays, loaded.ignored.layers]));
  }

  private needsResearch({ method }: PlanOptions): boolean {
    return method !== undefined && this.build === planner && !planner.methods().some((m) => m.name === method);
  }

  private async planInResearch(id: number, options: PlanOptions & Membership): Promise<void> {
    this.held = [];
    try {
      const research = await this.host.research();
      const job = this.loaded();
      this.job = new research.Job(job.bytes(), this.source.name, this.source.options);
      this.build = research;
      job.free();
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
    const seed = options.seed ?? this.build.randomSeed();
    const { method, parameters, ...others } = given(options);
    const isPaper = method !== undefined && !this.build.methods().some((m) => m.name === method);
    if (!isPaper && parameters !== undefined) throw new Error('Only methods from papers have parameters.');
    if (isPaper && (options.workers ?? 1) > 1) throw new Error('Methods from papers work alone: leave out the number of workers.');
    const text = isPaper ? JSON.stringify(parameters ?? {}) : undefined;
    const started = job.start({ ...others, ...given({ method, parameters: text }), ...budget, seed });
    const lines = [started.common, started.beam?.geometry].filter((g) => g !== null && g !== undefined);
    this.host.post({ type: 'started', id, ...started }, buffers(lines.flatMap((g) => [g.segments, g.offsets])));
    this.search = new Search(job, {
      progress: (progress) => this.host.post({ type: 'progress', ...progress }, pathBuffers(progress.progress)),
      done: (done) => this.host.post({ type: 'done', ...done }, pathBuffers(done.progress)),
      meeting: (met) => this.host.post({ type: 'meeting', ...met }, pathBuffers(met.progress)),
      bound: (bound) => this.host.post({ type: 'bound', ...bound }),
      failed: (of, error) => this.fail(of, error),
    }, options.workers);
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
    return [{ type: 'papers', id, methods: (await this.host.research()).paperMethods() }];
  }

  private quote(material: Material): Quote {
    return this.build.quoteOf(this.loaded().output('json'), JSON.stringify(material));
  }

  private async output(id: number, kind: OutputKind, width = PNG_WIDTH): Promise<[FromWorker, ArrayBuffer[]?]> {
    if (kind !== 'png') return [{ type: 'output', id, kind, data: this.loaded().output(kind) }];
    const json = this.loaded().output('json');
    this.png ??= await this.host.png();
    const data = this.png.renderPng(json, width);
    return [{ type: 'output', id, kind, data }, buffers([data])];
  }

  // Errors of ours carry one sentence for people. Anything that comes from the wasm machine itself (a trap, memory
  // that ran out) has left the instance unusable.
  private fail(id: number, error: unknown): void {
    if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError) {
      this.search = null;
      const why = panicOf(this.build) ?? (this.png === null ? undefined : panicOf(this.png));
      this.host.post({ type: 'broken', message: `The planner broke down (${why ?? error.message}).` });
      return;
    }
    this.host.post({ type: 'failed', id, message: error instanceof Error ? error.message : String(error) });
  }
}

/** What the panic that ended an instance said. An instance that ended otherwise may not answer. */
function panicOf(build: { lastPanic(): string | undefined }): string | undefined {
  try {
    return build.lastPanic();
  } catch {
    return undefined;
  }
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
