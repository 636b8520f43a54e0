/**
 * The table of all commands, with the options that each has. Parsing of arguments, help texts and shell completion use it.
 */

import {
  JOINTS, LEADS, LEVERS, MESSAGES, PLACING, PLANNING, PROVING, QUOTING, READING, SHELLS, SKELETON, WATCHING, type Choices, type Option, type Options,
} from './option-groups.js';

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

const MANY =
  'A drawing is a DXF, an SVG, or a project of the page (.kerfway), whose plan is kept unless the options ask for another; - is standard input. Several drawings may be named, also by patterns (*, ?, [ab], **; in quotes if the shell does not expand them). OUT is then ' +
  'a folder, ending in /, with one file for each drawing, named as it is without its folders, or - for JSON with one document per line. An unusable drawing is ' +
  'reported in a sentence; the others are processed anyway.';

const SIGNALS = 'Ctrl+C ends a search and keeps its result. SIGTERM does so, too, and leaves out the drawings after it.';

export const COMMANDS: Readonly<Record<string, Command>> = {
  plan: {
    about: 'plan the path and write it',
    words: 'FILE...',
    text: `Plans the path of the laser for each drawing and writes the requested outputs. ${MANY} ${SIGNALS}`,
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
    text: `Reports lengths, times, areas, weight, identical parts and possible defects of each drawing, with a hash that confirms the report. ${MANY} ${SIGNALS}`,
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
      'The machine': { machine: { ...(PLANNING['machine'] as Option), about: 'the name of a preset, or a JSON file with a machine profile (default: that of the plans)' } },
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
      'SIGTERM or Ctrl+C ends it when what runs is finished; the second one ends it at once.',
    options: {
      'Where': {
        host: { value: 'ADDRESS', about: 'the address to listen on (default 127.0.0.1; 0.0.0.0 for all)' },
        port: { value: 'N', about: 'the port (default 8080; 0 for any)' },
        cors: { value: 'ORIGIN', about: 'pages of this origin may call it; * for all', repeat: true },
        keys: { value: 'FILE', about: 'requests need one of the keys in this file: one per line, KEY or NAME KEY' },
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
        queue: { value: 'URL', about: 'puts jobs into a queue in Redis or Valkey (redis://...) instead; needs the packages bullmq and ioredis' },
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
    text: 'Solves an instance of TSPLIB, GTSPLIB or PCGTSP with the default method. Ctrl+C or SIGTERM ends the search and keeps its result.',
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
      'Verifies what kerfway plan --certificate has written: makes the problem again from the drawing and the machine, adds up the numbers of the ' +
      'certificate in whole numbers or finds its shortest walk, without a search, and says how many seconds no plan can be under. If no drawing is given, the ' +
      'one that the certificate names is read from the same folder. The exit code is 0 only if the certificate proves what it states.',
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
