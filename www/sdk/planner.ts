/**
 * The class `Planner`: loads a drawing, plans it, reports the progress, writes outputs. It checks what its callers give; the
 * work is done in a worker, which `PlannerWorker` starts, asks, and replaces when it dies.
 */

import { quietAtClose } from './closed.js';
import { KerfwayError } from './errors.js';
import type { Drawing } from './multi-search.js';
import { checkCallback, checkFile, checkMeasured, checkOptions, checkOutput, checkProfile, checkProgram } from './options.js';
import { Prover, type ProofHandle } from './prover.js';
import type { PlanHandle } from './plan-handle.js';
import { type Parts, PlannerWorker } from './planner-worker.js';
import type { Quote, QuoteTerms } from './quote.js';
import { checkSize } from './size.js';
import type { Configuration } from './places.js';
import { copied, withWarmPath } from './plain-data.js';
import type {
  Budget,
  Calibration,
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

  private readonly worker: PlannerWorker;
  /** The proof of the current plan's job. */
  private prover: Prover | null = null;

  private constructor(private readonly parts: Parts) {
    this.worker = new PlannerWorker(parts, {
      ready: ({ methods, machines, dialects }) => Object.assign(this, { methods, machines, dialects }),
      replaced: (why) => (this.replaced = why),
    });
  }

  /** Opens a planner, and resolves when its worker is ready. */
  static async open(parts: Parts): Promise<Planner> {
    const planner = new Planner(parts);
    await planner.worker.open();
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
        this.worker.others.end();
      }
    });
  }

  /** The methods of published papers, with their parameters. They are in a wasm file of their own, which the first call loads. */
  paperMethods(): Promise<PaperMethod[]> {
    return quietAtClose(async () => (await this.worker.ask<'papers'>((id) => ({ type: 'papers', id }))).methods);
  }

  /**
   * Plans the loaded drawing. One plan runs at a time: a running plan ends. If the callback throws, its plan ends and rejects
   * with that error.
   */
  plan(given: PlanOptions = {}, onProgress: (progress: Progress) => unknown = () => {}): PlanHandle {
    return this.worker.begin(onProgress, (plan) => {
      checkCallback('onProgress', onProgress);
      plan.options = checkOptions(withWarmPath(given), 'planning');
      this.worker.continued = [];
      this.worker.others.end();
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
    this.worker.refuseClosed();
    const own = checkOptions(budget, 'prove');
    checkCallback('onBound', onBound);
    const { drawing, current } = this.worker;
    if (drawing === null || current === null) throw new KerfwayError('no-plan', 'There is no plan to prove a bound for. Start one first.');
    this.endProof();
    // The best path of the plan is known at another moment each time, so that a budget in work does without.
    const planning = { ...current.options, warm: own.work === undefined ? (current.path ?? undefined) : undefined };
    this.prover = new Prover(this.parts, drawing, planning, own, (lowerBound, path) => {
      this.worker.whenReady({ type: 'raise', lowerBound });
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
      this.worker.refuseClosed();
      const plan = this.worker.current;
      if (plan === null) throw new KerfwayError('no-plan', 'There is no plan to offer a path to. Start one first.');
      const own = copied(path);
      await plan.handle.done;
      // Another plan may have begun meanwhile.
      if (this.worker.current !== plan) return null;
      const { progress } = await this.worker.ask<'offer'>((id) => ({ type: 'offer', id, path: own }));
      return progress && plan.improve(progress);
    });
  }

  /** Continues the last plan for another budget. */
  continue(budget: Budget, onProgress: (progress: Progress) => unknown = () => {}): PlanHandle {
    return this.worker.begin(onProgress, (plan) => {
      checkCallback('onProgress', onProgress);
      const own = checkOptions(budget, 'continue');
      const before = this.worker.current;
      plan.options = { ...before?.options, ...own };
      this.worker.others.continue(before?.id, plan.id, own);
      if (before?.begun === null) this.worker.continued.push({ before: before.id, id: plan.id, budget: own });
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
      const size = width === undefined ? {} : { width };
      return (await this.worker.ask<'output'>((id) => ({ type: 'output', id, kind, ...size }))).data;
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
      return (await this.worker.ask<'check'>((id) => ({ type: 'check', id, program, options: own }))).check;
    });
  }

  /** A small program for a machine, a square with a hole, which shows what its dialect looks like. */
  sampleProgram(options: CheckedOn = {}): Promise<string> {
    return quietAtClose(async () => {
      const own = checkOptions(options, 'sampleProgram');
      return (await this.worker.ask<'sample'>((id) => ({ type: 'sample', id, options: own }))).program;
    });
  }

  /** The quote report of the best plan so far, which is checked as for an output. */
  quote(terms: QuoteTerms = {}): Promise<Quote> {
    return quietAtClose(async () => {
      const own = checkOptions(terms, 'terms');
      return (await this.worker.ask<'quote'>((id) => ({ type: 'quote', id, terms: own }))).quote;
    });
  }

  /**
   * Fits the acceleration along contours, the corner deviation and the pierce time of a machine to the seconds that one or more jobs took.
   * The plans are documents (the output `json`) of this machine. Seconds that no machine near to this one takes are refused (`out-of-range`).
   */
  calibrate(machine: MachineProfile, measured: readonly MeasuredPlan[]): Promise<Calibration> {
    return quietAtClose(async () => {
      checkProfile(machine);
      checkMeasured(measured);
      const own = copied({ machine, measured });
      return (await this.worker.ask<'calibrate'>((id) => ({ type: 'calibrate', id, ...own }))).calibration;
    });
  }

  /** Ends the worker. Requests and plans that are running are rejected. */
  close(): void {
    this.endProof();
    this.worker.close();
  }

  /** Asks the worker to read a drawing, which takes the place of the one before and of its plan. A plan that was begun meanwhile is of the new one. */
  private async read(message: (id: number) => ToWorker, drawing: (before: Drawing | null) => Drawing | null): Promise<Loaded> {
    const { worker } = this;
    const plan = worker.current;
    const { loaded } = await worker.ask<'load'>(message);
    worker.drawing = drawing(worker.drawing);
    worker.others.end();
    this.endProof();
    if (worker.current === plan) worker.current = null;
    return loaded;
  }

  private endProof(): void {
    this.prover?.close();
    this.prover = null;
  }

}

/** A copy of the bytes: the caller may change its own, and a new worker needs them again. */
function ownCopy(bytes: ArrayBuffer | Uint8Array): ArrayBuffer {
  return new Uint8Array(bytes).slice().buffer;
}
