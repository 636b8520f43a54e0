/** A field for a number of the machine. */

import { h } from '../core/dom.js';
import { upTo } from '../core/format.js';
import { shownIn, typed, written } from '../core/lengths.js';
import { words } from '../core/words/index.js';

/** A number that is typed, in its own unit; a length is typed in the unit that the person has chosen. */
export interface Measure {
  unit: string;
  least: number;
  most: number;
  /** The value that the empty field stands for. Without one, an empty field changes nothing. */
  empty?: number;
  /** What the empty field says. */
  placeholder?: string;
  whole?: boolean;
}

/**
 * `onChange` gets every valid number. While another one is typed, a sentence below the field says what it may be; whoever leaves the field gets the
 * value back that counts. `show` leaves alone what is being typed.
 */
export function numberInput({ unit, least, most, empty, placeholder, whole = false }: Measure, onChange: (value: number) => void): { input: HTMLInputElement; show(value: number | null): void } {
  const input = h('input', { type: 'number', step: whole ? 1 : 'any', min: written(least, unit), max: written(most, unit), inputmode: 'decimal', placeholder });
  const { factor, unit: name } = shownIn(unit);
  const limits = h('p', { class: 'reason error', role: 'alert' }, words.drawing.within(upTo(least / factor, 6), `${upTo(most / factor, 6)} ${name}`.trim()));
  let counts: number | null = null;
  const put = () => (input.value = counts === null || counts === empty ? '' : written(counts, unit));
  const mark = (isWrong: boolean) => {
    input.setAttribute('aria-invalid', String(isWrong));
    if (isWrong) input.closest('.field')?.after(limits);
    else limits.remove();
  };
  input.addEventListener('input', () => {
    const value = input.value === '' && empty !== undefined && input.validity.valid ? empty : typed(input, unit);
    const valid = (value >= least && value <= most) || value === empty;
    // Of a number that has only begun, such as "-", the value is empty.
    mark(!valid && input.value !== '');
    if (valid) onChange((counts = value));
  });
  input.addEventListener('blur', () => {
    if (input.getAttribute('aria-invalid') === 'true') put();
    mark(false);
  });
  return {
    input,
    show(value) {
      counts = value;
      if (document.activeElement !== input) put();
    },
  };
}
