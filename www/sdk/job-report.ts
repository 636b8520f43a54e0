/**
 * The report of a job: one HTML page that needs nothing else, for the operator who pins it beside the machine and for the archive.
 * It has the picture of the path, the times, the parts, the layers, the order and the findings.
 */

import { base64 } from './base64.js';
import { isList, isRecord, shown } from './check.js';
import { KerfwayError } from './errors.js';
import { PROVEN } from './gap.js';
import { partThumbnail } from './thumbnail.js';
import type { Baselines, Beam, BestPath, ContourInfo, Finding, Loaded, Summary } from './protocol.js';
import type { Quote } from './quote.js';
import { ENGLISH, type ReportText } from './report-text.js';

/** What a report is made of: what `plan` and `quote` return, and the plan's SVG. */
export interface ReportInput {
  loaded: Loaded;
  summary: Summary;
  baselines: Baselines;
  path: BestPath;
  quote: Quote;
  /** The plan as SVG. */
  svg: string;
  /** The contours that the numbers of the path refer to, if the plan has them: with passes sheet by sheet, a kerf width, and the like. */
  beam?: Beam | null;
  /** The placement of the plan: entries are named in the coordinates of the machine, as in the program. Default: those of the drawing. */
  shift?: [number, number];
  /** The program in G-code, whose checksum the report then has: that of the program in the machine must be the same. */
  program?: string | null;
  /** Findings of the plan; those of the drawing are in `loaded`. */
  findings?: readonly Finding[];
  /** When the report was made. Default: it does not say. */
  date?: Date;
  /** The language of the report, and how it writes numbers and lengths. Default: English, in millimetres. */
  text?: ReportText;
}

/** Most rows of the order: more are hundreds of pages of paper. */
const MOST_ROWS = 500;

/**
 * The report as HTML. Throws a `KerfwayError` unless the job has what it is made of. A plan that has been JSON serves as well.
 *
 *     const planned = await plan(bytes, { outputs: ['svg'] });
 *     const page = jobReport({ ...planned, quote: await quote(bytes), svg: planned.outputs.svg });
 */
export function jobReport(job: ReportInput): string {
  checkInput(job);
  const { loaded, quote, summary: s, text = ENGLISH } = job;
  const { words: w } = text;
  const { machine, material } = quote;
  const title = `${loaded.name}, ${text.duration(s.total_time)}`;
  const facts: Fact[] = [
    [w.machine, [machine.title, quote.setting, `${text.length(machine.cut.speed)}/s`].filter((word) => word != null).join(', ')],
    [w.kerf, machine.kerf_width ? text.length(machine.kerf_width) : ''],
    [w.material, [material.name, material.thickness == null ? null : text.length(material.thickness)].filter((word) => word != null).join(', ')],
    [w.size, w.readIn(text.size(quote.bounds[2] - quote.bounds[0], quote.bounds[3] - quote.bounds[1]), quote.input.units, quote.input.units_source)],
    [w.parts, w.different(quote.part_count, quote.parts.length)],
    [w.weight, quote.weight === null ? '' : `${text.number(quote.weight / 1000)} kg`],
    [w.printed, job.date === undefined ? '' : job.date.toISOString().slice(0, 16).replace('T', ' ')],
  ];
  return `<!doctype html>
<html lang="${text.lang}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:">
<title>${escaped(title)}</title>
<style>${STYLE}</style>
</head>
<body>
<header><h1>${escaped(loaded.name)}</h1><p class="time">${text.duration(s.total_time)}</p></header>
${list(facts)}
<figure><img src="data:image/svg+xml;base64,${base64(new TextEncoder().encode(job.svg))}" alt="${escaped(w.picture)}"></figure>
${section(w.time, list(times(job, text)))}
${section(w.layers, table(text, [w.layer, w.operation, w.contours, w.length], quote.layers.map((l) => [l.layer, w.operations[l.operation], l.contours, text.far(l.length)])), 'layers')}
${section(w.parts, table(text, ['', w.count, w.size, w.area, w.toCut, w.holes], parts(job, text), [0]), 'parts')}
${section(w.findings, findings(job, text))}
${section(w.order, order(job, text), 'order')}
<footer>${escaped(w.source(quote.version, quote.seed, quote.moves, quote.input.sha256.slice(0, 16), quote.hash.slice(0, 16)))} ${checksum(job.program)}</footer>
</body>
</html>
`;
}

