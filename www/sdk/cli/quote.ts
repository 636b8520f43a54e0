/** `kerfway quote`: reports what a price depends on. */

import type { Material, Quote } from '../quote.js';
import { quoteBudget } from '../quote-budget.js';
import { parsed, positive, text, type Words } from './arguments.js';
import { outputsOf } from './destinations.js';
import { usable } from './io.js';
import { planFiles } from './planning.js';
import type { Column } from './report.js';
import { STANDARD_OUTPUT } from './target.js';
import { area, duration, grams, meters, millimetres, plural } from './words.js';

export async function quote(args: string[]): Promise<void> {
  const given = parsed('quote', args);
  const material = materialOf(given);
  const outputs = outputsOf(given, ['json']);
  await planFiles(given, { outputs, columns: COLUMNS, defaultBudget: quoteBudget }, async ({ file, place, planner }, to) => {
    const quoted = await usable(file, planner.quote(material));
    await to.write(file, outputs.map((output) => {
      // Several documents on standard output have one line each.
      const indent = place.of > 1 && output.out === STANDARD_OUTPUT ? 0 : 2;
      return { output, data: `${JSON.stringify(quoted, null, indent)}\n` };
    }));
    await to.report(place, () => lines(quoted), () => row(file, quoted));
  });
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
  return material;
}

function lines(q: Quote): string[] {
  const { times: t, bounds: [x0, y0, x1, y1] } = q;
  const against = (ratio: number | null) => (ratio === null ? '' : ` (${ratio.toFixed(2)} of the thickness)`);
  const weight = q.weight === null ? '' : `, ${grams(q.weight)}`;
  const text = [
    `${q.input.name}: ${plural(q.part_count, 'part')}, ${q.parts.length} different${weight}`,
    `Job        ${duration(t.total)}: cut ${duration(t.cut)}, air ${duration(t.air)}, pierce ${duration(t.pierce)} (${q.pierces})`,
    `Size       ${(x1 - x0).toFixed(1)} x ${(y1 - y0).toFixed(1)} mm, ${area(q.box_area)}; parts ${area(q.net_area)}`,
    ...q.layers.map((l) => `Layer      ${l.layer}: ${l.operation} ${meters(l.length)}, ${plural(l.contours, 'contour')}${l.open > 0 ? `, ${l.open} open` : ''}`),
    ...q.parts.map((p) => `Part       ${p.count} x ${area(p.net_area)}, ${meters(p.cut_length)} to cut, ${plural(p.holes, 'hole')}`),
  ];
  if (q.smallest_hole !== null) text.push(`Narrowest  hole ${millimetres(q.smallest_hole.width)}${against(q.smallest_hole.over_thickness)}`);
  if (q.narrowest_web !== null) text.push(`           web ${millimetres(q.narrowest_web.width)}${against(q.narrowest_web.over_thickness)}`);
  text.push(`Confidence ${q.confidence.level}`, ...q.confidence.reasons.map((r) => `           ${r}`), `Hash       ${q.hash}`);
  return text;
}
