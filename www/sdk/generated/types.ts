/**
 * Generated from the Rust types by `KERFWAY_BLESS=1 cargo test --lib typescript`: do not edit.
 * Units: mm, mm2, s, rad.
 */

import type { WarmPath } from '../protocol.js';

/** The unit of length of a drawing. */
export type Unit = "in" | "ft" | "yd" | "mil" | "microinch" | "um" | "mm" | "cm" | "dm" | "m" | "px";

/** Where the unit comes from. */
export type UnitsSource = "header" | "guessed" | "given";

/** The unit of a drawing, and why it was chosen. */
export interface UnitsTaken {
  /** The chosen unit. */
  unit: Unit,
  /** Pixels per inch, if the unit is a pixel. */
  dpi: number | null,
  /** Length in mm of one unit of the drawing's coordinates. It differs from the unit where an SVG page is scaled. */
  scale: number,
  /** Where the unit comes from. */
  source: UnitsSource,
  /** One sentence for people that gives the reason for this unit. */
  reason: string,
  /**
   * Whether a person should be asked, because the unit was guessed from too little evidence or the evidence contradicts
   * the file.
   */
  doubtful: boolean,
  /** How sure the unit is, from 0 to 1: the share of the evidence for it. 1 for a unit that a person chose. */
  confidence: number,
}

/** Number of entities of one kind. */
export interface EntityKindCount {
  /** Name of the kind in the format of the file. */
  kind: string,
  /** Number in model space, as written (an INSERT or `use` counts once). */
  count: number,
  /** Whether entities of this kind become geometry. */
  supported: boolean,
}

/** How much a finding matters. */
export type Severity = "info" | "warning" | "error";

/** The kind of a finding. Written in kebab case in JSON (`unsupported-entity`). Later versions may add codes. */
export type FindingCode = "unsupported-entity" | "damaged-entity" | "resynchronised" | "truncated" | "bad-number" | "invalid-geometry" | "missing-block" | "cyclic-block" | "hidden-entity" | "units-guessed" | "units-doubtful" | "encoding" | "projected" | "outline-taken" | "gap-closed" | "gap-left" | "branch" | "duplicate-removed" | "near-copy" | "overlap-removed" | "feature-too-small" | "common-cut" | "bridges" | "part-shift" | "zero-length" | "sliver-collapsed" | "self-crossing" | "crossing" | "open-contour" | "several-layers" | "sheet-outline" | "lettering" | "leaders" | "layer-suggestion" | "layer-ignored" | "contour-excluded" | "layer-unknown" | "kerf-not-applied" | "lead-adjusted" | "lead-missing" | "joint-adjusted" | "joint-missing" | "corner-stopped" | "far-from-origin" | "off-bed" | "layer-too-fast" | "least-power-left-out" | "risky-moves" | "hot-pairs" | "not-all-checked" | "more";

/** One finding. */
export interface Finding {
  /** Code for programs. */
  code: FindingCode,
  /** Severity. */
  severity: Severity,
  /** Sentence for people that says what, where and what to do, without technical error names. */
  message: string,
  /** Name of the layer it concerns. */
  layer: string | null,
  /** Handle of the entity, as written in the file. It is not a key, because handles repeat in real files. */
  handle: string | null,
  /** Place on the sheet, mm. */
  at: [number, number] | null,
  /** Number of entities or places the finding covers. */
  count: number,
}

/** What is done with the contours of a layer. */
export type Operation = "cut" | "mark" | "ignore";

/**
 * How contours that share cuts are cut on a machine that makes pre-cuts. `best`: pierced once and cut together, on the
 * best path through them that the search finds; `insertion`: on the path of the element insertion heuristic of Dewil et
 * al.; `off`: each contour separately, and a shared cut with one of its contours.
 */
export type CommonCuts = "best" | "insertion" | "off";

/** A group of contours that are recognised by their look, not by a layer. */
export type Group = "lettering" | "leaders";

/** A micro-joint that a person placed on a contour. The joints of a contour that has such ones are these and no others. */
export interface JointChoice {
  /** The contour, by id. */
  contour: number,
  /** Its middle, as a fraction of the length of the drawn contour from its start: 0 to 1. */
  at: number,
}

/** What a person decided for a contour. What is not given is as the rules of the machine say. */
export interface ContourChoice {
  /** The contour, by id. */
  contour: number,
  /** Number of its micro-joints, evenly spread; 0: none. Joints that are placed on it by hand go before this. */
  joints?: number,
  /** The form of its lead-in, with the sizes of the rule that fits it; `none`: neither lead-in nor lead-out. */
  lead?: LeadKind,
  /** What is done at its corners, with the sizes of the machine's `levers.corners`, which it has to have. */
  corners?: CornerKind,
}

/** How contours with several passes are run. */
export type PassOrder = "contour" | "sheet";

/** What a layer or a material sets; `null`: as without it. */
export interface Settings {
  /** Speed along the contour, mm/s. */
  speed?: number,
  /** Power as a fraction of full power, 0 to 1. */
  power?: number,
  /** Least power, where the head is slow, as a fraction of full power. */
  min_power?: number,
  /** Number of passes. */
  passes?: number,
  /** By how much the head is lowered for each further pass, mm. */
  z_step?: number,
  /** Whether the air assist is on. */
  air?: boolean,
}

/** A layer and its operation. */
export interface LayerUse {
  /** Name. */
  name: string,
  /** AutoCAD colour index. */
  color: number,
  /** Operation of its contours. */
  operation: Operation,
  /** Operation that its name suggests, if different. */
  suggestion: Operation | null,
  /** What is set for its contours. */
  settings?: Settings,
  /** Place in the order of layers; equal for all layers when there is no such order. */
  rank: number,
  /** Number of contours on it. */
  contours: number,
}

/** A part: an outer contour with its holes (contours at depth + 1 inside it) and the marks on it. */
export interface Part {
  /** Id of the outer contour. */
  outer: number,
  /** Ids of its holes, and of the open cuts and marks on it. */
  holes: Array<number>,
  /** Index of the part in whose hole this part lies. */
  inside: number | null,
}

/** One of nine points of a box: its corners, the middles of its sides, its centre. */
export type Anchor = "lower-left" | "lower-center" | "lower-right" | "center-left" | "center" | "center-right" | "upper-left" | "upper-center" | "upper-right";

/** What the coordinates of a program mean. */
export type Start = "absolute" | "current";

/** How the axes move on an air move. */
export type Travel = "straight" | "vector" | "per-axis";

/** Limits of the two axes. */
export interface Axes {
  /** Top speed of x and y, mm/s. */
  speed: [number, number],
  /** Acceleration of x and y, mm/s2; `null` if the speed is reached instantly. */
  accel: [number, number] | null,
}

