/** Numbers for people: seconds, lengths, counts. Measured values have three significant digits, as more would suggest an accuracy they do not have. */

import { words } from './words/index.js';

const grouping = new Intl.NumberFormat(words.numbers.locale, { maximumFractionDigits: 0 });

/** 1234 -> "1,234". */
export function count(n: number): string {
  return grouping.format(n);
}

/** Three significant digits, without an exponent: 0.0123, 1.23, 12.3, 123, 1,230. */
export function three(x: number): string {
  const size = Math.abs(x);
  if (size < 5e-4) return '0';
  if (size >= 999.5) return grouping.format(Number(x.toPrecision(3)));
  const decimals = Math.min(3, Math.max(0, 2 - Math.floor(Math.log10(size))));
  return x.toFixed(decimals);
}

/** Job time: "0.42 s", "42.3 s", "627 s", "16 min 40 s", "1 h 23 min". */
export function seconds(s: number): string {
  if (!Number.isFinite(s)) return '–';
  if (Math.abs(s) < 999.5) return `${three(s)} s`;
  const sign = s < 0 ? '-' : '';
  const whole = Math.round(Math.abs(s));
  if (whole < 3600) return `${sign}${Math.floor(whole / 60)} min ${String(whole % 60).padStart(2, '0')} s`;
  const minutes = Math.round(whole / 60);
  return `${sign}${count(Math.floor(minutes / 60))} h ${String(minutes % 60).padStart(2, '0')} min`;
}

/** Job time in a narrow column, where it is compared with others: "627 s", "16:40", "1:23:07". */
export function narrow(s: number): string {
  if (Math.abs(s) < 999.5) return seconds(s);
  const whole = Math.round(s);
  return whole < 3600 ? `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}` : clock(whole);
}

/** A time within the job: "1:23.4", "1:02:03". */
export function clock(s: number): string {
  const t = Math.max(0, s);
  if (t >= 3600) {
    const whole = Math.floor(t);
    const parts = [Math.floor(whole / 60) % 60, whole % 60].map((n) => String(n).padStart(2, '0'));
    return `${Math.floor(whole / 3600)}:${parts.join(':')}`;
  }
  const tenths = Math.floor(t * 10 + 1e-6);
  return `${Math.floor(tenths / 600)}:${String(Math.floor(tenths / 10) % 60).padStart(2, '0')}.${tenths % 10}`;
}

/** A length in mm as metres: "2.76 m"; from 10 km on as kilometres. */
export function metres(mm: number): string {
  if (mm >= 1e7) return `${three(mm / 1e6)} km`;
  return `${three(mm / 1000)} m`;
}

/** A length on the sheet: "44.2 mm"; above 10 m in metres. */
export function millimetres(mm: number): string {
  return mm >= 10_000 ? metres(mm) : `${three(mm)} mm`;
}

/** A length on the sheet, to a tenth: "1000", "297.5". */
export function size(mm: number): string {
  if (Math.abs(mm) < 1) return three(mm);
  return String(Math.round(mm * 10) / 10);
}

/** "1000 × 500 mm"; from 10 m on in metres. */
export function extent(width: number, height: number): string {
  if (Math.max(width, height) >= 10_000) return `${three(width / 1000)} × ${three(height / 1000)} m`;
  return `${size(width)} × ${size(height)} mm`;
}

/** A share: "12.3 %". */
export function percent(ratio: number): string {
  return `${three(ratio * 100)} %`;
}

/** Large counts in a short form: 950, "12.3 thousand", "4.5 million". */
export function short(n: number): string {
  if (n < 10_000) return count(n);
  if (n < 1e6) return words.numbers.thousand(three(n / 1e3));
  return words.numbers.million(three(n / 1e6));
}
