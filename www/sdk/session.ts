/**
 * The worker's side of the protocol: one drawing, one plan at a time. It knows neither Web Workers nor worker threads;
 * a `Host` sends its messages and finds the PNG renderer.
 */

import { initSync, Job, machines, methods } from './pkg/kerfway.js';
import type { FromWorker, Membership, OutputKind, PlanOptions, ToWorker } from './protocol.js';
import type { Material } from './quote.js';
import { Search } from './search.js';

/** What a session needs of the place it runs in. */
export interface Host {
  post(message: FromWorker, transfer?: ArrayBuffer[]): void;
  /** The wasm file that proves bounds, loaded when first asked for. */
  lab(): Promise<typeof import('./pkg/kerfway_lab.js')>;
  /** The methods of papers, loaded when first asked for. */
  papers(): Promise<typeof import('./pkg/kerfway_papers.js')>;
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

  constructor(private readonly host: Host) {}

  receive(message: ToWorker): void {
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
        this.job = new Job(new Uint8Array(message.bytes), message.name, given(message.options));
        this.tellLoaded(message.id);
        return;
      case 'reload':
        this.search?.stop();
        this.search = null;
        this.loaded().reload(given(message.options));
        this.tellLoaded(message.id);
        return;
      case 'plan':
        this.search?.stop();
        this.search = null;
        this.plan(message.id, message.options);
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
        void this.papers(message.id);
        return;
      case 'quote':
        void this.quote(message.id, message.material);
        return;
      case 'output':
        void this.output(message.id, message.kind, message.width);
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
    this.host.post({ type: 'started', id, ...started });
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

  private async papers(id: number): Promise<void> {
    try {
      this.host.post({ type: 'papers', id, methods: (await this.host.papers()).paperMethods() });
    } catch (error) {
      this.fail(id, error);
    }
  }

  private async quote(id: number, material: Material): Promise<void> {
    try {
      const json = this.loaded().output('json');
      this.host.post({ type: 'quote', id, quote: (await this.host.quote()).quoteOf(json, JSON.stringify(material)) });
    } catch (error) {
      this.fail(id, error);
    }
  }

  private async output(id: number, kind: OutputKind, width = PNG_WIDTH): Promise<void> {
    try {
      if (kind === 'png') {
        const json = this.loaded().output('json');
        const data = (await this.host.png())(json, width);
        this.host.post({ type: 'output', id, kind, data }, buffers([data]));
      } else {
        this.host.post({ type: 'output', id, kind, data: this.loaded().output(kind) });
      }
    } catch (error) {
      this.fail(id, error);
    }
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

/** A person who says nothing waits this long. */
const DEFAULT_SECONDS = 10;

/** Any of 2^32, from the system's source of randomness; told in the result, so that the plan can be made again. */
function inventSeed(): number {
  return crypto.getRandomValues(new Uint32Array(1))[0] ?? 0;
}

/** Options without those that are `undefined`: to the core they are not given. */
function given<T extends object>(options: T): T {
  return Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined)) as T;
}

function pathBuffers({ path }: { path: import('./protocol.js').BestPath | null }): ArrayBuffer[] {
  return path === null ? [] : buffers([path.contours, path.points, path.along, path.until, path.reversed, path.times]);
}

function buffers(arrays: ArrayBufferView[]): ArrayBuffer[] {
  return arrays.map((a) => a.buffer as ArrayBuffer);
}
