/**
 * The options that several commands have, in groups: how a drawing is read, how it is planned, what the machine does. `commands.ts` says which
 * command has which group.
 */

import { ANCHORS } from '../anchors.js';
import { CORNER_KINDS } from '../corners.js';
import { DEFAULT_JOINTS, JOINT_KINDS, JOINT_SIDES, SIZE_TESTS } from '../joints.js';
import { DEFAULT_LEADS, LEAD_KINDS, LEAD_POSITIONS } from '../leads.js';
import type { CommonCuts, Group, Operation, PassOrder, RiskyMoves, Unit } from '../protocol.js';

/** How contours with common cuts are cut. */
export const COMMON_CUTS: readonly CommonCuts[] = ['best', 'insertion', 'off'];
export const UNITS: readonly Unit[] = ['mm', 'cm', 'dm', 'm', 'um', 'in', 'ft', 'yd', 'mil', 'microinch', 'px'];
export const OPERATIONS: readonly Operation[] = ['cut', 'mark', 'ignore'];
export const GROUPS: readonly Group[] = ['lettering', 'leaders'];
export const TURNS = ['0', '90', '180', '270'] as const;
export const PASS_ORDERS: readonly PassOrder[] = ['contour', 'sheet'];
export const RISKY_MOVES: readonly RiskyMoves[] = ['avoid', 'ignore'];
export const STARTS = ['absolute', 'current'] as const;
export const SHELLS = ['bash', 'zsh', 'fish'] as const;

/** The completions of a value: a list, or the names that the planner knows. */
export type Choices = readonly string[] | 'machines' | 'methods' | 'dialects';

export interface Option {
  about: string;
  /** The name of its value; absent for a flag. */
  value?: string;
  /** Whether it may be given more than once. */
  repeat?: true;
  choices?: Choices;
}

export type Options = Readonly<Record<string, Option>>;

export const READING: Options = {
  units: { value: 'UNIT', about: 'the unit, if the file does not state it or states a wrong one', choices: UNITS },
  turn: { value: 'DEGREES', about: 'turn the drawing around its origin, counter-clockwise', choices: TURNS },
  dpi: { value: 'N', about: 'pixels per inch of a drawing in pixels: 96 (browsers, Inkscape), 90 (Inkscape before 0.92), 72 (Illustrator)' },
  'join-tolerance': { value: 'MM', about: 'join ends that are closer (default 0.05)' },
  'curve-tolerance': { value: 'MM', about: 'follow curves within this distance (default 0.005)' },
  'copy-tolerance': { value: 'MM', about: 'remove copies of lines that are closer (default 0.01)' },
  layer: { value: `NAME=${OPERATIONS.join('|')}[,speed=..]`, about: 'the operation of a layer, and what it is worked with: speed (mm/s), power and min-power (0 to 1), passes, z-step (mm), air (on or off)', repeat: true },
  group: { value: `NAME=${OPERATIONS.join('|')}`, about: 'the operation of a group recognised by its look: lettering, leaders', repeat: true },
  'keep-border': { about: 'cut the border around everything, even if it clearly shows the sheet' },
  'ignore-border': { about: 'ignore the border around everything, even if it may be a cut' },
  'pass-order': { value: PASS_ORDERS.join('|'), about: 'run all passes of a contour at once (the default), or one pass of the whole sheet after the other', choices: PASS_ORDERS },
  'order-by-layer': { about: 'process one layer after the other, in the order of --layer' },
  'part-by-part': { about: 'finish each part, with everything in its holes, before the next' },
  'common-cuts': { value: 'HOW', about: 'how to cut contours with common cuts: together, on the best path or that of a heuristic, or separately', choices: COMMON_CUTS },
  first: { value: 'ID', about: 'process a contour before all others', repeat: true },
  last: { value: 'ID', about: 'process a contour after all others', repeat: true },
  sequence: { value: 'ID,ID,...', about: 'process these contours in this order; others may come in between', repeat: true },
  together: { value: 'ID,ID,...', about: 'process these contours, with everything inside them, without any other in between', repeat: true },
  mark: { value: 'ID', about: 'mark a contour instead of cutting it', repeat: true },
  'joint-at': { value: 'ID@SHARE', about: 'place a micro-joint on a contour, at a share (0 to 1) of its length from its start', repeat: true },
  'joints-of': { value: 'ID=N', about: 'number of micro-joints of a contour, instead of the rules (0: none)', repeat: true },
  'lead-of': { value: 'ID=KIND', about: `lead-in of a contour, instead of the rules: ${LEAD_KINDS.join(', ')}, center`, repeat: true },
  'corners-of': { value: 'ID=KIND', about: `corners of a contour, instead of --corners: ${CORNER_KINDS.join(', ')}`, repeat: true },
  exclude: { value: 'ID', about: 'skip a contour; the others keep their ids', repeat: true },
};

