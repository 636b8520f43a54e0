/** Formats numbers for people. */

import type { Summary } from './protocol.js';

/** A number with some decimals; "under 0.01" and the like for what they do not show, so that only 0 is 0. */
export function fixed(n: number, decimals: number): string {
  const text = n.toFixed(decimals);
  return n > 0 && Number(text) === 0 ? `under ${(10 ** -decimals).toFixed(decimals)}` : text;
}

/** A length given in mm, in metres. */
export function meters(mm: number): string {
  return `${fixed(mm / 1000, 3)} m`;
}

/** A time given in seconds: "42.3 s", from two minutes on "16 min 40 s", from two hours on "3 h 04 min". */
export function duration(s: number): string {
  if (s < 119.95) return `${fixed(s, 1)} s`;
  return s < 7199.5 ? inSixties(s, 'min', 's') : inSixties(s / 60, 'h', 'min');
}

/** A number of small units, of which sixty make a large one. */
function inSixties(small: number, largeUnit: string, smallUnit: string): string {
  const whole = Math.round(small);
  return `${Math.floor(whole / 60)} ${largeUnit} ${String(whole % 60).padStart(2, '0')} ${smallUnit}`;
}

/** A ratio in per cent, with two decimals below one per cent. */
export function percent(share: number): string {
  return `${(100 * share).toFixed(share < 0.01 ? 2 : 1)} %`;
}

/** The seconds that a search took: below one second in whole milliseconds, of which there is at least one. */
export function elapsed(s: number): string {
  return s < 0.9995 ? `${Math.max(1, Math.round(s * 1000))} ms` : `${s.toFixed(1)} s`;
}

/** A ratio that is not exceeded: the same, rounded up, so that 0.000001 is "0.01 %". */
export function percentAtMost(share: number): string {
  const parts = share < 0.01 ? 1e4 : 1e3;
  return percent(Math.ceil(share * parts) / parts);
}

/** Width and height of a box in mm. */
export function size([x0, y0, x1, y1]: [number, number, number, number]): string {
  return `${fixed(x1 - x0, 1)} x ${fixed(y1 - y0, 1)} mm`;
}

export function plural(n: number, word: string): string {
  return `${n} ${word}${n === 1 ? '' : 's'}`;
}

/** What skeleton cuts add to a job, of a plan or a quote. */
export function skeletonLines({ skeleton_cuts, skeleton_length = 0, skeleton_time = 0 }: Partial<Pick<Summary, 'skeleton_cuts' | 'skeleton_length' | 'skeleton_time'>>): string[] {
  return skeleton_cuts ? [`Skeleton   ${plural(skeleton_cuts, 'cut')} at the end: ${duration(skeleton_time)}, ${meters(skeleton_length)}`] : [];
}

/** A small length, in mm. */
export function millimetres(mm: number): string {
  return `${fixed(mm, 2)} mm`;
}

/** An area given in mm2; from 100 cm2 on in square metres, below 10 mm2 with decimals. */
export function area(mm2: number): string {
  return mm2 < 1e4 ? `${fixed(mm2, mm2 < 10 ? 2 : 0)} mm²` : `${(mm2 / 1e6).toFixed(4)} m²`;
}

/** A weight given in grams; from a kilogram on in kilograms, below 10 g with decimals. */
export function grams(g: number): string {
  return g < 1000 ? `${fixed(g, g < 10 ? 2 : 0)} g` : `${(g / 1000).toFixed(2)} kg`;
}

/** A unit, with the resolution of pixels. */
export function unitOf({ unit, dpi }: { unit: string; dpi: number | null }): string {
  return dpi === null ? unit : `${unit} at ${dpi} dpi`;
}
