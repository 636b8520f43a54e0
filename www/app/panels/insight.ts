/**
 * What happens inside a method from a paper while it runs: charts of its values by round, as in the paper's figures, and its current table
 * (for example a Q-table).
 */

import { h, setText } from '../core/dom.js';
import { count } from '../core/format.js';
import type { Theme } from '../core/theme.js';
import type { Insights } from '../session/insights.js';
import type { Session } from '../session/session.js';
import { words } from '../core/words/index.js';
import { InsightChart, short, titles } from './insight-chart.js';

/** Milliseconds between two redraws. */
const PAUSE = 250;

export function insightPanel(session: Session, theme: Theme): HTMLElement {
  const round = h('span', { class: 'number' });
  const holder = h('div', { class: 'insights' });
  const grid = h('div', { class: 'insight-grid' });
  const partitions = h('p', { class: 'soft', hidden: true }, words.plan.partitions);
  const root = h('figure', { hidden: true }, h('figcaption', { class: 'soft' }, h('span', {}, words.plan.inside), round), holder, grid, partitions);
  let charts: InsightChart[] = [];
  let drawn = '';
  let timer = 0;

  const draw = () => {
    timer = 0;
    const { insights } = session.state;
    const { now } = insights;
    root.hidden = now === null;
    if (now === null) return;
    setText(round, words.plan.round(count(now.round)));
    const names = now.curves.map((c) => c.name).join();
    if (names !== drawn) {
      drawn = names;
      charts = titles(now.curves).map((title) => new InsightChart(title, now.curves));
      holder.replaceChildren(...charts.map((c) => c.root));
    }
    charts.forEach((c) => c.show(insights));
    grid.replaceChildren(...table(now.grid));
    partitions.hidden = !now.partitions?.parents.length;
  };
  const soon = () => {
    if (!timer) timer = window.setTimeout(draw, PAUSE);
  };
  session.store.on('progress', soon);
  session.store.on('change', soon);
  theme.on('change', () => charts.forEach((c) => c.redraw()));
  new ResizeObserver(soon).observe(holder);
  draw();
  return root;
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