export const PLANNING: Options = {
  machine: { value: 'NAME|FILE', about: "the name of a preset, or a JSON file with a machine profile (default co2-100w)", choices: 'machines' },
  dialect: { value: 'NAME|FILE', about: "the dialect of G-code: the name of a shipped one, or a JSON file (default: the machine's)", choices: 'dialects' },
  'kerf-width': { value: 'MM', about: "width of the cut, instead of that of the machine and its materials: parts get the drawn size (0: the beam follows the drawn lines)" },
  method: { value: 'NAME', about: 'the planning method: see kerfway methods', choices: 'methods' },
  set: { value: 'NAME=VALUE', about: 'a parameter of a method from a paper', repeat: true },
  seconds: { value: 'S', about: 'how long to search each drawing (default 10)' },
  moves: { value: 'N', about: 'how many moves to search; with a seed, the result is the same everywhere' },
  workers: { value: 'N', about: 'parallel searches that share the best path (default 1)' },
  seed: { value: 'N', about: 'the seed of all random choices (default: a random one)' },
  'no-return': { about: 'stay at the end of the last cut instead of returning home' },
};

/** A quote has another default, so that others can make the same report. */
export const QUOTING: Options = {
  ...PLANNING,
  seconds: { value: 'S', about: 'how long to search each drawing (default: moves that grow with the number of contours)' },
  seed: { value: 'N', about: 'the seed of all random choices (default: a random one; 1 without --seconds and --moves)' },
};

export const PROVING: Options = {
  bound: { value: 'S', about: 'seconds of work on the lower bound, in a thread beside the search: proves paths of few contours optimal, and proves more than the search alone from about 100 contours on' },
  'bound-work': { value: 'N', about: 'the same work, counted in millions of numbers instead of seconds: proves the same everywhere' },
};

export const LEADS: Options = {
  lead: { value: 'KIND', about: "the lead-in of every closed cut, instead of the machine's leads; without it, the other options change those", choices: LEAD_KINDS },
  'lead-out': { value: 'KIND', about: 'the lead-out (default none)', choices: LEAD_KINDS },
  'lead-length': { value: 'MM', about: `length of the line (default ${DEFAULT_LEADS.length})` },
  'lead-radius': { value: 'MM', about: `radius of the arc (default ${DEFAULT_LEADS.radius})` },
  'lead-angle': { value: 'DEGREES', about: `of a line the angle to the contour, of an arc its sweep (default ${DEFAULT_LEADS.angle})` },
  'lead-position': { value: 'WHERE', about: 'where leads join a contour (default any)', choices: LEAD_POSITIONS },
  'lead-clearance': { value: 'MM', about: `least distance from everything that is not scrap (default ${DEFAULT_LEADS.clearance})` },
  'lead-center-below': { value: 'MM', about: `holes smaller than this begin at their centres (default ${DEFAULT_LEADS.centerBelow}; 0: none)` },
  overcut: { value: 'MM', about: 'length that is cut again after the start; a negative one, as --overcut=-0.5, leaves a gap (default 0)' },
};

export const JOINTS: Options = {
  joints: { value: 'N', about: `least number of micro-joints of each contour, instead of the machine's joints; without it, the other options change those (default ${DEFAULT_JOINTS.count}, if the machine has none and another option asks for joints)` },
  'joint-width': { value: 'MM', about: `width of the material that holds (default ${DEFAULT_JOINTS.width}); the width of the cut is added` },
  'joint-spacing': { value: 'MM', about: 'greatest length that is cut without a joint (default any)' },
  'joint-side': { value: 'WHICH', about: `the contours that have joints (default ${DEFAULT_JOINTS.side})`, choices: JOINT_SIDES },
  'joint-kind': { value: 'KIND', about: `whether the head stops at a joint (default ${DEFAULT_JOINTS.kind})`, choices: JOINT_KINDS },
  'joint-corners': { value: 'MM', about: `least distance of joints from corners (default ${DEFAULT_JOINTS.cornerClearance})` },
  'joint-size-min': { value: 'MM|X,Y', about: 'only contours at least this large' },
  'joint-size-max': { value: 'MM|X,Y', about: 'only contours at most this large' },
  'joint-test': { value: SIZE_TESTS.join('|'), about: `whether both sizes have to be within these limits, or one of them (default ${DEFAULT_JOINTS.test})`, choices: SIZE_TESTS },
};

