/**
 * The worker's side of the protocol: one drawing and one plan at a time. It works in Web Workers and in worker threads: a
 * `Host` sends its messages and loads the other wasm files.
 */

import * as planner from './pkg/kerfway.js';
import { KerfwayError, reportOf } from './errors.js';
import { DEFAULT_SECONDS, given } from './options.js';
import { inPieces } from './pieces.js';
import type { Job } from './pkg/kerfway.js';
import type { CheckedOn, FromWorker, LoadOptions, MachineProfile, MeasuredPlan, Membership, OutputKind, PlanOptions, ToWorker } from './protocol.js';
import type { Quote, QuoteTerms } from './quote.js';
import { Proving } from './proving.js';
import { Search } from './search.js';
import { type WriterFiles, Writers } from './session-writers.js';

/** The planner with the reader of SVG, all levers, the methods of papers and benchmark instances. It can do everything that `kerfway.wasm` can. */
type Research = typeof import('./pkg/kerfway_research.js');

/** What a session needs from the platform it runs on. */
export interface Host extends WriterFiles {
  post(message: FromWorker, transfer?: ArrayBuffer[]): void;
  /** Loads the research build, when an SVG file, a method or heuristic from a paper or a lever that the core leaves out is first used. */
  research(): Promise<Research>;
}

/** Levers of a machine that the core leaves out: `Levers::not_in_this_build` in the planner refuses them there. */
const NOT_IN_CORE = ['fly', 'chains', 'bridges', 'common_cuts', 'tips', 'heat', 'corners'] as const;
/** Bytes at the start of a file by which SVG is recognised. */
const HEAD = 262_144;
/** Default width of a picture, in pixels. */
const PNG_WIDTH = 1600;

/** Handles messages. Each request is answered by one final message with the same id. */
export class Session {
  private job: Job | null = null;
  private search: Search | null = null;
  private proving: Proving | null = null;
  /** The build that runs the job. */
  private build: typeof planner | Research = planner;
  private readonly writers: Writers;
  /** How the drawing was loaded, for loading it again in the research build. */
  private source: { name: string; options: LoadOptions } = { name: '', options: {} };
  /** Messages that have arrived while the research build is being loaded; `null` when it is not. */
  private held: ToWorker[] | null = null;

  constructor(private readonly host: Host) {
    this.writers = new Writers(host);
  }

  receive(message: ToWorker): void {
    if (this.held !== null) {
      this.held.push(message);
      return;
    }
    try {
      this.answer(message);
    } catch (error) {
      if (message.type === 'init') this.host.post({ type: 'broken', message: `The wasm file is not that of this version (${reportOf(error).message}).` });
      else this.fail('id' in message ? message.id : -1, error);
    }
  }

  /** Ends the search and frees the drawing. A worker that ends needs no call: its memory goes with it. */
  close(): void {
    this.search?.stop();
    this.search = null;
    this.job?.free();
    this.job = null;
  }