/** How the beam works in the material, for cutting or for marking. */
export interface Process {
  /** Speed along the contour, mm/s. */
  speed: number,
  /** Acceleration along the contour, mm/s2; `null` if the speed is reached instantly. */
  accel: number | null,
  /** Power as a fraction of full power, 0 to 1. */
  power: number,
  /**
   * Least power, where the head is slow, as a fraction of full power; `null`: it follows the speed. For controllers
   * that take two powers.
   */
  min_power?: number | null,
  /** Number of passes over a contour. */
  passes?: number,
  /** By how much the head is lowered for each further pass, mm. */
  z_step?: number,
  /** Whether the air assist is on. */
  air?: boolean,
}

/** Which corners need a macro, and how long it takes. */
export interface SharpCorner {
  /** Corners whose elements meet at less than this angle are sharp, rad; pi is straight on. */
  angle: number,
  /** Seconds that the corner cools. */
  time: number,
}

/** How a machine works one material: an entry of its library. */
export interface MaterialSetting {
  /** Its name, by which it is chosen (`3 mm birch ply`). */
  name: string,
  /** Cutting. */
  cut?: Settings,
  /** Marking. */
  mark?: Settings,
  /** Seconds to pierce it; `null`: as the machine's. */
  pierce_time?: number | null,
  /** Width of the cut in it, mm; `null`: as the machine's. */
  kerf_width?: number | null,
}

/** The file that a machine's controller takes. */
export type Takes = "gcode" | "dxf" | "svg";

/** Which side of a contour is scrap. */
export type LeadSide = "hole" | "outer";

/** Where leads join a contour. */
export type LeadPosition = "any" | "corner" | "side";

/** What the beam does in a corner. */
export type CornerKind = "stop" | "loop" | "round";

/** The form of a lead. */
export type LeadKind = "none" | "line" | "arc" | "line-arc" | "center";

/** One lead. */
export interface LeadShape {
  /** Its form. */
  kind: LeadKind,
  /** Length of the line, mm. Default 3. */
  length?: number,
  /** Radius of the arc, mm. Default 1.5. */
  radius?: number,
  /** Of a line the angle to the contour, of an arc its sweep, rad. Default pi/2. */
  angle?: number,
}

/** The leads of some contours. Conditions that are not given fit every contour. */
export interface LeadRule {
  /** Fits holes or outlines of parts only. */
  side?: LeadSide,
  /** Fits contours whose box has a longer side below this, mm: of a circle, the diameter. */
  diameter_below?: number,
  /** Fits contours that are shorter than this, mm. */
  perimeter_below?: number,
  /** From the place of piercing to the contour. */
  lead_in: LeadShape,
  /** From the contour to where the beam goes off. Default: none. */
  lead_out?: LeadShape,
  /** Where leads join the contour. Default: anywhere. */
  position?: LeadPosition,
  /** Greatest size of a lead in a hole, as a fraction of the radius of the largest circle in the hole. Default 0.4. */
  max_share?: number,
  /**
   * Length of the contour that is cut again after its start, mm; negative: length that is left uncut before it. It is at
   * most half of the contour. Default 0.
   */
  overcut?: number,
}

/** Lead-ins, lead-outs and overcuts of a machine with a material. */
export interface Leads {
  /** Least distance of leads from everything that is not scrap, mm. A lead touches its own contour only where it joins. */
  clearance: number,
  /** The first rule that fits a contour applies to it. A contour that none fits has no lead. */
  rules: Array<LeadRule>,
}

/** The levers that are switched on. */
export interface Levers {
  /** The beam goes on as the head starts to move; `null`: the head pierces at rest. */
  moving_pierce?: MovingPierce,
  /** The head is lifted for moves with the beam off; `null`: it stays down. */
  lift?: Lift,
  /** Rows and grids of contours are cut on the run; `null`: the head stops before each contour. */
  fly?: Fly,
  /** Contours are joined by cuts through waste; `null`: the head pierces for each of them. */
  chains?: Chains,
  /** Parts stay connected by strips of material, so that their outlines are one cut; `null`: each outline is a cut. */
  bridges?: Bridges,
  /** Contours that share cuts, such as outlines one kerf apart, are pierced once and cut together; `null`: each is pierced. */
  common_cuts?: SharedCuts,
  /** Pieces that may tip up under the head, and what is done about moves over them; `null`: nothing is known of them. */
  tips?: Tips,
  /** Cuts near each other follow each other no sooner than stated, or at a charge; `null`: heat does not matter. */
  heat?: Heat,
  /** Corners are cut in a loop through waste or rounded, where that saves time; `null`: the beam turns in them. */
  corners?: Corners,
}

/**
 * Fly cuts: the head runs along a row of contours, or along the sides of a grid of them, without stopping, and the beam is
 * switched while it runs.
 */
export interface Fly {
  /** Longest run with the beam off between two cuts, mm. */
  reach: number,
  /**
   * Length of a contour cut in one go that is cut again at its end, because the beam was not through at its beginning, mm.
   * Sides that are cut one by one are never cut again. Default 0.
   */
  overcut?: number,
}

/**
 * Bridges: parts stay connected by strips of material through the waste. The outlines are opened where a strip ends on them, and
 * the sides of the strips are cut, so that the outlines of connected parts are one cut, which is pierced once.
 */
export interface Bridges {
  /** Width of a strip, mm. */
  width: number,
  /** Longest strip, mm. */
  reach: number,
  /** Least distance of a strip from everything else that is cut or marked, and from the corners of the sides that it joins, mm. Default 1. */
  clearance?: number,
  /** Most parts that hang together, a whole number; `null`: any number. */
  most?: number | null,
  /**
   * The machine cuts the bridges itself, after the cut around the connected parts: across each strip, along the outlines of both parts.
   * Otherwise a person separates the parts. Default false.
   */
  cut_later?: boolean,
}

/**
 * Chains: from the end of a contour the beam cuts straight through waste to the entry of the next one, where that takes less
 * time than switching it off, moving and piercing.
 */
export interface Chains {
  /** Longest cut through waste, mm. */
  reach: number,
  /** Least distance of such a cut from every contour but the two that it joins, and from these away from its ends, mm. Default 1. */
  clearance?: number,
  /**
   * Such a cut may also begin on the kerf of any contour that was cut before, or at the edge of the sheet: the head moves there
   * with the beam off, and the beam goes on without piercing. Skeleton cuts begin at the edge and on each other, too. Default false.
   */
  edge_starts?: boolean,
}

/**
 * Common cuts: contours that share cuts are pierced once and cut together, stretch by stretch. Where the beam begins again
 * on a kerf of theirs, it does not pierce.
 */
export interface SharedCuts {
  /** Parts that would stand one kerf from a neighbour if they were moved by at most this are reported, mm. Default 0: none are. */
  shift?: number,
  /** These parts are moved. Default false. */
  shift_parts?: boolean,
}

