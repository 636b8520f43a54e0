/**
 * The messages between the package and its workers, and the types of the data in them.
 *
 * Units: mm, s, rad. Geometry and paths travel as transferable typed arrays; options and reports as plain objects.
 */

import type { Material, Quote } from './quote.js';

/** The unit of a drawing. */
export type Unit = 'in' | 'ft' | 'yd' | 'mil' | 'microinch' | 'um' | 'mm' | 'cm' | 'dm' | 'm';
/** How the machine processes a contour or layer. */
export type Operation = 'cut' | 'mark' | 'ignore';
/** The severity of a finding. Info: worth knowing. Warning: something was skipped, changed or guessed, so check it. Error: it cannot be cut as drawn. */
export type Severity = 'info' | 'warning' | 'error';

/** How a drawing is read. All options are optional; by default all layers are cut. */
export interface LoadOptions {
  /** The unit of the drawing. Default: the unit in the file's header, or a guess. */
  units?: Unit;
  /** Largest distance between a spline or ellipse and the lines and arcs that replace it, mm. Default 0.005. */
  tolerance?: number;
  /** Whether to keep entities in a damaged place of the file. Default false. */
  keepDamaged?: boolean;
  /** End points that are closer than this are joined, mm. Default 0.05. */
  joinTolerance?: number;
  /** The operation of each layer, by name. Their order is that of `orderByLayer`. */
  layers?: { name: string; operation: Operation }[];
  /** Whether to process one layer after the other. Default false. */
  orderByLayer?: boolean;
  /** Whether to ignore a single border around everything. Default false. */
  ignoreOutline?: boolean;
  /** Whether to finish each part, with everything in its holes, before the next one. Default false. */
  partByPart?: boolean;
  /**
   * How contours with common cuts are cut on a machine that makes pre-cuts. `best` (default): pierced once and cut
   * together on the best path through them that is found; `insertion`: on the path of the element insertion heuristic of
   * Dewil et al.; `off`: each contour separately, and a common cut with one of its contours.
   */
  commonCuts?: CommonCuts;
  /** Ids of contours to process before all others, with everything inside them. */
  first?: number[];
  /** Ids of contours to process after all others, with the contours around them. */
  last?: number[];
  /**
   * Ids of contours to skip. They stay in the list of contours with the operation `ignore`, so that the others keep their
   * ids. A hole in a skipped contour becomes a part of its own. A side that a skipped contour shares with another contour
   * is cut with the other one.
   */
  exclude?: number[];
}

/** How contours with common cuts are cut. */
export type CommonCuts = 'best' | 'insertion' | 'off';

/** The kind of a finding. Later versions may add codes. */
export type FindingCode =
  | 'unsupported-entity' | 'damaged-entity' | 'resynchronised' | 'truncated' | 'bad-number' | 'invalid-geometry' | 'missing-block' | 'cyclic-block'
  | 'hidden-entity' | 'units-guessed' | 'units-doubtful' | 'encoding' | 'projected' | 'outline-taken'
  | 'gap-closed' | 'gap-left' | 'branch' | 'duplicate-removed' | 'overlap-removed' | 'feature-too-small' | 'common-cut' | 'zero-length' | 'self-crossing' | 'crossing'
  | 'open-contour' | 'several-layers' | 'sheet-outline' | 'layer-suggestion' | 'layer-ignored' | 'contour-excluded' | 'layer-unknown'
  | 'kerf-not-applied' | 'far-from-origin' | 'not-all-checked' | 'more';

/** Something that a person should know about the drawing, with its position. */
export interface Finding {
  code: FindingCode;
  severity: Severity;
  message: string;
  layer: string | null;
  handle: string | null;
  at: [number, number] | null;
  count: number;
}

/** A layer of the drawing and its operation. */
export interface LayerUse {
  name: string;
  /** AutoCAD colour index. */
  color: number;
  operation: Operation;
  /** The operation that its name suggests, if that is another one. */
  suggestion: Operation | null;
  rank: number;
  contours: number;
}

/** The unit in which a drawing was read, and why. */
export interface UnitsTaken {
  unit: Unit;
  source: 'header' | 'guessed' | 'given';
  reason: string;
  doubtful: boolean;
}

/** A contour. Lengths are in mm, areas in mm2. */
export interface ContourInfo {
  id: number;
  closed: boolean;
  layer: string;
  /** `ignore`: skipped by the option `exclude`, or as the border. */
  operation: Operation;
  /** The contour around it. */
  inside: number | null;
  length: number;
  area: number;
}

