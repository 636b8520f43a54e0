/** The menu for the language of the page and the unit of lengths. A change reloads the page; the job stays as it was. On a phone it also holds what the top bar has no room for. */

import { button, h } from '../core/dom.js';
import { keep } from '../core/kept.js';
import { LENGTH_KEY, lengthUnit } from '../core/lengths.js';
import { menuItem, popover } from '../core/menu.js';
import type { Theme } from '../core/theme.js';
import { language, LANGUAGE_KEY, LANGUAGES, words } from '../core/words/index.js';
import type { TopActions } from './topbar.js';

/** `refused` is called where the browser does not keep the choice. */
export function settingsMenu(theme: Theme, { restart, notKept: refused, help }: Pick<TopActions, 'restart' | 'notKept' | 'help'>): [opener: HTMLElement, menu: HTMLElement] {
  const w = words.settings;
  const opener = button(w.title, { icon: 'globe', iconOnly: true, class: 'quiet settings' });
  const choose = (key: string, value: string, now: string) => {
    if (value === now) return;
    if (keep(key, value)) restart();
    else refused();
  };
  const languages = Object.entries(LANGUAGES).map(([code, name]) => {
    const item = menuItem(name, null, code === language, () => choose(LANGUAGE_KEY, code, language));
    item.lang = code;
    return item;
  });
  const lengths = (['mm', 'in'] as const).map((unit) => menuItem(w.units[unit], null, unit === lengthUnit, () => choose(LENGTH_KEY, unit, lengthUnit)));
  const list = h('div', { class: 'menu rows-only' },
    h('p', { class: 'menu-note' }, w.language), ...languages, w.draft && h('p', { class: 'menu-note' }, w.draft),
    h('p', { class: 'menu-note' }, w.lengths), ...lengths);
  const more = h('div', { class: 'menu menu-more' });
  const fill = () => {
    more.hidden = !matchMedia('(max-width: 719px)').matches;
    more.replaceChildren(...(more.hidden ? [] : [menuItem(otherTheme(theme), null, false, () => theme.toggle()), menuItem(words.top.help, null, false, help)]));
  };
  return [opener, popover(opener, w.title, h('div', {}, list, more), fill)];
}

/** What the switch of the theme does now. */
export function otherTheme({ current }: Theme): string {
  return current === 'dark' ? words.top.light : words.top.dark;
}
