/** What was decided for single contours: those that are cut first or last, sequences, and those that are marked or skipped. Lists that have an order are dragged. */

import { button, h } from '../core/dom.js';
import { count } from '../core/format.js';
import { refill } from '../core/refill.js';
import { handle, moved } from '../core/sortable.js';
import type { LoadOptions } from 'kerfway';
import { withChoice, withoutGroup } from '../session/groups.js';
import { freeSequences, isOrdered, type Pin, type Rule, RULES, withoutPinOrder, withPinOrder, withSequence } from '../session/rules.js';
import type { Session } from '../session/session.js';
import { nameOf } from './contour.js';
import { words } from '../core/words/index.js';

/** How many contours of a list are shown one by one. */
const LISTED = 24;

export class Pins {
  readonly root = h('div', { class: 'stack' });
  /** The handle that is moved by keyboard: it gets the focus again when its list was made again. */
  private moving: string | null = null;

  constructor(private readonly session: Session, private readonly onContour: (contour: number) => void) {}

  show(): void {
    const { load } = this.session.state;
    this.moving ??= this.root.querySelector<HTMLElement>('[data-grip]:focus')?.dataset.grip ?? null;
    refill(this.root, ...RULES.flatMap((rule) => this.rule(load, rule)), ...freeSequences(load).map((sequence, i) => this.sequence(load, sequence, i)),
      ...(load.together ?? []).map((group) => this.listed(words.drawing.together, group, words.drawing.ungroup, () => withoutGroup(load, group))), ...this.own(load));
    if (this.moving !== null) this.root.querySelector<HTMLElement>(`[data-grip="${this.moving}"]`)?.focus();
    this.moving = null;
  }

  /** The contours that have a rule, with a button that removes it. */
  private rule(load: LoadOptions, rule: Rule): HTMLElement[] {
    const contours = load[rule] ?? [];
    if (contours.length === 0) return [];
    const clear = button(words.drawing.unpin[rule], { class: 'quiet small', 'aria-label': words.drawing.unpinAll[rule], onclick: () => this.session.drawing.clearRule(rule) });
    const head = h('span', {}, words.drawing.decided[rule](words.drawing.contours(contours.length, count(contours.length))));
    if ((rule !== 'first' && rule !== 'last') || contours.length < 2) return [h('div', { class: 'pins' }, head, this.chips(contours), clear)];
    return [h('div', { class: 'pins listed' }, head, this.order(load, rule), clear, this.rows(rule, contours, (to) => withPinOrder(load, rule, to), (c) => this.session.drawing.setRule([c], null)))];
  }

  /** Whether the pinned contours are cut in the order of the list. */
  private order(load: LoadOptions, pin: Pin): HTMLElement {
    const { drawing } = this.session;
    const ordered = isOrdered(load, pin);
    const toggle = () => drawing.change(ordered ? withoutPinOrder(load, pin) : withPinOrder(load, pin, load[pin] ?? []));
    return button(words.drawing.inOrder, { class: 'quiet small', 'aria-pressed': ordered, title: words.drawing.inOrderHint, onclick: toggle });
  }

  private sequence(load: LoadOptions, sequence: readonly number[], index: number): HTMLElement {
    const { drawing } = this.session;
    const clear = button(words.drawing.anyOrder, { class: 'quiet small', 'aria-label': words.drawing.anyOrderAll, onclick: () => drawing.change(withSequence(load, sequence, [])) });
    return h('div', { class: 'pins listed' }, h('span', {}, words.drawing.sequence(words.drawing.contours(sequence.length, count(sequence.length)))), h('span'), clear,
      this.rows(`s${index}`, sequence, (to) => withSequence(load, sequence, to), (c) => drawing.change(withSequence(load, sequence, sequence.filter((other) => other !== c)))));
  }

  /** The contours with micro-joints, leads or corners of their own. */
  private own(load: LoadOptions): HTMLElement[] {
    return (['joints', 'lead', 'corners'] as const).flatMap((what) => {
      const own = (load.contours ?? []).filter((c) => c[what] !== undefined).map((c) => c.contour);
      return own.length === 0 ? [] : [this.listed(words.drawing.own[what], own, words.drawing.byRule, () => withChoice(load, own, what, null))];
    });
  }

  private listed(title: (contours: string) => string, contours: readonly number[], clear: string, cleared: () => LoadOptions): HTMLElement {
    const head = title(words.drawing.contours(contours.length, count(contours.length)));
    return h('div', { class: 'pins' }, h('span', {}, head), this.chips(contours), button(clear, { class: 'quiet small', 'aria-label': `${clear}: ${head}`, onclick: () => this.session.drawing.change(cleared()) }));
  }

  private chips(contours: readonly number[]): HTMLElement {
    const shown = contours.slice(0, LISTED).map((c) => button(count(c), { class: 'small number', 'aria-label': words.drawing.show(count(c)), onclick: () => this.onContour(c) }));
    const more = contours.length > LISTED && h('span', { class: 'soft' }, words.drawing.others(count(contours.length - LISTED)));
    return h('span', { class: 'pinned' }, ...shown, more);
  }

  /** A list whose rows can be moved and removed. */
  private rows(key: string, contours: readonly number[], reordered: (to: number[]) => LoadOptions, remove: (contour: number) => void): HTMLElement {
    const { loaded } = this.session.state;
    const list = h('ol', { class: 'sortable' });
    const move = (from: number, to: number) => {
      this.moving = `${key}-${to}`;
      this.session.drawing.change(reordered(moved(contours, from, to)));
    };
    contours.slice(0, LISTED).forEach((contour, i) => {
      const name = loaded ? nameOf(loaded, contour) : '';
      const grip = handle(words.drawing.move(name, count(i + 1), count(contours.length)), list, i, { move });
      grip.dataset.grip = `${key}-${i}`;
      list.append(h('li', {}, grip, button(name, { class: 'quiet small name', 'aria-label': words.drawing.show(count(contour)), onclick: () => this.onContour(contour) }),
        button(words.drawing.removeOne(name), { icon: 'close', iconOnly: true, class: 'quiet small', onclick: () => remove(contour) })));
    });
    return h('div', {}, list, contours.length > LISTED ? h('span', { class: 'soft' }, words.drawing.others(count(contours.length - LISTED))) : null);
  }
}
