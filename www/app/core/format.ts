/**
 * Numbers for people: seconds, lengths, counts, in the form of the language. Measured values have three significant digits, as more would suggest
 * an accuracy they do not have.
 */

import { lengthUnit, shownIn } from './lengths.js';
import { words } from './words/index.js';

/** Formats with a number of decimals, made once each: making one takes far longer than using it. */
const formats = new Map<string, Intl.NumberFormat>();

function decimal(x: number, least: number, most = least, useGrouping = false): string {
  const key = `${least} ${most} ${useGrouping}`;
  let format = formats.get(key);
  if (format === undefined) formats.set(key, (format = new Intl.NumberFormat(words.numbers.locale, { minimumFractionDigits: least, maximumFractionDigits: most, useGrouping, signDisplay: 'negative' })));
  return format.format(x);
}

/** 1234 -> "1,234". */
export function count(n: number): string {
  return decimal(n, 0, 0, true);
}

/** Three significant digits, without an exponent: 0.0123, 1.23, 12.3, 123, 1,230. */
export function three(x: number): string {
  const size = Math.abs(x);
  if (size < 5e-4) return '0';
  if (size >= 999.5) return count(Number(x.toPrecision(3)));
  return decimal(x, decimals(size));
}

/** How many decimals three significant digits have. */
const decimals = (size: number) => Math.min(3, Math.max(0, 2 - Math.floor(Math.log10(size))));

/** A number with this many decimals. */
export function fixed(x: number, decimals: number): string {
  return decimal(x, decimals);
}

/** A number rounded to at most this many decimals. */
export function upTo(x: number, decimals: number): string {
  return decimal(x, 0, decimals);
}

/** From here on times are hours, minutes and seconds, s. */
export const LONG = 999.5;

/** Job time: "0.42 s", "42.3 s", "627 s", and from 1,000 s on "0:16:40". `beside`: the longest of the times it is compared with, as they should look alike. */
export function seconds(s: number, beside = s): string {
  if (!Number.isFinite(s)) return '–';
  if (Math.max(Math.abs(s), beside) < LONG) return `${three(s)} s`;
  const whole = Math.round(Math.abs(s));
  return `${s < 0 ? '-' : ''}${count(Math.floor(whole / 3600))}:${pair(Math.floor(whole / 60) % 60)}:${pair(whole % 60)}`;
}

const pair = (n: number) => String(n).padStart(2, '0');

/** A moment of a job of `total` seconds, in the form of that time, with a tenth of a second at least: "2.3 s" of "48.8 s", "0:01:23" of "0:19:41". `beside` as above. */
export function clock(s: number, total: number, beside = total): string {
  const t = Math.max(0, s);
  return Math.max(total, beside) < LONG ? `${fixed(t, total > 0 ? Math.max(1, decimals(total)) : 1)} s` : seconds(t, LONG);
}

/** What stands between whole numbers and decimals. */
export const POINT = decimal(0.5, 1).slice(1, -1);

/** A long way: "2.76 m"; from 10 km on as kilometres. */
export function metres(mm: number): string {
  if (lengthUnit === 'in') return millimetres(mm);
  if (mm >= 1e7) return `${three(mm / 1e6)} km`;
  return `${three(mm / 1000)} m`;
}

/** A length on the sheet: "44.2 mm"; above 10 m in metres. */
export function millimetres(mm: number): string {
  const { unit, factor } = shownIn('mm');
  return mm >= 10_000 && unit === 'mm' ? metres(mm) : `${three(mm / factor)} ${unit}`;
}

/** A length on the sheet, to a tenth of a millimetre, below 10 mm and in inches to a hundredth: "1000", "297.5", "1.75". `beside`: the larger one of two. */
export function size(mm: number, beside = mm): string {
  const { unit, factor } = shownIn('mm');
  const [value, largest] = [mm / factor, Math.abs(beside / factor)];
  return largest < 1 || Math.abs(value) < 0.1 ? three(value) : upTo(value, unit === 'mm' && largest >= 10 ? 1 : 2);
}

/** The same with its unit: "297.5 mm"; in metres where `extent` has these. */
export function width(mm: number, beside = mm): string {
  return Math.max(mm, beside) < 10_000 || lengthUnit === 'in' ? `${size(mm)} ${shownIn('mm').unit}` : metres(mm);
}

/** A coordinate, always with the decimals of `size`, so that a list of them is even: "6.0", "0.8". */
function coordinate(mm: number): string {
  const { unit, factor } = shownIn('mm');
  return fixed(mm / factor, unit === 'mm' ? 1 : 2);
}

/** Coordinates side by side: "6.0, 0.8", and "6,0; 0,8" where a comma comes before decimals. */
export function place(x: number, y: number): string {
  return `${coordinate(x)}${POINT === ',' ? ';' : ','} ${coordinate(y)}`;
}

/** "1000 × 500 mm"; from 10 m on in metres. */
export function extent(width: number, height: number): string {
  const { unit } = shownIn('mm');
  if (unit === 'mm' && Math.max(width, height) >= 10_000) return `${three(width / 1000)} × ${three(height / 1000)} m`;
  const largest = Math.max(width, height);
  return `${size(width, largest)} × ${size(height, largest)} ${unit}`;
}

/** An area: "120 mm²", from 100 cm² on "0.0123 m²", or "19.1 in²". `beside`: the smallest area of its list, as a list has one unit. */
export function area(mm2: number, beside = mm2): string {
  const { unit, factor } = shownIn('mm²');
  if (unit !== 'mm²') return `${three(mm2 / factor)} ${unit}`;
  return beside < 1e4 ? `${count(Math.round(mm2))} mm²` : `${fixed(mm2 / 1e6, 4)} m²`;
}

/** A share: "12.3 %". */
export function percent(ratio: number): string {
  return `${three(ratio * 100)} %`;
}

/** A text in which no line ends between a number and its unit. */
export function unbroken(text: string): string {
  return text.replace(/(\d) (?=(?:s|m|mm|in|ft|km)\b|%)/g, '$1\u00a0');
}

/** Facts in a text, whose lines end only between two of them. */
export function betweenFacts(text: string): string {
  return text.replace(/(?<![·,]) /g, '\u00a0');
}

/** Large counts in a short form: 950, "12.3 thousand", "4.5 million". */
export function short(n: number): string {
  if (n < 10_000) return count(n);
  if (n < 1e6) return words.numbers.thousand(n / 1e3, three);
  return words.numbers.million(n / 1e6, three);
}