/**
 * Lifting the head for moves with the beam off. It is lifted and lowered with the speed of the z axis
 * (`z_speed`(super::Profile::z_speed)).
 */
export interface Lift {
  /** How far the head is lifted, mm. */
  height: number,
  /** Moves up to this length are made with the head down, mm. Default 0. */
  stay_down?: number,
  /**
   * The head is lifted before it travels and lowered after that. Otherwise it is lifted during the first half of the way and
   * lowered during the second. Default false.
   */
  at_rest?: boolean,
}

/**
 * Piercing while the head moves: for marks, and for closed cuts in material that is thin enough. Neither the piercing time
 * nor the delay of the beam before a cut is spent then.
 */
export interface MovingPierce {
  /** Length of a closed cut that is cut again at its end because the beam was not through at its beginning, mm. Default 0. */
  overcut?: number,
}

/** What is done about moves with the head down over pieces that may have tipped. */
export type RiskyMoves = "ignore" | "avoid";

/** The slats under the sheet. */
export interface Slats {
  /** Distance from slat to slat, mm. */
  pitch: number,
  /** Direction in which they run, from the x axis, rad. Default 0. */
  angle?: number,
}

/** What falls, what tips, and what is done about it. */
export interface Tips {
  /**
   * What is done about moves with the head down over pieces that may have tipped. Default `avoid`, which needs
   * `lift`(super::Levers::lift).
   */
  risky_moves?: RiskyMoves,
  /** Radius of the nozzle, mm. Default 10, a guess. */
  nozzle_radius?: number,
  /** Distance that the nozzle keeps from a tipped piece, mm. Default 2, a guess. */
  margin?: number,
  /** The slats under the sheet; `null`: not known. */
  slats?: Slats | null,
  /**
   * Pieces smaller than this across the slats may tip, mm; without slats, pieces whose smaller extent along x or y is
   * below it. Default 150, a guess.
   */
  tips_below?: number,
  /**
   * Pieces smaller than this both across and along the slats drop, mm. Default: the pitch of the slats; 50, a guess,
   * where they are not known.
   */
  drops_below?: number | null,
  /** What is cut out of holes up to this size along x and y may be crossed with the head down, mm. Default 0. */
  cross_over?: number,
}

/** Which holes are small. */
export interface SmallHoles {
  /** Thickness of the plate, mm. */
  thickness: number,
  /** Holes up to this many times the thickness are small, by the larger of their extents along x and y. Default 1, a guess. */
  ratio?: number,
}

/** Least distance of cuts that follow each other within least seconds. */
export interface Heat {
  /** Cuts that are nearer to each other than this, from line to line, heat each other, mm. 0: none do. */
  distance: number,
  /** Seconds from the end of one such cut to the beginning of the other. */
  seconds: number,
  /**
   * Seconds that the search charges for each pair of cuts that follow each other sooner; `null`: the head waits, so that there
   * are no such pairs. The charge is no time of the machine, and not part of the time of the plan.
   */
  charge?: number | null,
  /** Small holes in thick plate are cut before all other cuts; `null`: they are not. */
  small_holes?: SmallHoles | null,
}

/** Which corners are cut how, where that saves time. */
export interface Corners {
  /** What is done at corners of the outlines of parts. Default `stop`. */
  outer?: CornerKind,
  /** What is done at corners of holes. Default `stop`. */
  hole?: CornerKind,
  /** Radius of loops, mm. Default 2. */
  loop_radius?: number,
  /** Least distance of loops from every other contour, mm. Default 1. */
  clearance?: number,
  /** Greatest radius of rounded corners, mm. Default 1. */
  round_radius?: number,
  /** Greatest distance of a rounded corner from the corner drawn, mm. Default 0.1. */
  deviation?: number,
}

/** How the sizes of a contour are compared with the limits of a rule. */
export type SizeTest = "and" | "or";

/** How a joint is left uncut. */
export type JointKind = "stop" | "flying";

/** The joints of some contours. Conditions that are not given fit every contour. */
export interface JointRule {
  /** Fits holes or outlines of parts only. */
  side?: LeadSide,
  /** Fits contours whose box is at least this large in x and y, mm. */
  size_min?: [number, number],
  /** Fits contours whose box is at most this large in x and y, mm. */
  size_max?: [number, number],
  /** Whether the sizes in x and in y have to be within the limits, or one of them is enough. Default `and`. */
  test?: SizeTest,
  /** Width of the material that holds, mm. The width of the cut is added to it. Default 0.5. */
  width?: number,
  /** Least number of joints. Default 2. */
  count?: number,
  /** Greatest length that is cut without a joint, mm; not given: any. */
  spacing?: number,
  /** Least distance of joints from corners, mm. Default 2. */
  corner_clearance?: number,
  /** Whether the head stops at a joint. Default `stop`. */
  kind?: JointKind,
}

/** Micro-joints of a machine with a material. */
export interface Joints {
  /**
   * The first rule that fits a contour applies to it. A contour that none fits has no joints, unless they are placed by
   * hand.
   */
  rules: Array<JointRule>,
}

/** Cuts through the waste, in the directions of x and y. */
export interface Skeleton {
  /** Greatest width of a piece in x, mm: cuts in the direction of y divide the sheet evenly. Not given: there are none. */
  spacing_x?: number,
  /** Greatest height of a piece in y, mm: cuts in the direction of x divide the sheet evenly. Not given: there are none. */
  spacing_y?: number,
  /** Least distance of these cuts from the cuts of parts, mm. Default 2. */
  clearance?: number,
  /** Greatest length that is cut without leaving a joint, mm; not given: any. */
  joint_spacing?: number,
  /** Width of the material that a joint leaves, mm. The width of the cut is added to it. Default 1. */
  joint_width?: number,
  /**
   * Least width of a strip at an edge of the sheet, without parts, that is cut off in one piece and kept, mm; not given: no
   * strip is kept.
   */
  remainder?: number,
}

/** Unit of coordinates in the program. */
export type FileUnit = "mm" | "inch";

/** Numbers of decimals. */
export interface Decimals {
  /** Of X, Y and Z. */
  xy: number,
  /** Of I and J: one more than of X and Y lets the two radii of an arc agree. */
  ij: number,
  /** Of F. */
  feed: number,
}

/** Unit of a dwell. */
export type DwellUnit = "s" | "ms";

/** How a program waits. */
export interface Dwell {
  /** The word after G4 that holds the time: `P`, `S`, `X` or `F`. */
  word: string,
  /** Its unit. */
  unit: DwellUnit,
  /** Its decimals. */
  decimals: number,
}

/** By which commands the power is set. The reader follows the beam by the same choice. */
export type PowerBy = "laser-m4" | "laser-m3" | "spindle-m3" | "output-m67" | "inline-m3" | "fan-m106" | "motion" | "macro";

