/**
 * Decimal commas in number fields. Browsers drop a comma that their own language does not use: 0,15 became 015. Where the language of the page or
 * one of the person's languages has decimal commas, a comma becomes a point, which every browser takes.
 */

import { words } from './words/index.js';

export function takeDecimalCommas(): void {
  const hasCommas = (language: string) => new Intl.NumberFormat(language).format(0.5).includes(',');
  if (![words.numbers.locale, ...navigator.languages].some(hasCommas)) return;
  addEventListener('beforeinput', (event) => {
    const { target, data } = event;
    if (!(target instanceof HTMLInputElement) || target.type !== 'number' || !data?.includes(',')) return;
    event.preventDefault();
    // Of several signs, as in "1.234,5" and "1,234.5", which are pasted, the last one is before the decimals.
    const [, whole = '', decimals = ''] = /^(.*)[.,](.*)$/.exec(data) ?? [];
    document.execCommand('insertText', false, `${whole.replace(/[.,]/g, '')}.${decimals}`);
  });
}
