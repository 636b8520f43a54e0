/**
 * The class `Planner`: loads a drawing, plans it, reports the progress, writes outputs. The work is done in a worker. A
 * worker that dies or hangs is replaced: the drawing is loaded again and the best plan is restored, so no result is lost.
 */

import { ClosedError, quietAtClose } from './closed.js';
import { KerfwayError } from './errors.js';
import { MultiSearch, type Drawing } from './multi-search.js';
import { checkFile, checkMachine, checkOptions, checkOutput, checkProgram } from './options.js';
import { Prover, type ProofHandle } from './prover.js';
import { RunningPlan, type PlanHandle, type PlanMessage } from './plan-handle.js';
import type { Quote, QuoteTerms } from './quote.js';
import { Requests } from './requests.js';
import type { Responses } from './responses.js';
import { checkSize } from './size.js';
import type { Configuration } from './places.js';
import { copied, withWarmPath } from './plain-data.js';
import { type SILENCE_LIMITS, type StartWorker, type WasmFiles, WorkerConnection } from './worker-connection.js';
import { WorkerStart } from './worker-start.js';
import type {
  Budget,
  Calibration,
  FromWorker,
  BinaryKind,
  CheckedOn,
  Dialect,
  LoadOptions,
  Loaded,
  MachineProfile,
  MeasuredPlan,
  MethodInfo,
  OutputKind,
  PaperMethod,
  PlanOptions,
  ProgramCheck,
  ProofBudget,
  Progress,
  ToWorker,
  WarmPath,
} from './protocol.js';

/** Options of `createPlanner`. */
export interface PlannerOptions extends Configuration {
  /** Called with one sentence when a worker had to be replaced. */
  onReplaced?: (message: string) => void;
}

/** What a planner needs. */
export interface Parts extends WasmFiles {
  start: StartWorker;
  onReplaced?: ((message: string) => void) | undefined;
  /** Seconds after which a silent worker counts as hung. */
  silenceLimits?: typeof SILENCE_LIMITS;
}

const CLOSED = 'The planner was closed.';

/** A worker that keeps a drawing and its plan. Make one with `createPlanner`, and close it when done. */
export class Planner {
  /** The available methods, the default first. */
  methods: readonly MethodInfo[] = [];
  /** The machine presets, the default first. */
  machines: readonly MachineProfile[] = [];
  /** The shipped dialects of G-code, the default first. */
  dialects: readonly Dialect[] = [];
  /** Why the worker was last replaced; `null` if it never was. */
  replaced: string | null = null;

  private connection!: WorkerConnection;
  private lastId = 0;
  private readonly requests = new Requests();
  /** Running plans: one, and for a moment also the one that it replaces. */
  private readonly plans = new Map<number, RunningPlan>();
  /** The drawing in the worker. */
  private drawing: Drawing | null = null;
  /** The last plan, running or ended. */
  private current: RunningPlan | null = null;
  /** Plans that continue one which has not begun, each the one before it. */
  private continued: { before: number; id: number; budget: Budget }[] = [];
  /** Messages wait for this: it resolves when the worker has started and has read the drawing. */
  private ready: Promise<void> = Promise.resolve();
  private readonly starting = new WorkerStart();
  private restoring = false;
  private closed = false;

  /** The other searches of a plan with several workers. */
  private readonly others: MultiSearch;
  /** The proof of the current plan's job. */
  private prover: Prover | null = null;

  private constructor(private readonly parts: Parts) {
    this.others = new MultiSearch({
      ...parts,
      toFirst: (message) => this.connection.post(message),
      report: (message) => this.report(message),
    });
  }

  /** Opens a planner, and resolves when its worker is ready. */
  static async open(parts: Parts): Promise<Planner> {
    const planner = new Planner(parts);
    planner.ready = planner.connect();
    await planner.ready;
    return planner;
  }

  /** Reads a DXF or SVG file. A running plan ends. Rejects with a `KerfwayError` when the file or an option is unusable. */
  load(source: ArrayBuffer | ArrayBufferView, name: string, options: LoadOptions = {}): Promise<Loaded> {
    return quietAtClose(async () => {
      const bytes = checkFile(source, name);
      checkSize(bytes.byteLength);
      const drawing = { bytes: ownCopy(bytes), name, options: checkOptions(options, 'load') };
      return this.read((id) => ({ type: 'load', id, ...drawing }), () => drawing);
    });
  }

