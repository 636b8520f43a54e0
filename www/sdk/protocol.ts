/**
 * The worker protocol and the data that crosses it: one file, typed, used by the worker, the package and the page.
 *
 * Units: mm, s, rad. Geometry and paths travel as transferable typed arrays; options and reports as plain objects.
 */

import type { Material, Quote } from './quote.js';

/** Units a drawing may be in. */
export type Unit = 'in' | 'ft' | 'yd' | 'mil' | 'microinch' | 'um' | 'mm' | 'cm' | 'dm' | 'm';
/** What is done with a contour or layer. */
export type Operation = 'cut' | 'mark' | 'ignore';
/** How much a finding matters: worth knowing; left out, changed or guessed, so look at it; cannot be cut as drawn. */
export type Severity = 'info' | 'warning' | 'error';

/** How a drawing is read and arranged. Everything is optional; nothing given means: header or guess, all layers cut. */
export interface LoadOptions {
  /** Units given by the person; otherwise the file's header or a guess. */
  units?: Unit;
  /** Largest distance between a spline or ellipse and its lines and arcs, mm. Default 0.005. */
  tolerance?: number;
  /** Keep entities that were read through a break in the file. Default false. */
  keepDamaged?: boolean;
  /** Ends nearer than this are joined, mm. Default 0.05. */
  joinTolerance?: number;
  /** What is done with each layer, by name; the order of the list is the order by layer. */
  layers?: { name: string; operation: Operation }[];
  /** Work layer after layer. Default false. */
  orderByLayer?: boolean;
  /** Leave out the lone border around everything. Default false. */
  ignoreOutline?: boolean;
  /** Work a part wholly, with all that lies in its holes, before the next one. Default false. */
  partByPart?: boolean;
  /**
   * Contours that share cuts are pierced once and cut as a whole, where the machine makes pre-cuts. `best` (default): on
   * the best way through them that is found; `insertion`: on that of the element insertion heuristic of Dewil et al.;
   * `off`: every contour by itself, what two share with one of them.
   */
  commonCuts?: CommonCuts;
  /** Contours worked before all others, by id; what lies inside them, too. */
  first?: number[];
  /** Contours worked after all others, by id; what lies around them, too. */
  last?: number[];
  /**
   * Contours left out, by id: not cut, but told among the contours (to be ignored), so that the others keep their ids, and
   * shown with what is ignored. What was a hole in one is a part by itself; a side that one shared with another contour is cut
   * with that one.
   */
  exclude?: number[];
}

/** What is done with cuts that contours share. */
export type CommonCuts = 'best' | 'insertion' | 'off';

/** What a finding is about. Later versions may add codes. */
export type FindingCode =
  | 'unsupported-entity' | 'damaged-entity' | 'resynchronised' | 'truncated' | 'bad-number' | 'invalid-geometry' | 'missing-block' | 'cyclic-block'
  | 'hidden-entity' | 'units-guessed' | 'units-doubtful' | 'encoding' | 'projected' | 'outline-taken'
  | 'gap-closed' | 'gap-left' | 'branch' | 'duplicate-removed' | 'overlap-removed' | 'feature-too-small' | 'common-cut' | 'zero-length' | 'self-crossing' | 'crossing'
  | 'open-contour' | 'several-layers' | 'sheet-outline' | 'layer-suggestion' | 'layer-ignored' | 'contour-excluded' | 'layer-unknown'
  | 'kerf-not-applied' | 'far-from-origin' | 'not-all-checked' | 'more';

/** Something a person should know about the drawing, with its place. */
export interface Finding {
  code: FindingCode;
  severity: Severity;
  message: string;
  layer: string | null;
  handle: string | null;
  at: [number, number] | null;
  count: number;
}

/** A layer of the drawing, and what is done with it. */
export interface LayerUse {
  name: string;
  /** AutoCAD colour index. */
  color: number;
  operation: Operation;
  /** What its name suggests, where that differs. */
  suggestion: Operation | null;
  rank: number;
  contours: number;
}

/** The units a drawing was read in, and why. */
export interface UnitsTaken {
  unit: Unit;
  source: 'header' | 'guessed' | 'given';
  reason: string;
  doubtful: boolean;
}

/** A contour: mm and mm2. */
export interface ContourInfo {
  id: number;
  closed: boolean;
  layer: string;
  /** `ignore`: left out by itself, by `exclude` or as the border. */
  operation: Operation;
  /** The contour around it. */
  inside: number | null;
  length: number;
  area: number;
}