/** Throws a `KerfwayError` that names the first field which is not what a report is made of. */
function checkInput(job: Partial<ReportInput> | null): void {
  const { loaded, summary, baselines, path, quote, svg, program, beam, shift = [0, 0], findings = [], date = new Date(0) } = job ?? {};
  const fits: Partial<Record<keyof ReportInput, boolean>> = {
    loaded: isList(loaded?.contours) && isList(loaded.parts) && isList(loaded.findings) && isRecord(loaded.geometry),
    summary: typeof summary?.total_time === 'number',
    baselines: isRecord(baselines?.greedy) && isRecord(baselines.drawing),
    path: isList(path?.contours) && isList(path.points) && isList(path.times),
    quote: quote?.schema === 'kerfway.quote/2',
    svg: typeof svg === 'string',
    program: program == null || typeof program === 'string',
    beam: beam == null || isList(beam.contours),
    shift: isList(shift) && shift.length === 2 && shift.every(Number.isFinite),
    findings: isList(findings),
    date: date instanceof Date && !Number.isNaN(date.getTime()),
  };
  const wrong = Object.entries(fits).find(([, fit]) => !fit)?.[0];
  if (wrong === undefined) return;
  const given = shown((job as Record<string, unknown> | null)?.[wrong]);
  throw new KerfwayError('wrong-type', `The field "${wrong}" of the report is ${given}. Give what plan and quote return, the plan as SVG, and a valid date.`, { field: wrong });
}

/** The last line of its kind in a program, word for word; dialects may have none. */
function checksum(program: string | null | undefined): string {
  return program?.match(/checksum [0-9a-f]{16}/g)?.at(-1) ?? '';
}

type Fact = readonly [term: string, value: string];

function times({ summary: s, baselines: { greedy, drawing } }: ReportInput, { words: w, duration, far }: ReportText): Fact[] {
  return [
    [w.job, duration(s.total_time)],
    [w.cutting, w.along(duration(s.cut_time), far(s.cut_length))],
    [w.air, w.along(duration(s.air_time), far(s.air_length))],
    [w.piercing, w.pierced(duration(s.pierce_time), s.pierces)],
    [w.preCuts, s.pre_cuts === 0 ? '' : w.along(duration(s.pre_cut_time), String(s.pre_cuts))],
    [w.nearest, w.asDrawn(duration(greedy.total_time), duration(drawing.total_time))],
    [w.gap, s.gap === null ? w.noBound : s.gap <= PROVEN ? w.nothing : w.atMost(duration(s.total_time - s.lower_bound))],
  ];
}

function parts({ quote, loaded }: ReportInput, text: ReportText): Cell[][] {
  return quote.parts.map((part) => {
    const [first] = part.items;
    const [x0, y0, x1, y1] = first?.bounds ?? [0, 0, 0, 0];
    const known = loaded.parts.some((p) => p.outer === first?.id);
    return [first !== undefined && known ? partThumbnail(loaded, first.id, { size: 56 }) : '', part.count, text.size(x1 - x0, y1 - y0), text.area(part.net_area), text.far(part.cut_length), part.holes];
  });
}

function findings({ loaded, findings: ofPlan = [] }: ReportInput, { words: w, number, finding }: ReportText): string {
  const all = [...loaded.findings, ...ofPlan];
  if (all.length === 0) return `<p>${escaped(w.none)}</p>`;
  const place = (at: readonly [number, number]) => ` <small>${escaped(w.at(number(at[0]), number(at[1])))}</small>`;
  return `<ul>${all.map((f) => `<li class="${escaped(f.severity)}"><b>${escaped(w.severities[f.severity] ?? f.severity)}</b> ${escaped(finding(f))}${f.count > 1 ? ` (${escaped(w.times(f.count))})` : ''}${f.at === null ? '' : place(f.at)}</li>`).join('')}</ul>`;
}

