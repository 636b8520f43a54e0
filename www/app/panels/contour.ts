/** What a contour is: in the tooltip beside the pointer, and on the card of the selected contours. */

import { type ContourChoice, CORNER_KINDS, LEAD_KINDS, type LeadKind, type Loaded } from 'kerfway';
import { button, h } from '../core/dom.js';
import { clock, count, extent, millimetres } from '../core/format.js';
import { leave, refill } from '../core/refill.js';
import type { Session } from '../session/session.js';
import type { Playback } from '../playback/playback.js';
import { partsOf } from '../session/parts.js';
import { choosing, commonChoice, groupOf } from '../session/groups.js';
import { holds, isDrawn, pathContours, type Rule, RULES } from '../session/rules.js';
import { longestTime } from '../session/state.js';
import { whyHere } from '../session/why.js';
import { words } from '../core/words/index.js';

/** Facts about a contour; the first one is its name. */
export function describe(session: Session, playback: Playback, contour: number): string[] {
  const { loaded } = session.state;
  const info = pathContours(session.state)[contour];
  if (!loaded || !info) return [];
  const stop = playback.stopOf(contour);
  const part = partsOf(loaded).of(contour);
  const name = stop === null ? words.contour.numbered(contour) : words.contour.place(count(stop + 1), count(playback.stops));
  const kind = info.skeleton === true ? words.result.skeleton : info.operation === 'ignore' ? words.contour.excluded : info.operation === 'mark' ? words.contour.mark : !info.closed ? words.contour.open : info.inside === null ? words.contour.outer : words.contour.inner;
  return [name, info.layer, millimetres(info.length), part === null ? '' : words.contour.part(count(part + 1)), kind].filter((t) => t !== '');
}

/** The name of a contour that does not depend on the order: its part, if it is the outline of one. */
export function nameOf(loaded: Loaded, contour: number): string {
  const part = partsOf(loaded).of(contour);
  return part !== null && loaded.parts[part]?.outer === contour ? words.contour.wholePart(count(part + 1)) : words.contour.numbered(contour);
}

/** A line of text that follows the pointer. */
export class Tooltip {
  readonly root = h('div', { class: 'tooltip', role: 'tooltip', hidden: true });

  show(facts: readonly string[], x: number, y: number): void {
    this.root.hidden = facts.length === 0;
    if (facts.length === 0) return;
    this.root.replaceChildren(h('strong', {}, facts[0]!), h('span', { class: 'soft' }, facts.slice(1).join(' · ')));
    const right = x + 14 + this.root.offsetWidth > innerWidth;
    this.root.style.transform = `translate(${right ? x - 14 - this.root.offsetWidth : x + 14}px, ${y + 16}px)`;
  }

  hide(): void {
    this.root.hidden = true;
  }
}

/** Numbers of micro-joints that a contour may be given on the card. */
const COUNTS: readonly number[] = [0, 1, 2, 3, 4, 6, 8];

export interface CardActions {
  toggleRule(rule: Rule): void;
  /** Selects the whole parts of what is selected. */
  whole(): void;
  /** Selects everything like what is selected. */
  like(): void;
  /** Fixes the order in which the selected parts are cut now. */
  keepOrder(): void;
  /** Keeps what is selected together, or not any more. */
  group(): void;
  /** Gives what is selected a number of micro-joints, a lead or corners; null: by the rules of the machine. */
  choose<K extends 'joints' | 'lead' | 'corners'>(what: K, value: NonNullable<ContourChoice[K]> | null): void;
  step(by: 1 | -1): void;
  close(): void;
}

/** The card of what is selected: its facts, why it is cut where it is, its rule, what else can be selected with it. */
export class ContourCard {
  readonly root = h('section', { class: 'card contour', 'aria-label': words.contour.card, hidden: true });

  private shown: readonly number[] = [];

  constructor(private readonly session: Session, private readonly playback: Playback, private readonly actions: CardActions) {}

