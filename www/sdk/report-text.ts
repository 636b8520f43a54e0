/** The words of a report, and how it writes numbers: English, and what another language has to say. */

import { duration, fixed, plural } from './words.js';
import type { Finding, Operation, Severity, Unit, UnitsTaken } from './protocol.js';

/** How a report is written. */
export interface ReportText {
  /** The language, as in the attribute `lang` of HTML. */
  lang: string;
  /** A number with at most two decimals: a coordinate or a weight. */
  number(value: number): string;
  /** A length, mm. */
  length(mm: number): string;
  /** A width and a height, mm. */
  size(width: number, height: number): string;
  /** A long way, mm. */
  far(mm: number): string;
  /** An area, mm2. */
  area(mm2: number): string;
  /** A time, s. */
  duration(s: number): string;
  /** What a finding says. */
  finding(finding: Finding): string;
  words: ReportWords;
}

/** The words of a report. What holds a value is a function. */
export interface ReportWords {
  machine: string;
  /** The width of the cut. */
  kerf: string;
  material: string;
  size: string;
  parts: string;
  weight: string;
  printed: string;
  /** What the picture shows. */
  picture: string;
  time: string;
  job: string;
  cutting: string;
  air: string;
  piercing: string;
  preCuts: string;
  nearest: string;
  gap: string;
  noBound: string;
  nothing: string;
  layers: string;
  layer: string;
  operation: string;
  contours: string;
  contour: string;
  length: string;
  count: string;
  area: string;
  toCut: string;
  holes: string;
  findings: string;
  order: string;
  /** Number in the order. */
  no: string;
  begins: string;
  entry: string;
  /** A list has nothing in it. */
  none: string;
  operations: Record<Operation, string>;
  severities: Record<Severity, string>;
  /** The size, with the unit it was read in and where that comes from. */
  readIn(size: string, unit: Unit, source: UnitsTaken['source']): string;
  /** How many parts there are, and of how many kinds. */
  different(parts: number, kinds: number): string;
  /** A time for a way or a number of pre-cuts. */
  along(time: string, way: string): string;
  /** The seconds of piercing, and how often. */
  pierced(time: string, piercings: number): string;
  /** The time of the order nearest first, with that of the drawing. */
  asDrawn(nearest: string, drawn: string): string;
  /** What could be saved at most. */
  atMost(time: string): string;
  /** How many rows are not listed. */
  more(rows: number): string;
  /** How often a finding occurs. */
  times(n: number): string;
  /** Where a finding is. */
  at(x: string, y: string): string;
  /** What the report was made of. */
  source(version: string, seed: number, moves: number, drawing: string, quote: string): string;
}

const SOURCES: Record<UnitsTaken['source'], string> = { header: 'stated in the file', guessed: 'guessed', given: 'chosen' };

const number = (value: number) => String(Math.round(value * 100) / 100);

/** English, in millimetres. */
export const ENGLISH: ReportText = {
  lang: 'en', number, duration,
  length: (mm) => `${number(mm)} mm`, size: (width, height) => `${number(width)} × ${number(height)} mm`, far: (mm) => `${(mm / 1000).toFixed(2)} m`, area: (mm2) => `${fixed(mm2 / 100, 2)} cm²`,
  finding: (finding) => finding.message,
  words: {
    machine: 'Machine', kerf: 'Kerf width', material: 'Material', size: 'Size', parts: 'Parts', weight: 'Weight', printed: 'Printed', picture: 'The path of the beam, with order and direction',
    time: 'Time', job: 'Job', cutting: 'Cutting', air: 'Air moves', piercing: 'Piercing', preCuts: 'Pre-cuts', nearest: 'Nearest first', gap: 'Left to gain', noBound: 'no bound yet', nothing: 'nothing: this path is optimal',
    layers: 'Layers', layer: 'Layer', operation: 'Operation', contours: 'Contours', contour: 'Contour', length: 'Length', count: 'Count', area: 'Area', toCut: 'To cut', holes: 'Holes',
    findings: 'Findings', order: 'Cutting order', no: 'No.', begins: 'Begins', entry: 'Entry, mm', none: 'None.',
    operations: { cut: 'cut', mark: 'mark', ignore: 'ignore' }, severities: { error: 'error', warning: 'warning', info: 'note' },
    readIn: (size, unit, source) => `${size}, read in ${unit} (${SOURCES[source]})`, different: (parts, kinds) => `${parts}, ${kinds} different`,
    along: (time, way) => `${time} for ${way}`, pierced: (time, piercings) => `${time} for ${plural(piercings, 'piercing')}`, asDrawn: (nearest, drawn) => `${nearest}; as drawn ${drawn}`,
    atMost: (time) => `at most ${time}`, more: (rows) => `And ${rows} more.`, times: (n) => `${n} times`, at: (x, y) => `at ${x}, ${y}`,
    source: (version, seed, moves, drawing, quote) => `Kerfway ${version}, seed ${seed}, ${moves} moves. Drawing ${drawing}, quote ${quote}.`,
  },
};
