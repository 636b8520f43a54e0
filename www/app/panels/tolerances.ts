/**
 * How far ends may be apart and how closely curves are followed: while a number is turned, the sheet shows what would join
 * or disappear; only then is it applied.
 */

import { button, h, setText } from '../core/dom.js';
import { count } from '../core/format.js';
import { undecided } from '../session/choices.js';
import type { Outlook } from '../session/outlook.js';
import type { Preview } from '../session/preview.js';
import type { Session } from '../session/session.js';
import { field } from './section.js';
import { words } from '../core/words/index.js';

interface Tolerance {
  label: string;
  /** mm; when nobody chose one, as `LoadOptions` says. */
  usual: number;
  least: number;
  most: number;
}

const TOLERANCES = {
  joinTolerance: { label: words.drawing.join, usual: 0.05, least: 0.001, most: 5 },
  tolerance: { label: words.drawing.curves, usual: 0.005, least: 0.0001, most: 1 },
} satisfies Record<string, Tolerance>;

type Key = keyof typeof TOLERANCES;

/** Steps of a slider, which is even in the number of digits. */
const STEPS = 200;

export function tolerances(session: Session, preview: Preview): HTMLElement {
  const draft: Partial<Record<Key, number>> = {};
  const told = h('p', { class: 'outlook', role: 'status' });
  const apply = button(words.drawing.apply, { class: 'small primary' });
  apply.type = 'submit';
  const back = button(words.drawing.cancel, { class: 'small', onclick: () => preview.clear() });
  const choice = h('div', { class: 'row', hidden: true }, apply, back);
  const chosen = (key: Key) => session.state.load[key] ?? TOLERANCES[key].usual;
  const keys = Object.keys(TOLERANCES) as Key[];
  const rows = keys.map((key) => tolerance(TOLERANCES[key], (mm) => {
    if (mm === null) delete draft[key];
    else draft[key] = mm;
    const wrong = keys.some((k) => !rows[keys.indexOf(k)]!.valid());
    const same = keys.every((k) => (draft[k] ?? chosen(k)) === chosen(k));
    apply.disabled = wrong;
    choice.hidden = same && !wrong;
    if (wrong) setText(told, words.drawing.within(TOLERANCES[key].least, TOLERANCES[key].most));
    else if (same) preview.clear();
    else {
      setText(told, words.drawing.checking);
      preview.ask({ ...undecided(session.state.load), joinTolerance: chosen('joinTolerance'), ...draft });
    }
  }));
  const reset = () => {
    for (const [i, key] of keys.entries()) {
      delete draft[key];
      rows[i]!.set(chosen(key));
    }
    choice.hidden = true;
    setText(told, '');
  };
  const form = h('form', { class: 'stack' }, ...rows.map((row) => row.root), told, choice);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    if (!choice.hidden && !apply.disabled) void session.reread({ ...session.state.load, ...draft });
  });
  form.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') preview.clear();
  });
  preview.on('outlook', (outlook) => {
    if (outlook === null) reset();
    else setText(told, inWords(outlook));
  });
  preview.on('refused', (sentence) => setText(told, sentence));
  session.on('loaded', reset);
  reset();
  return h('details', { class: 'more' }, h('summary', {}, words.drawing.tolerances), form);
}

/** A slider with its number; `onTurn` hears what is chosen, null where it is nothing that can be. */
function tolerance({ label, least, most }: Tolerance, onTurn: (mm: number | null) => void): { root: HTMLElement; set(mm: number): void; valid(): boolean } {
  const input = h('input', { type: 'number', min: least, max: most, step: 'any', inputmode: 'decimal' });
  const slider = h('input', { type: 'range', min: 0, max: STEPS, 'aria-label': label, class: 'tolerance' });
  const span = Math.log(most / least);
  const valid = () => input.valueAsNumber >= least && input.valueAsNumber <= most;
  const slide = (mm: number) => {
    const share = Math.min(1, Math.max(0, Math.log(mm / least) / span));
    slider.value = String(Math.round(STEPS * share));
    slider.style.setProperty('--share', String(share));
    slider.setAttribute('aria-valuetext', `${mm} mm`);
  };
  const hear = () => {
    input.setAttribute('aria-invalid', String(!valid()));
    onTurn(valid() ? input.valueAsNumber : null);
  };
  input.addEventListener('input', () => {
    if (valid()) slide(input.valueAsNumber);
    hear();
  });
  slider.addEventListener('input', () => {
    // Two digits: nobody means a third.
    const mm = Number((least * Math.exp((span * slider.valueAsNumber) / STEPS)).toPrecision(2));
    input.value = String(mm);
    slide(mm);
    hear();
  });
  const root = h('div', { class: 'tolerance-field' }, field(label, input, 'mm'), slider);
  const set = (mm: number) => {
    input.value = String(mm);
    input.setAttribute('aria-invalid', 'false');
    slide(mm);
  };
  return { root, set, valid };
}

function inWords({ joins, opens, goes, contours, open, elements }: Outlook): string {
  const { preview } = words.drawing;
  const change = (of: readonly [number, number], say: (now: string, then: string) => string) => (of[0] === of[1] ? '' : say(count(of[0]), count(of[1])));
  const parts = [
    joins > 0 ? preview.joins(joins, count(joins)) : '', opens > 0 ? preview.opens(opens, count(opens)) : '', goes > 0 ? preview.removals(goes, count(goes)) : '',
    change(contours, preview.contours), change(open, preview.open), joins + opens + goes === 0 ? change(elements, preview.elements) : '',
  ].filter((part) => part !== '');
  return parts.length === 0 ? preview.nothing : preview.sentence(parts);
}
