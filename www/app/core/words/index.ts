/** The words of the page in the first of the browser's languages that the page has, otherwise in English. */

import { en } from './en.js';

/** The words of a language. */
export type Words = typeof en;

/** The languages by their codes. */
const LANGUAGES: Readonly<Record<string, Words>> = { en };

const wanted = navigator.languages.map((language) => language.split('-')[0] ?? '').find((code) => Object.hasOwn(LANGUAGES, code));

export const words: Words = LANGUAGES[wanted ?? 'en'] ?? en;
document.documentElement.lang = words.numbers.locale;