/** How the power of the beam is set. */
export interface Power {
  /** By which commands. */
  by: PowerBy,
  /** The word that holds it: `S` or `Q`. */
  word: string,
  /** Number at full power; `null`: `max_s` of the machine. */
  full: number | null,
  /** Its decimals. */
  decimals: number,
  /** Number of the output (E of M67, P of M106). */
  output?: number | null,
  /** With `macro`: the lines that switch the beam on, with `{power}`. */
  on?: Array<string>,
  /** With `macro`: the lines that switch it off. */
  off?: Array<string>,
}

/** The ways to pierce. */
export type PierceBy = "dwell-m3" | "dwell-m68" | "dwell-standard" | "creep" | "macro";

/** How the material is pierced. */
export interface Pierce {
  /** The method. */
  by: PierceBy,
  /** With `creep`: the length that is cut slowly, mm. */
  length?: number | null,
  /** With `macro`: its lines, with `{seconds}` and `{power}`. They leave the beam on. */
  lines?: Array<string>,
}

/** The commands of the air assist. */
export interface Air {
  /** Line that switches it on. */
  on: string,
  /** Line that switches it off. */
  off: string,
}

/** How comments are written. */
export type Comments = "semicolon" | "parentheses" | "none";

/** What ends a line. */
export type LineEnd = "lf" | "crlf";

/** How a controller is spoken to. */
export interface Dialect {
  /** Name and version of this format: `kerfway.dialect/1`. */
  schema: 'kerfway.dialect/1',
  /** Name of the dialect (`grbl-m4`). */
  name: string,
  /** Title for people. */
  title: string,
  /** The controllers it is for, as sentences name them (`GRBL 1.1`). */
  controller: string,
  /** Unit of coordinates and feeds. The header must select it. */
  units: FileUnit,
  /** Decimals of numbers. */
  decimals: Decimals,
  /** How the program waits; `null` if the controller cannot. */
  dwell: Dwell | null,
  /** How the power of the beam is set. */
  power: Power,
  /** How the material is pierced; `null` if the controller cannot: a plan with a piercing time is refused. */
  pierce: Pierce | null,
  /** Whether the controller itself keeps the beam off on G0. The power is set to 0 before every rapid in any case. */
  rapids_dark: boolean,
  /** Whether the controller runs G0 with the feed in force, so that rapids need an F word of their own. */
  rapid_feed?: boolean,
  /** Largest distance between an arc and the chords written for it, mm; `null`: arcs are written as G2 and G3. */
  chords: number | null,
  /** The commands of the air assist; `null` if there are none: a plan with air is refused. */
  air: Air | null,
  /** Whether the controller has a Z axis. Without one, a plan that lowers the head between passes is refused. */
  z?: boolean,
  /** How comments are written. */
  comments: Comments,
  /** Longest line in characters. */
  line_length: number,
  /** What ends a line. */
  line_end: LineEnd,
  /**
   * Lines before the first move. A line that begins with `;` is a comment, written in the style of `comments`.
   * Placeholders such as `{seconds}` are replaced; a line whose placeholder has no value is left out.
   */
  header: Array<string>,
  /** Lines at the end, after the beam is off and the head is home. */
  footer: Array<string>,
}

/** The name of a shipped dialect, or a dialect of one's own. */
export type DialectChoice = string | Dialect;

/** A machine with a material. */
export interface MachineProfile {
  /** Version of this data format: 1. */
  version: 1,
  /** Name of the preset (`co2-100w`). */
  name: string,
  /** Title for people. */
  title: string,
  /** Position of the head before the first move, mm. */
  home: [number, number],
  /**
   * What the head can reach, in machine coordinates: xmin, ymin, xmax, ymax in mm; `null` if it is not known. A program
   * that reaches beyond it is not written.
   */
  bed?: [number, number, number, number] | null,
  /** Whether the head returns home at the end. */
  return_home: boolean,
  /** How air moves are run. */
  travel: Travel,
  /** Limits of air moves. */
  rapid: Axes,
  /** Cutting. */
  cut: Process,
  /** Marking. */
  mark: Process,
  /**
   * Allowed deviation at corners in the look-ahead, mm (GRBL's junction deviation, `$11`). It also limits the speed
   * on arcs, which such a controller runs as chords. With `null`, corners are passed at full speed, and the speed on
   * arcs is limited by the centripetal acceleration.
   */
  junction_deviation: number | null,
  /** Seconds to pierce the material. */
  pierce_time: number,
  /**
   * Seconds of a pre-cut. A contour may be interrupted where a pre-cut is made, and is resumed there without
   * piercing. With 0, contours may be interrupted without charge and without pre-cuts (the partial cutting of the
   * hull-part papers). With `null`, every contour is cut in one go.
   */
  pre_cut_time?: number | null,
  /** Length of a pre-cut, mm. It is cut and the head returns within `pre_cut_time`. */
  pre_cut_length?: number,
  /** The corners that are cut with a pause; `null` for no such corners. */
  sharp_corner?: SharpCorner | null,
  /**
   * Width of the cut, mm. If it is above 0, contours are outlines of parts and holes, and the beam is offset from
   * them by half the kerf width. If it is 0, the beam follows the drawn lines.
   */
  kerf_width?: number,
  /** Lead-ins, lead-outs and overcuts; `null` for none of them: cuts begin and end on their contours. */
  leads?: Leads | null,
  /** Levers: abilities that make jobs shorter. Default: all off. */
  levers?: Levers,
  /** Micro-joints; `null` for none, unless they are placed by hand. */
  joints?: Joints | null,
  /** Cuts through the waste after everything else; `null` for none. */
  skeleton?: Skeleton | null,
  /** Speed at which the head is lowered and raised, mm/s; `null` if it cannot be. */
  z_speed?: number | null,
  /** Settings for materials, by name. */
  materials?: Array<MaterialSetting>,
  /** Time for the beam to settle before a cut, s. */
  beam_on_delay: number,
  /** Time for the beam to settle after a cut, s. */
  beam_off_delay: number,
  /** The file that its controller takes, which is offered first. Default `gcode`. */
  takes?: Takes,
  /** Dialect of G-code: the name of a shipped one, or a document. */
  dialect: DialectChoice,
  /** Power value at full power, for dialects that do not state it. */
  max_s: number,
}

/** The kind of an error. Written in kebab case (`out-of-range`). Later versions may add codes. */
export type ErrorCode = "unknown-field" | "missing-field" | "wrong-type" | "out-of-range" | "not-a-choice" | "invalid-parameter" | "not-json" | "options-conflict" | "unknown-contour" | "unfit-path" | "not-bytes" | "not-a-drawing" | "empty-drawing" | "too-large" | "nothing-to-cut" | "other-drawing" | "far-from-origin" | "off-bed" | "unwritable" | "not-a-quote" | "download-failed" | "no-drawing" | "no-plan" | "unsound-plan" | "planner-died" | "not-started" | "deadline" | "closed" | "not-in-this-build" | "wrong-usage" | "unreadable-file" | "unwritable-output" | "busy" | "stopping" | "unauthorized" | "not-found" | "method-not-allowed" | "unsupported-media-type" | "malformed-form" | "slow-upload" | "queue-unavailable" | "internal";

