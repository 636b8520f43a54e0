/** Several quotes together, and one in several quantities: seconds, weight, and an estimate of the sheets. No prices. */

import { check, checkOne, isRecord, optional, type Range, type Shape } from './check.js';
import { KerfwayError } from './errors.js';
import type { Quote } from './quote.js';
import { ADDED, checkReport } from './read-report.js';
import { sheetsFor, type SheetEstimate, type Stock } from './sheets.js';

/** A drawing of a basket: its report, and how many times it is ordered. */
export interface BasketItem {
  report: Quote;
  /** Number of copies of the drawing. Default 1. */
  quantity?: number;
}

/** What a basket or a price break is computed with. */
export interface BasketOptions {
  /** The sheets in stock. Without it there is no estimate of sheets. */
  stock?: Stock;
}

/** A line of a basket. */
export interface BasketLine {
  /** Name and hash of the drawing's report. */
  name: string;
  hash: string;
  quantity: number;
  /** Number of parts of all copies. */
  part_count: number;
  /** Seconds of all copies. */
  times: Quote['times'];
  /** Weight of all copies, g. */
  weight: number | null;
}

/** Several drawings together (`kerfway.basket/1`). Times in s, areas in mm2, weights in g. */
export interface BasketReport {
  schema: 'kerfway.basket/1';
  items: BasketLine[];
  part_count: number;
  times: Quote['times'];
  net_area: number;
  /** The weight of everything, if that of every drawing is known. */
  weight: number | null;
  /** The sheets that all parts need together; `null` without a stock. */
  sheets: SheetEstimate | null;
}

/** One quantity of a drawing. */
export interface PriceBreak extends BasketLine {
  sheets: SheetEstimate | null;
}

const LENGTH: Range = { least: 1, most: 1e5, or_zero: false, unit: 'mm', why: 'sheets are made in millimetres to tens of metres' };
const EDGE: Range = { least: 0, most: 1000, or_zero: false, unit: 'mm', why: 'a wider one would leave no sheet' };
const STOCK: Shape = {
  owner: 'The stock', item: 'field', value: "The stock's field",
  fields: [
    { ...optional('width', { number: LENGTH }), required: true }, { ...optional('height', { number: LENGTH }), required: true },
    optional('gap', { number: EDGE }), optional('margin', { number: EDGE }),
  ],
};
/** The stock is checked by its own table, whose sentences name it. */
const OPTIONS: Shape = { owner: 'A basket', item: 'option', value: 'The option', fields: [optional('stock', 'any')] };
/** What an item may have; report and quantity are checked by their own rules. */
const ITEMS: Shape = { owner: 'A basket', item: 'field', value: 'The field', fields: [optional('items', { list: { object: [optional('report', 'any'), optional('quantity', 'any')] } })] };
const COUNT: Range = { least: 1, most: 1e6, or_zero: false, unit: '', why: 'it is a number of copies' };

/** Throws a `KerfwayError` unless this is a number of copies. */
export function checkQuantity(field: string, quantity: unknown): number {
  checkOne('The quantity', field, { whole: COUNT }, quantity);
  return quantity as number;
}

/** The sheets in stock of the options, checked. */
function stockOf(options: BasketOptions): Stock | undefined {
  check(OPTIONS, options);
  if (options.stock !== undefined) checkStock(options.stock);
  return options.stock;
}

/** Throws a `KerfwayError` unless these are sheets. */
export function checkStock(stock: unknown): void {
  check(STOCK, stock);
}

/** Adds up several reports, each multiplied by its quantity. Every figure comes from the reports; only the number of sheets is estimated. */
export function basket(items: readonly BasketItem[], options: BasketOptions = {}): BasketReport {
  const stock = stockOf(options);
  checkOne('The field', 'items', { list: 'any' }, items);
  items.forEach((item: unknown, k) => {
    if (!isRecord(item)) throw new KerfwayError('wrong-type', `The field "items[${k}]" is no object. Give an object with a report and a quantity.`, { field: `items[${k}]` });
  });
  // A misspelt quantity would price a single copy.
  check(ITEMS, { items });
  const lines = items.map(({ report, quantity = 1 }, k) => lineOf(checkReport(report, `items[${k}].report`, ADDED), checkQuantity(`items[${k}].quantity`, quantity)));
  const weights = lines.map((l) => l.weight);
  return {
    schema: 'kerfway.basket/1',
    items: lines,
    part_count: sum(lines, (l) => l.part_count),
    times: lines.reduce((total, l) => added(total, l.times), NO_TIMES),
    net_area: items.reduce((total, { report, quantity = 1 }) => total + report.net_area * quantity, 0),
    weight: weights.includes(null) ? null : sum(weights, (w) => w ?? 0),
    sheets: stock === undefined ? null : sheetsFor(items.flatMap(({ report, quantity = 1 }) => boxesOf(report, quantity)), stock),
  };
}

/** Seconds, weight and sheets of several quantities of one drawing, for prices that fall with the quantity. */
export function priceBreaks(report: Quote, quantities: readonly number[], options: BasketOptions = {}): PriceBreak[] {
  const stock = stockOf(options);
  checkReport(report, 'report', ADDED);
  checkOne('The field', 'quantities', { list: 'any' }, quantities);
  // A typed array would make another one of the objects.
  return Array.from(quantities, (quantity, k) => {
    const line = lineOf(report, checkQuantity(`quantities[${k}]`, quantity));
    return { ...line, sheets: stock === undefined ? null : sheetsFor(boxesOf(report, quantity), stock) };
  });
}

const NO_TIMES: Quote['times'] = { total: 0, cut: 0, air: 0, pierce: 0, pre_cut: 0, macros: 0 };

function lineOf(report: Quote, quantity: number): BasketLine {
  const times = Object.fromEntries(Object.entries(report.times).map(([kind, seconds]) => [kind, seconds * quantity])) as unknown as Quote['times'];
  return {
    name: report.input.name, hash: report.hash, quantity,
    part_count: report.part_count * quantity,
    times,
    weight: report.weight === null ? null : report.weight * quantity,
  };
}

function added(a: Quote['times'], b: Quote['times']): Quote['times'] {
  return Object.fromEntries(Object.entries(a).map(([kind, seconds]) => [kind, seconds + b[kind as keyof Quote['times']]])) as unknown as Quote['times'];
}

function boxesOf(report: Quote, quantity: number): { width: number; height: number; count: number }[] {
  return report.parts.flatMap((group) => group.items.map(({ bounds: [x0, y0, x1, y1] }) => ({ width: x1 - x0, height: y1 - y0, count: quantity })));
}

function sum<T>(list: readonly T[], of: (item: T) => number): number {
  return list.reduce((total, item) => total + of(item), 0);
}