  private answer(message: ToWorker): void {
    switch (message.type) {
      case 'init':
        planner.initSync({ module: message.planner });
        this.writers.given = message.outputs;
        this.host.post({ type: 'ready', methods: planner.methods(), machines: planner.machines(), dialects: planner.dialects() });
        return;
      case 'load':
        if (this.build === planner && planner.isSvg(new Uint8Array(message.bytes, 0, Math.min(HEAD, message.bytes.byteLength)))) {
          void this.inResearch(message.id, (research) => this.load(message, research));
        } else this.load(message, this.build);
        return;
      case 'reload':
        this.search?.stop();
        this.search = null;
        this.loaded().reload(given(message.options));
        this.source.options = given(message.options);
        this.postLoaded(message.id);
        return;
      case 'plan':
        this.search?.stop();
        this.search = null;
        if (this.needsResearch(message.options)) {
          void this.inResearch(message.id, (research) => {
            const job = this.loaded();
            this.job = new research.Job(job.bytes(), this.source.name, this.source.options);
            this.build = research;
            job.free();
            this.plan(message.id, message.options);
          });
        } else this.plan(message.id, message.options);
        return;
      case 'continue':
        if (this.search === null) throw new KerfwayError('no-plan', 'There is no plan to continue. Start one first.');
        this.search.stop();
        this.search.extend(message.id, message.budget);
        return;
      case 'meet':
        if (this.search?.id === message.id) this.search.meet(message.path);
        return;
      case 'pause':
      case 'resume':
      case 'stop':
        // A plan that has been displaced must not stop the one that has taken its place.
        if (this.search?.id === message.id) this.search[message.type]();
        if (message.type === 'stop') this.proving?.stop();
        return;
      case 'prove':
        void this.inResearch(message.id, (research) => void this.reply(message.id, () => this.prove(message, research)));
        return;
      case 'raise':
        if (this.search === null) return;
        this.loaded().raiseBound(message.lowerBound);
        this.search.raise(message.lowerBound);
        return;
      case 'offer':
        this.host.post({ type: 'offered', id: message.id, progress: this.search?.offer(message.path) ?? null });
        return;
      case 'papers':
        void this.reply(message.id, () => this.papers(message.id));
        return;
      case 'calibrate':
        void this.reply(message.id, () => this.calibrate(message.id, message.machine, message.measured));
        return;
      case 'quote':
        this.host.post({ type: 'quote', id: message.id, quote: this.quote(message.terms) });
        return;
      case 'check':
        void this.reply(message.id, () => this.check(message.id, message.program, message.options));
        return;
      case 'sample':
        void this.reply(message.id, () => this.sample(message.id, message.options));
        return;
      case 'output':
        void this.reply(message.id, () => this.output(message.id, message.kind, message.width));
        return;
    }
  }

  /** Reads another drawing. If it cannot be used, the one before stays, and its search goes on. */
  private load({ id, bytes, name, options }: Extract<ToWorker, { type: 'load' }>, build: typeof planner | Research): void {
    const source = { name, options: given(options) };
    const job = new build.Job(new Uint8Array(bytes), name, source.options);
    this.search?.stop();
    this.search = null;
    this.job?.free();
    [this.job, this.source, this.build] = [job, source, build];
    this.postLoaded(id);
  }

  private loaded(): Job {
    if (this.job === null) throw new KerfwayError('no-drawing', 'No drawing is loaded yet. Load one first.');
    return this.job;
  }

  private postLoaded(id: number): void {
    const job = this.loaded();
    const loaded = { ...job.report(), geometry: job.geometry(), ignored: job.ignored() };
    const { pieces, rest } = inPieces(id, loaded);
    for (const piece of pieces) this.host.post(piece);
    const arrays = [loaded.geometry, loaded.ignored.geometry].flatMap((g) => [g.segments, g.offsets]);
    this.host.post({ type: 'loaded', id, loaded: rest }, buffers([...arrays, loaded.ignored.layers]));
  }

  /** Methods from papers and some levers are not in the core. */
  private needsResearch({ method, machine }: PlanOptions): boolean {
    const isPaper = method !== undefined && !planner.methods().some((m) => m.name === method);
    const levers = typeof machine === 'object' ? machine.levers : undefined;
    const inserts = this.source.options.commonCuts === 'insertion';
    return this.build === planner && (isPaper || inserts || NOT_IN_CORE.some((lever) => levers?.[lever] != null));
  }