/** An error as programs get it. */
export interface ErrorReport {
  /** What went wrong. */
  code: ErrorCode,
  /** One sentence for people, in English: what, where, what to do. */
  message: string,
  /** What the sentence names, by name: `field`, `value`, `least`, `most`, .... */
  params: Record<string, string | number | string[]>,
  /** Whether the same call may succeed later, without a change by the caller. */
  retryable: boolean,
}

/** The operation for one layer, and what it is worked with. What is not set is as the machine or the material says. */
export interface LayerChoice {
  /** Name of the layer. */
  name: string,
  /** Cut, mark or ignore; without a choice, as for other layers, and what the layer's name suggests stays a question. */
  operation?: Operation | null,
  /** Speed along its contours, mm/s. */
  speed?: number | null,
  /** Power as a fraction of full power, 0 to 1. */
  power?: number | null,
  /** Least power, where the head is slow, as a fraction of full power. */
  minPower?: number | null,
  /** Number of passes. */
  passes?: number | null,
  /** By how much the head is lowered for each further pass, mm. */
  zStep?: number | null,
  /** Whether the air assist is on. */
  air?: boolean | null,
}

/** The operation for a group of contours. */
export interface GroupChoice {
  /** The group. */
  name: Group,
  /** Cut, mark or ignore. */
  operation: Operation,
}

/** How a drawing is read and arranged. */
export interface LoadOptions {
  /** The unit of the drawing. Default: the unit that the file states, or a guess. */
  units?: Unit,
  /** Pixels per inch, for a drawing in pixels: 96 in browsers and Inkscape, 90 in Inkscape before 0.92, 72 in Illustrator. */
  dpi?: number,
  /** Largest distance between a spline or ellipse and the lines and arcs that replace it, mm. Default 0.005. */
  tolerance: number,
  /** Whether entities are kept that were read across a defect in the file. Default false. */
  keepDamaged: boolean,
  /** By how many degrees the drawing is turned around its origin, counter-clockwise: 0, 90, 180 or 270. Default 0. */
  turn: number,
  /** Largest distance between ends that are joined, mm. Default 0.05. */
  joinTolerance: number,
  /** Largest distance between lines that are copies of each other, mm. Default 0.01. */
  copyTolerance: number,
  /** The operation of each layer, by name. The order of the list is the order by layer. */
  layers: Array<LayerChoice>,
  /** Whether layers are processed one after the other. Default false. */
  orderByLayer: boolean,
  /**
   * How contours with several passes are run: `contour`, all passes of one before the next, or `sheet`, the first pass of
   * all, then the second. Default `contour`.
   */
  passOrder: PassOrder,
  /**
   * Whether the single border around everything is ignored even if it may be a cut. If it clearly shows the sheet, it is
   * ignored in any case. Default false.
   */
  ignoreOutline: boolean,
  /** Whether the border around everything is cut even if it clearly shows the sheet. Default false. */
  keepBorder: boolean,
  /** The operation of groups of contours that are recognised by their look. Default: they are cut. */
  groups: Array<GroupChoice>,
  /** Whether a part is finished, with everything inside its holes, before the next one. Default false. */
  partByPart: boolean,
  /** How contours that share cuts are cut on machines that make pre-cuts. Default `best`. */
  commonCuts: CommonCuts,
  /** Contours that are processed before all others, with everything inside them, by id. */
  first: Array<number>,
  /** Contours that are processed after all others, with the contours around them, by id. */
  last: Array<number>,
  /** Contours to mark instead of cutting them, by id. A mark bounds no part: a hole in it becomes a part of its own. */
  mark: Array<number>,
  /**
   * Sequences of contours, by id: each contour is finished, with everything inside it, before the next one of its sequence
   * begins. Others may be processed in between, where that is faster. A contour that is listed itself does not count as inside
   * another one of the same sequence.
   */
  sequences: Array<Array<number>>,
  /**
   * Contours to skip, by id. They stay in the list of contours with the operation `ignore`, so that the others keep their
   * ids. A hole in a skipped contour becomes a part of its own. A side that a skipped contour shares with another
   * contour is cut with the other one.
   */
  exclude: Array<number>,
  /**
   * Groups of contours, by id: all contours of a group are processed, with everything inside them, without any other in
   * between, in the order that is fastest. A contour is in one group at most.
   */
  together: Array<Array<number>>,
  /** Micro-joints that are placed by hand. A contour that has such ones has no others. */
  joints: Array<JointChoice>,
  /** What is decided for single contours instead of the rules of the machine: the number of micro-joints, the lead. */
  contours: Array<ContourChoice>,
}

/** The name of a preset machine, or a whole profile. */
export type MachineChoice = string | MachineProfile;

/**
 * When a plan ends. If both are given, the first to be reached ends it. The search counts moves itself; seconds are left
 * to the caller, who has a clock.
 */
export interface Budget {
  /** Seconds of search. */
  seconds?: number,
  /** Moves of the search. The same seed and moves give the same bytes everywhere. */
  moves?: number,
}

/** A point of the job and the point of the bed that it comes to lie on. */
export interface Place {
  /** A point of the box around everything that is cut or marked, as drawn. Default `lower-left`. */
  point?: Anchor,
  /** A point of the drawing instead, mm. */
  from?: [number, number],
  /** Where it comes to lie, in machine coordinates, or as seen from where the head stands, mm. */
  at: [number, number],
}

/** How a loaded drawing is planned. */
export interface StartOptions {
  /** The name of a preset, or a profile. Default `co2-100w`. */
  machine: MachineChoice,
  /** The name of a setting in the machine's library of materials. Default: the machine's own cutting and marking. */
  material?: string,
  /** Where the job lies on the bed. Default: as drawn. */
  place?: Place,
  /** Whether the program is in machine coordinates, or starts where the head stands. Default `absolute`. */
  start: Start,
  /** Whether a program is written that reaches beyond the bed. Default false. */
  allowOffBed: boolean,
  /** Name of a method. Default: the first of `methods`. */
  method?: string,
  /** Parameters of a published method, as a JSON object with the values that differ from its defaults. */
  parameters?: string,
  /** Seed of all random choices. */
  seed: number,
  /** A path to start from. */
  warm: WarmPath,
  /** When to stop, in seconds of search. */
  seconds?: number,
  /** When to stop, in moves of the search. */
  moves?: number,
  /**
   * Number of searches that run in parallel, each with its own random numbers. They exchange the best path at fixed
   * numbers of moves, so the same number of searches gives the same bytes. A budget in moves applies to each search.
   * Default 1.
   */
  workers?: number,
  /**
   * Index of this search among them. Each has its own stream of random numbers; the first one has the stream of the seed
   * itself.
   */
  member: number,
}