/** Elements of contours. */
export interface Geometry {
  /** Seven numbers an element: x0, y0, x1, y1, centre x, centre y, sweep (0: a line). */
  segments: Float64Array;
  /** Element index at which each contour starts; one more at the end. */
  offsets: Uint32Array;
}

/** What a drawing turned out to hold. */
export interface Loaded {
  name: string;
  sha256: string;
  version: string | null;
  units: UnitsTaken;
  /** Entities of model space by kind. */
  entities: { kind: string; count: number; supported: boolean }[];
  layers: LayerUse[];
  contours: ContourInfo[];
  /** Part of each contour (index into parts), parts as outer contour, holes, and the part around. */
  parts: { outer: number; holes: number[]; inside: number | null }[];
  /** The contour that looks like the sheet's border. */
  outline: number | null;
  /** xmin, ymin, xmax, ymax in mm. */
  bounds: [number, number, number, number];
  findings: Finding[];
  /** Contours, by id. */
  geometry: Geometry;
  /** Shown, not cut: one entry a chain, with its layer index. First ignored layers, then contours left out, by id. */
  ignored: { geometry: Geometry; layers: Uint32Array };
}

/** A machine with a material on it; see `machine/profile.rs`. */
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
   * Seconds of a pre-cut: a contour may be left unfinished wherever one is made, and resumed there without piercing.
   * 0: left free of charge; null or nothing: contours are cut in one go.
   */
  pre_cut_time?: number | null;
  /** How far a pre-cut reaches into the contour, mm: cut there and back within `pre_cut_time`. Default 0. */
  pre_cut_length?: number;
  /** Cuts pause for `time` seconds in corners of less than `angle` rad; null or nothing: nowhere. */
  sharp_corner?: { angle: number; time: number } | null;
  /**
   * How wide the beam cuts, mm, from 0.02 to 10. Contours are then outlines of parts and holes, and the beam follows them half
   * of this aside. 0 or nothing: it follows the lines drawn.
   */
  kerf_width?: number;
  beam_on_delay: number;
  beam_off_delay: number;
  dialect: 'grbl-m4';
  max_s: number;
}

/**
 * The contours as they are cut where these are not the lines drawn, by id: those of `Loaded` keep their ids, further pieces of
 * contours of which others cut the rest come after them. A contour of which others cut everything is there with the operation
 * `ignore`. Areas are those of what is made.
 */
export interface Beam {
  contours: ContourInfo[];
  geometry: Geometry;
}

/** When a plan stops; with both, whichever comes first. */
export interface Budget {
  /** After this many seconds of work. */
  seconds?: number;
  /** After this many moves: the same seed and moves give the same bytes everywhere. */
  moves?: number;
}

/** How a drawing is planned. */
export interface PlanOptions extends Budget {
  /** A preset's name or a whole profile. Default `co2-100w`. */
  machine?: string | MachineProfile;
  /** A method's name. Default: the first of `methods()`. */
  method?: string;
  /** Parameters of a method from a paper, those that differ from its defaults: see `Planner.paperMethods`. */
  parameters?: Record<string, unknown>;
  /** Decides every random choice. Default: invented, and told in the result. */
  seed?: number;
  /** A path to start from. */
  warm?: WarmPath;
  /**
   * Searches side by side, each in a worker of its own and on random numbers of its own, that hand the best path on
   * at fixed counts of moves; a budget in moves is that of each. Default 1; the same number gives the same bytes.
   */
  workers?: number;
}

/** As much of a path as a search needs to start from it. */
export type WarmPath = Pick<BestPath, 'contours' | 'along' | 'reversed'> & Partial<Pick<BestPath, 'until'>>;

/** What a worker is told of its place among others: which of the random streams of the seed is its own. */
export interface Membership {
  member?: number;
}

/** A plan as the core is told of it. */
export interface StartOptions extends Omit<PlanOptions, 'parameters'>, Membership {
  /** JSON text. It says that the method is a paper's, which works beside the planner. */
  parameters?: string;
}

/** What a plan adds up to, mm and s; see `plan/model.rs`. */
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

/** The order of the head, for drawing: stop k cuts `contours[k]`, or a stretch of it. */
export interface BestPath {
  contours: Uint32Array;
  /** Entry x, y and exit x, y of each stop. */
  points: Float64Array;
  /** Arc length from the contour's stored start to the entry, mm. */
  along: Float64Array;
  /** The same to where the stop ends; equal: all of the contour. One that is left unfinished has several stops. */
  until: Float64Array;
  /** 1 where a stop runs its contour against the stored direction. */
  reversed: Uint8Array;
  /** Seconds from the start of the job at which each stop's cut begins and ends: 2 a stop. */
  times: Float64Array;
  /** Where pre-cuts are made: x, y each. */
  preCuts: Float64Array;
  /** Sharp corners in which a cut pauses: x, y each. */
  pauses: Float64Array;
}

