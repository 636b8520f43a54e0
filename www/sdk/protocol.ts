/**
 * The messages between the package and its workers, and the types of the data in them.
 *
 * Units: mm, s, rad. Geometry and paths travel as transferable typed arrays; options and reports as plain objects. The
 * types of options and reports are generated from the Rust types (`generated/types.ts`). This file adds what Rust has no
 * type for: messages, typed arrays, and options that may all be left out.
 */

import type * as core from './generated/types.js';
import type {
  Baselines, Budget, Calibration, ContourInfo, Dialect, ErrorReport, Finding, Insight, MachineProfile, MethodInfo, PaperMethod, ProgramCheck, Quote, Summary,
} from './generated/types.js';
import type { QuoteTerms } from './quote.js';
import type { WasmBytes, WasmModule } from './wasm-module.js';

export type * from './generated/types.js';

/** How a drawing is read. All options are optional; by default all layers are cut. */
export interface LoadOptions extends Partial<core.LoadOptions> {}

/** The lines and arcs of contours. */
export interface Geometry {
  /** Seven numbers per element: x0, y0, x1, y1, centre x, centre y, sweep angle (0 for a line). */
  segments: Float64Array;
  /** The index of each contour's first element, and the number of elements at the end. */
  offsets: Uint32Array;
}

/** The contents of a drawing. */
export interface Loaded extends core.LoadedReport {
  /** The lines and arcs of the contours, by id. */
  geometry: Geometry;
  /** Chains that are shown but not cut, each with the index of its layer: first those of ignored layers, then skipped contours by id. */
  ignored: { geometry: Geometry; layers: Uint32Array };
}

/**
 * The contours as the beam follows them, by id. Contours of `Loaded` keep their ids. A contour of which other contours
 * cut a part may fall into several pieces, which come after them; one that others cut entirely has the operation
 * `ignore`. Areas are those of the finished parts.
 */
export interface Beam {
  contours: ContourInfo[];
  geometry: Geometry;
}

/** How a drawing is planned. */
export interface PlanOptions extends Partial<Omit<core.StartOptions, 'parameters' | 'member'>> {
  /** Parameters of a method from a paper that differ from their defaults: see `Planner.paperMethods`. */
  parameters?: Record<string, unknown>;
  /** The seed of all random choices. Default: a random seed, which the result contains. */
  seed?: number;
}

/** The machine by whose rules a program is read. */
export interface CheckedOn extends Pick<PlanOptions, 'machine'> {}

/** The part of a path that a search needs to start from it. */
export type WarmPath = Pick<BestPath, 'contours' | 'along' | 'reversed'> & Partial<Pick<BestPath, 'until'>>;

/** The number of a worker among several, which selects its stream of random numbers. */
export interface Membership extends Partial<Pick<core.StartOptions, 'member'>> {}

/** The options of a plan as the core gets them: the parameters of a method are JSON text. */
export interface StartOptions extends Partial<core.StartOptions> {}

/** The path of the head as a sequence of stops: stop k cuts `contours[k]`, or a stretch of it. */
export interface BestPath {
  contours: Uint32Array;
  /** Entry x, y and exit x, y of each stop. */
  points: Float64Array;
  /** Arc length from the contour's stored start to the entry, mm. */
  along: Float64Array;
  /** Arc length from the stored start to where the stop ends, mm. Equal to `along`: the whole contour. A contour that is cut in several stretches has several stops. */
  until: Float64Array;
  /** 1 if the stop follows its contour against the stored direction. */
  reversed: Uint8Array;
  /** When the cut of each stop begins and ends, in seconds from the start of the job: two numbers per stop. */
  times: Float64Array;
  /**
   * The elements of lead-ins and lead-outs, seven numbers each as in `Geometry.segments`. Empty without leads. With leads, `points` holds where
   * the lead-in begins and the lead-out ends.
   */
  leads: Float64Array;
  /** Where each lead begins among the elements: the lead-in of stop k is chain 2k, its lead-out chain 2k + 1. Empty without leads. */
  leadOffsets: Uint32Array;
  /** The elements of micro-joints, which stay uncut, seven numbers each as in `Geometry.segments`. */
  joints: Float64Array;
  /** Where each joint begins among the elements. */
  jointOffsets: Uint32Array;
  /** The positions of pre-cuts: x and y of each. */
  preCuts: Float64Array;
  /** The sharp corners in which the beam pauses: x and y of each. */
  pauses: Float64Array;
  /**
   * What the move to each stop does about pieces that may have tipped, and last that of the way home: 0 nothing, 1 it goes around them, 2 it
   * is lifted over them, 3 it crosses them with the head down; 4: it is a cut through waste; 5: it goes to a place
   * on a kerf (`via`), and is a cut through waste from there. Empty if the machine has no `levers.tips` and the
   * plan no chains.
   */
  ways: Uint8Array;
  /** The places on the way around tipped pieces, and those on kerfs: x and y of each. */
  via: Float64Array;
  /** The stop to which each of these moves leads; for the way home, the number of stops. */
  viaOf: Uint32Array;
  /** The contours that bound pieces which may tip once they are free; of a strip between parts, a cut across its end. */
  tips: Uint32Array;
  /** The stop that frees each of these pieces: the last cut along its outline. */
  freedBy: Uint32Array;
  /** The elements of loops at corners, seven numbers each as in `Geometry.segments`. */
  loops: Float64Array;
  /** Where each loop begins among the elements. */
  loopOffsets: Uint32Array;
  /** Seconds that the head waits before each stop until what was cut nearby has cooled; empty if it never does. */
  waits: Float64Array;
}

