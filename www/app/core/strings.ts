/** Sentences that depend on a state, units and operations in the order of their lists, names of files. */

import { count, POINT } from './format.js';
import { inChosenUnit, lengthsIn } from './lengths.js';
import { language, translated, words } from './words/index.js';
import { type ConfidenceReason, type DoneReason, type Finding, isKerfwayError, type KerfwayError, type MachineProfile, type MethodInfo, type Operation, type Unit, type UnitsTaken } from 'kerfway';

/** Millimetres in a unit. */
export const UNIT_SIZES: Record<Unit, number> = {
  mm: 1, in: 25.4, cm: 10, m: 1000, dm: 100, um: 0.001, ft: 304.8, yd: 914.4, mil: 0.0254, microinch: 2.54e-5, px: 25.4 / 96,
};

export const OPERATIONS: readonly Operation[] = ['cut', 'mark', 'ignore'];

/** From this many seconds without an improvement, rounded, the page says that nothing better is found. */
const QUIET = 1;

/** Why a search ended. `quiet`: seconds since its last improvement. */
export function doneSentence(reason: DoneReason | null, quiet: number): string {
  if (reason !== null && reason !== 'budget') return words.dock.done[reason];
  const whole = Math.round(quiet);
  return whole < QUIET ? words.dock.improving : words.dock.quiet(whole === 1 ? words.dock.second : `${count(whole)} s`);
}

/** The sentence of an error that the planner or the browser has thrown. */
export function messageOf(error: unknown): string {
  if (typeof error === 'string') return error;
  if (isKerfwayError(error)) return ofCode(error);
  // What browsers say of a module that they cannot load is its address.
  if (error instanceof TypeError && /\bmodule\b/i.test(error.message)) return words.page.noPart;
  const message = error instanceof Error ? error.message : null;
  return message || words.page.somethingElse;
}

/** The planner's own sentence; where the language has none, that of its code, with the planner's behind it unless that of the code names what it is about. */
function ofCode({ code, message, params }: KerfwayError): string {
  const translation = inOwnWords(message);
  if (translation !== null) return translation;
  const own = inChosenUnit(message);
  const say = Object.entries(words.errors ?? {}).find(([known]) => known === code)?.[1];
  if (say === undefined) return own;
  let named = false;
  const sentence = say((name) => {
    named = true;
    return [params[name] ?? ''].flat().join(', ');
  });
  return named ? sentence : `${sentence} (${own})`;
}

/** What a finding says. `detail`: the planner's sentence, in English, where the page is in another language that has no sentence of its own for it. */
export function sentenceOf({ code, message, count: n }: Finding): { text: string; detail: string | null } {
  const sentence = inOwnWords(message);
  return sentence === null ? { text: words.findingTitles[code](n, count(n)), detail: inChosenUnit(message) } : { text: sentence, detail: null };
}

/** Why the planner takes the drawing's unit. */
export const reasonOf = ({ reason }: UnitsTaken): string => inOwnWords(reason) ?? inChosenUnit(reason);

/** What a method does. */
export const aboutMethod = ({ about }: MethodInfo): string => inOwnWords(about) ?? about;

/** Why the figures of a quote are not sure. */
export function doubtOf({ message, finding, count: n }: ConfidenceReason): string {
  return inOwnWords(message) ?? (finding === null ? inChosenUnit(message) : `${words.findingTitles[finding](n, count(n))}.`);
}

/** A sentence of the planner about a drawing in the language of the page; null where that has none. */
function inOwnWords(message: string): string | null {
  if (language === 'en') return inChosenUnit(message);
  const sentence = translated(message);
  return sentence === null ? null : inChosenUnit(sentence).replace(lengthsIn('(?:mm|in|m)'), (lengths) => lengths.replaceAll('.', POINT));
}

/** The name of a download: file, machine and date, as in "plate-co2-100w-2026-03-01.nc". */
export function downloadName({ name, machine }: { name: string; machine: MachineProfile | null }, suffix: string, date = new Date()): string {
  const day = [date.getFullYear(), date.getMonth() + 1, date.getDate()].map((n) => String(n).padStart(2, '0')).join('-');
  return [baseName(name), machine?.name, day].filter(Boolean).join('-') + suffix;
}

/** "drawing.dxf" -> "drawing". */
export function baseName(name: string): string {
  return name.replace(/\.[^.]*$/, '') || 'plan';
}