/** A contour, for lists. */
export interface ContourInfo {
  /** Its index, which identifies it everywhere. */
  id: number,
  /** Whether it returns to its start. */
  closed: boolean,
  /** Name of its layer. */
  layer: string,
  /** Cut, mark, or ignore: skipped by the option `exclude`, or as the border. */
  operation: Operation,
  /** The contour directly around it. */
  inside: number | null,
  /** Length, mm. */
  length: number,
  /** Area, mm². */
  area: number,
  /** Whether it is a skeleton cut, which nobody drew. */
  skeleton?: boolean,
}

/** The content of a drawing, without its geometry. */
export interface LoadedReport {
  /** Name of the file. */
  name: string,
  /** SHA-256 of its bytes, in hexadecimal. */
  sha256: string,
  /** Version of the file, `$ACADVER`. */
  version: string | null,
  /** The units used, and where they come from. */
  units: UnitsTaken,
  /** Number of entities in model space, by kind. */
  entities: Array<EntityKindCount>,
  /** Layers and their operations. */
  layers: Array<LayerUse>,
  /** Contours by id. */
  contours: Array<ContourInfo>,
  /** The parts: outer contours with their holes. */
  parts: Array<Part>,
  /** The contour that looks like the border of the sheet. */
  outline: number | null,
  /** Bounding box of all contours, mm: xmin, ymin, xmax, ymax; zeros if there are none. */
  bounds: [number, number, number, number],
  /** Findings of the reader, then of the sheet. */
  findings: Array<Finding>,
}

/** What kind of thing is wrong. */
export type CheckCode = "unreadable" | "bad-line" | "units-unknown" | "beam-on-rapid" | "power-on-rapid" | "dark-cut" | "lifted-cut" | "dark-pierce" | "power-out-of-range" | "feed-out-of-range" | "wait-out-of-range" | "bad-arc" | "off-bed" | "cut-twice" | "beam-on-at-end" | "incomplete" | "differs" | "empty" | "changed";

/** Something wrong with a program. */
export interface CheckProblem {
  /** What kind of thing. */
  code: CheckCode,
  /** An error: the program must not be run. A warning: look at it. */
  severity: Severity,
  /** What, where, and what it means, in one sentence. */
  message: string,
  /** Number of the first line, counted from 1. */
  line: number | null,
  /** How often it was found. */
  count: number,
}

/** What a program does, and what is wrong with it. */
export interface ProgramCheck {
  /** Whether the program may be run: it has no problem of severity error. */
  passed: boolean,
  /** Name of the dialect by whose rules it was read. */
  dialect: string,
  /** Name of the machine. */
  machine: string,
  /** Number of lines. */
  lines: number,
  /** Number of different contours. */
  contours: number,
  /** How often each contour is cut; 0 if they differ or there are none. */
  passes: number,
  /** Number of parts: closed contours inside an even number of others. */
  parts: number,
  /** Number of piercings at rest. */
  pierces: number,
  /** Length of cuts, mm. */
  cut_length: number,
  /** Length of rapids, mm. */
  air_length: number,
  /** Seconds on this machine. */
  seconds: number,
  /** Box of everything cut, mm: xmin, ymin, xmax, ymax; `null` if nothing is cut. */
  bounds: [number, number, number, number] | null,
  /** Whether the head stays on the bed; `null` if the machine's bed is not known. */
  fits_bed: boolean | null,
  /** Whether the beam is off on every rapid. */
  dark_rapids: boolean,
  /** What is wrong, one entry for each kind. */
  problems: Array<CheckProblem>,
}

/** The sums of a plan. Lengths are in mm, times in s. */
export interface Summary {
  /** Number of contours cut or marked. */
  contours: number,
  /** Number of open contours among them. */
  open_contours: number,
  /** Number of parts. */
  parts: number,
  /** Number of piercings at rest. */
  pierces: number,
  /** Number of cuts and marks that begin with the beam on as the head starts to move. */
  moving_starts?: number,
  /** Number of cuts that begin on the run: the head does not stop before them. */
  fly_cuts?: number,
  /** Number of cuts through waste that lead to contours. */
  chains?: number,
  /** Those of them that begin on the kerf of a contour or at the edge of the sheet, after an air move. */
  edge_starts?: number,
  /** The length of all of them, mm, which is part of the length of cuts. */
  chain_length?: number,
  /** Number of bridges between parts. */
  bridges?: number,
  /** Number of air moves for which the head is lifted. */
  lifts?: number,
  /** Number of air moves that go around pieces that may have tipped. */
  detours?: number,
  /** Number of air moves that cross pieces that may have tipped, with the head down. */
  crossings?: number,
  /** Number of waits until what was cut nearby has cooled. */
  waits?: number,
  /** Time of these waits. It is part of the time of air moves. */
  wait_time?: number,
  /** Number of pairs of cuts nearer to each other than the machine asks for that follow each other sooner than it asks for. */
  hot_pairs?: number,
  /** Number of pre-cuts. */
  pre_cuts: number,
  /** Number of micro-joints. */
  joints?: number,
  /**
   * Time of stopping at micro-joints: moving over them and piercing after them. It is part of the time of air moves and
   * of piercing.
   */
  joint_time?: number,
  /** Length of cuts and marks, leads included. */
  cut_length: number,
  /** Length of lead-ins, lead-outs and overcuts. */
  lead_length?: number,
  /** Number of skeleton cuts, which are not among the contours. */
  skeleton_cuts?: number,
  /** Length of skeleton cuts. It is part of the length of cuts. */
  skeleton_length?: number,
  /** Time from the end of the last other cut to the end of the last skeleton cut: air, piercing and cutting. */
  skeleton_time?: number,
  /** Number of corners that are cut in a loop through waste. */
  loops?: number,
  /** The length of all loops, which is part of the length of cuts. */
  loop_length?: number,
  /** Number of corners that are rounded. */
  rounded_corners?: number,
  /** The greatest distance of a rounded corner from the corner drawn, mm. */
  corner_deviation?: number,
  /** Length of air moves. */
  air_length: number,
  /** Time along contours, by look-ahead over corners and acceleration. It includes the ways between cuts on the run, and chains. */
  cut_time: number,
  /** Time of air moves, of lowering and raising the head, and of waits. */
  air_time: number,
  /** Time of piercing, including beam delays. */
  pierce_time: number,
  /** Time of pre-cuts. */
  pre_cut_time: number,
  /** Time of pauses in sharp corners. */
  macro_time: number,
  /** Total time. */
  total_time: number,
  /** Lower bound of the total time of every plan; 0 if not computed. */
  lower_bound: number,
  /** (total - bound) / bound; `null` when there is no bound. */
  gap: number | null,
  /** Bounding box of everything cut or marked: xmin, ymin, xmax, ymax. */
  bounds: [number, number, number, number],
}

