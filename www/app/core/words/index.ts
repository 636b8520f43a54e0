/**
 * The words of the page. The language is the one that the person has chosen here, otherwise the first of the browser's languages that the page has,
 * otherwise English. English is part of the page; another language is a file of its own that is loaded before anything is built.
 */

import { kept } from '../kept.js';
import type { ErrorCode, ReportWords } from 'kerfway';
import { en } from './en.js';
import type { Sentences } from './sentences.js';

/** The codes of errors that reach the page; the others are those of the command line and the service. */
type PageError = Exclude<ErrorCode, 'wrong-usage' | 'unreadable-file' | 'unwritable-output' | 'busy' | 'stopping' | 'unauthorized' | 'not-found' | 'method-not-allowed' | 'unsupported-media-type' | 'malformed-form' | 'slow-upload' | 'queue-unavailable'>;

/** What went wrong, by the code of the planner's error. `value` gives what the planner's own sentence names. */
type Errors = Record<PageError, (value: (name: string) => string) => string>;

/** The words of a language other than English, for which the planner's own sentences about errors serve. */
export type Words = typeof en & { errors: Errors; report: ReportWords; sentences: Sentences };

/** The languages by their codes, each under its own name. */
export const LANGUAGES = { en: 'English', de: 'Deutsch', es: 'Español', zh: '简体中文', ja: '日本語' } as const;
export type Language = keyof typeof LANGUAGES;

/** Where the choice is kept. */
export const LANGUAGE_KEY = 'kerfway.language';

const LOADED: Record<Exclude<Language, 'en'>, () => Promise<Words>> = {
  de: async () => (await import('./de.js')).de,
  es: async () => (await import('./es.js')).es,
  zh: async () => (await import('./zh.js')).zh,
  ja: async () => (await import('./ja.js')).ja,
};

const codes = Object.keys(LANGUAGES) as Language[];
const spoken = navigator.languages.map((language) => language.split('-')[0]);
const wanted = kept(LANGUAGE_KEY, codes) ?? spoken.map((code) => codes.find((c) => c === code)).find((code) => code !== undefined) ?? 'en';

// Without a network, a language that was never used before is not there, and the page is in English.
export const words: typeof en & Partial<Pick<Words, 'errors' | 'report' | 'sentences'>> = wanted === 'en' ? en : await LOADED[wanted]().catch((): typeof en => en);

const patterns = words === en ? null : await import('./sentences.js').catch(() => null);

/** A sentence of the planner in the language of the page; null where there is none, and in English. */
export const translated = (sentence: string): string | null => patterns?.translated(words as Words, sentence) ?? null;

/** The language of the page. */
export const language: Language = words === en ? 'en' : wanted;
document.documentElement.lang = words.numbers.locale;
