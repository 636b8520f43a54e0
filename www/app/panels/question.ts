/**
 * What the page must know before it plans, asked in a card over the sheet: which units are right where the file leaves that open, with the
 * size that each would give; what to do with damaged entities; and whether a rectangle around everything is the sheet or a cut.
 */

import { button, h } from '../core/dom.js';
import { count, extent, unbroken } from '../core/format.js';
import { leave } from '../core/refill.js';
import { reasonOf, sentenceOf, UNIT_SIZES } from '../core/strings.js';
import type { Loaded, LoadOptions, Unit } from 'kerfway';
import type { Session } from '../session/session.js';
import { borderInDoubt } from '../session/drawing.js';
import type { Question, State } from '../session/state.js';
import { words } from '../core/words/index.js';

/** A unit, or pixels of a resolution. */
export type UnitChoice = Pick<LoadOptions, 'units' | 'dpi'>;

/** What is offered in the card; the other units are in the menu of the top bar. */
const OFFERED: readonly UnitChoice[] = [{ units: 'mm' }, { units: 'in' }, { units: 'cm' }, { units: 'm' }];
/** For a drawing in pixels: browsers and Inkscape, Inkscape before 0.92, Illustrator; or its numbers are millimetres. */
const OFFERED_FOR_PIXELS: readonly UnitChoice[] = [{ dpi: 96 }, { dpi: 90 }, { dpi: 72 }, { units: 'mm' }];

export function questionCard(session: Session): HTMLElement {
  const root = h('section', { class: 'card question', 'aria-labelledby': 'question', tabindex: -1, hidden: true });
  let asked = '';
  session.store.on('change', ({ question, loaded, phase }) => {
    const now = question && loaded && phase === 'question' ? `${question} ${loaded.sha256} ${loaded.units.unit}` : '';
    if (now === asked) return;
    asked = now;
    leave(root);
    root.hidden = now === '';
    if (!loaded || now === '') return;
    root.replaceChildren(...CARDS[question!](session, loaded));
    // An answer that has to be chosen is not the one that the next key gives.
    (root.querySelector<HTMLElement>('.primary') ?? root).focus({ preventScroll: true });
  });
  return root;
}

const CARDS: Record<Question, (session: Session, loaded: Loaded) => HTMLElement[]> = { units, damaged, border };

/** What can be chosen for a drawing, the likeliest first. */
export function unitChoices({ units: { unit } }: Loaded): readonly UnitChoice[] {
  const all = (Object.keys(UNIT_SIZES) as Unit[]).filter((u) => u !== 'px').map((units) => ({ units }));
  return unit === 'px' ? [...OFFERED_FOR_PIXELS.filter((c) => c.dpi !== undefined), ...all] : all;
}

/** Whether a drawing is read as a choice says. */
export function isTaken({ units: { unit, dpi } }: Loaded, choice: UnitChoice): boolean {
  return choice.dpi === undefined ? choice.units === unit : choice.dpi === dpi;
}

/** The name of a unit or a resolution. */
export function unitName({ units = 'px', dpi }: UnitChoice): string {
  return dpi === undefined ? words.unitNames[units] : words.question.dpi(dpi);
}

/** Width and height of the drawing if it were read in another unit. */
export function sizeIn({ loaded, extent: [x0, y0, x1, y1] }: State, { units = 'px', dpi }: UnitChoice): string {
  const unit = dpi === undefined ? UNIT_SIZES[units] : MM_PER_INCH / dpi;
  const factor = loaded ? unit / loaded.units.scale : 1;
  return extent((x1 - x0) * factor, (y1 - y0) * factor);
}

const MM_PER_INCH = 25.4;

function units(session: Session, loaded: Loaded): HTMLElement[] {
  const { unit, dpi } = loaded.units;
  const now: UnitChoice = dpi === null ? { units: unit } : { dpi };
  const offered = unit === 'px' ? OFFERED_FOR_PIXELS : OFFERED;
  // None is proposed: the page does not know, and a wrong unit makes the job 25 times too large or too small. What the planner took says where it is from.
  const choice = (c: UnitChoice) => {
    const name = c.dpi === undefined ? words.question.in(words.unitNames[c.units ?? 'px']) : words.question.dpi(c.dpi);
    return h('button', { type: 'button', onclick: () => session.drawing.setUnits(c) }, h('span', {}, unbroken(sizeIn(session.state, c))), h('span', {}, isTaken(loaded, c) ? `${name}, ${words.unitSources[loaded.units.source]}` : name));
  };
  return [
    h('h2', { id: 'question' }, words.question.size),
    h('p', {}, reasonOf(loaded.units)),
    h('div', { class: 'choices' }, ...[...offered, ...(offered.some((c) => isTaken(loaded, c)) ? [] : [now])].map(choice)),
  ];
}

function damaged(session: Session, loaded: Loaded): HTMLElement[] {
  const number = loaded.findings.filter((f) => f.code === 'damaged-entity').reduce((n, f) => n + f.count, 0);
  return [
    h('h2', { id: 'question' }, words.question.damaged(number, count(number))),
    h('p', {}, words.question.about(number)),
    h('div', { class: 'choices' },
      button(words.question.skip(number), { class: 'primary', onclick: () => session.drawing.answer('damaged') }),
      button(words.question.keep(number), { onclick: () => session.drawing.answer('damaged', { keepDamaged: true }) })),
  ];
}

function border(session: Session, loaded: Loaded): HTMLElement[] {
  const doubt = borderInDoubt(loaded);
  return [
    h('h2', { id: 'question' }, words.question.border),
    h('p', {}, doubt === undefined ? '' : sentenceOf(doubt).text),
    h('div', { class: 'choices' },
      button(words.question.ignoreBorder, { class: 'primary', onclick: () => session.drawing.answer('border', { ignoreOutline: true }) }),
      button(words.question.keepBorder, { onclick: () => session.drawing.answer('border', { keepBorder: true }) })),
  ];
}
