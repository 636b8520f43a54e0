/** What a contour is: in the tooltip beside the pointer, and on the card of the selected contours. */

import type { Loaded } from 'kerfway';
import { button, h } from '../core/dom.js';
import { clock, count, extent, millimetres } from '../core/format.js';
import type { Session } from '../session/session.js';
import type { Playback } from '../playback/playback.js';
import { partsOf } from '../session/parts.js';
import { pathContours, type Rule, ruleOf, RULES } from '../session/rules.js';
import { whyHere } from '../session/why.js';
import { words } from '../core/words/index.js';

/** Facts about a contour; the first one is its name. */
export function describe(session: Session, playback: Playback, contour: number): string[] {
  const { loaded } = session.state;
  const info = pathContours(session.state)[contour];
  if (!loaded || !info) return [];
  const stop = playback.stopOf(contour);
  const part = partsOf(loaded).of(contour);
  const name = stop === null ? words.contour.numbered(contour + 1) : words.contour.place(count(stop + 1), count(playback.stops));
  const kind = info.operation === 'ignore' ? words.contour.excluded : info.operation === 'mark' ? words.contour.mark : !info.closed ? words.contour.open : info.inside === null ? words.contour.outer : words.contour.inner;
  return [name, info.layer, millimetres(info.length), part === null ? '' : words.contour.part(count(part + 1)), kind].filter((t) => t !== '');
}

/** The name of a contour that does not depend on the order: its part, if it is the outline of one. */
export function nameOf(loaded: Loaded, contour: number): string {
  const part = partsOf(loaded).of(contour);
  return part !== null && loaded.parts[part]?.outer === contour ? words.contour.wholePart(count(part + 1)) : words.contour.numbered(contour + 1);
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

export interface CardActions {
  toggleRule(rule: Rule): void;
  /** Selects the whole parts of what is selected. */
  whole(): void;
  /** Selects everything like what is selected. */
  like(): void;
  /** Fixes the order in which the selected parts are cut now. */
  keepOrder(): void;
  step(by: 1 | -1): void;
  close(): void;
}

/** The card of what is selected: its facts, why it is cut where it is, its rule, what else can be selected with it. */
export class ContourCard {
  readonly root = h('section', { class: 'card contour', 'aria-label': words.contour.card, hidden: true });

  constructor(private readonly session: Session, private readonly playback: Playback, private readonly actions: CardActions) {}

  /** Shows what is selected; the last contour is the one that was selected last. */
  show(contours: readonly number[]): void {
    const { loaded, load } = this.session.state;
    this.root.hidden = contours.length === 0 || loaded === null;
    if (this.root.hidden || loaded === null) return;
    const { actions } = this;
    const single = contours.length === 1 ? contours[0]! : null;
    const [name, facts, why] = single === null ? [this.several(loaded, contours), this.sizes(loaded, contours), ''] : this.one(single);
    const rules = new Set(contours.map((c) => ruleOf(load, c)));
    const now = rules.size === 1 ? [...rules][0] : undefined;
    const parts = partsOf(loaded);
    const whole = parts.whole(contours), like = parts.like(contours);
    const topmost = contours.filter((c) => !contours.includes(loaded.contours[c]?.inside ?? -1));
    const choices = [
      ...RULES.map((rule) => button(words.contour.rules[rule], { class: 'quiet small rule', 'aria-pressed': rule === now, onclick: () => actions.toggleRule(rule) })),
      topmost.length > 1 && button(words.contour.keepOrder, { class: 'quiet small', title: words.contour.keepOrderHint, onclick: () => actions.keepOrder() }),
      whole.length > contours.length && button(words.contour.whole, { class: 'quiet small', title: words.contour.wholeKey, onclick: () => actions.whole() }),
      like.length > contours.length && button(words.contour.like(count(like.length)), { class: 'quiet small', title: words.contour.likeKey, onclick: () => actions.like() }),
    ];
    const focused = this.root.contains(document.activeElement) ? document.activeElement?.textContent || document.activeElement?.getAttribute('aria-label') : null;
    this.root.replaceChildren(
      h('div', { class: 'contour-text' }, h('strong', {}, name), h('span', { class: 'soft number' }, facts), why && h('span', { class: 'soft why' }, why)),
      h('div', { class: 'contour-steps' },
        single !== null && button(words.contour.before, { icon: 'back', iconOnly: true, class: 'quiet small', onclick: () => actions.step(-1) }),
        single !== null && button(words.contour.next, { icon: 'next', iconOnly: true, class: 'quiet small', onclick: () => actions.step(1) }),
        button(words.contour.close, { icon: 'close', iconOnly: true, class: 'quiet small', onclick: () => actions.close() })),
      h('div', { class: 'contour-rules', role: 'group', 'aria-label': words.contour.actions }, ...choices));
    if (focused) [...this.root.querySelectorAll('button')].find((b) => (b.textContent || b.getAttribute('aria-label')) === focused)?.focus();
  }

  private one(contour: number): [name: string, facts: string, why: string] {
    const [name = '', ...facts] = describe(this.session, this.playback, contour);
    const stop = this.playback.stopOf(contour);
    const { path } = this.playback;
    const begin = stop === null ? [] : [words.contour.begins(clock(this.playback.begin(stop)))];
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
