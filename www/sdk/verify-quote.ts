/** Confirms the report of a quote: plans the drawing again as the report says, and compares. */

import { isRecord } from './check.js';
import { KerfwayError } from './errors.js';
import { SHAPES } from './fields.js';
import type { PlanningOptions } from './options.js';
import type { Loaded, LoadOptions, PlanOptions } from './protocol.js';
import type { Quote, QuoteTerms } from './quote.js';
import { quoteBudget } from './quote-budget.js';
import { checkReport, PLANNED } from './read-report.js';

/** The result of `verifyQuote`. */
export interface Verification {
  /** Whether the report is what this planner makes of the drawing. */
  valid: boolean;
  /** The fields of the report that differ. `input`: it was made from another drawing. `version`: another version of the planner made it. */
  differences: string[];
  /** The report that this planner makes, to rely on instead; `null` for another drawing. */
  report: Quote | null;
}

/** A report may ask for this many times the moves that a quote takes by default, of all its workers together. More would let a sender keep the server busy. */
const MOST = 10;
/**
 * A small drawing may ask for as many as a large one, because a quote within seconds makes any number of moves: 500 million are what the
 * service takes of a request, 50 s of a small drawing at ten million a second.
 */
const ALWAYS = 500_000_000;
/** Each worker takes a thread and the memory of a planner. */
const MOST_WORKERS = 16;

/** How a report says that its drawing was read. The document has names in snake case and values for what was not given. */
export function readingOf(report: Quote): LoadOptions {
  const given = renamed(record(report.options, 'options'));
  const layers = given.find(([name]) => name === 'layers');
  // A report has what is set for a layer in an object of its own.
  if (layers !== undefined && Array.isArray(layers[1])) {
    layers[1] = layers[1].map((layer) => {
      const { settings, ...choice } = record(layer, 'options.layers');
      return { ...choice, ...(settings === undefined ? {} : Object.fromEntries(renamed(record(settings, 'options.layers.settings')))) };
    });
  }
  const known = given.filter(([name, value]) => value !== null && SHAPES.reading.fields.some((f) => f.name === name));
  return Object.fromEntries(known) as LoadOptions;
}

/** Names in camel case instead of snake case. */
function renamed(object: Record<string, unknown>): [string, unknown][] {
  return Object.entries(object).map(([name, value]) => [name.replace(/_([a-z])/g, (_, letter: string) => letter.toUpperCase()), value]);
}

/** How a report says that its drawing was planned. */
export function planningOf(report: Quote, loaded: Loaded): PlanOptions {
  const { machine, method, seed, moves, workers, parameters, setting } = report;
  if (workers !== null && !(workers >= 1 && workers <= MOST_WORKERS)) {
    throw new KerfwayError('out-of-range', `The report's field "workers" is ${String(workers)}. Reports of up to ${MOST_WORKERS} are verified.`, { field: 'workers', value: String(workers), least: 1, most: MOST_WORKERS });
  }
  // Each worker makes this number of moves.
  const most = Math.floor(Math.max(ALWAYS, MOST * quoteBudget(loaded).moves) / (workers ?? 1));
  if (!(Number.isSafeInteger(moves) && moves >= 0 && moves <= most)) {
    throw new KerfwayError('out-of-range', `The report's field "moves" is ${String(moves)}. Up to ${most} are verified for this drawing.`, { field: 'moves', value: String(moves), least: 0, most });
  }
  const { placement } = report;
  return {
    // A report has the machine with the setting on it, and only its name is missing in the library.
    ...(setting === null ? { machine } : { machine: { ...machine, materials: [{ name: setting }] }, material: setting }),
    method, seed, moves,
    // The report says how far the job was moved, so the origin of the drawing is placed there.
    ...(placement === null ? {} : { place: { from: [0, 0], at: placement.shift }, start: placement.start }),
    ...(workers === null ? {} : { workers }),
    ...(parameters === null ? {} : { parameters: json(parameters) }),
  };
}

/** What a report says that was stated about the job. */
export function termsOf(report: Quote): QuoteTerms {
  const terms: QuoteTerms = { material: given(report.material, 'material') };
  if (report.checks !== null) terms.limits = given(record(report.checks, 'checks')['limits'], 'checks.limits');
  return terms;
}

/** Compares a report with the one that was made again. The name of the file is not compared: it is part of neither hash nor job. */
export function compared(report: Quote, again: Quote): Verification {
  const all = new Set([...Object.keys(report), ...Object.keys(again)]) as Set<keyof Quote>;
  const unnamed = (quote: Quote) => ({ ...quote, input: { ...quote.input, name: '' } });
  const [a, b] = [unnamed(report), unnamed(again)];
  const differences = [...all].filter((field) => canonical(a[field]) !== canonical(b[field]));
  return { valid: differences.length === 0, differences, report: again };
}

/** The options with which the report is made again. */
export function optionsOf(report: unknown): { quote: Quote; reading: LoadOptions } {
  const quote = checkReport(report, 'report', PLANNED);
  return { quote, reading: readingOf(quote) };
}

/** JSON with sorted names: the order of fields says nothing. */
function canonical(value: unknown): string {
  return JSON.stringify(value, (_, inner: unknown) =>
    typeof inner === 'object' && inner !== null && !Array.isArray(inner) ? Object.fromEntries(Object.entries(inner).sort(([a], [b]) => (a < b ? -1 : 1))) : inner,
  ) ?? '';
}

function record(value: unknown, field: string): Record<string, unknown> {
  if (isRecord(value)) return value;
  throw new KerfwayError('not-a-quote', `The report lacks the field "${field}".`, { field });
}

function given(value: unknown, field: string): Record<string, never> {
  return Object.fromEntries(Object.entries(record(value, field)).filter(([, inner]) => inner !== null)) as Record<string, never>;
}

function json(text: unknown): NonNullable<PlanningOptions['parameters']> {
  try {
    return record(JSON.parse(String(text)), 'parameters');
  } catch {
    throw new KerfwayError('not-a-quote', 'The report\'s field "parameters" is not JSON.', { field: 'parameters' });
  }
}
