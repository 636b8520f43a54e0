/** The words of the page in the language of whoever reads it, English where there are none in it. */

import { en } from './en.js';

/** What a language has to say. */
export type Words = typeof en;

/** By the code of the language. */
const LANGUAGES: Readonly<Record<string, Words>> = { en };

const wanted = navigator.languages.map((language) => language.split('-')[0] ?? '').find((code) => Object.hasOwn(LANGUAGES, code));

export const words: Words = LANGUAGES[wanted ?? 'en'] ?? en;
document.documentElement.lang = words.numbers.locale;