/** The progress of a search. */
export interface Progress {
  /** The number of moves that the search has made. */
  moves: number;
  /** Seconds of search, without pauses. */
  seconds: number;
  /** Recent moves per second. */
  rate: number;
  /** Times and lengths of the best plan so far. */
  summary: Summary;
  /** The path of the best plan, if it has changed since the last message. */
  path: BestPath | null;
  /** The internal state of a method from a paper. */
  insight?: Insight;
}

/** How long a proof works. If both are given, the first to be reached ends it; without a budget it works until it is stopped or proves no more. */
export interface ProofBudget {
  /** Seconds by the clock. */
  seconds?: number;
  /** Million numbers that it looks at, which proves the same everywhere. */
  work?: number;
}

/** What a proof has come to. */
export interface Proof {
  /** No plan takes less: seconds of the whole job. 0 if nothing is proven. */
  seconds: number;
  /** A certificate of it (`kerfway.certificate/1`), which `kerfway verify` checks; null if there is none. */
  certificate: string | null;
  /**
   * The best path that it has found, which may take less than that of the plan: `Planner.offer` takes it over. It searches up to 220 contours for itself; null
   * where there are more, and where they may be left unfinished or are cut as one.
   */
  path: WarmPath | null;
  /** Why nothing can be proven for this job, or why the proof ended early, in a sentence; null otherwise. */
  hindrance: string | null;
}

/** A plan that was run, and the seconds that the job took. */
export interface MeasuredPlan {
  /** The plan document, as the output `json`. */
  plan: string;
  /** Seconds by the clock. */
  seconds: number;
}

/** The format of an output. */
export type OutputKind = 'gcode' | 'svg' | 'dxf' | 'json' | 'png' | 'lbrn2' | 'rd' | 'remainder';

/** The formats that are bytes instead of text. */
export type BinaryKind = 'png' | 'rd';

/** Why a plan ended. `replaced`: its worker died, and the best plan that it had reported is kept. */
export type DoneReason = 'budget' | 'stopped' | 'exhausted' | 'replaced';

/** Messages to a worker. Callers of the functions do not need them. */
export type ToWorker =
  /** The first message: the compiled planner, which all workers share, and the writers of outputs where the worker cannot load them itself. */
  | { type: 'init'; planner: WasmModule; outputs?: WasmModule | WasmBytes | undefined }
  | { type: 'load'; id: number; bytes: ArrayBuffer; name: string; options: LoadOptions }
  /** Reads the bytes of the last `load` again with other options. */
  | { type: 'reload'; id: number; options: LoadOptions }
  | { type: 'plan'; id: number; options: PlanOptions & Membership }
  /** Continues the finished plan for another budget. */
  | { type: 'continue'; id: number; budget: Budget }
  /** Ends an exchange between searches: continues from `path` if it is faster. After the end of a search, it takes over the path and answers with `done`. Ignored when another plan runs. */
  | { type: 'meet'; id: number; path: WarmPath | null }
  /** For the plan with this id; ignored when another one runs. */
  | { type: 'pause' | 'resume' | 'stop'; id: number }
  /** Works on the lower bound of a job of its own. Sent to a worker that does nothing else. */
  | { type: 'prove'; id: number; bytes: ArrayBuffer; name: string; options: LoadOptions; planning: PlanOptions; budget: ProofBudget }
  /** A lower bound of the current plan's job in seconds, which another worker has proven. */
  | { type: 'raise'; lowerBound: number }
  /** A path from elsewhere for the plan whose search has ended. */
  | { type: 'offer'; id: number; path: WarmPath }
  | { type: 'papers'; id: number }
  | { type: 'quote'; id: number; terms: QuoteTerms }
  /** Checks a program for a machine; without a program, that of the best plan so far. */
  | { type: 'check'; id: number; program: string | null; options: CheckedOn }
  /** Writes a small program for a machine. */
  | { type: 'sample'; id: number; options: CheckedOn }
  | { type: 'calibrate'; id: number; machine: MachineProfile; measured: readonly MeasuredPlan[] }
  | { type: 'output'; id: number; kind: OutputKind; width?: number };

/** Messages from a worker. */
export type FromWorker =
  | { type: 'ready'; methods: MethodInfo[]; machines: MachineProfile[]; dialects: Dialect[] }
  /** Contours and parts that come before those of the answer with this id. */
  | { type: 'piece'; id: number; contours: ContourInfo[]; parts: Loaded['parts'] }
  | { type: 'loaded'; id: number; loaded: Loaded }
  | { type: 'started'; id: number; seed: number; method: string; baselines: Baselines; findings: Finding[]; beam: Beam | null; common: Geometry | null; shift: [number, number] }
  | { type: 'progress'; id: number; progress: Progress }
  /** One of several searches has reached an exchange and waits for the others. */
  | { type: 'meeting'; id: number; progress: Progress }
  /** `path`: a better path than before, which a proof has found. */
  | { type: 'bound'; id: number; lowerBound: number; path?: WarmPath | null }
  | { type: 'done'; id: number; reason: DoneReason; progress: Progress }
  /** What a proof has come to. Its path was reported before. */
  | { type: 'proof'; id: number; proof: Omit<Proof, 'path'> }
  /** The plan with the path that was offered; null if that takes no less. */
  | { type: 'offered'; id: number; progress: Progress | null }
  | { type: 'papers'; id: number; methods: PaperMethod[] }
  | { type: 'quote'; id: number; quote: Quote }
  | { type: 'check'; id: number; check: ProgramCheck }
  | { type: 'sample'; id: number; program: string }
  | { type: 'calibrate'; id: number; calibration: Calibration }
  | { type: 'output'; id: number; kind: OutputKind; data: string | Uint8Array }
  | { type: 'failed'; id: number; error: ErrorReport }
  /** The planner has crashed and this worker cannot be used any more: one sentence for people. */
  | { type: 'broken'; message: string };
