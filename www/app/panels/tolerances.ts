/**
 * How far apart ends may be, how near lines are copies, and how closely curves are followed. While a value is being changed, the sheet shows what would join or
 * disappear; nothing changes before the value is applied. Loaded when it is opened.
 */

import { button, h, setText } from '../core/dom.js';
import { count, upTo } from '../core/format.js';
import { shownIn, typed, written } from '../core/lengths.js';
import type { ChangeMark, Comparison } from '../session/comparison.js';
import { Preview } from '../session/preview.js';
import { withoutRules } from '../session/rules.js';
import type { Session } from '../session/session.js';
import { isWithin, marking } from './number-input.js';
import { field } from './section.js';
import { words } from '../core/words/index.js';

interface Tolerance {
  label: string;
  /** The default of `LoadOptions`, mm. */
  usual: number;
  least: number;
  most: number;
}

const TOLERANCES = {
  joinTolerance: { label: words.drawing.join, usual: 0.05, least: 0.001, most: 5 },
  copyTolerance: { label: words.drawing.near, usual: 0.01, least: 0.001, most: 1 },
  tolerance: { label: words.drawing.curves, usual: 0.005, least: 0.0001, most: 1 },
} satisfies Record<string, Tolerance>;

type Key = keyof typeof TOLERANCES;

const inUnit = (mm: number) => `${upTo(mm / shownIn('mm').factor, 6)} ${shownIn('mm').unit}`;

/** Steps of a slider. The scale is logarithmic, because the range covers several powers of ten. */
const STEPS = 200;

/** `mark` marks the changes on the sheet. */
export function tolerances(session: Session, mark: (changes: ChangeMark[]) => void): HTMLElement {
  const preview = new Preview(session);
  const draft: Partial<Record<Key, number>> = {};
  const outcome = h('p', { class: 'comparison', role: 'status' });
  const apply = button(words.drawing.apply, { class: 'small primary' });
  apply.type = 'submit';
  const back = button(words.drawing.cancel, { class: 'small', onclick: () => preview.clear() });
  const choice = h('div', { class: 'row', hidden: true }, apply, back);
  /** What would change, and the buttons, are below the fields, where the panel may end. */
  const show = () => choice.scrollIntoView({ block: 'nearest' });
  const chosen = (key: Key) => session.state.load[key] ?? TOLERANCES[key].usual;
  const keys = Object.keys(TOLERANCES) as Key[];
  const rows = keys.map((key) => tolerance(TOLERANCES[key], (mm) => {
    if (mm === null) delete draft[key];
    else draft[key] = mm;
    const wrong = keys.some((k) => !rows[keys.indexOf(k)]!.valid());
    const same = keys.every((k) => (draft[k] ?? chosen(k)) === chosen(k));
    apply.disabled = wrong;
    choice.hidden = same && !wrong;
    if (wrong) setText(outcome, '');
    else if (same) preview.clear();
    else {
      setText(outcome, words.drawing.checking);
      preview.request({ ...withoutRules(session.state.load), joinTolerance: chosen('joinTolerance'), ...draft });
    }
    show();
  }));
  const reset = () => {
    for (const [i, key] of keys.entries()) {
      delete draft[key];
      rows[i]!.set(chosen(key));
    }
    choice.hidden = true;
    setText(outcome, '');
  };
  const form = h('form', { class: 'stack' }, ...rows.map((row) => row.root), outcome, choice);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    if (!choice.hidden && !apply.disabled) session.drawing.change({ ...draft });
  });
  form.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') preview.clear();
  });
  preview.on('comparison', (comparison) => {
    mark(comparison?.marks ?? []);
    if (comparison === null) reset();
    else {
      setText(outcome, inWords(comparison));
      show();
    }
  });
  preview.on('refused', (sentence) => setText(outcome, sentence));
  session.store.on('loaded', reset);
  reset();
  return form;
}

/** A slider with its number. `onTurn` is called with the value, or with null where it is not a valid one. */
function tolerance({ label, least, most }: Tolerance, onTurn: (mm: number | null) => void): { root: HTMLElement; set(mm: number): void; valid(): boolean } {
  const input = h('input', { type: 'number', min: written(least, 'mm'), max: written(most, 'mm'), step: 'any', inputmode: 'decimal' });
  const slider = h('input', { type: 'range', min: 0, max: STEPS, 'aria-label': label, class: 'tolerance' });
  const span = Math.log(most / least);
  const value = () => typed(input, 'mm');
  const measure = { unit: 'mm', least, most };
  const valid = () => isWithin(value(), measure);
  const mark = marking(input, measure);
  const slide = (mm: number) => {
    const share = Math.min(1, Math.max(0, Math.log(mm / least) / span));
    slider.value = String(Math.round(STEPS * share));
    slider.style.setProperty('--share', String(share));
    slider.setAttribute('aria-valuetext', inUnit(mm));
  };
  const report = () => {
    mark(!valid());
    onTurn(valid() ? value() : null);
  };
  input.addEventListener('input', () => {
    if (valid()) slide(value());
    report();
  });
  slider.addEventListener('input', () => {
    // A slider cannot be set more exactly than to two digits.
    const mm = Number((least * Math.exp((span * slider.valueAsNumber) / STEPS)).toPrecision(2));
    input.value = written(mm, 'mm');
    slide(mm);
    report();
  });
  const root = h('div', { class: 'tolerance-field' }, field(label, input, 'mm'), slider);
  const set = (mm: number) => {
    input.value = written(mm, 'mm');
    mark(false);
    slide(mm);
  };
  return { root, set, valid };
}

function inWords({ joins, opens, removals, contours, openContours, elements }: Comparison): string {
  const { preview } = words.drawing;
  const change = (of: readonly [number, number], say: (now: string, then: string, n: number) => string) => (of[0] === of[1] ? '' : say(count(of[0]), count(of[1]), of[1]));
  const parts = [
    joins > 0 ? preview.joins(joins, count(joins)) : '', opens > 0 ? preview.opens(opens, count(opens)) : '', removals > 0 ? preview.removals(removals, count(removals)) : '',
    change(contours, preview.contours), change(openContours, preview.open), joins + opens + removals === 0 ? change(elements, preview.elements) : '',
  ].filter((part) => part !== '');
  return parts.length === 0 ? preview.nothing : preview.sentence(parts);
}
