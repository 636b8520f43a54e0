/** The result: the seconds saved, the orders compared, the chart, what the job time consists of, downloads. */

import { button, disable, h, setText } from '../core/dom.js';
import { betweenFacts, count, metres, millimetres, percent, seconds, unbroken } from '../core/format.js';
import { type OutputKind, PROVEN, type Summary } from 'kerfway';
import type { Alternatives } from '../session/alternatives.js';
import { isRefusedOffBed } from '../session/off-bed.js';
import type { Session } from '../session/session.js';
import { longestTime, type State } from '../session/state.js';
import { messageOf } from '../core/strings.js';
import type { Theme } from '../core/theme.js';
import { chart } from './chart.js';
import { preflight } from './preflight.js';
import { laterDetails, section } from './section.js';
import { words } from '../core/words/index.js';

const ROWS = [
  { key: 'drawing', label: words.result.drawing, line: 'dashed' },
  { key: 'greedy', label: words.result.greedy, line: 'dotted' },
  { key: 'now', label: words.result.now, line: 'solid' },
] as const;

/** s */
const MINUTE = 60;

const DOWNLOADS: readonly OutputKind[] = ['gcode', 'dxf', 'svg', 'png', 'json', 'lbrn2', 'rd', 'remainder'];

export interface ResultActions {
  download(kind: OutputKind): void;
  saveProject(): void;
  saveReport(): void;
  copyProgram(): void;
}

export function resultPanel(session: Session, theme: Theme, { download, saveProject, saveReport, copyProgram }: ResultActions, alternatives: () => Promise<Alternatives>): HTMLElement {
  const { root, body } = section(words.result.title, true);
  const saved = h('p', { class: 'large' });
  const of = h('p', { class: 'soft number' });
  const rows = ROWS.map(({ label, line }) => new Row(label, line));
  const table = h('table', { class: 'compare' },
    h('caption', { class: 'hidden' }, words.result.compare),
    h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, words.result.order), ...[[words.result.job, ''], [words.result.air, 'air'], [words.result.travel, '']].map(([t, key]) => h('th', { scope: 'col', class: `number ${key}` }, t!)))),
    ...rows.map((r) => r.root));
  const parts = h('dl', { class: 'parts' });
  const buttons = DOWNLOADS.map((kind) => button(words.result.kinds[kind], { class: 'small', title: words.result.downloadKind(words.result.kinds[kind]), onclick: () => download(kind) }));
  const copy = button(words.result.copy, { class: 'small', title: words.result.copyHint, onclick: copyProgram });
  const files = h('div', { class: 'downloads', role: 'group', 'aria-label': words.result.download },
    ...buttons.slice(0, 1), copy, ...buttons.slice(1), button(words.result.report, { class: 'small', title: words.result.reportHint, onclick: saveReport }), button(words.result.project, { class: 'small', title: words.result.projectHint, onclick: saveProject }));
  const check = preflight(session, (why) => {
    DOWNLOADS.forEach((kind, i) => disable(buttons[i]!, kind === 'gcode' ? why : isRefusedOffBed(session.state, kind) ? words.dock.offBed : ''));
    disable(copy, why);
    session.store.programChecked(why === '');
  });
  const insights = h('div', { hidden: true });
  const stopWaiting = session.store.on('progress', () => {
    if (session.state.insights.now === null) return;
    stopWaiting();
    // Only methods from papers have insights.
    import('./insight.js').then(({ insightPanel }) => insights.replaceWith(insightPanel(session, theme)), (error) => session.store.notify(messageOf(error)));
  });
  const savings = laterDetails(words.savings.title, async () => (await import('./savings.js')).savingsPanel(session, alternatives), (sentence) => session.store.notify(sentence));
  const content = h('div', { class: 'stack' }, h('div', {}, saved, of), table, chart(session, theme), insights, parts, savings, files, check);
  const empty = h('p', { class: 'soft' }, words.result.none);
  body.append(empty, content);

  let timer = 0;
  const draw = () => {
    clearTimeout(timer);
    timer = 0;
    const { state } = session;
    empty.hidden = state.progress !== null;
    content.hidden = state.progress === null;
    if (state.progress) show(state, state.progress.summary);
  };
  const show = (state: State, now: Summary) => {
    const before = state.baselines?.drawing;
    const usual = state.baselines?.greedy;
    if (before && usual) {
      // Compared with what a shop would cut otherwise. Nobody would cut in the order of the drawing, which saves more on paper.
      const gain = usual.total_time - now.total_time;
      const more = before.total_time - now.total_time;
      const none = seconds(Math.abs(gain)) === seconds(0);
      setText(saved, none ? words.result.nothing(state.phase !== 'done') : gain > 0 ? words.result.saved(seconds(gain)) : words.result.longer(seconds(-gain)));
      // A long difference looks like the times that it is the difference of.
      const apart = seconds(Math.abs(more), Math.abs(more) < MINUTE ? 0 : before.total_time);
      const order = apart === seconds(0) ? words.result.same : more > 0 ? words.result.less(apart) : words.result.more(apart);
      setText(of, unbroken(none ? words.result.asLong(order) : words.result.of(percent(Math.abs(gain) / usual.total_time), order)));
    }
    const longest = longestTime(state);
    rows[0]!.show(before, longest);
    rows[1]!.show(state.baselines?.greedy, longest);
    rows[2]!.show(now, longest);
    showParts(parts, now, longest);
  };
  const soon = () => {
    // Nobody reads numbers that change more than ten times a second.
    if (!timer) timer = window.setTimeout(draw, 100);
  };
  session.store.on('progress', soon);
  // The last numbers are there as soon as the plan is said to be done.
  session.store.on('change', () => (session.state.phase === 'done' ? draw() : soon()));
  draw();
  return root;
}