  /** Shows what is selected; the last contour is the one that was selected last. */
  show(contours: readonly number[]): void {
    const { loaded, load } = this.session.state;
    this.root.hidden = contours.length === 0 || loaded === null;
    if (this.root.hidden || loaded === null) return leave(this.root);
    const { actions } = this;
    const single = contours.length === 1 ? contours[0]! : null;
    const [name, facts, why] = single === null ? [this.several(loaded, contours), this.sizes(loaded, contours), ''] : this.one(single);
    const parts = partsOf(loaded);
    // Of very many parts, the shapes are found little by little; what is like these is offered then.
    if (!parts.isGrouped) void parts.group().then(() => this.shown === contours && this.show(contours));
    this.shown = contours;
    const whole = parts.whole(contours), like = parts.isGrouped ? parts.like(contours) : [];
    const topmost = contours.filter((c) => !contours.includes(loaded.contours[c]?.inside ?? -1));
    const drawn = contours.every((c) => isDrawn(loaded, c));
    const rules = !drawn ? [] : RULES.map((rule) => button(words.contour.rules[rule], { class: 'quiet small rule', 'aria-pressed': holds(load, loaded, contours, rule), onclick: () => actions.toggleRule(rule) }));
    const others = !drawn ? [] : [
      contours.length > 1 && button(words.contour.group, { class: 'quiet small', title: words.contour.groupKey, 'aria-pressed': groupOf(load, loaded, contours) !== undefined, onclick: () => actions.group() }),
      topmost.length > 1 && button(words.contour.keepOrder, { class: 'quiet small', title: words.contour.keepOrderHint, onclick: () => actions.keepOrder() }),
      whole.length > contours.length && button(words.contour.whole, { class: 'quiet small', title: words.contour.wholeKey, onclick: () => actions.whole() }),
      like.length > contours.length && button(words.contour.like(count(like.length)), { class: 'quiet small', title: words.contour.likeKey, onclick: () => actions.like() }),
    ];
    const rest = [...others, ...this.choices(loaded, contours)].filter((control) => control !== null && control !== false);
    const text = h('div', { class: 'contour-text' }, h('strong', {}, name), h('span', { class: 'soft number' }, facts), why && h('span', { class: 'soft why' }, why));
    const controls = [
      h('div', { class: 'contour-steps' }, rest.length > 0 && this.unfold(),
        single !== null && button(words.contour.before, { icon: 'back', iconOnly: true, class: 'quiet small', onclick: () => actions.step(-1) }),
        single !== null && button(words.contour.next, { icon: 'next', iconOnly: true, class: 'quiet small', onclick: () => actions.step(1) }),
        button(words.contour.close, { icon: 'close', iconOnly: true, class: 'quiet small', onclick: () => actions.close() })),
      h('div', { class: 'contour-rules', role: 'group', 'aria-label': words.contour.actions }, ...rules, h('div', { class: 'contour-rest' }, ...rest))];
    // A search brings other facts ten times a second. The controls stay, so that an open list is not closed.
    const [before, ...shown] = this.root.children;
    if (before && controls.every((c, i) => shown[i]?.isEqualNode(c))) before.replaceWith(text);
    else refill(this.root, text, ...controls);
  }

  /** Shows on a phone what else can be chosen, which would cover the sheet. Elsewhere it is always shown. */
  private unfold(): HTMLButtonElement {
    const { classList } = this.root;
    const more = button(words.contour.more, { icon: 'more', iconOnly: true, class: 'quiet small contour-more', 'aria-expanded': classList.contains('unfolded') });
    more.addEventListener('click', () => more.setAttribute('aria-expanded', String(classList.toggle('unfolded'))));
    return more;
  }

  /** The number of micro-joints, the lead and the corners of what is selected, where it can have some. */
  private choices(loaded: Loaded, contours: readonly number[]): (HTMLElement | null)[] {
    const { load, machine } = this.session.state;
    const kinds: readonly LeadKind[] = [...LEAD_KINDS, 'center'];
    const one = <K extends 'joints' | 'lead' | 'corners', V extends NonNullable<ContourChoice[K]>>(what: K, label: string, values: readonly V[], name: (value: V) => string) => {
      const named = choosing(loaded, contours, what);
      if (named.length === 0) return null;
      const now = commonChoice(load, named, what);
      const root = h('select', { class: 'small', 'aria-label': label });
      // The choice is an attribute, so that controls which show the same are equal.
      root.append(h('option', { selected: now === null }, words.contour.byRule), ...values.map((value) => h('option', { selected: value === now }, name(value))));
      if (now === undefined) root.selectedIndex = -1;
      root.addEventListener('change', () => this.actions.choose(what, root.selectedIndex === 0 ? null : values[root.selectedIndex - 1]!));
      return h('label', { class: 'contour-choice' }, h('span', { class: 'soft' }, label), root);
    };
    return [
      one('joints', words.contour.joints, COUNTS, (n) => (n === 0 ? words.leads.kinds.none : count(n))),
      one('lead', words.contour.lead, kinds, (kind) => words.leads.kinds[kind]),
      machine?.levers?.corners == null ? null : one('corners', words.contour.corners, CORNER_KINDS, (kind) => words.corners.kinds[kind]),
    ];
  }

  private one(contour: number): [name: string, facts: string, why: string] {
    const [name = '', ...facts] = describe(this.session, this.playback, contour);
    const stop = this.playback.stopOf(contour);
    const { path } = this.playback;
    const begin = stop === null ? [] : [words.contour.begins(clock(this.playback.begin(stop), this.playback.total, longestTime(this.session.state)))];
    const why = stop === null || path === null ? '' : whyHere(this.session.state, path, contour, stop, (c) => this.playback.stopOf(c));
    return [name, [...facts, ...begin].join(' · '), why];
  }

  private several(loaded: Loaded, contours: readonly number[]): string {
    const parts = partsOf(loaded);
    const chosen = new Set(contours);
    const whole = new Set(contours.map((c) => parts.of(c)).filter((p): p is number => p !== null && parts.contours(p).every((c) => chosen.has(c))));
    const inParts = contours.filter((c) => whole.has(parts.of(c) ?? -1)).length;
    const all = words.drawing.contours(contours.length, count(contours.length));
    if (whole.size === 0) return all;
    return inParts === contours.length ? `${words.drawing.parts(whole.size, count(whole.size))}, ${all}` : `${all}, ${words.drawing.parts(whole.size, count(whole.size))}`;
  }

  private sizes(loaded: Loaded, contours: readonly number[]): string {
    const infos = contours.map((c) => loaded.contours[c]).filter((i) => i !== undefined);
    const [x0, y0, x1, y1] = partsOf(loaded).boxOf(contours);
    return [extent(x1 - x0, y1 - y0), millimetres(infos.reduce((sum, i) => sum + i.length, 0))].join(' · ');
  }
}
