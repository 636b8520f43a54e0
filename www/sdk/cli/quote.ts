/** `kerfway quote`: reports what a price depends on. */

import { checkQuantity, checkStock, priceBreaks } from '../basket.js';
import { KerfwayError, reportOf } from '../errors.js';
import type { Planner, PlanResult } from '../node.js';
import { checkOptions } from '../options.js';
import type { Limits, Material, Quote, QuoteTerms } from '../quote.js';
import { quoteBudget } from '../quote-budget.js';
import type { Stock } from '../sheets.js';
import { number, parsed, positive, text, type Words } from './arguments.js';
import { checkedAsWritten } from './as-written.js';
import { outputsOf } from './destinations.js';
import { subject, textOf, Unusable, usable, WrongUse } from './io.js';
import { planFiles } from './planning.js';
import type { Column } from './report.js';
import { savingLines, savingsOf } from './savings.js';
import { STANDARD_OUTPUT } from './target.js';
import { area, duration, fixed, grams, meters, millimetres, plural, size, skeletonLines, unitOf } from '../words.js';

export async function quote(args: string[]): Promise<void> {
  const given = parsed('quote', args);
  const material = materialOf(given);
  const limits = await limitsOf(given);
  const order = orderOf(given);
  const outputs = outputsOf(given, ['json']);
  const inputs = [text(given.values, 'limits') ?? []].flat();
  await planFiles(given, { outputs, columns: COLUMNS, inputs, defaultBudget: quoteBudget }, async ({ file, place, planner, options, result }, to) => {
    const quoted = await usable(file, reported(planner, result, { material, ...limits }));
    const saved = given.values['savings'] === true ? await usable(file, savingsOf(planner, options, result)) : null;
    await to.write(file, outputs.map((output) => {
      // Several documents on standard output have one line each.
      const indent = place.of > 1 && output.out === STANDARD_OUTPUT ? 0 : 2;
      return { output, data: `${JSON.stringify(quoted, null, indent)}\n` };
    }));
    const asked = () => [...orderLines(quoted, order), ...savingLines(saved)];
    await to.report(place, () => [...lines(quoted), ...asked()], () => row(file, quoted), () => [...limitLines(quoted), ...asked()]);
  });
}

/** The report of the search. A worker that took the place of one that died has its path only, so nobody could make that report again. */
async function reported(planner: Planner, { reason }: PlanResult, terms: QuoteTerms): Promise<Quote> {
  if (reason === 'replaced') throw new KerfwayError('planner-died', `${planner.replaced} Quote this drawing again.`);
  return planner.quote(terms);
}

const COLUMNS: readonly Column[] = [
  { title: 'Parts', width: 5, right: true },
  { title: 'Job', width: 11, right: true },
  { title: 'To cut', width: 10, right: true },
  { title: 'Pierces', width: 7, right: true },
  { title: 'Net area', width: 10, right: true },
  { title: 'Weight', width: 8, right: true },
  { title: 'Confidence', width: 10 },
  { title: 'Hash', width: 12 },
];

/** The number of digits of a hash in the table, enough to compare reports; the report has all of them. */
const SHORT = 12;

function row(file: string, q: Quote): string[] {
  return [
    ...[file, String(q.part_count), duration(q.times.total), meters(q.cut_length), String(q.pierces), area(q.net_area)],
    ...[q.weight === null ? '' : grams(q.weight), q.confidence.level, q.hash.slice(0, SHORT)],
  ];
}

function materialOf({ values }: Words): Material {
  const material: Material = {};
  const name = text(values, 'material');
  const [thickness, density] = [positive(values, 'thickness'), positive(values, 'density')];
  if (name !== undefined) material.name = name;
  if (thickness !== undefined) material.thickness = thickness;
  if (density !== undefined) material.density = density;
  return checkedAsWritten(values, () => (checkOptions({ material }, 'terms'), material));
}

/** How many are ordered, and of which sheets they are cut. */
interface Order {
  quantities: number[];
  stock?: Stock;
}

