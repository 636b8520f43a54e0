/**
 * How the job's time fell while the search ran: seconds of the job over seconds of search, the latter on a logarithmic
 * axis because most is won at first. Level lines: drawing order, nearest first and, once known, the bound.
 */

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { h } from '../core/dom.js';
import { count, seconds } from '../core/format.js';
import type { Session } from '../session/session.js';
import type { State } from '../session/state.js';
import type { Theme } from '../core/theme.js';

/** The chart begins here, s: the first plan stands within milliseconds, and a logarithm needs a beginning. */
const FIRST = 0.01;
/** Milliseconds between two drawings. */
const PAUSE = 250;
const HEIGHT = 136;

export function chart(session: Session, theme: Theme): HTMLElement {
  const holder = h('div', { class: 'chart', role: 'img', 'aria-label': 'Job time over search time' });
  const color = (name: string) => () => getComputedStyle(holder).getPropertyValue(`--${name}`).trim();
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
    scales: { x: { time: false, distr: 3 }, y: { range: (_u, low, high) => pad(low, high) } },
    axes: [
      { ...axis, size: 22, space: 40, filter: decades, grid: { ...axis.grid, filter: decades }, values: (_u, splits) => splits.map((s) => (s === null ? '' : `${Number(s.toPrecision(3))} s`)) },
      { ...axis, size: 44, space: 32, values: (_u, splits) => splits.map((s) => (s < 1000 ? String(Math.round(s * 100) / 100) : count(s))) },
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
    if (holder.clientWidth === 0) return;
    plot ??= make();
    if (plot.width !== holder.clientWidth) plot.setSize({ width: holder.clientWidth, height: HEIGHT });
    plot.setData(dataOf(session.state));
    holder.setAttribute('aria-label', describe(session.state));
  };
  const soon = () => {
    if (!timer) timer = window.setTimeout(draw, PAUSE);
  };
  session.on('progress', soon);
  session.on('change', soon);
  theme.on('change', () => plot?.redraw(false));
  new ResizeObserver(soon).observe(holder);
  return h('figure', {}, h('figcaption', { class: 'soft' }, 'Job in seconds, over seconds of search'), holder);
}

function dataOf({ history, baselines, progress }: State): uPlot.AlignedData {
  const at = history.at.map((s) => Math.max(FIRST, s));
  const flat = (value: number | undefined) => at.map(() => value ?? null);
  const bound = progress?.summary.lower_bound || undefined;
  return [at, history.total, flat(baselines?.drawing.total_time), flat(baselines?.greedy.total_time), flat(bound)];
}

function pad(low: number | null, high: number | null): [number, number] {
  if (low === null || high === null) return [0, 1];
  const room = Math.max((high - low) * 0.12, high * 0.002, 1e-3);
  return [Math.max(0, low - room), high + room];
}

/** Of the marks of a logarithmic axis, those at powers of ten. */
function decades(_plot: uPlot, splits: number[]): (number | null)[] {
  return splits.map((s) => (Math.abs(Math.log10(s) - Math.round(Math.log10(s))) < 1e-6 ? s : null));
}

function describe({ history, baselines }: State): string {
  const first = history.total[0], last = history.total.at(-1);
  if (first === undefined || last === undefined) return 'Job time over search time: nothing yet.';
  const order = baselines ? ` Drawing order takes ${seconds(baselines.drawing.total_time)}, nearest first ${seconds(baselines.greedy.total_time)}.` : '';
  return `Job time over search time: from ${seconds(first)} to ${seconds(last)} in ${seconds(history.at.at(-1) ?? 0)}.${order}`;
}