  /** Loads the research build and does there what a request asks for. Messages that arrive meanwhile wait. */
  private async inResearch(id: number, work: (research: Research) => void): Promise<void> {
    this.held = [];
    try {
      work(await this.host.research());
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
    if (!isPaper && parameters !== undefined) throw conflict('parameters', 'Only methods from papers have parameters.');
    if (isPaper && (options.workers ?? 1) > 1) throw conflict('workers', 'Methods from papers use one worker: omit the number of workers.');
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

  // Sends an answer that takes time to make, because a wasm file may have to be loaded first.
  private async reply(id: number, make: () => Promise<[FromWorker, ArrayBuffer[]?]>): Promise<void> {
    try {
      this.host.post(...(await make()));
    } catch (error) {
      this.fail(id, error);
    }
  }

  private async prove({ id, bytes, name, options, planning, budget }: Extract<ToWorker, { type: 'prove' }>, research: Research): Promise<[FromWorker]> {
    const { method: _, parameters: __, ...others } = given(planning);
    this.proving = new Proving(new research.Proof(new Uint8Array(bytes), name, given(options), others));
    return [{ type: 'proof', id, proof: await this.proving.run(budget, (lowerBound, path) => this.host.post({ type: 'bound', id, lowerBound, path })) }];
  }

  private async papers(id: number): Promise<[FromWorker]> {
    return [{ type: 'papers', id, methods: (await this.host.research()).paperMethods() }];
  }

  private async check(id: number, program: string | null, options: CheckedOn): Promise<[FromWorker]> {
    // The plan is that of this moment, although the file may have to be loaded first.
    if (program === null) {
      const order = this.loaded().workOrder('gcode');
      return [{ type: 'check', id, check: (await this.writers.loaded()).preflight(order) }];
    }
    const machine = this.build.checkedMachine(given(options));
    return [{ type: 'check', id, check: (await this.writers.loaded()).checkProgram(program, machine) }];
  }

  private async sample(id: number, options: CheckedOn): Promise<[FromWorker]> {
    const order = this.build.sampleOrder(options);
    return [{ type: 'sample', id, program: (await this.writers.loaded()).writeOutput(order, 'gcode') as string }];
  }

  private quote(terms: QuoteTerms): Quote {
    return this.loaded().quote(terms);
  }

  private async calibrate(id: number, machine: MachineProfile, measured: readonly MeasuredPlan[]): Promise<[FromWorker]> {
    return [{ type: 'calibrate', id, calibration: await this.writers.calibrate(machine, measured) }];
  }

  private async output(id: number, kind: OutputKind, width = PNG_WIDTH): Promise<[FromWorker, ArrayBuffer[]?]> {
    if (kind === 'json') return [{ type: 'output', id, kind, data: this.loaded().document() }];
    if (kind === 'png') {
      const data = await this.writers.picture(this.loaded().document(), width);
      return [{ type: 'output', id, kind, data }, buffers([data])];
    }
    const order = this.loaded().workOrder(kind);
    const data = (await this.writers.loaded()).writeOutput(order, kind);
    return [{ type: 'output', id, kind, data }, typeof data === 'string' ? [] : buffers([data])];
  }

  // Our own errors have one sentence for people. An error of the wasm engine itself (a trap, or no memory left) leaves
  // the instance unusable.
  private fail(id: number, error: unknown): void {
    if (error instanceof WebAssembly.RuntimeError || error instanceof RangeError) {
      // Nothing of a broken instance can be used or freed.
      this.search = null;
      this.job = null;
      const why = [this.build, this.writers.outputs, this.writers.png].map((build) => build && panicOf(build)).find((panic) => panic != null);
      this.host.post({ type: 'broken', message: `The planner broke down (${why ?? error.message}).` });
      return;
    }
    this.host.post({ type: 'failed', id, error: reportOf(error) });
  }
}

function conflict(field: string, sentence: string): KerfwayError {
  return new KerfwayError('options-conflict', sentence, { field });
}

/** The message of the panic that ended an instance. An instance that ended for another reason may not answer. */
function panicOf(build: { lastPanic(): string | undefined }): string | undefined {
  try {
    return build.lastPanic();
  } catch {
    return undefined;
  }
}

function pathBuffers({ path }: { path: import('./protocol.js').BestPath | null }): ArrayBuffer[] {
  return path === null ? [] : buffers([path.contours, path.points, path.along, path.until, path.reversed, path.times, path.leads, path.leadOffsets, path.joints, path.jointOffsets, path.preCuts, path.pauses, path.ways, path.via, path.viaOf, path.tips, path.freedBy, path.waits, path.loops, path.loopOffsets]);
}

function buffers(arrays: ArrayBufferView[]): ArrayBuffer[] {
  return arrays.map((a) => a.buffer as ArrayBuffer);
}
