/**
 * What the page must know before it plans, asked over the sheet: whether the units are right when the file leaves
 * them in doubt, with the size each would give; and what to do with damaged entities.
 */

import { button, h } from '../core/dom.js';
import { counted, extent } from '../core/format.js';
import { UNIT_NAMES, UNIT_SIZES } from '../core/strings.js';
import type { Loaded, Unit } from 'kerfway';
import type { Session } from '../session/session.js';
import type { State } from '../session/state.js';

/** Units offered at once; the rest are in the menu of the top bar. */
const OFFERED: readonly Unit[] = ['mm', 'in', 'cm', 'm'];

export function questionCard(session: Session): HTMLElement {
  const root = h('section', { class: 'card question', 'aria-labelledby': 'question', hidden: true });
  let asked = '';
  session.on('change', ({ question, loaded, phase }) => {
    const now = question && loaded && phase === 'question' ? `${question} ${loaded.sha256} ${loaded.units.unit}` : '';
    if (now === asked) return;
    asked = now;
    root.hidden = now === '';
    if (!loaded || now === '') return;
    root.replaceChildren(...(question === 'units' ? units(session, loaded) : damaged(session, loaded)));
    root.querySelector('button')?.focus({ preventScroll: true });
  });
  return root;
}

/** Width and height of the drawing in another unit than it was read in. */
export function sizeIn({ loaded, extent: [x0, y0, x1, y1] }: State, unit: Unit): string {
  const factor = loaded ? UNIT_SIZES[unit] / UNIT_SIZES[loaded.units.unit] : 1;
  return extent((x1 - x0) * factor, (y1 - y0) * factor);
}

function units(session: Session, loaded: Loaded): HTMLElement[] {
  const { unit } = loaded.units;
  const others = OFFERED.filter((u) => u !== unit);
  const choice = (u: Unit, primary: boolean) =>
    h('button', { type: 'button', class: primary ? 'primary' : '', onclick: () => (u === unit ? session.answer('units') : session.setUnits(u)) }, h('span', {}, sizeIn(session.state, u)), h('span', {}, `in ${UNIT_NAMES[u]}`));
  return [
    h('h2', { id: 'question' }, 'How large is this drawing?'),
    h('p', {}, loaded.units.reason),
    h('div', { class: 'choices' }, choice(unit, true), ...others.map((u) => choice(u, false))),
  ];
}

function damaged(session: Session, loaded: Loaded): HTMLElement[] {
  const number = loaded.findings.filter((f) => f.code === 'damaged-entity').reduce((n, f) => n + f.count, 0);
  return [
    h('h2', { id: 'question' }, `${counted(number, 'entity', 'entities')} in this file ${number === 1 ? 'is' : 'are'} damaged`),
    h('p', {}, 'They were read through a break in the file, so their shape may be wrong. Leave them out, or keep them and look at each.'),
    h('div', { class: 'choices' },
      button('Leave them out', { class: 'primary', onclick: () => session.answer('damaged') }),
      button('Keep them', { onclick: () => session.answer('damaged', { keepDamaged: true }) })),
  ];
}
