/**
 * How the job time fell during the search: seconds of the job over seconds of search. The axis of the search is logarithmic, because most is
 * gained at the beginning. Horizontal lines: drawing order, nearest first and, once it is known, the lower bound.
 */

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { colorOf } from '../core/color.js';
import { h, setText } from '../core/dom.js';
import { LONG, seconds, upTo } from '../core/format.js';
import type { Session } from '../session/session.js';
import { longestTime, type State } from '../session/state.js';
import type { Theme } from '../core/theme.js';
import { words } from '../core/words/index.js';

/** Where the axis begins, s: the first plan is ready within milliseconds, and a logarithmic axis cannot begin at zero. */
const FIRST = 0.01;
/** A search that ends before, s, has no course that could be shown. */
const BRIEF = 0.1;
/** Milliseconds between two redraws. */
const PAUSE = 250;
const HEIGHT = 136;
/** Steps between the marks of job times, s: what people count time in. */
const STEPS = [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800, 3600, 7200, 14_400, 36_000, 72_000, 180_000, 360_000, 720_000];
/** The drawing order is shown unless it is farther from the best path than this multiple of what the search has gained. */
const FAR = 8;

export function chart(session: Session, theme: Theme): HTMLElement {
  const holder = h('div', { class: 'chart', role: 'img', 'aria-label': words.result.chart });
  const off = h('span', { class: 'number' });
  const caption = h('figcaption', { class: 'soft' }, h('span', {}, words.result.chartAxis), off);
  const root = h('figure', {}, caption, holder);
  const color = (name: string) => () => colorOf(name);
  const soft = color('ink-soft'), hair = color('line');
  const axis = { stroke: soft, font: '12px system-ui', grid: { stroke: hair, width: 1 }, ticks: { show: false }, gap: 4 };
  let plot: uPlot | null = null;
  let timer = 0;

  const make = () => new uPlot({
    width: holder.clientWidth || 308,
    height: HEIGHT,
    padding: [8, 16, 0, 0],
    legend: { show: false },
    cursor: { show: false },
    select: { show: false, left: 0, top: 0, width: 0, height: 0 },
    scales: { x: { time: false, distr: 3, range: (_u, _low, high) => [FIRST, Math.max(1, high)] }, y: { range: (_u, low, high) => pad(low, high) } },
    axes: [
      { ...axis, size: 22, space: 40, filter: decades, grid: { ...axis.grid, filter: decades }, values: (_u, splits) => splits.map((s) => (s === null ? '' : `${upTo(s, 3)} s`)) },
      { ...axis, size: (_u, marks) => Math.max(52, 6.5 * Math.max(...(marks ?? []).map((mark) => mark.length), 0) + 6), space: 24, incrs: STEPS, values: (_u, splits) => splits.map((s) => (longestTime(session.state) < LONG ? `${upTo(s, 2)} s` : seconds(s, LONG))) },
    ],
    series: [
      {},
      { stroke: color('accent'), width: 2, paths: uPlot.paths.stepped!({ align: 1 }), points: { show: false } },
      { stroke: soft, width: 1, dash: [6, 4], points: { show: false } },
      { stroke: soft, width: 1, dash: [2, 3], points: { show: false } },
      { stroke: soft, width: 1, points: { show: false } },
    ],
  }, [[], [], [], [], []], holder);

  const draw = () => {
    timer = 0;
    root.hidden = session.state.phase === 'done' && hasNoCourse(session.state);
    if (holder.clientWidth === 0) return;
    plot ??= make();
    if (plot.width !== holder.clientWidth) plot.setSize({ width: holder.clientWidth, height: HEIGHT });
    const { data, above } = dataOf(session.state);
    plot.setData(data);
    setText(off, above === null ? '' : words.result.chartAbove(seconds(above, longestTime(session.state))));
    holder.setAttribute('aria-label', describe(session.state));
  };
  const soon = () => {
    if (!timer) timer = window.setTimeout(draw, PAUSE);
  };
  session.store.on('progress', soon);
  session.store.on('change', soon);
  theme.on('change', () => plot?.redraw(false));
  new ResizeObserver(soon).observe(holder);
  return root;
}

/** Whether a finished search is not worth a chart: it ended at once, or by itself with the path that it began with. */
function hasNoCourse({ curve: { at, total }, reason }: State): boolean {
  return (at.at(-1) ?? 0) < BRIEF || (reason === 'exhausted' && total[0] === total.at(-1));
}

/** The curve and its horizontal lines. `above`: the job time of the drawing order, where it is too far away to be shown. */
function dataOf({ curve, baselines, progress }: State): { data: uPlot.AlignedData; above: number | null } {
  const at = curve.at.map((s) => Math.max(FIRST, s));
  const flat = (value: number | undefined) => at.map(() => value ?? null);
  const greedy = baselines?.greedy.total_time, drawing = baselines?.drawing.total_time;
  const best = curve.total.at(-1) ?? 0;
  const gained = Math.max(greedy ?? 0, curve.total[0] ?? 0) - best;
  const far = drawing !== undefined && drawing - best > FAR * gained && gained > 0;
  const bound = progress?.summary.lower_bound || undefined;
  return { data: [at, [...curve.total], flat(far ? undefined : drawing), flat(greedy), flat(bound)], above: far ? drawing : null };
}

function pad(low: number | null, high: number | null): [number, number] {
  if (low === null || high === null) return [0, 1];
  const room = Math.max((high - low) * 0.12, high * 0.002, 1e-3);
  return [Math.max(0, low - room), high + room];
}

/** The marks of a logarithmic axis that are powers of ten. */
function decades(_plot: uPlot, splits: number[]): (number | null)[] {
  return splits.map((s) => (Math.abs(Math.log10(s) - Math.round(Math.log10(s))) < 1e-6 ? s : null));
}

function describe({ curve, baselines }: State): string {
  const first = curve.total[0], last = curve.total.at(-1);
  if (first === undefined || last === undefined) return words.result.chartNone;
  const order = baselines ? words.result.chartOrders(seconds(baselines.drawing.total_time), seconds(baselines.greedy.total_time)) : '';
  return words.result.chartWords(seconds(first), seconds(last), seconds(curve.at.at(-1) ?? 0)) + order;
}