  /** Reads the same file with other options. A running plan ends. */
  reload(options: LoadOptions): Promise<Loaded> {
    return quietAtClose(async () => {
      const own = { options: checkOptions(options, 'reload') };
      try {
        return await this.read((id) => ({ type: 'reload', id, ...own }), (drawing) => drawing && { ...drawing, ...own });
      } finally {
        // The running plan has ended even if the options are unusable.
        this.others.end();
      }
    });
  }

  /** The methods of published papers, with their parameters. They are in a wasm file of their own, which the first call loads. */
  paperMethods(): Promise<PaperMethod[]> {
    return quietAtClose(async () => {
      await this.ready;
      return (await this.ask<'papers'>((id) => ({ type: 'papers', id }))).methods;
    });
  }

  /**
   * Plans the loaded drawing. One plan runs at a time: a running plan ends. If the callback throws, its plan ends and rejects
   * with that error.
   */
  plan(given: PlanOptions = {}, onProgress: (progress: Progress) => unknown = () => {}): PlanHandle {
    return this.begin(onProgress, (plan) => {
      plan.options = checkOptions(withWarmPath(given), 'planning');
      this.continued = [];
      this.others.end();
      this.endProof();
      return { type: 'plan', id: plan.id, options: plan.options };
    });
  }

  /**
   * Works on a lower bound of the current plan's job in a worker of its own, beside its search or after it, until the budget is used up.
   * A higher bound is reported as the progress of the plan and is in its outputs. Up to 128 contours it can prove that a path is optimal. It is stronger
   * than the search's own from about 100 contours on, where contours have corners in which the machine brakes, and where contours may be left unfinished
   * or are cut as one. It has a certificate, which `kerfway verify` checks. Another plan or another drawing ends the proof. `onBound` gets what
   * is proven and the best path that the proof has found, for `offer`.
   */
  prove(budget: ProofBudget = {}, onBound: (seconds: number, path: WarmPath | null) => unknown = () => {}): ProofHandle {
    if (this.closed) throw new ClosedError(CLOSED);
    const own = checkOptions(budget, 'prove');
    if (this.drawing === null || this.current === null) throw new KerfwayError('no-plan', 'There is no plan to prove a bound for. Start one first.');
    this.endProof();
    // The best path of the plan is known at another moment each time, so that a budget in work does without.
    const planning = { ...this.current.options, warm: own.work === undefined ? (this.current.path ?? undefined) : undefined };
    this.prover = new Prover(this.parts, this.drawing, planning, own, (lowerBound, path) => {
      this.whenReady({ type: 'raise', lowerBound });
      return onBound(lowerBound, path);
    });
    return this.prover;
  }

  /**
   * Offers the current plan a path from elsewhere, such as the one that a proof has found. The plan takes it over once its search has ended, if it takes less.
   * Resolves with what the plan has become, or with null if it stays as it is.
   */
  offer(path: WarmPath): Promise<Progress | null> {
    return quietAtClose(async () => {
      const plan = this.current;
      if (plan === null) throw new KerfwayError('no-plan', 'There is no plan to offer a path to. Start one first.');
      const own = copied(path);
      await plan.handle.done;
      await this.ready;
      // Another plan may have begun meanwhile.
      if (this.current !== plan) return null;
      const { progress } = await this.ask<'offer'>((id) => ({ type: 'offer', id, path: own }));
      return progress && plan.improve(progress);
    });
  }

  /** Continues the last plan for another budget. */
  continue(budget: Budget, onProgress: (progress: Progress) => unknown = () => {}): PlanHandle {
    return this.begin(onProgress, (plan) => {
      const own = checkOptions(budget, 'continue');
      const before = this.current;
      plan.options = { ...before?.options, ...own };
      this.others.continue(before?.id, plan.id, own);
      if (before?.begun === null) this.continued.push({ before: before.id, id: plan.id, budget: own });
      if (before !== null) plan.follow(before);
      return { type: 'continue', id: plan.id, budget: own };
    });
  }

