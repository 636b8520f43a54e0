/** Checks the report of a quote that comes from outside, before its fields are read. */

import { isRecord } from './check.js';
import { KerfwayError } from './errors.js';
import type { Quote } from './quote.js';

/** Whether a field of a report has a value that can be read. */
type Readable = (value: unknown) => boolean;

/** Some fields of a report, with what they must be. */
export type ReportFields = Partial<Record<keyof Quote, Readable>>;

const isStated: Readable = (value) => value !== undefined;
const isText: Readable = (value) => typeof value === 'string';
const isNumber: Readable = (value) => Number.isFinite(value);
const isCount: Readable = (value) => Number.isSafeInteger(value) && (value as number) >= 0;
const orNull = (readable: Readable): Readable => (value) => value === null || readable(value);
const isList = (of: Readable): Readable => (value) => Array.isArray(value) && value.every(of);
const isNumbers = (length: number): Readable => (value) => isList(isNumber)(value) && (value as unknown[]).length === length;
const hasFields = (fields: Record<string, Readable>): Readable => (value) => isRecord(value) && Object.entries(fields).every(([name, readable]) => readable(value[name]));

const TIMES: Record<keyof Quote['times'], Readable> = { total: isNumber, cut: isNumber, air: isNumber, pierce: isNumber, pre_cut: isNumber, macros: isNumber };

/** What a basket adds up. */
export const ADDED: ReportFields = {
  input: hasFields({ name: isText }), hash: isText, part_count: isCount, times: hasFields(TIMES), net_area: isNumber, weight: orNull(isNumber),
  parts: isList(hasFields({ items: isList(hasFields({ bounds: isNumbers(4) })) })),
};

/** What is planned again. Machine, options and the like are checked by the planner, as those of any plan. */
export const PLANNED: ReportFields = {
  input: hasFields({ name: isText, sha256: isText }), options: isRecord, machine: isRecord, setting: orNull(isText), method: isText, parameters: orNull(isText),
  seed: isStated, moves: isStated, workers: orNull(isCount), placement: orNull(hasFields({ shift: isNumbers(2), start: isText })),
  material: isRecord, checks: orNull(hasFields({ limits: isRecord })),
};

/** Throws a `KerfwayError` unless this is a report of a version that can be read, with these fields. */
export function checkReport(report: unknown, field: string, fields: ReportFields): Quote {
  const schema = isRecord(report) ? report['schema'] : undefined;
  if (!isRecord(report) || schema !== 'kerfway.quote/2') {
    const version = typeof schema === 'string' && /^kerfway\.quote\/\d{1,3}$/.test(schema);
    const sentence = version ? `The report is of the version ${schema}; this Kerfway reads kerfway.quote/2. Make the quote again.` : 'This is no report of a quote (kerfway.quote/2).';
    throw new KerfwayError('not-a-quote', sentence, { field });
  }
  const wrong = Object.entries(fields).find(([name, readable]) => !readable(report[name]))?.[0];
  if (wrong === undefined) return report as unknown as Quote;
  const sentence = report[wrong] === undefined ? `The report lacks the field "${wrong}".` : `The report's field "${wrong}" is not as in a report of a quote.`;
  throw new KerfwayError('not-a-quote', sentence, { field: `${field}.${wrong}` });
}
