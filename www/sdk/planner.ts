/**
 * The planner as a page or a program sees it: load a drawing, plan it, watch it improve, write it out. The work runs
 * in a worker. One that dies or hangs is replaced: the drawing is loaded again and the best plan found is put back, so
 * nothing that was reached is lost.
 */

import { FINAL, type Answers } from './answers.js';
import { ClosedError, quietAtClose } from './closed.js';
import { Crew, type Drawing } from './crew.js';
import { Line, PATIENCE, type StartWorker } from './line.js';
import { checkFile, checkOptions, checkOutput } from './options.js';
import { RunningPlan, type PlanHandle, type PlanMessage } from './plan-handle.js';
import type { Material, Quote } from './quote.js';
import { checkSize } from './size.js';
import type {
  Budget,
  FromWorker,
  LoadOptions,
  Loaded,
  MachineProfile,
  MethodInfo,
  OutputKind,
  PaperMethod,
  PlanOptions,
  Progress,
  ToWorker,
} from './protocol.js';

/** How a planner is made. */
export interface PlannerOptions {
  /** The compiled planner, or its bytes; otherwise it is read from beside this module. */
  wasm?: WebAssembly.Module | BufferSource;
  /** Told in one sentence when a worker had to be replaced. */
  onReplaced?: (message: string) => void;
}

/** What a planner is made of. */
export interface Parts {
  module: WebAssembly.Module;
  start: StartWorker;
  onReplaced?: ((message: string) => void) | undefined;
  /** Seconds after which a silent worker counts as hung. */
  patience?: typeof PATIENCE;
}

const CLOSED = 'The planner was closed.';

/** Times that a worker is started before it counts as one that cannot be. */
const STARTS = 2;

interface Request {
  resolve: (answer: never) => void;
  reject: (error: Error) => void;
}

/** One worker that keeps a drawing and the plan of it. Make one with `createPlanner`, close it when done. */
export class Planner {
  /** The methods there are, the default first. */
  methods: readonly MethodInfo[] = [];
  /** The machines there are, the default first. */
  machines: readonly MachineProfile[] = [];
  /** Why the worker had to be replaced, the last time it had to. */
  replaced: string | null = null;

  private line!: Line;
  private lastId = 0;
  private readonly requests = new Map<number, Request>();
  /** Plans under way: one, and for a moment the one it takes the place of. */
  private readonly plans = new Map<number, RunningPlan>();
  /** The drawing in the worker. */
  private drawing: Drawing | null = null;
  /** The last plan, under way or ended. */
  private current: RunningPlan | null = null;
  /** Messages wait for this: a worker that is there, with the drawing in it. */
  private ready: Promise<void> = Promise.resolve();
  /** Waits for the worker that is starting. */
  private greeting: { resolve: () => void; reject: (error: Error) => void } | null = null;
  private restoring = false;
  private closed = false;

  /** The workers that help with a plan. */
  private readonly crew: Crew;

  private constructor(private readonly parts: Parts) {
    this.crew = new Crew({
      ...parts,
      toFirst: (message) => this.line.post(message),
      tell: (message) => this.tell(message),
    });
  }

  /** A planner whose worker is ready. */
  static async open(parts: Parts): Promise<Planner> {
    const planner = new Planner(parts);
    planner.ready = planner.openLine();
    await planner.ready;
    return planner;
  }

  /** Reads a DXF file. A plan under way ends. Rejects with one sentence when the file or an option is unusable. */
  load(bytes: ArrayBuffer | Uint8Array, name: string, options: LoadOptions = {}): Promise<Loaded> {
    return quietAtClose(async () => {
      checkFile(bytes, name);
      checkSize(bytes.byteLength);
      checkOptions(options, 'load');
      const drawing = { bytes: ownCopy(bytes), name, options };
      await this.ready;
      const { loaded } = await this.ask<'load'>((id) => ({ type: 'load', id, ...drawing }));
      this.drawing = drawing;
      this.current = null;
      return loaded;
    });
  }

  /** Reads the same file with other options. A plan under way ends. */
  reload(options: LoadOptions): Promise<Loaded> {
    return quietAtClose(async () => {
      checkOptions(options, 'reload');
      await this.ready;
      const { loaded } = await this.ask<'load'>((id) => ({ type: 'reload', id, options }));
      if (this.drawing !== null) this.drawing = { ...this.drawing, options };
      this.current = null;
      return loaded;
    });
  }