/** Contours have the numbers of programs and options, which begin with 0; with several passes, also which one it is, or how many follow each other. */
function order({ path, loaded, quote, beam, shift: [dx, dy] = [0, 0] }: ReportInput, text: ReportText): string {
  const { words: w, duration, number } = text;
  const all = beam?.contours ?? loaded.contours;
  const rows = Array.from(path.contours.slice(0, MOST_ROWS), (id, k): Cell[] => {
    let contour = all[id];
    let later = 0;
    // Sheet by sheet, each pass but the last is a contour of its own: it comes after all others, inside the next pass of the same line.
    while (contour && contour.id >= loaded.contours.length) {
      const next: ContourInfo | undefined = all[contour.inside!];
      if (next?.area !== contour.area || next.length !== contour.length) break;
      contour = next;
      later += 1;
    }
    const passes = loaded.layers.find((l) => l.name === contour?.layer)?.settings?.passes ?? quote.machine[contour?.operation === 'mark' ? 'mark' : 'cut'].passes ?? 1;
    const which = passes > 1 ? ` (${quote.options['pass_order'] === 'sheet' ? `${passes - later}/${passes}` : w.times(passes)})` : '';
    const [x = 0, y = 0] = [path.points[4 * k], path.points[4 * k + 1]];
    return [k + 1, (contour?.id ?? id) + which, contour?.layer ?? '', duration(path.times[2 * k] ?? 0), `${number(x + dx)}, ${number(y + dy)}`];
  });
  const more = path.contours.length - rows.length;
  return table(text, [w.no, w.contour, w.layer, w.begins, w.entry], rows) + (more > 0 ? `<p>${escaped(w.more(more))}</p>` : '');
}

type Cell = string | number;

/** A table; the columns in `raw` hold HTML. Without rows it says that there are none. */
function table({ words: w }: ReportText, head: readonly string[], rows: readonly Cell[][], raw: readonly number[] = []): string {
  if (rows.length === 0) return `<p>${escaped(w.none)}</p>`;
  const cell = (value: Cell, k: number) => (raw.includes(k) ? String(value) : escaped(String(value)));
  return `<table><thead><tr>${head.map((h) => `<th>${escaped(h)}</th>`).join('')}</tr></thead><tbody>${rows.map((row) => `<tr>${row.map((v, k) => `<td>${cell(v, k)}</td>`).join('')}</tr>`).join('')}</tbody></table>`;
}

const list = (facts: readonly Fact[]) => `<dl>${facts.filter(([, value]) => value !== '').map(([term, value]) => `<div><dt>${escaped(term)}</dt><dd>${escaped(value)}</dd></div>`).join('')}</dl>`;

/** `name`: which columns are figures, in the style below. */
const section = (title: string, body: string, name = '') => `<section><h2>${escaped(title)}</h2><div class="${name}">${body}</div></section>`;

const ESCAPES: Record<string, string> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;', "'": '&#39;' };
const escaped = (text: string) => text.replace(/[&<>"']/g, (c) => ESCAPES[c]!);

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
th { text-align: left; font-weight: 600; color: #57606a; } th, td { padding: 2px 0 2px 16px; border-bottom: 1px solid #eaeef2; vertical-align: middle; } tr > :first-child { padding-left: 0; }
.layers tr > :nth-child(n + 3), .parts tr > :nth-child(n + 2), .order tr > :not(:nth-child(3)) { text-align: right; white-space: nowrap; } section div { overflow-x: auto; }
ul { padding-left: 18px; margin: 0; } .error b { color: #b3261e; } .warning b { color: #8a5a00; } .info b { color: #57606a; } small, footer { color: #57606a; }
footer { margin-top: 24px; font-size: 12px; }
@media print { body { margin: 0; max-width: none; padding: 0; } h2 { break-after: avoid; } section div { overflow: visible; } .order { columns: 2; column-gap: 32px; font-size: 11px; } .order tr > * + * { padding-left: 8px; } }
`;