function orderOf({ values }: Words): Order {
  const quantities = ((values['quantity'] as string[] | undefined) ?? []).map((word, k) => checkedAsWritten(values, () => checkQuantity(`quantity[${k}]`, Number(word)), { quantity: 'quantity' }));
  const [sheet, gap] = [text(values, 'sheet'), number(values, 'gap')];
  if (sheet === undefined) {
    if (gap !== undefined) throw new WrongUse('--gap is for sheets: give their size as well, --sheet 3000x1500.');
    return { quantities };
  }
  const [, width, height] = /^(\d+(?:\.\d+)?)x(\d+(?:\.\d+)?)$/i.exec(sheet) ?? [];
  if (width === undefined || height === undefined) throw new WrongUse(`--sheet ${sheet}: write the size in mm, for example 3000x1500.`);
  const stock: Stock = { width: Number(width), height: Number(height), ...(gap === undefined ? {} : { gap }) };
  checkedAsWritten(values, () => checkStock(stock));
  return { quantities: quantities.length > 0 ? quantities : [1], stock };
}

function orderLines(q: Quote, { quantities, stock }: Order): string[] {
  return priceBreaks(q, quantities, stock === undefined ? {} : { stock }).map(({ quantity, times, weight, sheets }) => {
    const needed = sheets === null || sheets.count === 0 ? '' : `, about ${plural(sheets.count, 'sheet')}`;
    const left = sheets === null || sheets.too_large === 0 ? '' : `, ${plural(sheets.too_large, 'part')} too large for a sheet`;
    return `${plural(quantity, 'copy').replace('copys', 'copies').padEnd(10)} ${duration(times.total)}${weight === null ? '' : `, ${grams(weight)}`}${needed}${left}`;
  });
}

/** What exceeds the limits of the shop. */
function limitLines({ checks }: Quote): string[] {
  return (checks?.exceeded ?? []).map(({ message, at }) => `Limit      ${message} At ${at.map((n) => n.toFixed(1)).join(', ')}.`);
}

/** The limits in the file that `--limits` names. */
async function limitsOf({ values }: Words): Promise<{ limits?: Limits }> {
  const file = text(values, 'limits');
  if (file === undefined) return {};
  const content = await textOf(file);
  try {
    const limits = JSON.parse(content) as Limits;
    checkOptions({ limits }, 'terms');
    return { limits };
  } catch (error) {
    throw new Unusable(error instanceof SyntaxError ? `${subject(file)} is not JSON: limits are an object like {"smallest_hole": 3}.` : `${subject(file)}: ${(error as Error).message}`, reportOf(error));
  }
}

function lines(q: Quote): string[] {
  const { times: t } = q;
  const against = (ratio: number | null) => (ratio === null ? '' : ` (${fixed(ratio, 2)} of the thickness)`);
  const weight = q.weight === null ? '' : `, ${grams(q.weight)}`;
  const text = [
    `${q.input.name}: ${plural(q.part_count, 'part')}, ${q.parts.length} different${weight}`,
    `Job        ${duration(t.total)}: cut ${duration(t.cut)}, air ${duration(t.air)}, pierce ${duration(t.pierce)} (${q.pierces})`,
    ...skeletonLines(q),
    `Size       ${size(q.bounds)}, ${area(q.box_area)}; parts ${area(q.net_area)}`,
    ...q.layers.map((l) => `Layer      ${l.layer}: ${l.operation} ${meters(l.length)}, ${plural(l.contours, 'contour')}${l.open > 0 ? `, ${l.open} open` : ''}`),
    ...q.parts.map((p) => `Part       ${p.count} x ${area(p.net_area)}, ${meters(p.cut_length)} to cut, ${plural(p.holes, 'hole')}`),
  ];
  if (q.smallest_hole !== null) text.push(`Narrowest  hole ${millimetres(q.smallest_hole.width)}${against(q.smallest_hole.over_thickness)}`);
  if (q.narrowest_web !== null) text.push(`           web ${millimetres(q.narrowest_web.width)}${against(q.narrowest_web.over_thickness)}`);
  if (q.input.units_doubt !== undefined) text.push(`Units      ${unitOf({ unit: q.input.units, dpi: q.input.dpi ?? null })}, in doubt: ${q.input.units_doubt}`);
  text.push(...limitLines(q), `Confidence ${q.confidence.level}`, ...q.confidence.reasons.map((r) => `           ${r.message}`), `Hash       ${q.hash}`);
  return text;
}