/** The lines and arcs of contours. */
export interface Geometry {
  /** Seven numbers per element: x0, y0, x1, y1, centre x, centre y, sweep angle (0 for a line). */
  segments: Float64Array;
  /** The index of each contour's first element, and the number of elements at the end. */
  offsets: Uint32Array;
}

/** The contents of a drawing. */
export interface Loaded {
  name: string;
  sha256: string;
  version: string | null;
  units: UnitsTaken;
  /** Entities of model space, counted by kind. */
  entities: { kind: string; count: number; supported: boolean }[];
  layers: LayerUse[];
  contours: ContourInfo[];
  /** The parts: the outer contour, the holes, and the index of the part around it. */
  parts: { outer: number; holes: number[]; inside: number | null }[];
  /** The contour that seems to be the sheet's border. */
  outline: number | null;
  /** xmin, ymin, xmax, ymax in mm. */
  bounds: [number, number, number, number];
  findings: Finding[];
  /** The lines and arcs of the contours, by id. */
  geometry: Geometry;
  /** Chains that are shown but not cut, each with the index of its layer: first those of ignored layers, then skipped contours by id. */
  ignored: { geometry: Geometry; layers: Uint32Array };
}

/** A machine set up for a material; see `machine/profile.rs`. */
export interface MachineProfile {
  version: 1;
  name: string;
  title: string;
  home: [number, number];
  return_home: boolean;
  travel: 'straight' | 'vector' | 'per-axis';
  rapid: { speed: [number, number]; accel: [number, number] | null };
  cut: { speed: number; accel: number | null; power: number };
  mark: { speed: number; accel: number | null; power: number };
  junction_deviation: number | null;
  pierce_time: number;
  /**
   * The time of a pre-cut, s. A cut may stop where a pre-cut is made and resume there later without piercing. 0: cuts may
   * be interrupted at no cost. Null or absent: every contour is cut without interruption.
   */
  pre_cut_time?: number | null;
  /** The length of a pre-cut along the contour, mm. `pre_cut_time` includes the way there and back. Default 0. */
  pre_cut_length?: number;
  /** The beam pauses for `time` seconds in corners of less than `angle` rad. Null or absent: no pauses. */
  sharp_corner?: { angle: number; time: number } | null;
  /**
   * The width of the cut, mm, from 0.02 to 10. Contours are then the outlines of parts and holes, and the beam follows them
   * offset by half the kerf width. 0 or absent: the beam follows the drawn lines.
   */
  kerf_width?: number;
  beam_on_delay: number;
  beam_off_delay: number;
  dialect: 'grbl-m4';
  max_s: number;
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

/** When a plan ends. If both are given, the first to be reached ends it. */
export interface Budget {
  /** After this many seconds of work. */
  seconds?: number;
  /** After this many moves. The same seed and number of moves give the same bytes everywhere. */
  moves?: number;
}

/** How a drawing is planned. */
export interface PlanOptions extends Budget {
  /** The name of a preset, or a profile. Default `co2-100w`. */
  machine?: string | MachineProfile;
  /** The name of a method. Default: the first of `Planner.methods`. */
  method?: string;
  /** Parameters of a method from a paper that differ from their defaults: see `Planner.paperMethods`. */
  parameters?: Record<string, unknown>;
  /** The seed of all random choices. Default: a random seed, which the result contains. */
  seed?: number;
  /** A path to start from. */
  warm?: WarmPath;
  /**
   * The number of parallel searches, each in a worker of its own with its own random numbers. They exchange the best path
   * at fixed numbers of moves, so the same number of workers gives the same bytes. A budget in moves applies to each
   * search. Default 1.
   */
  workers?: number;
}

/** The part of a path that a search needs to start from it. */
export type WarmPath = Pick<BestPath, 'contours' | 'along' | 'reversed'> & Partial<Pick<BestPath, 'until'>>;

/** The number of a worker among several, which selects its stream of random numbers. */
export interface Membership {
  member?: number;
}

/** The options of a plan as the core gets them. */
export interface StartOptions extends Omit<PlanOptions, 'parameters'>, Membership {
  /** The parameters as JSON text, set for methods from papers only. */
  parameters?: string;
}

/** Times and lengths of a plan, in s and mm; see `plan/model.rs`. */
export interface Summary {
  contours: number;
  open_contours: number;
  parts: number;
  pierces: number;
  pre_cuts: number;
  cut_length: number;
  air_length: number;
  cut_time: number;
  air_time: number;
  pierce_time: number;
  pre_cut_time: number;
  macro_time: number;
  total_time: number;
  lower_bound: number;
  gap: number | null;
  bounds: [number, number, number, number];
}

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
  /** The positions of pre-cuts: x and y of each. */
  preCuts: Float64Array;
  /** The sharp corners in which the beam pauses: x and y of each. */
  pauses: Float64Array;
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

/** A planning method. */
export interface MethodInfo {
  name: string;
  title: string;
  about: string;
  source: string | null;
}

/** A method from a published paper. */
export interface PaperMethod extends MethodInfo {
  /** The parameters with their defaults, which are the paper's values if it gives them. */
  parameters: Record<string, unknown>;
}

/** The internal state of a method from a paper at one time; see `solve/papers/insight.rs`. */
export interface Insight {
  /** The number of iterations or generations so far. */
  round: number;
  /** Current values, to be plotted against the round. */
  curves: { name: string; value: number }[];
  /** A table of numbers, such as a Q-table. `at` is the index of the entry that was used last. */
  grid: { name: string; rows: string[]; columns: string[]; values: number[]; at: number | null } | null;
  /**
   * The partitions of the best path, if the method uses them: the partition of each contour (0 is that of home), and the
   * contour and point (mm) from which each other partition is entered.
   */
  partitions: { of: number[]; parents: { contour: number; at: [number, number] }[] } | null;
}

/** Plans without a search, for comparison. */
export interface Baselines {
  /** The contours in the order of the drawing, each from its first point. */
  drawing: Summary;
  /** The nearest allowed contour next. */
  greedy: Summary;
}

/** The result of a slice of search, as the core returns it. */
export interface Slice {
  /** The number of moves made. */
  done: number;
  /** Whether the best plan has changed. */
  improved: boolean;
  end: 'running' | 'budget' | 'exhausted';
  /** A lower bound of the time of any plan, s; 0 before one is proven. */
  bound: number;
}

/** The format of an output. */
export type OutputKind = 'gcode' | 'svg' | 'dxf' | 'json' | 'png';

/** Why a plan ended. `replaced`: its worker died, and the best plan that it had reported is kept. */
export type DoneReason = 'budget' | 'stopped' | 'exhausted' | 'replaced';

/** Messages to a worker. Callers of the functions do not need them. */
export type ToWorker =
  /** The first message: the compiled planner, which all workers share. */
  | { type: 'init'; planner: WebAssembly.Module }
  | { type: 'load'; id: number; bytes: ArrayBuffer; name: string; options: LoadOptions }
  /** Reads the bytes of the last `load` again with other options. */
  | { type: 'reload'; id: number; options: LoadOptions }
  | { type: 'plan'; id: number; options: PlanOptions & Membership }
  /** Continues the finished plan for another budget. */
  | { type: 'continue'; id: number; budget: Budget }
  /** Ends an exchange between searches: continues from `path` if it is faster. After the end of a search, it takes over the path and answers with `done`. */
  | { type: 'meet'; id: number; path: WarmPath | null }
  | { type: 'pause' }
  | { type: 'resume' }
  | { type: 'stop' }
  | { type: 'papers'; id: number }
  | { type: 'quote'; id: number; material: Material }
  | { type: 'output'; id: number; kind: OutputKind; width?: number };

/** Messages from a worker. */
export type FromWorker =
  | { type: 'ready'; methods: MethodInfo[]; machines: MachineProfile[] }
  | { type: 'loaded'; id: number; loaded: Loaded }
  | { type: 'started'; id: number; seed: number; method: string; baselines: Baselines; findings: Finding[]; beam: Beam | null; common: Geometry | null }
  | { type: 'progress'; id: number; progress: Progress }
  /** One of several searches has reached an exchange and waits for the others. */
  | { type: 'meeting'; id: number; progress: Progress }
  | { type: 'bound'; id: number; lowerBound: number }
  | { type: 'done'; id: number; reason: DoneReason; progress: Progress }
  | { type: 'papers'; id: number; methods: PaperMethod[] }
  | { type: 'quote'; id: number; quote: Quote }
  | { type: 'output'; id: number; kind: OutputKind; data: string | Uint8Array }
  /** One sentence for people. */
  | { type: 'failed'; id: number; message: string }
  /** The planner has crashed and this worker cannot be used any more: one sentence for people. */
  | { type: 'broken'; message: string };