/** How a search stands. */
export interface Progress {
  /** Moves the search has done. */
  moves: number;
  /** Seconds since the search began (of work, pauses left out). */
  seconds: number;
  /** Moves a second, of late. */
  rate: number;
  /** Sums of the best plan so far. */
  summary: Summary;
  /** Set when the best changed since the last message. */
  path: BestPath | null;
  /** What makes a method from a paper special, as it stands now. */
  insight?: Insight;
}

/** A method of planning. */
export interface MethodInfo {
  name: string;
  title: string;
  about: string;
  source: string | null;
}

/** A method from a published paper. */
export interface PaperMethod extends MethodInfo {
  /** What may be set of it, with the defaults: the paper's values where it gives them. */
  parameters: Record<string, unknown>;
}

/** Numbers of a method from a paper at one time; see `solve/papers/insight.rs`. */
export interface Insight {
  /** Iterations or generations done. */
  round: number;
  /** Values now, to be drawn against the round. */
  curves: { name: string; value: number }[];
  /** A table of numbers, such as a Q-table; `at`: the one last used. */
  grid: { name: string; rows: string[]; columns: string[]; values: number[]; at: number | null } | null;
  /**
   * The partitions of the best path, of methods that make them: the partition of each contour (0: home's), and where each but
   * home's hangs, a place on a contour that is left for it, mm.
   */
  partitions: { of: number[]; parents: { contour: number; at: [number, number] }[] } | null;
}

/** How the job would run without a search. */
export interface Baselines {
  /** As drawn: drawing order, first point of each contour. */
  drawing: Summary;
  /** Always the nearest allowed contour. */
  greedy: Summary;
}

/** What came of a slice of work, as the core tells the worker. */
export interface Slice {
  /** Moves done in it. */
  done: number;
  /** The best changed in it. */
  improved: boolean;
  end: 'running' | 'budget' | 'exhausted';
  /** Seconds that no plan takes less than; 0 before anything is proven. */
  bound: number;
}

/** What a plan can be written as. */
export type OutputKind = 'gcode' | 'svg' | 'dxf' | 'json' | 'png';

/** Why a plan ended; `replaced`: its worker died, what it had told is kept. */
export type DoneReason = 'budget' | 'stopped' | 'exhausted' | 'replaced';

/** Messages to a worker; whoever uses the functions needs none of them. */
export type ToWorker =
  /** Comes first: the compiled planner, shared by all workers. */
  | { type: 'init'; planner: WebAssembly.Module }
  | { type: 'load'; id: number; bytes: ArrayBuffer; name: string; options: LoadOptions }
  /** Reads the bytes of the last load again with other options. */
  | { type: 'reload'; id: number; options: LoadOptions }
  | { type: 'plan'; id: number; options: PlanOptions & Membership }
  /** Goes on with the plan that is done, for another budget. */
  | { type: 'continue'; id: number; budget: Budget }
  /** All have met: goes on, from a better path if there is one. After the end it is taken over and told in `done`. */
  | { type: 'meet'; id: number; path: WarmPath | null }
  | { type: 'pause' }
  | { type: 'resume' }
  | { type: 'stop' }
  | { type: 'papers'; id: number }
  | { type: 'quote'; id: number; material: Material }
  | { type: 'output'; id: number; kind: OutputKind; width?: number };

/** Messages of a worker. */
export type FromWorker =
  | { type: 'ready'; methods: MethodInfo[]; machines: MachineProfile[] }
  | { type: 'loaded'; id: number; loaded: Loaded }
  | { type: 'started'; id: number; seed: number; method: string; baselines: Baselines; findings: Finding[]; beam: Beam | null; common: Geometry | null }
  | { type: 'progress'; id: number; progress: Progress }
  /** One of several searches has come to where they meet, and waits. */
  | { type: 'meeting'; id: number; progress: Progress }
  | { type: 'bound'; id: number; lowerBound: number }
  | { type: 'done'; id: number; reason: DoneReason; progress: Progress }
  | { type: 'papers'; id: number; methods: PaperMethod[] }
  | { type: 'quote'; id: number; quote: Quote }
  | { type: 'output'; id: number; kind: OutputKind; data: string | Uint8Array }
  /** One sentence for people. */
  | { type: 'failed'; id: number; message: string }
  /** The planner died and this worker is of no more use: one sentence for people. */
  | { type: 'broken'; message: string };