  /** Checks the best plan so far and writes it in one of the formats. `width` is the width of a PNG in pixels. */
  output(kind: BinaryKind, width?: number): Promise<Uint8Array>;
  output(kind: Exclude<OutputKind, BinaryKind>): Promise<string>;
  output(kind: OutputKind, width?: number): Promise<string | Uint8Array>;
  output(kind: OutputKind, width?: number): Promise<string | Uint8Array> {
    return quietAtClose(async () => {
      checkOutput(kind, width);
      await this.ready;
      const size = width === undefined ? {} : { width };
      return (await this.ask<'output'>((id) => ({ type: 'output', id, kind, ...size }))).data;
    });
  }

  /**
   * Reads a G-code program back by the rules of a machine's dialect and says what it would do there. Without a program it is that of
   * the best plan so far: `output` refuses one that fails.
   */
  check(program: string | null = null, options: CheckedOn = {}): Promise<ProgramCheck> {
    return quietAtClose(async () => {
      checkProgram(program);
      const own = checkOptions(options, 'checkedOn');
      await this.ready;
      return (await this.ask<'check'>((id) => ({ type: 'check', id, program, options: own }))).check;
    });
  }

  /** A small program for a machine, a square with a hole, which shows what its dialect looks like. */
  sampleProgram(options: CheckedOn = {}): Promise<string> {
    return quietAtClose(async () => {
      const own = checkOptions(options, 'checkedOn');
      await this.ready;
      return (await this.ask<'sample'>((id) => ({ type: 'sample', id, options: own }))).program;
    });
  }

  /** The quote report of the best plan so far, which is checked as for an output. */
  quote(terms: QuoteTerms = {}): Promise<Quote> {
    return quietAtClose(async () => {
      const own = checkOptions(terms, 'terms');
      await this.ready;
      return (await this.ask<'quote'>((id) => ({ type: 'quote', id, terms: own }))).quote;
    });
  }

  /**
   * Fits the acceleration along contours, the corner deviation and the pierce time of a machine to the seconds that one or more jobs took.
   * The plans are documents (the output `json`) of this machine.
   */
  calibrate(machine: MachineProfile, measured: readonly MeasuredPlan[]): Promise<Calibration> {
    return quietAtClose(async () => {
      checkMachine(machine);
      const own = copied({ machine, measured });
      await this.ready;
      return (await this.ask<'calibrate'>((id) => ({ type: 'calibrate', id, ...own }))).calibration;
    });
  }

  /** Ends the worker. Requests and plans that are running are rejected. */
  close(): void {
    this.closed = true;
    this.others.close();
    this.endProof();
    this.connection.close();
    const reason = new ClosedError(CLOSED);
    // Calls that wait for a worker that is still starting are rejected too.
    this.ready.catch(() => {});
    this.starting.fail(reason);
    this.abandon(reason);
  }

  /** Asks the worker to read a drawing, which takes the place of the one before and of its plan. A plan that was begun meanwhile is of the new one. */
  private async read(message: (id: number) => ToWorker, drawing: (before: Drawing | null) => Drawing | null): Promise<Loaded> {
    const plan = this.current;
    await this.ready;
    const { loaded } = await this.ask<'load'>(message);
    this.drawing = drawing(this.drawing);
    this.others.end();
    this.endProof();
    if (this.current === plan) this.current = null;
    return loaded;
  }

  private endProof(): void {
    this.prover?.close();
    this.prover = null;
  }

  // If `prepare` refuses the plan, the plan fails and a running one goes on. Otherwise it returns the message that begins the plan.
  private begin(onProgress: (progress: Progress) => unknown, prepare: (plan: RunningPlan) => ToWorker): PlanHandle {
    const plan = new RunningPlan(++this.lastId, onProgress, (message) => {
      this.whenReady(message);
      if (this.others.runs(plan.id)) this.others.post(message);
    });
    try {
      if (this.closed) throw new ClosedError(CLOSED);
      this.whenReady(prepare(plan), (error) => {
        this.plans.delete(plan.id);
        plan.fail(error);
      });
      this.current = plan;
      this.plans.set(plan.id, plan);
    } catch (error) {
      plan.fail(error);
    }
    return plan.handle;
  }

  // `failed` hears why a message cannot be sent. What concerns a plan that could not begin needs no sending.
  private whenReady(message: ToWorker, failed: (error: unknown) => void = () => {}): void {
    const post = () => {
      this.connection.post(message);
      this.updateExpectation();
    };
    this.ready.then(post).catch(failed);
  }

