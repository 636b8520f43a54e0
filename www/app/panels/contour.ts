/** What a contour is: in the tooltip beside the pointer, and on the card of the selected contour. */

import { button, h } from '../core/dom.js';
import { clock, count, millimetres } from '../core/format.js';
import type { Session } from '../session/session.js';
import type { Playback } from '../playback/playback.js';
import { pathContours, type Rule, ruleOf, RULES } from '../session/rules.js';
import { words } from '../core/words/index.js';

/** Facts about a contour; the first one is its name. */
export function describe(session: Session, playback: Playback, contour: number): string[] {
  const { loaded } = session.state;
  const info = pathContours(session.state)[contour];
  if (!loaded || !info) return [];
  const stop = playback.stopOf(contour);
  const part = loaded.parts.findIndex((p) => p.outer === contour || p.holes.includes(contour));
  const name = stop === null ? words.contour.numbered(contour + 1) : words.contour.place(count(stop + 1), count(playback.stops));
  const kind = info.operation === 'ignore' ? words.contour.excluded : info.operation === 'mark' ? words.contour.mark : !info.closed ? words.contour.open : info.inside === null ? words.contour.outer : words.contour.inner;
  return [name, info.layer, millimetres(info.length), part < 0 ? '' : words.contour.part(count(part + 1)), kind].filter((t) => t !== '');
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

/** The card of the selected contour: its facts, its rule, and buttons to the contours before and after it. */
export class ContourCard {
  readonly root = h('section', { class: 'card contour', 'aria-label': words.contour.card, hidden: true });

  constructor(private readonly session: Session, private readonly playback: Playback, private readonly actions: { toggleRule(contour: number, rule: Rule): void; step(by: 1 | -1): void; close(): void }) {}

  show(contour: number | null): void {
    this.root.hidden = contour === null;
    if (contour === null) return;
    const [name, ...facts] = describe(this.session, this.playback, contour);
    const stop = this.playback.stopOf(contour);
    const begin = stop === null ? [] : [words.contour.begins(clock(this.playback.begin(stop)))];
    const focused = this.root.contains(document.activeElement) ? [...this.root.querySelectorAll('button')].indexOf(document.activeElement as HTMLButtonElement) : -1;
    const now = ruleOf(this.session.state.load, contour);
    const choices = RULES.map((rule) => button(words.contour.rules[rule], { class: 'quiet small rule', 'aria-pressed': rule === now, onclick: () => this.actions.toggleRule(contour, rule) }));
    this.root.replaceChildren(
      h('div', { class: 'contour-text' }, h('strong', {}, name ?? ''), h('span', { class: 'soft number' }, [...facts, ...begin].join(' · '))),
      ...choices,
      button(words.contour.before, { icon: 'back', iconOnly: true, class: 'quiet small', onclick: () => this.actions.step(-1) }),
      button(words.contour.next, { icon: 'next', iconOnly: true, class: 'quiet small', onclick: () => this.actions.step(1) }),
      button(words.contour.close, { icon: 'close', iconOnly: true, class: 'quiet small', onclick: () => this.actions.close() }));
    if (focused >= 0) this.root.querySelectorAll('button')[focused]?.focus();
  }
}
