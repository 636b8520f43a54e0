/** A field for a number. */

import { h } from '../core/dom.js';
import { upTo } from '../core/format.js';
import { shownIn, typed, written } from '../core/lengths.js';
import { words } from '../core/words/index.js';

/** A number that is typed, in its own unit; a length is typed in the unit that the person has chosen. */
export interface Measure {
  unit: string;
  /** Where another value sets the limit, it is looked up when something is typed. */
  least: number | (() => number);
  most: number | (() => number);
  /** The value that the empty field stands for. Without one, an empty field changes nothing. */
  empty?: number;
  /** What the empty field says. */
  placeholder?: string;
  whole?: boolean;
}

const now = (limit: number | (() => number)) => (typeof limit === 'number' ? limit : limit());

/**
 * `onChange` gets every valid number. While another one is typed, the value of before counts, and a sentence below the field says what it may be;
 * whoever leaves the field gets the value back that counts. `show` leaves alone what is being typed.
 */
export function numberInput(measure: Measure, onChange: (value: number) => void): { input: HTMLInputElement; show(value: number | null): void } {
  const { unit, empty, placeholder } = measure;
  const input = h('input', { type: 'number', step: measure.whole ? 1 : 'any', min: written(now(measure.least), unit), max: written(now(measure.most), unit), inputmode: 'decimal', placeholder });
  const mark = marking(input, measure);
  let counts: number | null = null;
  /** The value before the person began to type, or that was confirmed since. */
  let before: number | null = null;
  const put = () => (input.value = counts === null || counts === empty ? '' : written(counts, unit));
  for (const event of ['focus', 'change']) input.addEventListener(event, () => (before = counts));
  input.addEventListener('input', () => {
    const value = input.value === '' && empty !== undefined && input.validity.valid ? empty : typed(input, unit);
    const valid = isWithin(value, measure) || value === empty;
    // Of a number that has only begun, such as "-", the value is empty.
    mark(!valid && input.value !== '');
    const next = valid ? value : before ?? empty ?? counts;
    if (next !== null && (valid || next !== counts)) onChange((counts = next));
  });
  input.addEventListener('blur', () => {
    put();
    // What is pressed does not move away before it is released.
    if (document.querySelector(':active') === null) mark(false);
    else addEventListener('mouseup', () => setTimeout(mark, 0, false), { once: true });
  });
  return {
    input,
    show(value) {
      counts = value;
      if (document.activeElement !== input) put();
    },
  };
}

export function isWithin(value: number, { least, most, whole = false }: Measure): boolean {
  return value >= now(least) && value <= now(most) && (!whole || Number.isInteger(value));
}

/** Returns what marks a field as wrong, with a sentence below it that says what it may be, or as right. */
export function marking(input: HTMLInputElement, { unit, least, most, whole = false }: Measure): (isWrong: boolean) => void {
  const limits = h('p', { class: 'reason error', role: 'alert' });
  return (isWrong) => {
    input.setAttribute('aria-invalid', String(isWrong));
    if (!isWrong) return limits.remove();
    const { factor, unit: name } = shownIn(unit);
    limits.textContent = words.drawing.within(upTo(now(least) / factor, 6), `${upTo(now(most) / factor, 6)}${name === '°' ? '' : ' '}${name}`.trim(), whole);
    if (!limits.isConnected) input.closest('.field')?.after(limits);
  };
}