  private ask<K extends keyof Responses>(message: (id: number) => ToWorker): Promise<Responses[K]> {
    if (this.closed) return Promise.reject(new ClosedError(CLOSED));
    const id = ++this.lastId;
    this.connection.post(message(id));
    const answer = this.requests.add<K>(id);
    this.updateExpectation();
    return answer;
  }

  private connect(): Promise<void> {
    const open = () => {
      const { start, silenceLimits } = this.parts;
      this.connection = new WorkerConnection(start, this.parts, (m) => this.receive(m), (why) => this.lost(why), silenceLimits);
      this.connection.expect('working');
    };
    return this.starting.run(open, () => (this.closed ? new ClosedError(CLOSED) : null));
  }

  private lost(why: string): void {
    if (this.starting.running) this.starting.fail(new KerfwayError('planner-died', why));
    else void this.replace(why);
  }

  private receive(message: FromWorker): void {
    if (message.type === 'ready') {
      this.methods = message.methods;
      this.machines = message.machines;
      this.dialects = message.dialects;
      this.starting.succeed();
    } else if ('id' in message) {
      this.deliver(message);
    }
    this.updateExpectation();
  }

  private deliver(message: Extract<FromWorker, { id: number }>): void {
    const plan = this.plans.get(message.id);
    if (plan !== undefined) {
      const { workers = 1 } = plan.options;
      const isLast = plan === this.current || this.continued[0]?.before === plan.id;
      if (message.type === 'started' && workers > 1 && this.drawing !== null && isLast) {
        this.others.begin(plan.id, { ...plan.options, seed: message.seed }, this.drawing);
        for (const { before, id, budget } of this.continued.splice(0)) this.others.continue(before, id, budget);
      }
      if (this.others.runs(plan.id)) this.others.receive(0, message);
      // Its other searches have ended, so there is nobody to wait for.
      else if (message.type === 'meeting') this.connection.post({ type: 'meet', id: plan.id, path: null });
      else this.report(message as PlanMessage);
    } else {
      this.requests.settle(message);
    }
  }

  private report(message: PlanMessage): void {
    const plan = this.plans.get(message.id);
    plan?.receive(message);
    if (plan?.ended === true) this.plans.delete(message.id);
    this.updateExpectation();
  }

  // Tells the connection what the worker is doing now, which decides how long it may stay silent.
  private updateExpectation(): void {
    const plans = [...this.plans.values()].filter((p) => !p.paused);
    // One of several searches sends nothing while it waits for the others.
    const sendsProgress = (p: RunningPlan) => p.begun !== null && !this.others.runs(p.id);
    const searching = plans.length > 0 && plans.every(sendsProgress) && !this.requests.pending;
    const busy = plans.length > 0 || this.requests.pending;
    this.connection.expect(searching ? 'searching' : busy ? 'working' : 'idle');
  }

  // A worker died. A drawing that it was reading is not read again, because it may have caused the death. The drawing from
  // before is restored once: if the new worker dies of that, it is replaced by one without a drawing.
  private async replace(why: string): Promise<void> {
    const kept = this.restoring ? null : this.drawing;
    this.replaced = why;
    const message = `${why} It was started again${kept === null ? '.' : ' and the drawing loaded again.'}`;
    this.abandon(new KerfwayError('planner-died', message));
    const plan = kept === null ? null : this.current;
    [this.drawing, this.current] = [null, plan];
    this.ready = this.connect().then(() => (kept === null ? undefined : this.restore(kept, plan)));
    // If the worker could not be started, later calls reject with the reason.
    const started = await this.ready.then(() => true, () => false);
    if (started) this.reportReplacement(message);
  }

  // This callback belongs to no call, so there is nobody to pass its errors to.
  private reportReplacement(message: string): void {
    try {
      const returned: unknown = this.parts.onReplaced?.(message);
      if (returned instanceof Promise) returned.catch(() => {});
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
    } finally {
      this.restoring = false;
    }
  }

  private abandon(reason: Error): void {
    this.others.end('replaced');
    this.requests.rejectAll(reason);
    for (const plan of this.plans.values()) plan.interrupt(reason);
    this.plans.clear();
  }
}

/** A copy of the bytes: the caller may change its own, and a new worker needs them again. */
function ownCopy(bytes: ArrayBuffer | Uint8Array): ArrayBuffer {
  return new Uint8Array(bytes).slice().buffer;
}
