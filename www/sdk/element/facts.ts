/** The rows of a quote that `<kerfway-quote>` shows. */

import { area, duration, grams, meters, millimetres, plural, size } from '../words.js';
import type { Quote } from '../quote.js';

export function facts(q: Quote): [string, string][] {
  const { times: t } = q;
  const against = (ratio: number | null) => (ratio === null ? '' : `, ${ratio.toFixed(2)} of the thickness`);
  const rows: [string, string | null][] = [
    ['Job', `${duration(t.total)}: cut ${duration(t.cut)}, air ${duration(t.air)}, pierce ${duration(t.pierce)}`],
    ['To cut', `${meters(q.cut_length)}, ${plural(q.pierces, 'piercing')}`],
    ['Parts', `${q.part_count}${q.parts.length < q.part_count ? `, ${q.parts.length} different` : ''}`],
    ['Size', size(q.bounds)],
    ['Area', `${area(q.net_area)} of ${area(q.box_area)}`],
    ['Weight', q.weight === null ? null : grams(q.weight)],
    ['Narrowest hole', q.smallest_hole === null ? null : millimetres(q.smallest_hole.width) + against(q.smallest_hole.over_thickness)],
    ['Narrowest web', q.narrowest_web === null ? null : millimetres(q.narrowest_web.width) + against(q.narrowest_web.over_thickness)],
    ['Confidence', [q.confidence.level, ...q.confidence.reasons.map((r) => r.message)].join('; ')],
  ];
  return rows.flatMap(([term, figure]) => (figure === null ? [] : [[term, figure] as [string, string]]));
}
