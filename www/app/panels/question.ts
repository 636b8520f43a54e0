/**
 * What the page must know before it plans, asked in a card over the sheet: which units are right where the file leaves that open, with the
 * size that each would give; what to do with damaged entities; and whether a rectangle around everything is the sheet or a cut.
 */

import { button, h } from '../core/dom.js';
import { count, extent } from '../core/format.js';
import { UNIT_SIZES } from '../core/strings.js';
import type { Loaded, Unit } from 'kerfway';
import type { Session } from '../session/session.js';
import { borderInDoubt } from '../session/drawing.js';
import type { Question, State } from '../session/state.js';
import { words } from '../core/words/index.js';

/** The units offered in the card; the others are in the menu of the top bar. */
const OFFERED: readonly Unit[] = ['mm', 'in', 'cm', 'm'];

export function questionCard(session: Session): HTMLElement {
  const root = h('section', { class: 'card question', 'aria-labelledby': 'question', hidden: true });
  let asked = '';
  session.store.on('change', ({ question, loaded, phase }) => {
    const now = question && loaded && phase === 'question' ? `${question} ${loaded.sha256} ${loaded.units.unit}` : '';
    if (now === asked) return;
    asked = now;
    root.hidden = now === '';
    if (!loaded || now === '') return;
    root.replaceChildren(...CARDS[question!](session, loaded));
    root.querySelector('button')?.focus({ preventScroll: true });
  });
  return root;
}

const CARDS: Record<Question, (session: Session, loaded: Loaded) => HTMLElement[]> = { units, damaged, border };

/** Width and height of the drawing if it were read in another unit. */
export function sizeIn({ loaded, extent: [x0, y0, x1, y1] }: State, unit: Unit): string {
  const factor = loaded ? UNIT_SIZES[unit] / UNIT_SIZES[loaded.units.unit] : 1;
  return extent((x1 - x0) * factor, (y1 - y0) * factor);
}

function units(session: Session, loaded: Loaded): HTMLElement[] {
  const { unit } = loaded.units;
  const others = OFFERED.filter((u) => u !== unit);
  const choice = (u: Unit, primary: boolean) =>
    h('button', { type: 'button', class: primary ? 'primary' : '', onclick: () => (u === unit ? session.drawing.answer('units') : session.drawing.setUnits(u)) }, h('span', {}, sizeIn(session.state, u)), h('span', {}, words.question.in(words.unitNames[u])));
  return [
    h('h2', { id: 'question' }, words.question.size),
    h('p', {}, loaded.units.reason),
    h('div', { class: 'choices' }, choice(unit, true), ...others.map((u) => choice(u, false))),
  ];
}

function damaged(session: Session, loaded: Loaded): HTMLElement[] {
  const number = loaded.findings.filter((f) => f.code === 'damaged-entity').reduce((n, f) => n + f.count, 0);
  return [
    h('h2', { id: 'question' }, words.question.damaged(number, count(number))),
    h('p', {}, words.question.about),
    h('div', { class: 'choices' },
      button(words.question.skip, { class: 'primary', onclick: () => session.drawing.answer('damaged') }),
      button(words.question.keep, { onclick: () => session.drawing.answer('damaged', { keepDamaged: true }) })),
  ];
}

function border(session: Session, loaded: Loaded): HTMLElement[] {
  return [
    h('h2', { id: 'question' }, words.question.border),
    h('p', {}, borderInDoubt(loaded)?.message ?? ''),
    h('div', { class: 'choices' },
      button(words.question.ignoreBorder, { class: 'primary', onclick: () => session.drawing.answer('border', { ignoreOutline: true }) }),
      button(words.question.keepBorder, { onclick: () => session.drawing.answer('border', { keepBorder: true }) })),
  ];
}
