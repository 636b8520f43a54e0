/** One chart of a method from a paper: the curves that have one unit, by round, with a table of their current values as its legend. */

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import type { Insight } from 'kerfway';
import { colorOf } from '../core/color.js';
import { h, setText } from '../core/dom.js';
import { count, upTo } from '../core/format.js';
import type { Insights } from '../session/insights.js';
import { words } from '../core/words/index.js';

const HEIGHT = 104;
/** Rounds between two marks of the axis: whole numbers. */
const ROUNDS = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10_000, 100_000, 1_000_000];
/** Number of colours for curves in `styles/tokens.css`. */
const COLORS = 5;

const colorName = (k: number) => `series-${(k % COLORS) + 1}`;

export class InsightChart {
  readonly root: HTMLElement;
  private readonly holder: HTMLElement;
  private readonly values: HTMLElement[];
  private plot: uPlot | null = null;

  /** `title`: the curves with this chart; `curves`: all curves of the method. */
  constructor(private readonly title: string, curves: Insight['curves']) {
    const own = indices(title, curves);
    this.holder = h('div', { class: 'insight-chart', role: 'img', 'aria-label': title });
    this.values = own.map(() => h('td', { class: 'number' }));
    const row = (k: number, place: number) => {
      const swatch = h('span', { class: 'swatch', 'aria-hidden': 'true' });
      swatch.style.setProperty('--series', `var(--${colorName(place)})`);
      return h('tr', {}, h('th', { scope: 'row' }, swatch, curves[k]!.name), this.values[place]!);
    };
    this.root = h('figure', { class: 'insight' },
      h('figcaption', { class: 'soft' }, h('span', {}, title)), this.holder,
      h('table', {}, h('caption', { class: 'hidden' }, words.plan.numbers), ...own.map(row)));
  }

  show({ rounds, values, now }: Insights): void {
    if (now === null) return;
    const own = indices(this.title, now.curves);
    own.forEach((k, place) => setText(this.values[place]!, short(now.curves[k]!.value)));
    if (this.holder.clientWidth === 0) return;
    this.plot ??= this.make(own.length);
    if (this.plot.width !== this.holder.clientWidth) this.plot.setSize({ width: this.holder.clientWidth, height: HEIGHT });
    this.plot.setData([[...rounds], ...own.map((k) => values.map((v) => v[k] ?? null))]);
  }

  /** Draws in the colours of the theme. */
  redraw(): void {
    this.plot?.redraw(false);
  }

  private make(series: number): uPlot {
    const color = (name: string) => () => colorOf(name);
    const axis = { stroke: color('ink-soft'), font: '12px system-ui', grid: { stroke: color('line'), width: 1 }, ticks: { show: false }, gap: 4 };
    return new uPlot({
      width: this.holder.clientWidth,
      height: HEIGHT,
      padding: [8, 16, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      select: { show: false, left: 0, top: 0, width: 0, height: 0 },
      scales: { x: { time: false }, y: { range: (_u, low, high) => room(low, high) } },
      axes: [{ ...axis, size: 22, space: 60, incrs: ROUNDS }, { ...axis, size: 52, space: 26, values: (_u, splits) => splits.map(short) }],
      series: [{}, ...Array.from({ length: series }, (_, k) => ({ stroke: color(colorName(k)), width: 1.5, points: { show: false } }))],
    }, [[], ...Array.from({ length: series }, () => [])] as uPlot.AlignedData, this.holder);
  }
}

/** The titles of all charts in the order of their first curve. */
export const titles = (curves: Insight['curves']): string[] => [...new Set(curves.map((c) => c.chart))];

const indices = (title: string, curves: Insight['curves']): number[] => curves.flatMap((c, k) => (c.chart === title ? [k] : []));

/** Some room above and below, also where all values are one. */
function room(low: number | null, high: number | null): [number, number] {
  if (low === null || high === null) return [0, 1];
  const more = high > low ? (high - low) * 0.08 : Math.max(Math.abs(high) * 0.1, 0.1);
  return [low - more, high + more];
}

/** Three significant digits; from 1000 on a whole number. */
export function short(value: number): string {
  if (Math.abs(value) >= 1000) return count(Math.round(value));
  return upTo(Number(value.toPrecision(3)), 20);
}