export const LEVERS: Options = {
  'moving-pierce': { value: 'MM', about: 'begin marks and closed cuts moving, without a wait, and cut this length of a cut again at its end' },
  lift: { value: 'MM', about: 'lift the head by this much for moves with the beam off, on the way' },
  'stay-down': { value: 'MM', about: 'with --lift: moves up to this length are made with the head down (default 0)' },
  'lift-at-rest': { about: 'with --lift: lift the head before it travels, and lower it after that' },
  fly: { value: 'MM', about: 'cut rows and grids of contours on the run, with at most this way between two cuts' },
  'fly-overcut': { value: 'MM', about: 'with --fly: cut this length of a contour again at its end (default 0)' },
  chains: { value: 'MM', about: 'join contours by cuts through waste of at most this length, where that is quicker than piercing' },
  'chain-clearance': { value: 'MM', about: 'with --chains: least distance of these cuts from other contours (default 1)' },
  'edge-starts': { about: 'with --chains: begin cuts through waste on kerfs that were cut before and at the edge of the sheet, too, without piercing' },
  bridges: { value: 'MM', about: 'connect parts by strips of material up to this long, so that they are pierced once, where that is quicker' },
  'bridge-width': { value: 'MM', about: 'with --bridges: width of the strips (default 2)' },
  'bridge-clearance': { value: 'MM', about: 'with --bridges: least distance of the strips from other contours and from corners (default 1)' },
  'bridge-most': { value: 'N', about: 'with --bridges: most parts that are connected (default: any number)' },
  'cut-bridges': { about: 'with --bridges: cut the strips, too, after the cut around the connected parts (default: a person separates them)' },
  'shared-cuts': { about: 'cut contours that share cuts, such as parts one kerf apart, together: pierced once, on any machine' },
  'offer-shifts': { value: 'MM', about: 'with a kerf: say which parts would stand one kerf from a neighbour if they were shifted by at most this' },
  'shift-parts': { value: 'MM', about: 'shift these parts, each by at most this' },
  corners: { value: CORNER_KINDS.join('|'), about: 'at corners of parts, cut a loop through waste or an arc instead of turning, where that is quicker', choices: CORNER_KINDS },
  'hole-corners': { value: CORNER_KINDS.join('|'), about: 'the same at corners of holes (default stop)', choices: CORNER_KINDS },
  'loop-radius': { value: 'MM', about: 'radius of loops at corners (default 2)' },
  'loop-clearance': { value: 'MM', about: 'least distance of loops from other contours (default 1)' },
  'round-radius': { value: 'MM', about: 'greatest radius of rounded corners (default 1)' },
  'corner-deviation': { value: 'MM', about: 'greatest distance of a rounded corner from the corner drawn (default 0.1)' },
  savings: { about: 'say what each lever of the machine saves: plan again without it, as long as before; Ctrl+C skips the rest' },
  'z-speed': { value: 'MM/S', about: "speed of lifting and lowering, instead of the machine's" },
  tips: { value: RISKY_MOVES.join('|'), about: 'moves over pieces that may have tipped: go around or over them with the head lifted (needs --lift), or report them', choices: RISKY_MOVES },
  'nozzle-radius': { value: 'MM', about: 'with --tips: radius of the nozzle (default 10)' },
  'tip-margin': { value: 'MM', about: 'with --tips: distance that the nozzle keeps from tipped pieces (default 2)' },
  slats: { value: 'MM[,DEGREES]', about: 'with --tips: distance from slat to slat, and the direction in which they run (default 0: along x)' },
  'tips-below': { value: 'MM', about: 'with --tips: pieces smaller than this across the slats may tip (default 150)' },
  'drops-below': { value: 'MM', about: 'with --tips: pieces smaller than this both ways drop (default: the distance of the slats, or 50)' },
  'cross-over': { value: 'MM', about: 'with --tips: what is cut out of holes up to this size may be crossed with the head down (default 0)' },
  heat: { value: 'MM,S', about: 'a cut nearer than this to another begins no sooner than these seconds after its end: the head waits' },
  'heat-charge': { value: 'S', about: 'with --heat: charge this much for each pair of cuts that follow each other sooner, instead of waiting' },
  'small-holes': { value: 'MM[,RATIO]', about: 'cut holes up to RATIO (default 1) times this thickness of the plate before all other cuts' },
};

export const SKELETON: Options = {
  skeleton: { value: 'MM|X,Y', about: 'cut up what is left of the sheet, last of all, into pieces of at most this size' },
  'skeleton-clearance': { value: 'MM', about: 'least distance of these cuts from the cuts of parts (default 2)' },
  'skeleton-joints': { value: 'MM', about: 'greatest length of these cuts without a joint of 1 mm (default any)' },
  'keep-strip': { value: 'MM', about: 'cut off the largest strip without parts in one piece, if it is at least this wide' },
};

export const PLACING: Options = {
  place: {
    value: 'POINT@PLACE', about: `put a point of the job (${ANCHORS[0]}, center, ... or X,Y in the drawing) at a place of the bed (X,Y or one of its points)`,
    choices: ANCHORS.map((point) => `${point}@`),
  },
  start: { value: STARTS.join('|'), about: 'machine coordinates (the default), or as seen from where the head stands', choices: STARTS },
  'allow-off-bed': { about: "write a program although it reaches beyond the machine's bed" },
};

export const MESSAGES: Options = { quiet: { about: 'print no report and no progress, only warnings and errors' } };

export const WATCHING: Options = { watch: { about: 'run again whenever a file changes; Ctrl+C ends' } };