/** One cutting order: its figures, and a bar that shows what the time is spent on. */
class Row {
  readonly root: HTMLElement;
  private readonly cells = [h('td', { class: 'number' }), h('td', { class: 'number' }), h('td', { class: 'number' })];
  private readonly bar = h('td', { colspan: 4, class: 'bar' }, h('span', { class: 'cut' }), h('span', { class: 'pierce' }), h('span', { class: 'air' }));

  constructor(label: string, line: string) {
    this.root = h('tbody', { class: line },
      h('tr', {}, h('th', { scope: 'row' }, h('span', { class: `line ${line}`, 'aria-hidden': 'true' }), label), ...this.cells),
      h('tr', { 'aria-hidden': 'true' }, this.bar));
  }

  show(summary: Summary | undefined, longest: number): void {
    this.root.hidden = summary === undefined;
    if (!summary) return;
    [seconds(summary.total_time, longest), seconds(summary.air_time, longest), metres(summary.air_length)].forEach((text, i) => setText(this.cells[i]!, text));
    const shares = [summary.cut_time + summary.macro_time, summary.pierce_time + summary.pre_cut_time, summary.air_time];
    [...this.bar.children].forEach((span, i) => (span as HTMLElement).style.setProperty('width', `${(100 * shares[i]!) / longest}%`));
  }
}

/** How much a better plan could save at most, in seconds of the machine. */
function leftToGain({ gap, total_time, lower_bound }: Summary): string {
  if (gap === null) return words.result.noBound;
  // As little as can be written: "at most 0 s" is nothing.
  const left = Math.max(0.001, total_time - lower_bound);
  return gap <= PROVEN ? words.result.nothingLeft : words.result.atMost(seconds(left), percent(Math.max(1e-5, left / total_time)));
}

function showParts(list: HTMLElement, s: Summary, longest: number): void {
  // Less than a minute needs no hours.
  const time = (t: number) => seconds(t, t < MINUTE ? 0 : longest);
  const rows: [name: string, term: string, value: string][] = [
    ['cut', words.result.cut, `${time(s.cut_time)} · ${metres(s.cut_length)}`],
    ['pierce', words.result.pierce, `${time(s.pierce_time)} · ${words.result.piercings(s.pierces, count(s.pierces))}`],
  ];
  if (s.lead_length) rows.push(['leads', words.result.leads, metres(s.lead_length)]);
  if (s.joints) rows.push(['joints', words.result.joints, [count(s.joints), s.joint_time ? time(s.joint_time) : ''].filter((t) => t !== '').join(' · ')]);
  if (s.skeleton_cuts) rows.push(['skeleton-cuts', words.result.skeleton, `${time(s.skeleton_time ?? 0)} · ${metres(s.skeleton_length ?? 0)} · ${words.result.skeletonCuts(s.skeleton_cuts, count(s.skeleton_cuts))}`]);
  if (s.lifts) rows.push(['lifts', words.tips.lifts, count(s.lifts)]);
  if (s.detours) rows.push(['detours', words.tips.detours, count(s.detours)]);
  if (s.crossings) rows.push(['crossings', words.tips.crossings, count(s.crossings)]);
  if (s.loops) rows.push(['loops', words.corners.loops, `${metres(s.loop_length ?? 0)} · ${count(s.loops)}`]);
  if (s.rounded_corners) rows.push(['rounded', words.corners.rounded, `${millimetres(s.corner_deviation ?? 0)} · ${count(s.rounded_corners)}`]);
  if (s.waits) rows.push(['waits', words.heat.waits, `${time(s.wait_time ?? 0)} · ${count(s.waits)}`]);
  if (s.hot_pairs) rows.push(['hot-pairs', words.heat.hotPairs, count(s.hot_pairs)]);
  if (s.pre_cuts > 0) rows.push(['pre-cuts', words.result.preCuts, `${time(s.pre_cut_time)} · ${count(s.pre_cuts)}`]);
  if (s.macro_time > 0) rows.push(['corners', words.result.corners, time(s.macro_time)]);
  rows.push([s.gap === null ? 'gap' : 'gap bound', words.result.gap, leftToGain(s)]);
  const text = JSON.stringify(rows);
  if (list.dataset.shown === text) return;
  list.dataset.shown = text;
  list.replaceChildren(...rows.flatMap(([name, term, value]) => [h('dt', { class: name }, term), h('dd', { class: 'number' }, value.includes('·') ? betweenFacts(value) : unbroken(value))]));
}