  /** The methods of published papers, with their parameters: loaded when first asked for. */
  paperMethods(): Promise<PaperMethod[]> {
    return quietAtClose(async () => {
      await this.ready;
      return (await this.ask<'papers'>((id) => ({ type: 'papers', id }))).methods;
    });
  }

  /**
   * Plans the loaded drawing. One plan runs at a time; one under way ends. A callback that throws ends its plan, which rejects
   * with what was thrown.
   */
  plan(options: PlanOptions = {}, onProgress: (progress: Progress) => unknown = () => {}): PlanHandle {
    const plan = this.newPlan(options, onProgress);
    return this.begin(plan, { type: 'plan', id: plan.id, options }, () => checkOptions(options, 'planning'));
  }

  /** Goes on with the last plan, for another budget. */
  continue(budget: Budget, onProgress: (progress: Progress) => unknown = () => {}): PlanHandle {
    const plan = this.newPlan({ ...this.current?.options, ...budget }, onProgress);
    return this.begin(plan, { type: 'continue', id: plan.id, budget }, () => {
      checkOptions(budget, 'continue');
      if (this.current !== null) plan.follow(this.current);
      this.crew.again(plan.id, budget);
    });
  }

  /** The best plan so far, checked and written out; `width` is that of the picture, in pixels. */
  output(kind: 'png', width?: number): Promise<Uint8Array>;
  output(kind: Exclude<OutputKind, 'png'>): Promise<string>;
  output(kind: OutputKind, width?: number): Promise<string | Uint8Array>;
  output(kind: OutputKind, width?: number): Promise<string | Uint8Array> {
    return quietAtClose(async () => {
      checkOutput(kind, width);
      await this.ready;
      const size = width === undefined ? {} : { width };
      return (await this.ask<'output'>((id) => ({ type: 'output', id, kind, ...size }))).data;
    });
  }

  /** The report of a quote of the best plan so far, checked like an output. */
  quote(material: Material = {}): Promise<Quote> {
    return quietAtClose(async () => {
      checkOptions(material, 'material');
      await this.ready;
      return (await this.ask<'quote'>((id) => ({ type: 'quote', id, material }))).quote;
    });
  }

  /** Ends the worker; whatever was under way is rejected. */
  close(): void {
    this.closed = true;
    this.crew.close();
    this.line.close();
    const reason = new ClosedError(CLOSED);
    // Whoever waits for a worker that is still starting waits no longer.
    this.ready.catch(() => {});
    this.greeting?.reject(reason);
    this.abandon(reason);
  }

  private newPlan(options: PlanOptions, onProgress: (progress: Progress) => unknown): RunningPlan {
    const id = ++this.lastId;
    return new RunningPlan(id, options, onProgress, (message) => {
      this.whenReady(message);
      if (this.crew.works(id)) this.crew.post(message);
    });
  }

  // A plan that `prepare` refuses fails, and leaves the one under way alone.
  private begin(plan: RunningPlan, message: ToWorker, prepare: () => void): PlanHandle {
    try {
      if (this.closed) throw new ClosedError(CLOSED);
      prepare();
    } catch (error) {
      plan.fail(error);
      return plan.handle;
    }
    this.current = plan;
    this.plans.set(plan.id, plan);
    this.whenReady(message);
    return plan.handle;
  }

  private whenReady(message: ToWorker): void {
    const post = () => {
      this.line.post(message);
      this.attend();
    };
    this.ready.then(post).catch((error: Error) => this.abandon(error));
  }

  private ask<K extends keyof Answers>(message: (id: number) => ToWorker): Promise<Answers[K]> {
    return new Promise((resolve, reject) => {
      if (this.closed) return reject(new ClosedError(CLOSED));
      const id = ++this.lastId;
      this.line.post(message(id));
      this.requests.set(id, { resolve, reject });
      this.attend();
    });
  }

  // A worker that dies before it has greeted is tried again: memory that is short for a moment, or a machine that goes to
  // sleep, ends one that is starting.
  private async openLine(): Promise<void> {
    for (let left = STARTS; ; ) {
      left -= 1;
      try {
        return await this.startWorker();
      } catch (error) {
        if (this.closed) throw new ClosedError(CLOSED);
        if (left === 0) throw new Error(`The planner could not be started. ${(error as Error).message} It was tried ${STARTS} times.`);
      }
    }
  }

