/** The controls of the plan's section: method, time, seed; and the rules that every plan follows, in the terms of laser software. */

import { h, setText } from '../core/dom.js';
import type { MethodInfo, PaperMethod } from 'kerfway';
import { aboutMethod, messageOf } from '../core/strings.js';
import type { Session } from '../session/session.js';
import type { State } from '../session/state.js';
import { numberInput } from './number-input.js';
import { span } from './plan-section.js';
import { check, field, select } from './section.js';
import { words } from '../core/words/index.js';

/** The time budgets to choose from, s. */
const BUDGETS = [2, 5, 10, 30, 60, 300];

/** The entry of the list of methods that unfolds those from papers. */
const MORE = '*';

export function planControls(session: Session): HTMLElement {
  // The methods from papers are loaded and listed when somebody asks for them.
  let unfolded = false;
  const method = select<string>((value) => {
    if (value !== MORE) return session.setSearch({ method: value, parameters: {} });
    unfolded = true;
    void session.catalog.loadPapers().then(() => session.store.catalogChanged());
  }, { wide: true });
  method.list.setAttribute('aria-label', words.plan.method);
  const budget = select<number>((value) => session.setSearch({ seconds: value }));
  const about = h('p', { class: 'soft' });
  const source = h('p', { class: 'soft' });
  const own = h('div', { hidden: true });
  // Only methods from papers have parameters.
  let parameters: Promise<{ show(method: PaperMethod | undefined): void }> | null = null;
  const loadParameters = async () => {
    const made = (await import('./parameters.js')).parameters(session);
    own.replaceWith(made.root);
    return made;
  };
  const showParameters = (method: PaperMethod | undefined) => {
    if (method === undefined && parameters === null) return;
    (parameters ??= loadParameters()).then((panel) => panel.show(method), (error) => {
      parameters = null;
      session.store.notify(messageOf(error));
    });
  };
  const seed = numberInput({ unit: '', least: 0, most: 4294967295, whole: true, empty: -1, placeholder: words.plan.random }, (value) => session.setSearch({ seed: value < 0 ? null : value }, true));
  const byLayer = check(words.plan.byLayer, (on) => session.drawing.change({ orderByLayer: on }));
  const bySheet = check(words.plan.bySheet, (on) => session.drawing.change({ passOrder: on ? 'sheet' : 'contour' }));
  const byPart = check(words.plan.byPart, (on) => session.drawing.change({ partByPart: on }));
  const common = check(words.plan.common, (on) => session.drawing.change({ commonCuts: on ? 'best' : 'off' }));
  const used = h('p', { class: 'soft' });
  const root = h('div', { class: 'stack' },
    method.root, about, source, own, field(words.plan.time, budget.root), field(words.plan.seed, seed.input), used, byLayer.root, byPart.root, bySheet.root, common.root,
    h('p', { class: 'soft' }, words.plan.always));

  const show = ({ search, seed: taken, load, loaded, machine }: State) => {
    const { methods, papers } = session.catalog;
    // The page has its own name for the order that it compares with.
    const option = (m: MethodInfo) => ({ value: m.name, label: m.name === 'greedy' ? words.result.greedy : m.title });
    const chosen = [...methods, ...papers].find((m) => m.name === search.method);
    const isPaper = papers.some((m) => m.name === search.method);
    const shown = unfolded || isPaper ? papers : [];
    const more = shown.length === 0 ? [{ value: MORE, label: words.plan.more }] : [];
    method.fill([...methods.map(option), ...more], search.method, { [words.plan.papers]: shown.map(option) });
    showParameters(papers.find((m) => m.name === search.method));
    setText(source, chosen?.source ?? '');
    source.hidden = !chosen?.source;
    // A budget from an address need not be in the list.
    const budgets = [...new Set([...BUDGETS, search.seconds])].sort((a, b) => a - b);
    budget.fill(budgets.map((s) => ({ value: s, label: span(s) })), search.seconds);
    setText(about, chosen ? aboutMethod(chosen) : '');
    byLayer.root.hidden = (loaded?.layers.length ?? 0) < 2;
    byLayer.input.checked = load.orderByLayer ?? false;
    bySheet.root.hidden = passes(session.state) < 2;
    bySheet.input.checked = load.passOrder === 'sheet';
    byPart.root.hidden = (loaded?.parts.length ?? 0) < 2;
    byPart.input.checked = load.partByPart ?? false;
    const off = load.commonCuts === 'off';
    const open = loaded?.contours.some((c) => !c.closed && c.operation === 'cut') ?? false;
    common.root.hidden = !open || !machine?.pre_cut_time;
    common.input.checked = !off;
    seed.show(search.seed);
    setText(used, taken === null ? '' : words.plan.used(taken));
    used.hidden = taken === null || search.seed !== null;
  };
  session.store.on('change', show);
  show(session.state);
  return root;
}

/** The most passes over any contour. */
function passes({ load, machine, material }: State): number {
  const setting = machine?.materials?.find((m) => m.name === material);
  return Math.max(machine?.cut.passes ?? 1, setting?.cut?.passes ?? 1, ...(load.layers ?? []).map((l) => l.passes ?? 1));
}
