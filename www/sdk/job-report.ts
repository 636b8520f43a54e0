/**
 * The report of a job: one HTML page that needs nothing else, for the operator who pins it beside the machine and for the archive.
 * It has the picture of the path, the times, the parts, the layers, the order and the findings.
 */

import { base64 } from './base64.js';
import { PROVEN } from './gap.js';
import { partThumbnail } from './thumbnail.js';
import type { Baselines, BestPath, Finding, Loaded, Summary } from './protocol.js';
import type { Quote } from './quote.js';

/** What a report is made of: what `plan` and `quote` return, and the plan's SVG. */
export interface ReportInput {
  loaded: Loaded;
  summary: Summary;
  baselines: Baselines;
  path: BestPath;
  quote: Quote;
  /** The plan as SVG. */
  svg: string;
  /** Findings of the plan; those of the drawing are in `loaded`. */
  findings?: readonly Finding[];
  /** When the report was made. Default: it does not say. */
  date?: Date;
}

/** Most rows of the order: more are hundreds of pages of paper. */
const MOST_ROWS = 500;

/** The report as HTML. */
export function jobReport(job: ReportInput): string {
  const { loaded, quote, summary: s } = job;
  const { machine, material } = quote;
  const title = `${loaded.name}, ${duration(s.total_time)}`;
  const facts: Fact[] = [
    ['Machine', machine.title],
    ['Material', [material.name, material.thickness == null ? null : `${number(material.thickness)} mm`].filter((word) => word != null).join(', ')],
    ['Size', `${number(quote.bounds[2] - quote.bounds[0])} × ${number(quote.bounds[3] - quote.bounds[1])} mm, read in ${quote.input.units} (${UNITS[quote.input.units_source]})`],
    ['Parts', `${quote.part_count}, ${quote.parts.length} different`],
    ['Weight', quote.weight === null ? '' : `${number(quote.weight / 1000)} kg`],
    ['Printed', job.date === undefined ? '' : job.date.toISOString().slice(0, 16).replace('T', ' ')],
  ];
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:">
<title>${escaped(title)}</title>
<style>${STYLE}</style>
</head>
<body>
<header><h1>${escaped(loaded.name)}</h1><p class="time">${duration(s.total_time)}</p></header>
${list(facts)}
<figure><img src="data:image/svg+xml;base64,${base64(new TextEncoder().encode(job.svg))}" alt="The path of the beam, with order and direction"></figure>
${section('Time', list(times(job)))}
${section('Layers', table(['Layer', 'Operation', 'Contours', 'Length'], quote.layers.map((l) => [l.layer, l.operation, l.contours, metres(l.length)])))}
${section('Parts', table(['', 'Count', 'Size', 'Area', 'To cut', 'Holes'], parts(job), [0]))}
${section('Findings', findings(job))}
${section('Cutting order', order(job))}
<footer>Kerfway ${escaped(quote.version)}, seed ${quote.seed}, ${quote.moves} moves. Drawing ${quote.input.sha256.slice(0, 16)}, quote ${quote.hash.slice(0, 16)}.</footer>
</body>
</html>
`;
}

type Fact = readonly [term: string, value: string];

const UNITS: Record<string, string> = { header: 'stated in the file', guessed: 'guessed', given: 'chosen' };

function times({ summary: s, baselines: { greedy, drawing } }: ReportInput): Fact[] {
  return [
    ['Job', duration(s.total_time)],
    ['Cutting', `${duration(s.cut_time)} for ${metres(s.cut_length)}`],
    ['Air moves', `${duration(s.air_time)} for ${metres(s.air_length)}`],
    ['Piercing', `${duration(s.pierce_time)} for ${s.pierces} piercings`],
    ['Pre-cuts', s.pre_cuts === 0 ? '' : `${duration(s.pre_cut_time)} for ${s.pre_cuts}`],
    ['Nearest first', `${duration(greedy.total_time)}; as drawn ${duration(drawing.total_time)}`],
    ['Left to gain', s.gap === null ? 'no bound yet' : s.gap <= PROVEN ? 'nothing: this path is optimal' : `at most ${duration(s.total_time - s.lower_bound)}`],
  ];
}

function parts({ quote, loaded }: ReportInput): Cell[][] {
  return quote.parts.map((part) => {
    const [first] = part.items;
    const [x0, y0, x1, y1] = first?.bounds ?? [0, 0, 0, 0];
    const known = loaded.parts.some((p) => p.outer === first?.id);
    return [first !== undefined && known ? partThumbnail(loaded, first.id, { size: 56 }) : '', part.count, `${number(x1 - x0)} × ${number(y1 - y0)} mm`, `${number(part.net_area / 100)} cm²`, metres(part.cut_length), part.holes];
  });
}

function findings({ loaded, findings: ofPlan = [] }: ReportInput): string {
  const all = [...loaded.findings, ...ofPlan];
  if (all.length === 0) return '<p>None.</p>';
  return `<ul>${all.map((f) => `<li class="${f.severity}"><b>${f.severity}</b> ${escaped(f.message)}${f.count > 1 ? ` (${f.count} times)` : ''}${f.at === null ? '' : ` <small>at ${number(f.at[0])}, ${number(f.at[1])}</small>`}</li>`).join('')}</ul>`;
}

function order({ path, loaded }: ReportInput): string {
  const rows = Array.from(path.contours.subarray(0, MOST_ROWS), (contour, k): Cell[] => [
    k + 1, contour + 1, loaded.contours[contour]?.layer ?? '', duration(path.times[2 * k] ?? 0), `${number(path.points[4 * k] ?? 0)}, ${number(path.points[4 * k + 1] ?? 0)}`,
  ]);
  const more = path.contours.length - rows.length;
  return table(['No.', 'Contour', 'Layer', 'Begins', 'Entry, mm'], rows) + (more > 0 ? `<p>And ${more} more.</p>` : '');
}

type Cell = string | number;

/** A table; the columns in `raw` hold HTML. Without rows it says that there are none. */
function table(head: readonly string[], rows: readonly Cell[][], raw: readonly number[] = []): string {
  if (rows.length === 0) return '<p>None.</p>';
  const cell = (value: Cell, k: number) => (raw.includes(k) ? String(value) : escaped(String(value)));
  return `<table><thead><tr>${head.map((h) => `<th>${escaped(h)}</th>`).join('')}</tr></thead><tbody>${rows.map((row) => `<tr>${row.map((v, k) => `<td>${cell(v, k)}</td>`).join('')}</tr>`).join('')}</tbody></table>`;
}

const list = (facts: readonly Fact[]) => `<dl>${facts.filter(([, value]) => value !== '').map(([term, value]) => `<div><dt>${escaped(term)}</dt><dd>${escaped(value)}</dd></div>`).join('')}</dl>`;

const section = (title: string, body: string) => `<section><h2>${title}</h2>${body}</section>`;

const ESCAPES: Record<string, string> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;' };
const escaped = (text: string) => text.replace(/[&<>"']/g, (c) => ESCAPES[c]!);

const number = (value: number) => String(Math.round(value * 100) / 100);
const metres = (mm: number) => `${(mm / 1000).toFixed(2)} m`;

/** "42.3 s", "16:40", "1:02:03". */
function duration(s: number): string {
  if (s < 99.95) return `${s.toFixed(1)} s`;
  const whole = Math.round(s);
  const two = (n: number) => String(n).padStart(2, '0');
  return whole < 3600 ? `${Math.floor(whole / 60)}:${two(whole % 60)} min` : `${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)} h`;
}

const STYLE = `
:root { color-scheme: light; font: 14px/1.45 system-ui, sans-serif; color: #1b1f24; }
body { max-width: 190mm; margin: 24px auto; padding: 0 16px; }
header { display: flex; justify-content: space-between; align-items: baseline; gap: 24px; border-bottom: 2px solid; }
h1 { font-size: 22px; margin: 0; overflow-wrap: anywhere; } h2 { font-size: 15px; margin: 20px 0 6px; }
.time { font-size: 22px; font-weight: 700; margin: 0; white-space: nowrap; }
dl { display: grid; grid-template-columns: repeat(auto-fill, minmax(240px, 1fr)); gap: 4px 24px; margin: 10px 0; }
dl div { display: flex; gap: 8px; } dt { color: #57606a; min-width: 90px; } dd { margin: 0; }
figure { margin: 12px 0; padding: 8px; border: 1px solid #d0d7de; } img { display: block; width: 100%; max-height: 150mm; object-fit: contain; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; } tr { break-inside: avoid; }
th { text-align: left; font-weight: 600; color: #57606a; } th, td { padding: 2px 12px 2px 0; border-bottom: 1px solid #eaeef2; vertical-align: middle; }
ul { padding-left: 18px; margin: 0; } .error b { color: #b3261e; } .warning b { color: #8a5a00; } .info b { color: #57606a; } small, footer { color: #57606a; }
footer { margin-top: 24px; font-size: 12px; }
@media print { body { margin: 0; max-width: none; padding: 0; } h2 { break-after: avoid; } }
`;
