/** `kerfway quote`: what a shop asks of a job before it names a price. */

import type { Material, Quote } from '../quote.js';
import { positive, text, words, type Words } from './arguments.js';
import { put, usable } from './io.js';
import { planFile, PLANNING } from './planning.js';
import { duration, meters, plural } from './words.js';

const OPTIONS = {
  ...PLANNING,
  ...Object.fromEntries(['json', 'material', 'thickness', 'density'].map((o) => [o, { type: 'string' }])),
} as const;

export async function quote(args: string[]): Promise<void> {
  const given = words(args, OPTIONS);
  const material = materialOf(given);
  await planFile(given, async ({ planner }) => {
    const report = await usable(given.file, planner.quote(material));
    const json = text(given.values, 'json');
    if (json !== undefined) await put(json, `${JSON.stringify(report, null, 2)}\n`);
    if (json === '-') process.stderr.write(told(report));
    else await put('-', told(report));
  });
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

const millimetres = (mm: number) => `${mm.toFixed(2)} mm`;
const area = (mm2: number) => (mm2 < 1e4 ? `${mm2.toFixed(0)} mm²` : `${(mm2 / 1e6).toFixed(4)} m²`);

function told(q: Quote): string {
  const { times: t, bounds: [x0, y0, x1, y1] } = q;
  const against = (ratio: number | null) => (ratio === null ? '' : ` (${ratio.toFixed(2)} of the thickness)`);
  const weight = q.weight === null ? '' : `, ${q.weight < 1000 ? `${q.weight.toFixed(0)} g` : `${(q.weight / 1000).toFixed(2)} kg`}`;
  const lines = [
    `${q.input.name}: ${plural(q.part_count, 'part')}, ${q.parts.length} different${weight}`,
    `Job        ${duration(t.total)}: cut ${duration(t.cut)}, air ${duration(t.air)}, pierce ${duration(t.pierce)} (${q.pierces})`,
    `Size       ${(x1 - x0).toFixed(1)} x ${(y1 - y0).toFixed(1)} mm, ${area(q.box_area)}; parts ${area(q.net_area)}`,
    ...q.layers.map((l) => `Layer      ${l.layer}: ${l.operation} ${meters(l.length)}, ${plural(l.contours, 'contour')}${l.open > 0 ? `, ${l.open} open` : ''}`),
    ...q.parts.map((p) => `Part       ${p.count} x ${area(p.net_area)}, ${meters(p.cut_length)} to cut, ${plural(p.holes, 'hole')}`),
  ];
  if (q.smallest_hole !== null) lines.push(`Narrowest  hole ${millimetres(q.smallest_hole.width)}${against(q.smallest_hole.over_thickness)}`);
  if (q.narrowest_web !== null) lines.push(`           web ${millimetres(q.narrowest_web.width)}${against(q.narrowest_web.over_thickness)}`);
  lines.push(`Confidence ${q.confidence.level}${q.confidence.reasons.map((r) => `\n           ${r}`).join('')}`, `Hash       ${q.hash}`);
  return `${lines.join('\n')}\n`;
}
