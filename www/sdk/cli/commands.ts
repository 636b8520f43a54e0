/**
 * Every command of the command line with its options, in one table: words are parsed by it, help is written from it, and
 * shells complete by it.
 */

import type { CommonCuts, Operation, Unit } from '../protocol.js';

/** What is done with cuts that contours share. */
export const COMMON_CUTS: readonly CommonCuts[] = ['best', 'insertion', 'off'];
export const UNITS: readonly Unit[] = ['mm', 'cm', 'dm', 'm', 'um', 'in', 'ft', 'yd', 'mil', 'microinch'];
export const OPERATIONS: readonly Operation[] = ['cut', 'mark', 'ignore'];
export const SHELLS = ['bash', 'zsh', 'fish'] as const;

/** What completes a value: a list, or names that the planner knows. */
export type Choices = readonly string[] | 'machines' | 'methods';

export interface Option {
  about: string;
  /** What its value is called; none: it is a switch. */
  value?: string;
  /** It may be given more than once. */
  repeat?: true;
  choices?: Choices;
}

export type Options = Readonly<Record<string, Option>>;

export interface Command {
  about: string;
  /** What follows the command's name. */
  words: string;
  /** A paragraph of help. */
  text: string;
  /** By heading. */
  options: Readonly<Record<string, Options>>;
  /** A command line and what it does. */
  examples: readonly (readonly [string, string])[];
  /** What completes its words; without: files. */
  choices?: Choices;
}

const READING: Options = {
  units: { value: 'UNIT', about: 'when the file says nothing or lies', choices: UNITS },
  layer: { value: `NAME=${OPERATIONS.join('|')}`, about: 'what to do with a layer', repeat: true },
  'order-by-layer': { about: 'layer after layer, in the order of --layer' },
  'part-by-part': { about: 'a part wholly, with all in its holes, before the next' },
  'common-cuts': { value: 'HOW', about: 'contours that share cuts: as one, on the best way or that of a heuristic, or not', choices: COMMON_CUTS },
  first: { value: 'ID', about: 'a contour before all others', repeat: true },
  last: { value: 'ID', about: 'a contour after all others', repeat: true },
  exclude: { value: 'ID', about: 'a contour not cut; the others keep their ids', repeat: true },
};

const PLANNING: Options = {
  machine: { value: 'NAME|FILE', about: "a preset's name, or a machine profile as JSON (default co2-100w)", choices: 'machines' },
  method: { value: 'NAME', about: 'see kerfway methods', choices: 'methods' },
  set: { value: 'NAME=VALUE', about: 'a parameter of a method from a paper', repeat: true },
  seconds: { value: 'S', about: 'how long to search each drawing (default 10)' },
  moves: { value: 'N', about: 'how many moves to search: the same result everywhere' },
  workers: { value: 'N', about: 'searches side by side that share the best path (default 1)' },
  seed: { value: 'N', about: 'decides every random choice' },
  'no-return': { about: 'stay where the last cut ends' },
};

const WATCHING: Options = { watch: { about: 'do it again whenever a file changes; Ctrl+C ends' } };

const MANY =
  'Several drawings may be named, by patterns, too (*, ?, [ab], **; quoted where the shell knows them not). OUT is then a ' +
  'folder, ending in /, with one file for each drawing, or - for JSON, one document a line. One that is unusable is told in a ' +
  'sentence; the others are done all the same.';

export const COMMANDS: Readonly<Record<string, Command>> = {
  plan: {
    about: 'plan the path and write it',
    words: 'FILE.dxf...',
    text: `Plans the path of the laser through each drawing and writes what is asked for. ${MANY} Ctrl+C ends a search and keeps what it found.`,
    options: {
      'Outputs; - is standard output': {
        gcode: { value: 'OUT', about: 'G-code for the machine' },
        json: { value: 'OUT', about: 'the plan (kerfway.plan/1)' },
        svg: { value: 'OUT', about: 'picture with order and direction' },
        dxf: { value: 'OUT', about: 'contours in cutting order' },
        png: { value: 'OUT', about: 'picture as pixels' },
      },
      'How to plan': PLANNING,
      'How to read': READING,
      'When': WATCHING,
    },
    examples: [
      ['kerfway plan plate.dxf --gcode plate.nc', 'G-code after ten seconds of search'],
      ["kerfway plan a.dxf 'orders/**/*.dxf' --gcode out/ --seconds 5", 'one file of G-code for each drawing'],
      ['kerfway plan plate.dxf --moves 1000000 --seed 7 --json -', 'the same bytes everywhere'],
      ['kerfway plan plate.dxf --svg plate.svg --watch', 'a picture that follows the drawing'],
    ],
  },
  inspect: {
    about: 'tell what the drawing holds, without planning',
    words: 'FILE.dxf...',
    text: `Tells contours, parts, layers, units and findings of each drawing. ${MANY}`,
    options: { Output: { json: { value: 'OUT', about: 'the whole report' } }, 'How to read': READING, 'When': WATCHING },
    examples: [
      ['kerfway inspect plate.dxf', 'what a drawing holds, in words'],
      ["kerfway inspect '*.dxf' --json - | jq .findings", 'findings of many, for a program'],
    ],
  },
  quote: {
    about: 'plan, and tell what a shop asks before it names a price',
    words: 'FILE.dxf...',
    text: `Tells lengths, times, areas, weight, identical parts and what may be wrong with each drawing, with a hash that confirms it. ${MANY}`,
    options: {
      'The sheet': {
        material: { value: 'NAME', about: 'for people' },
        thickness: { value: 'MM', about: 'of the sheet' },
        density: { value: 'G', about: 'g/cm3: mild steel 7.85, aluminium 2.70, acrylic 1.19' },
      },
      Output: { json: { value: 'OUT', about: 'the report (kerfway.quote/1)' } },
      'How to plan': PLANNING,
      'How to read': READING,
      'When': WATCHING,
    },
    examples: [
      ['kerfway quote plate.dxf --thickness 3 --density 7.85', 'figures and weight, in words'],
      ["kerfway quote 'orders/*.dxf' --moves 100000 --seed 1 --json quotes/", 'reports whose hashes another machine confirms'],
    ],
  },
  methods: {
    about: 'list the methods of planning',
    words: '',
    text: 'Lists the methods with their sources, and the parameters of those from papers.',
    options: {},
    examples: [['kerfway methods', 'the list']],
  },
  solve: {
    about: 'solve a benchmark instance: .tsp, .gtsp or .pcglns',
    words: 'FILE',
    text: 'Solves an instance of TSPLIB, GTSPLIB or PCGTSP by the default method.',
    options: {
      'How to solve': {
        seconds: PLANNING['seconds'] as Option,
        moves: PLANNING['moves'] as Option,
        seed: PLANNING['seed'] as Option,
        json: { value: 'OUT', about: 'length, tour, seconds, moves, lower_bound' },
      },
    },
    examples: [['kerfway solve 107ali535.gtsp --seconds 10', 'the best tour found in ten seconds']],
  },
  completion: {
    about: 'write what completes these words in a shell',
    words: SHELLS.join('|'),
    text: 'Writes the script that has a shell complete commands, options, machines and methods.',
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
