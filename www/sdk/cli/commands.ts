/**
 * The table of all commands and their options. Parsing of arguments, help texts and shell completion use it.
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

export interface Command {
  about: string;
  /** The arguments after the command's name. */
  words: string;
  /** A paragraph of help. */
  text: string;
  /** The options, by heading. */
  options: Readonly<Record<string, Options>>;
  /** Example command lines, each with a description. */
  examples: readonly (readonly [string, string])[];
  /** The completions of its arguments; files by default. */
  choices?: Choices;
}

const READING: Options = {
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

const PLANNING: Options = {
  machine: { value: 'NAME|FILE', about: "the name of a preset, or a JSON file with a machine profile (default co2-100w)", choices: 'machines' },
  dialect: { value: 'NAME|FILE', about: "the dialect of G-code: the name of a shipped one, or a JSON file (default: the machine's)", choices: 'dialects' },
  method: { value: 'NAME', about: 'the planning method: see kerfway methods', choices: 'methods' },
  set: { value: 'NAME=VALUE', about: 'a parameter of a method from a paper', repeat: true },
  seconds: { value: 'S', about: 'how long to search each drawing (default 10)' },
  moves: { value: 'N', about: 'how many moves to search; with a seed, the result is the same everywhere' },
  workers: { value: 'N', about: 'parallel searches that share the best path (default 1)' },
  seed: { value: 'N', about: 'the seed of all random choices (default: a random one)' },
  'no-return': { about: 'stay at the end of the last cut instead of returning home' },
};

/** A quote has another default, so that others can make the same report. */
const QUOTING: Options = {
  ...PLANNING,
  seconds: { value: 'S', about: 'how long to search each drawing (default: moves that grow with the number of contours)' },
  seed: { value: 'N', about: 'the seed of all random choices (default: a random one; 1 without --seconds and --moves)' },
};

const PROVING: Options = {
  bound: { value: 'S', about: 'seconds of work on the lower bound in a thread of its own, beside the search: proves paths of few contours optimal, and is stronger than its own from about 100 on' },
  'bound-work': { value: 'N', about: 'million numbers of the same work, which prove the same everywhere' },
};

const LEADS: Options = {
  lead: { value: 'KIND', about: "the lead-in of every closed cut, instead of the machine's leads", choices: LEAD_KINDS },
  'lead-out': { value: 'KIND', about: 'the lead-out (default none)', choices: LEAD_KINDS },
  'lead-length': { value: 'MM', about: `length of the line (default ${DEFAULT_LEADS.length})` },
  'lead-radius': { value: 'MM', about: `radius of the arc (default ${DEFAULT_LEADS.radius})` },
  'lead-angle': { value: 'DEGREES', about: `of a line the angle to the contour, of an arc its sweep (default ${DEFAULT_LEADS.angle})` },
  'lead-position': { value: 'WHERE', about: 'where leads join a contour (default any)', choices: LEAD_POSITIONS },
  'lead-clearance': { value: 'MM', about: `least distance from everything that is not scrap (default ${DEFAULT_LEADS.clearance})` },
  'lead-center-below': { value: 'MM', about: `holes smaller than this begin at their centres (default ${DEFAULT_LEADS.centerBelow}; 0: none)` },
  overcut: { value: 'MM', about: 'length that is cut again after the start; a negative one, as --overcut=-0.5, leaves a gap (default 0)' },
};

const JOINTS: Options = {
  joints: { value: 'N', about: `least number of micro-joints of each contour, instead of the machine's joints (default ${DEFAULT_JOINTS.count}, if another option asks for joints)` },
  'joint-width': { value: 'MM', about: `width of the material that holds (default ${DEFAULT_JOINTS.width}); the width of the cut is added` },
  'joint-spacing': { value: 'MM', about: 'greatest length that is cut without a joint (default any)' },
  'joint-side': { value: 'WHICH', about: `the contours that have joints (default ${DEFAULT_JOINTS.side})`, choices: JOINT_SIDES },
  'joint-kind': { value: 'KIND', about: `whether the head stops at a joint (default ${DEFAULT_JOINTS.kind})`, choices: JOINT_KINDS },
  'joint-corners': { value: 'MM', about: `least distance of joints from corners (default ${DEFAULT_JOINTS.cornerClearance})` },
  'joint-size-min': { value: 'MM|X,Y', about: 'only contours at least this large' },
  'joint-size-max': { value: 'MM|X,Y', about: 'only contours at most this large' },
  'joint-test': { value: SIZE_TESTS.join('|'), about: `whether both sizes have to be within these limits, or one of them (default ${DEFAULT_JOINTS.test})`, choices: SIZE_TESTS },
};

const LEVERS: Options = {
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
  savings: { about: 'say what each lever of the machine saves: plan again without it, as long as before' },
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

const SKELETON: Options = {
  skeleton: { value: 'MM|X,Y', about: 'cut up what is left of the sheet, last of all, into pieces of at most this size' },
  'skeleton-clearance': { value: 'MM', about: 'least distance of these cuts from the cuts of parts (default 2)' },
  'skeleton-joints': { value: 'MM', about: 'greatest length of these cuts without a joint of 1 mm (default any)' },
  'keep-strip': { value: 'MM', about: 'cut off the largest strip without parts in one piece, if it is at least this wide' },
};

const PLACING: Options = {
  place: {
    value: 'POINT@PLACE', about: `put a point of the job (${ANCHORS[0]}, center, ... or X,Y in the drawing) at a place of the bed (X,Y or one of its points)`,
    choices: ANCHORS.map((point) => `${point}@`),
  },
  start: { value: STARTS.join('|'), about: 'machine coordinates (the default), or as seen from where the head stands', choices: STARTS },
  'allow-off-bed': { about: "write a program although it reaches beyond the machine's bed" },
};

const MESSAGES: Options = { quiet: { about: 'print no report and no progress, only warnings and errors' } };

const WATCHING: Options = { watch: { about: 'run again whenever a file changes; Ctrl+C ends' } };

const MANY =
  'A drawing is a DXF or an SVG; - is standard input. Several drawings may be named, also by patterns (*, ?, [ab], **; in quotes if the shell does not expand them). OUT is then ' +
  'a folder, ending in /, with one file for each drawing, or - for JSON with one document per line. An unusable drawing is ' +
  'reported in a sentence; the others are processed anyway.';

export const COMMANDS: Readonly<Record<string, Command>> = {
  plan: {
    about: 'plan the path and write it',
    words: 'FILE...',
    text: `Plans the path of the laser for each drawing and writes the requested outputs. ${MANY} Ctrl+C ends a search and keeps its result.`,
    options: {
      'Outputs; - is standard output': {
        gcode: { value: 'OUT', about: 'G-code for the machine' },
        json: { value: 'OUT', about: 'the plan (kerfway.plan/1)' },
        svg: { value: 'OUT', about: 'a picture with order and direction' },
        report: { value: 'OUT', about: 'an HTML page for the operator: picture, times, parts, order, findings' },
        dxf: { value: 'OUT', about: 'contours in cutting order' },
        png: { value: 'OUT', about: 'a picture in pixels' },
        lbrn2: { value: 'OUT', about: 'a LightBurn project' },
        rd: { value: 'OUT', about: 'a file for Ruida controllers (experimental)' },
        remainder: { value: 'OUT', about: 'DXF of what is left of the sheet, for the next job' },
        certificate: { value: 'OUT', about: 'the certificate of the lower bound, for kerfway verify' },
      },
      'The sheet': { material: { value: 'NAME', about: "a setting of the machine's library of materials" } },
      'Where on the bed': PLACING,
      'How to plan': PLANNING,
      'How to prove': PROVING,
      'Leads': LEADS,
      'Micro-joints': JOINTS,
      'Levers': LEVERS,
      'Skeleton cuts': SKELETON,
      'How to read': { ...READING, 'accept-guess': { about: 'write G-code although the unit is in doubt' } },
      'When': WATCHING, 'Messages': MESSAGES,
    },
    examples: [
      ['kerfway plan plate.dxf --gcode plate.nc', 'G-code after ten seconds of search'],
      ['kerfway plan plate.dxf --place lower-left@10,10 --turn 90 --gcode plate.nc', 'turned, and 10 mm from the corner of the bed'],
      ["kerfway plan a.dxf 'orders/**/*.dxf' --gcode out/ --seconds 5", 'one file of G-code for each drawing'],
      ['kerfway plan plate.dxf --gcode plate.ngc --dialect linuxcnc-m67', 'G-code for LinuxCNC'],
      ['kerfway plan plate.dxf --moves 1000000 --seed 7 --json -', 'the same bytes everywhere'],
      ['kerfway plan plate.dxf --machine fibre-3kw-thin --lead arc --overcut 0.5 --gcode plate.nc', 'every cut begins in scrap'],
      ['kerfway plan plate.dxf --svg plate.svg --watch', 'a picture that follows the drawing'],
      ['curl -s https://example.com/box.svg | kerfway plan - --dpi 72 --gcode box.nc', 'an SVG from standard input'],
    ],
  },
  inspect: {
    about: 'describe the drawing, without planning',
    words: 'FILE...',
    text: `Lists contours, parts, layers, units and findings of each drawing. ${MANY}`,
    options: { Output: { json: { value: 'OUT', about: 'the whole report' } }, 'How to read': READING, 'When': WATCHING, 'Messages': MESSAGES },
    examples: [
      ['kerfway inspect plate.dxf', 'the contents of a drawing, as text'],
      ["kerfway inspect '*.dxf' --json - | jq .findings", 'the findings of many drawings, for a program'],
    ],
  },
  quote: {
    about: 'plan, and report what a price depends on',
    words: 'FILE...',
    text: `Reports lengths, times, areas, weight, identical parts and possible defects of each drawing, with a hash that confirms the report. ${MANY}`,
    options: {
      'The sheet': {
        material: { value: 'NAME', about: "its name: a setting of the machine's library, if it has one" },
        thickness: { value: 'MM', about: 'the thickness of the sheet' },
        density: { value: 'G', about: 'g/cm3: mild steel 7.85, aluminium 2.70, acrylic 1.19' },
        sheet: { value: 'WxH', about: 'the size of the sheets in stock, mm: estimates how many are needed' },
        gap: { value: 'MM', about: 'the least distance between parts on a sheet (default 5)' },
      },
      'The order': {
        quantity: { value: 'N', about: 'copies of each drawing: seconds, weight and sheets for each quantity', repeat: true },
        limits: { value: 'FILE', about: 'a JSON file with the limits of the shop: smallest_hole, smallest_web, hole_to_edge, smallest_part, largest_part, floating_pieces' },
      },
      Output: { json: { value: 'OUT', about: 'the report (kerfway.quote/2)' } },
      'How to plan': QUOTING,
      'Leads': LEADS,
      'Micro-joints': JOINTS,
      'Levers': LEVERS,
      'Skeleton cuts': SKELETON,
      'How to read': READING,
      'When': WATCHING, 'Messages': MESSAGES,
    },
    examples: [
      ['kerfway quote plate.dxf --thickness 3 --density 7.85', 'figures and weight, as text'],
      ['kerfway quote bracket.dxf --quantity 1 --quantity 50 --sheet 3000x1500', 'seconds, weight and sheets of 1 and of 50'],
      ["kerfway quote 'orders/*.dxf' --moves 100000 --seed 1 --json quotes/", 'reports whose hashes another computer can confirm'],
    ],
  },
  check: {
    about: 'read a G-code program back and say what it would do',
    words: 'FILE.nc...',
    text:
      "Follows the head and the beam through each program by the rules of the machine's dialect: does it fit the bed, is each contour cut once, " +
      'is the beam off on every rapid, is every word in range, how long does it take. Files of other programs can be checked too. ' +
      'The exit code is 0 only if every program passes.',
    options: {
      'The machine': { machine: PLANNING['machine'] as Option, dialect: PLANNING['dialect'] as Option },
      Output: { json: { value: 'OUT', about: 'the whole report' } },
      'When': WATCHING, 'Messages': MESSAGES,
    },
    examples: [
      ['kerfway check plate.nc --machine co2-100w', 'before it goes to the machine'],
      ['kerfway check other.ngc --dialect linuxcnc-m67 --json -', 'the report, for a program'],
    ],
  },
  calibrate: {
    about: 'fit a machine to the seconds that jobs took',
    words: 'PLAN.json=SECONDS...',
    text: 'Reads plans that were written with --json and run, with the seconds that each took by the clock, and fits the acceleration along contours, the corner deviation and the pierce time of the machine. One or two jobs are enough; best is one with many piercings and one with many corners.',
    options: {
      'The machine': { machine: PLANNING['machine'] as Option },
      Output: { json: { value: 'OUT', about: 'the machine with the fitted values, for --machine' } },
      Messages: MESSAGES,
    },
    examples: [['kerfway calibrate grid.json=341 gears.json=1022 --machine shop.json --json shop-fitted.json', 'from two jobs']],
  },
  serve: {
    about: 'answer over HTTP: POST /inspect, /plan, /quote',
    words: '',
    text:
      'Starts a service. A request has the drawing as its body or as the file of a form, and options in the query or as JSON in the field ' +
      'options; GET /openapi.json describes it. When too many wait, it answers 429 with Retry-After. Logs are JSON on standard error. ' +
      'SIGTERM ends it when what runs is finished.',
    options: {
      'Where': {
        host: { value: 'ADDRESS', about: 'the address to listen on (default 127.0.0.1; 0.0.0.0 for all)' },
        port: { value: 'N', about: 'the port (default 8080; 0 for any)' },
        cors: { value: 'ORIGIN', about: 'pages of this origin may call it; * for all', repeat: true },
        keys: { value: 'FILE', about: 'needs a key: one per line, KEY or NAME KEY' },
      },
      'Limits': {
        workers: { value: 'N', about: 'drawings worked on at once (default: the number of processors)' },
        waiting: { value: 'N', about: 'requests that may wait (default 64)' },
        largest: { value: 'MB', about: 'the largest body (default 20)' },
        'upload-seconds': { value: 'S', about: 'the time for a body to arrive, and for an answer to be read, with a second more for each MB of it (default 30)' },
        deadline: { value: 'S', about: 'the time for a drawing, besides the seconds of its search (default 120)' },
        'most-seconds': { value: 'S', about: 'the longest search that a request may ask for (default 60)' },
        'most-moves': { value: 'N', about: 'the most moves that a request may ask for (default 500000000)' },
        grace: { value: 'S', about: 'the time to finish what runs when it is stopped (default 30)' },
      },
      'Several machines': {
        queue: { value: 'URL', about: 'puts jobs into a queue in Redis or Valkey (redis://...) instead; needs the package bullmq' },
        expires: { value: 'S', about: 'how long results of the queue are kept (default 86400)' },
      },
    },
    examples: [
      ['kerfway serve --port 8080', 'a service on this computer'],
      ["curl --data-binary @plate.dxf 'localhost:8080/quote?name=plate.dxf&machine=co2-100w&material.thickness=3'", 'a quote'],
      ["curl -F drawing=@plate.dxf -F 'options={\"seconds\":5,\"outputs\":[\"gcode\"]}' localhost:8080/plan", 'a plan with G-code'],
    ],
  },
  work: {
    about: 'take jobs from the queue of kerfway serve --queue',
    words: '',
    text: 'Works on the drawings that wait in a queue. Start as many as there are machines. SIGTERM ends it when its jobs are finished; jobs of a worker that dies are taken by another.',
    options: {
      'How': {
        queue: { value: 'URL', about: 'the queue: redis://HOST:6379' },
        workers: { value: 'N', about: 'drawings worked on at once (default: the number of processors)' },
        deadline: { value: 'S', about: 'the time for a drawing, besides the seconds of its search (default 120)' },
      },
    },
    examples: [['kerfway work --queue redis://queue.internal:6379', 'one worker process']],
  },
  methods: {
    about: 'list the planning methods',
    words: '',
    text: 'Lists the methods with their sources, and the parameters of those from papers.',
    options: {},
    examples: [['kerfway methods', 'the list']],
  },
  solve: {
    about: 'solve a benchmark instance: .tsp, .gtsp or .pcglns',
    words: 'FILE',
    text: 'Solves an instance of TSPLIB, GTSPLIB or PCGTSP with the default method.',
    options: {
      'How to solve': {
        seconds: PLANNING['seconds'] as Option,
        moves: PLANNING['moves'] as Option,
        seed: PLANNING['seed'] as Option,
        json: { value: 'OUT', about: 'name, length, tour, seconds, moves, seed, lower_bound' },
      },
    },
    examples: [['kerfway solve 107ali535.gtsp --seconds 10', 'the best tour found in ten seconds']],
  },
  verify: {
    about: 'check the certificate of a lower bound',
    words: 'CERTIFICATE [DRAWING]',
    text:
      'Verifies what kerfway plan --certificate has written: makes the problem again from the drawing and the machine, adds the numbers of the ' +
      'certificate up in whole numbers or finds its shortest walk, without a search, and says how many seconds no plan can be under. Without a drawing, it is the file of ' +
      "the certificate's own name beside it. The exit code is 0 only if the certificate proves what it states.",
    options: {
      'The machine': { machine: { value: 'NAME|FILE', about: 'refuse a certificate for any other machine', choices: 'machines' } },
      Output: { json: { value: 'OUT', about: 'seconds, paid, drawing, machine' } },
      Messages: MESSAGES,
    },
    examples: [
      ['kerfway plan plate.dxf --certificate plate.certificate.json', 'a plan, and the certificate of its lower bound'],
      ['kerfway verify plate.certificate.json plate.dxf', 'the proof, checked on another computer'],
    ],
  },
  completion: {
    about: 'write a script for shell completion',
    words: SHELLS.join('|'),
    text: 'Writes a script that makes a shell complete commands, options, machines and methods.',
    options: {},
    examples: [
      ['source <(kerfway completion bash)', 'in ~/.bashrc'],
      ['kerfway completion zsh > "${fpath[1]}/_kerfway"', 'once, for zsh'],
      ['kerfway completion fish > ~/.config/fish/completions/kerfway.fish', 'once, for fish'],
    ],
    choices: SHELLS,
  },
};

/** All options of a command, without their headings. */
export function optionsOf(command: string): Options {
  return Object.assign({}, ...Object.values(COMMANDS[command]?.options ?? {})) as Options;
}

/** Commands in a sentence: `plan, inspect or methods`. */
export function commandsInWords(): string {
  const names = Object.keys(COMMANDS);
  return `${names.slice(0, -1).join(', ')} or ${names.at(-1)}`;
}