/** The job without a search, for comparison. */
export interface Baselines {
  /** In the order of the drawing. */
  drawing: Summary,
  /** By nearest neighbour. */
  greedy: Summary,
}

/** Why a slice ended. */
export type SliceEnd = "running" | "budget" | "exhausted";

/** The result of a slice of work. */
export interface Slice {
  /** Number of moves done. */
  done: number,
  /** Whether the best plan changed. */
  improved: boolean,
  /** Why it ended. */
  end: SliceEnd,
  /** Lower bound of the total time of every plan in seconds, as in `bound`. */
  bound: number,
}

/** What a certificate file proves. */
export interface Verified {
  /** No plan takes less, s. */
  seconds: number,
  /** Of these, what every plan pays for piercing, cutting and marking, s. */
  paid: number,
  /** Name of the drawing's file when the certificate was written. */
  drawing: string,
  /** Name of the machine. */
  machine: string,
  /** Whether that is the preset of this name, or the machine that was asked for: others may call themselves as they like. */
  known_machine: boolean,
  /** What it was planned with other than the defaults: options of reading, material, place and start, as a JSON object. */
  settings: string,
}

/** A method, for lists and citations. */
export interface MethodInfo {
  /** Name on the command line. */
  name: string,
  /** Name for people. */
  title: string,
  /** What it does, in one sentence. */
  about: string,
  /** The paper it comes from, if any. */
  source: string | null,
}

/** A method and its parameters, for lists. */
export interface PaperMethod {
  /** Parameters with their default values, the paper's where it gives them. */
  parameters: Record<string, unknown>,
  /** The parameters that each preset changes, by the name of the preset. The parameter `preset` selects one. */
  presets: Record<string, Record<string, unknown>>,
  /** Name on the command line. */
  name: string,
  /** Name for people. */
  title: string,
  /** What it does, in one sentence. */
  about: string,
  /** The paper it comes from, if any. */
  source: string | null,
}

/** A named value. */
export interface InsightCurve {
  /** Name for people, with the symbol of the paper. */
  name: string,
  /** Current value. */
  value: number,
  /** Title of the chart in which it is drawn, together with the other curves of that title: they have one unit. */
  chart: string,
}

/** A named table of numbers. */
export interface InsightGrid {
  /** Name for people. */
  name: string,
  /** Names of the rows. */
  rows: Array<string>,
  /** Names of the columns. */
  columns: Array<string>,
  /** Values, row by row. */
  values: Array<number>,
  /** Index of the value that was used last. */
  at: number | null,
}

/** The place where a contour is left for a partition and resumed. */
export interface PartitionParent {
  /** The contour. */
  contour: number,
  /** The place, mm. */
  at: [number, number],
}

/** Partitions: the contours that are cut between leaving a contour and coming back to it. */
export interface Partitions {
  /** Partition of each contour: 0 for that of home, -1 for a contour without entries. */
  of: Array<number>,
  /** Where each partition except that of home hangs, in order. */
  parents: Array<PartitionParent>,
}

/** The state of a method at one moment. */
export interface Insight {
  /** Iterations or generations done. */
  round: number,
  /** Current values, to be drawn against the round. */
  curves: Array<InsightCurve>,
  /** A table of numbers, such as a Q-table. */
  grid: InsightGrid | null,
  /** The partitions of its best path, if it makes any. */
  partitions: Partitions | null,
}

/** One job of a calibration. */
export interface CalibratedJob {
  /** Name of its file. */
  name: string,
  /** Seconds by the clock. */
  measured: number,
  /** Seconds planned with the machine as it was. */
  before: number,
  /** Seconds planned with the fitted machine. */
  after: number,
}

/** A machine fitted to measured times. */
export interface Calibration {
  /** The machine with the fitted values. */
  machine: MachineProfile,
  /** The jobs it was fitted to. */
  jobs: Array<CalibratedJob>,
}

/** The material of the sheet. */
export interface Material {
  /** A name, which is only shown. */
  name?: string,
  /** Thickness, mm. */
  thickness?: number,
  /** Density, g/cm3: mild steel 7.85, aluminium 2.70, acrylic 1.19, birch plywood about 0.68. */
  density?: number,
}

/** Limits of what a shop makes. A limit that is not given is not checked. */
export interface Limits {
  /** Least width of a hole, mm: the diameter of a round one, the width of a slot. */
  smallest_hole?: number,
  /** Least material between two holes, mm. */
  smallest_web?: number,
  /** Least material between a hole and the edge of its part, mm. */
  hole_to_edge?: number,
  /** Least width and height of a part, mm, the longer side first. */
  smallest_part?: [number, number],
  /** Largest width and height of a part, mm, the longer side first. */
  largest_part?: [number, number],
  /** Whether pieces that lie loose in a hole of another part are accepted: the inside of a letter O, a part nested in a part. */
  floating_pieces?: boolean,
}

/** What a quote is asked for. */
export interface QuoteTerms {
  /** The material of the sheet. */
  material: Material,
  /** What the shop can make. Each limit that a part exceeds is reported with its place. */
  limits: Limits,
}

/** Seconds of the job or of a part, by what they go into. */
export interface QuoteTimes {
  /** The whole job. */
  total: number,
  /** Along contours. */
  cut: number,
  /** Air moves. */
  air: number,
  /** Piercing, with beam delays. */
  pierce: number,
  /** Pre-cuts. */
  pre_cut: number,
  /** Sharp corners. */
  macros: number,
}

/** The contours of a layer with the same operation. */
export interface QuoteLayer {
  /** Name of the layer. */
  layer: string,
  /** Cut or mark. */
  operation: Exclude<Operation, 'ignore'>,
  /** Number of contours on it. */
  contours: number,
  /** Number of open contours among them. */
  open: number,
  /** Length of all its contours. */
  length: number,
}

/** One part of the sheet. */
export interface PartItem {
  /** The id of its outer contour, which identifies the part. */
  id: number,
  /** xmin, ymin, xmax, ymax of its outline. */
  bounds: [number, number, number, number],
  /** Its own seconds, with its share of the air moves. Those of all parts and `loose_times` add up to the job's. */
  times: QuoteTimes,
  /** Number of its piercings. */
  pierces: number,
  /** How far its figures can be relied on: the findings that lie on it. */
  confidence: Confidence,
}

/** A group of equal parts. */
export interface PartGroup {
  /** Number of parts in the group. */
  count: number,
  /** Area of one part without its holes. */
  net_area: number,
  /** Length of the outlines of one part: outer contour and holes. A side shared with another part counts for both. */
  cut_length: number,
  /** Number of holes in one part. */
  holes: number,
  /** Outer contours of the parts, by id. */
  contours: Array<number>,
  /** Each part of the group, in the order of `contours`. */
  items: Array<PartItem>,
}

