/**
 * What happens inside a method from a paper while it runs: its figures as small curves over its rounds, and its current table (for
 * example a Q-table).
 */

import { h, setText } from '../core/dom.js';
import { count } from '../core/format.js';
import type { Insights } from '../session/insights.js';
import type { Session } from '../session/session.js';
import { words } from '../core/words/index.js';

/** Width and height of a curve in the units of its own drawing, which is stretched to its place. */
const WIDE = 120, HIGH = 20;
/** Milliseconds between two redraws. */
const PAUSE = 250;

export function insightPanel(session: Session): HTMLElement {
  const round = h('span', { class: 'number' });
  const curves = h('table', { class: 'insight' }, h('caption', { class: 'hidden' }, words.plan.numbers));
  const grid = h('div', { class: 'insight-grid' });
  const partitions = h('p', { class: 'soft', hidden: true }, words.plan.partitions);
  const root = h('figure', { hidden: true }, h('figcaption', { class: 'soft' }, h('span', {}, words.plan.inside), round), curves, grid, partitions);
  let rows: Row[] = [];
  let timer = 0;

  const draw = () => {
    timer = 0;
    const { insights } = session.state;
    root.hidden = insights.now === null;
    if (insights.now === null) return;
    setText(round, words.plan.round(count(insights.now.round)));
    const names = insights.now.curves.map((c) => c.name);
    if (names.join() !== rows.map((r) => r.name).join()) {
      rows = names.map((name) => new Row(name));
      curves.replaceChildren(...rows.map((r) => r.root));
    }
    rows.forEach((row, k) => row.show(insights, k));
    grid.replaceChildren(...table(insights.now.grid));
    partitions.hidden = !insights.now.partitions?.parents.length;
  };
  const soon = () => {
    if (!timer) timer = window.setTimeout(draw, PAUSE);
  };
  session.store.on('progress', soon);
  session.store.on('change', soon);
  return root;
}

/** One figure: its name, its curve and its current value. */
class Row {
  readonly root: HTMLElement;
  private readonly value = h('td', { class: 'number' });
  private readonly line = document.createElementNS('http://www.w3.org/2000/svg', 'polyline');

  constructor(readonly name: string) {
    const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
    svg.setAttribute('viewBox', `0 -1 ${WIDE} ${HIGH + 2}`);
    svg.setAttribute('preserveAspectRatio', 'none');
    svg.setAttribute('aria-hidden', 'true');
    svg.append(this.line);
    this.root = h('tr', {}, h('th', { scope: 'row' }, name), h('td', {}, svg as unknown as HTMLElement), this.value);
  }

  show({ rounds, values, now }: Insights, k: number): void {
    const series = values.map((v) => v[k] ?? 0);
    const low = Math.min(...series), high = Math.max(...series);
    const first = rounds[0] ?? 0, span = Math.max((rounds.at(-1) ?? 0) - first, 1);
    const points = series.map((v, i) => {
      const x = (WIDE * (rounds[i]! - first)) / span;
      const y = high > low ? HIGH * (1 - (v - low) / (high - low)) : HIGH / 2;
      return `${x.toFixed(1)},${y.toFixed(1)}`;
    });
    this.line.setAttribute('points', points.join(' '));
    setText(this.value, short(now?.curves[k]?.value ?? 0));
  }
}

function table(grid: NonNullable<Insights['now']>['grid']): HTMLElement[] {
  if (grid === null) return [];
  const most = Math.max(...grid.values.map(Math.abs), 1e-12);
  const cell = (row: number, column: number) => {
    const at = row * grid.columns.length + column;
    const value = grid.values[at] ?? 0;
    const td = h('td', { class: at === grid.at ? 'number now' : 'number' }, short(value));
    td.style.setProperty('--share', `${((Math.abs(value) / most) * 100).toFixed(0)}%`);
    return td;
  };
  return [h('table', {}, h('caption', {}, grid.name),
    h('thead', {}, h('tr', {}, h('td'), ...grid.columns.map((c) => h('th', { scope: 'col' }, c)))),
    h('tbody', {}, ...grid.rows.map((name, row) => h('tr', {}, h('th', { scope: 'row' }, name), ...grid.columns.map((_, column) => cell(row, column))))))];
}

/** Three significant digits; from 1000 on a whole number. */
function short(value: number): string {
  if (Math.abs(value) >= 1000) return count(Math.round(value));
  return String(Number(value.toPrecision(3)));
}
