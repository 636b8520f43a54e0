/**
 * Lengths for people: millimetres, or inches where the person has chosen them. Only what is shown and typed changes; the drawing, the machine and
 * every program stay in millimetres.
 */

import { kept } from './kept.js';

export type LengthUnit = 'mm' | 'in';

const LENGTH_UNITS: readonly LengthUnit[] = ['mm', 'in'];

/** Where the choice is kept. */
export const LENGTH_KEY = 'kerfway.lengths';

/** The unit of lengths on the page. */
export const lengthUnit: LengthUnit = kept(LENGTH_KEY, LENGTH_UNITS) ?? 'mm';

const INCH = 25.4;

/** What a value with a unit is shown in, and how much of the value's own unit one shown unit is. */
export interface Shown {
  unit: string;
  factor: number;
}

/** How values of a unit are shown. Units without a length stay as they are. */
export function shownIn(unit: string): Shown {
  return lengthUnit === 'in' && /^mm\b/.test(unit) ? { unit: unit.replace('mm', 'in'), factor: unit.endsWith('²') && !unit.includes('/') ? INCH * INCH : INCH } : { unit, factor: 1 };
}

/** A value as a field shows it, without digits that come from the conversion only. */
export function written(value: number, unit: string): string {
  return String(Number((value / shownIn(unit).factor).toFixed(6)));
}

/** The value that is typed into a field; NaN where there is none. */
export function typed(input: HTMLInputElement, unit: string): number {
  return Number((input.valueAsNumber * shownIn(unit).factor).toFixed(9));
}

const NUMBER = String.raw`-?[\d,]*\.?\d+`;
/** What may stand between numbers that share a unit, in all languages: "x 0 to 400, y 0 to 300 mm". */
const BETWEEN = ' (?:×|x|to|and|bis|a|～|至) |(?:,| and| und| y de|、) ?y ';
/** The lengths in a sentence, with their unit. */
export const lengthsIn = (unit: string) => new RegExp(`${NUMBER}(?:(?:${BETWEEN})${NUMBER})* ${unit}(?![²³/\\w])`, 'g');

/** A sentence about a drawing with its lengths in the chosen unit: "12.7 mm" becomes "0.5 in", "100 × 50 mm" becomes "3.94 × 1.97 in". */
export function inChosenUnit(sentence: string): string {
  if (lengthUnit === 'mm') return sentence;
  const convert = (number: string) => String(Number((Number(number.replaceAll(',', '')) / INCH).toPrecision(3)));
  return sentence.replace(lengthsIn('mm'), (lengths) => lengths.replace(new RegExp(NUMBER, 'g'), convert).replace(/mm$/, 'in'));
}