  private startWorker(): Promise<void> {
    return new Promise((resolve, reject) => {
      this.greeting = { resolve, reject };
      const { start, module, patience } = this.parts;
      this.line = new Line(start, module, (m) => this.hear(m), (why) => this.lost(why), patience);
      this.line.expect('working');
    });
  }

  private lost(why: string): void {
    if (this.greeting === null) void this.replace(why);
    else this.greeting.reject(new Error(why));
  }

  private hear(message: FromWorker): void {
    if (message.type === 'ready') {
      this.methods = message.methods;
      this.machines = message.machines;
      this.greeting?.resolve();
      this.greeting = null;
    } else if ('id' in message) {
      this.deliver(message);
    }
    this.attend();
  }

  private deliver(message: Extract<FromWorker, { id: number }>): void {
    const plan = this.plans.get(message.id);
    const request = this.requests.get(message.id);
    if (plan !== undefined) {
      const { workers = 1 } = plan.options;
      if (message.type === 'started' && workers > 1 && this.drawing !== null) {
        this.crew.begin(plan.id, { ...plan.options, seed: message.seed }, this.drawing);
      }
      if (this.crew.works(plan.id)) this.crew.hear(0, message);
      else this.tell(message as PlanMessage);
    } else if (request !== undefined && FINAL.has(message.type)) {
      this.requests.delete(message.id);
      if (message.type === 'failed') request.reject(new Error(message.message));
      else request.resolve(message as never);
    }
  }

  private tell(message: PlanMessage): void {
    const plan = this.plans.get(message.id);
    plan?.hear(message);
    if (plan?.ended === true) this.plans.delete(message.id);
    this.attend();
  }

  // Judges the silence of the worker by what it has to do.
  private attend(): void {
    const plans = [...this.plans.values()].filter((p) => !p.paused);
    // One of several may wait for the others without a word.
    const talks = (p: RunningPlan) => p.begun !== null && !this.crew.works(p.id);
    const searching = plans.length > 0 && plans.every(talks) && this.requests.size === 0;
    const busy = plans.length > 0 || this.requests.size > 0;
    this.line.expect(searching ? 'searching' : busy ? 'working' : 'idle');
  }

  // A worker died. What it was reading is not read again: it may be what killed it. What was there before comes back,
  // once: a worker that dies of that is replaced by an empty one.
  private async replace(why: string): Promise<void> {
    const kept = this.restoring ? null : this.drawing;
    this.replaced = why;
    const message = `${why} It was started again${kept === null ? '.' : ' and the drawing loaded again.'}`;
    this.abandon(new Error(message));
    const plan = kept === null ? null : this.current;
    [this.drawing, this.current] = [null, null];
    this.ready = this.openLine().then(() => (kept === null ? undefined : this.restore(kept, plan)));
    // Whoever asks for something later hears that it could not be started.
    const there = await this.ready.then(() => true, () => false);
    if (there) this.tellReplaced(message);
  }

  // It is told aside from any call, so what it throws has nowhere to go.
  private tellReplaced(message: string): void {
    try {
      const told: unknown = this.parts.onReplaced?.(message);
      if (told instanceof Promise) told.catch(() => {});
    } catch {}
  }

  private async restore(drawing: Drawing, plan: RunningPlan | null): Promise<void> {
    this.restoring = true;
    try {
      await this.ask<'load'>((id) => ({ type: 'load', id, ...drawing }));
      this.drawing = drawing;
      if (plan === null || plan.path === null || plan.begun === null) return;
      const { seed, method } = plan.begun;
      const options = { ...plan.options, seed, method, warm: plan.path, seconds: undefined, moves: 0 };
      await this.ask<'restore'>((id) => ({ type: 'plan', id, options }));
      this.current = plan;
    } finally {
      this.restoring = false;
    }
  }

  private abandon(reason: Error): void {
    this.crew.end();
    for (const request of this.requests.values()) request.reject(reason);
    for (const plan of this.plans.values()) plan.interrupt(reason);
    this.requests.clear();
    this.plans.clear();
  }
}

/** The caller may go on using its bytes, and a worker that is replaced needs them again. */
function ownCopy(bytes: ArrayBuffer | Uint8Array): ArrayBuffer {
  return new Uint8Array(bytes).slice().buffer;
}