/** The hole with the least width. */
export interface SmallestHole {
  /** The contour's id. */
  contour: number,
  /** Diameter of the largest circle inside it: a circle's diameter, a slot's width, also where the slot is bent. */
  width: number,
  /** Width divided by the thickness, if that is given. */
  over_thickness: number | null,
}

/** Where material is thinnest between two cuts of a part. */
export interface NarrowestWeb {
  /** The two contours. */
  contours: [number, number],
  /** Distance between them. */
  width: number,
  /** Middle of the narrowest place. */
  at: [number, number],
  /** Width divided by the thickness, if that is given. */
  over_thickness: number | null,
}

/** A kind of defect. */
export interface Defect {
  /** The code of its findings. */
  code: FindingCode,
  /** The severity of its findings. */
  severity: Severity,
  /** How many there are. */
  count: number,
}

/** In one word. */
export type ConfidenceLevel = "high" | "medium" | "low";

/** The kind of a reason. */
export type ReasonCode = "units-doubtful" | "units-guessed" | "open-cuts" | "no-setting" | "findings";

/** Why figures cannot be relied on. */
export interface ConfidenceReason {
  /** The kind of reason. */
  code: ReasonCode,
  /** The code of the findings, if they are the reason. */
  finding: FindingCode | null,
  /** How many there are. */
  count: number,
  /** One sentence for people. */
  message: string,
}

/** How far the figures can be relied on. */
export interface Confidence {
  /** In one word. */
  level: ConfidenceLevel,
  /** Why it is not high. */
  reasons: Array<ConfidenceReason>,
}

/** What a limit is about. */
export type LimitCode = "hole-too-small" | "web-too-thin" | "hole-too-close-to-edge" | "part-too-small" | "part-too-large" | "floating-piece";

/** A place where a part exceeds a limit. */
export interface LimitExceeded {
  /** What the limit is about. */
  code: LimitCode,
  /** The part: the id of its outer contour. */
  part: number,
  /** The contours concerned. */
  contours: Array<number>,
  /** The place, mm. */
  at: [number, number],
  /** The measured length, mm; `null` for a floating piece. */
  measured: number | null,
  /** The limit, mm; `null` for a floating piece. */
  limit: number | null,
  /** One sentence for people. */
  message: string,
}

/** The limits as given, and where they are exceeded. */
export interface LimitChecks {
  /** The limits; those that are `null` were not checked. */
  limits: { [K in keyof Required<Limits>]: Required<Limits>[K] | null },
  /** Where they are exceeded, by part; at most 200 of each kind. */
  exceeded: Array<LimitExceeded>,
  /** Number of further places that are not listed. */
  unlisted: number,
}

/** What a price depends on. Lengths are in mm, areas in mm2, times in s, weights in g. docs/quote.md describes every field. */
export interface Quote {
  /** Name and version of the format. */
  schema: 'kerfway.quote/2',
  /** The version of the planner that made the report. It is not part of the hash. */
  version: string,
  /**
   * SHA-256 of the whole report with `hash`, `version` and `input.name` empty. The same drawing, options, seed and moves give the same
   * hash natively, in Node and in every browser, whatever the file is called. A server that plans again with `moves` can confirm
   * the report of a browser.
   */
  hash: string,
  /** The drawing. */
  input: {
    /** SHA-256 of the file's bytes, in lower-case hexadecimal. */
    sha256: string,
    /** Name of the file, for people. */
    name: string,
    /** Unit the drawing was taken to be in. */
    units: Unit,
    /** Where that unit came from. */
    units_source: UnitsSource,
    /** Pixels per inch, if the unit is a pixel. */
    dpi?: number,
    /** Why the unit may be wrong, in one sentence; missing if nothing speaks against it. */
    units_doubt?: string,
  },
  /** The machine's whole profile. */
  machine: MachineProfile,
  /**
   * Name of the setting in the machine's library of materials that it was planned with; the machine has it on. `null`: with
   * its own.
   */
  setting: string | null,
  /** How the drawing was read and arranged, as in the plan document. */
  options: Record<string, unknown>,
  /** Where the job lies on the bed; `null`: where it was drawn. */
  placement: { shift: [number, number], start: Start } | null,
  /** Name of the search method. */
  method: string,
  /** Parameters of the method; `null` if all are the defaults. */
  parameters: string | null,
  /** Seed of all random choices. */
  seed: number,
  /** Number of moves that the search made. The same moves, seed and workers give the same plan. */
  moves: number,
  /** Number of parallel searches; `null` for one. */
  workers: number | null,
  /** Whether the plan comes from a path that was given: then the three do not give it again. */
  from_path?: boolean,
  /** The material, as given. */
  material: { [K in keyof Required<Material>]: Required<Material>[K] | null },
  /** Seconds of the job. */
  times: QuoteTimes,
  /** Seconds of cuts and marks that belong to no part. Those of all parts and these add up to `times`. */
  loose_times: QuoteTimes,
  /** Length of cuts and marks, leads included. */
  cut_length: number,
  /** Length of lead-ins, lead-outs and overcuts. */
  lead_length?: number,
  /** Length of air moves. */
  air_length: number,
  /** Number of piercings. */
  pierces: number,
  /** Number of pre-cuts. */
  pre_cuts: number,
  /** Number of micro-joints. */
  joints?: number,
  /** Time of stopping at micro-joints, which is part of the times of air moves and of piercing. */
  joint_time?: number,
  /** Number of skeleton cuts, which are not among the contours. */
  skeleton_cuts?: number,
  /** Length of skeleton cuts, which is part of the length of cuts. */
  skeleton_length?: number,
  /** Time from the end of the last other cut to the end of the last skeleton cut. */
  skeleton_time?: number,
  /** Cut and marked contours by layer. */
  layers: Array<QuoteLayer>,
  /** Number of parts. */
  part_count: number,
  /** Groups of equal parts, the largest part first. Mirrored parts are equal. */
  parts: Array<PartGroup>,
  /** xmin, ymin, xmax, ymax of everything that is cut or marked. */
  bounds: [number, number, number, number],
  /** Area of all parts without their holes. */
  net_area: number,
  /** Area of the box `bounds`. */
  box_area: number,
  /** Weight of all parts, g, if thickness and density are given. */
  weight: number | null,
  /** The narrowest hole. */
  smallest_hole: SmallestHole | null,
  /** The narrowest web: where two cuts of one part are closest to each other. */
  narrowest_web: NarrowestWeb | null,
  /** Where the drawing exceeds the limits of the shop, if limits were given. */
  checks: LimitChecks | null,
  /** What a person should look at before cutting. */
  defects: Array<Defect>,
  /** How far the figures can be relied on. */
  confidence: Confidence,
}
