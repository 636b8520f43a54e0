/**
 * Menus and small panels that open under a button: native popovers, so Escape, a click elsewhere and the top layer
 * come from the browser.
 */

import { h } from './dom.js';

/** Pixels kept between a popover and the edge of the window. */
const EDGE = 8;

let made = 0;

/** Makes `content` open under `opener`; `fill` runs before each opening. Returns the popover, to be put in the page. */
export function popover(opener: HTMLButtonElement, label: string, content: HTMLElement, fill?: () => void): HTMLElement {
  made += 1;
  const panel = h('div', { id: `popover-${made}`, class: 'popover', popover: 'auto', role: 'group', 'aria-label': label }, content);
  opener.setAttribute('popovertarget', panel.id);
  opener.setAttribute('aria-expanded', 'false');
  panel.addEventListener('beforetoggle', (event) => {
    if ((event as ToggleEvent).newState === 'open') fill?.();
  });
  panel.addEventListener('toggle', (event) => {
    const open = (event as ToggleEvent).newState === 'open';
    opener.setAttribute('aria-expanded', String(open));
    if (!open) return;
    const at = opener.getBoundingClientRect();
    const left = Math.max(EDGE, Math.min(at.left, innerWidth - panel.offsetWidth - EDGE));
    panel.style.left = `${left}px`;
    panel.style.top = `${at.bottom + 4}px`;
    panel.style.maxHeight = `${innerHeight - at.bottom - 4 - EDGE}px`;
    panel.querySelector<HTMLElement>('button, input')?.focus();
  });
  panel.addEventListener('keydown', (event) => {
    if (event.key !== 'ArrowDown' && event.key !== 'ArrowUp') return;
    const items = [...panel.querySelectorAll<HTMLElement>('button')];
    const at = items.indexOf(document.activeElement as HTMLElement);
    if (at < 0) return;
    event.preventDefault();
    items[(at + (event.key === 'ArrowDown' ? 1 : items.length - 1)) % items.length]?.focus();
  });
  return panel;
}

/** One line of a menu: a title, and what it is about. */
export function menuItem(title: string, about: string | null, chosen: boolean, onChoose: () => void): HTMLButtonElement {
  const item = h('button', { type: 'button', class: 'menu-item', 'aria-current': chosen ? 'true' : undefined },
    h('span', { class: 'menu-title' }, title), about ? h('span', { class: 'soft' }, about) : null);
  item.addEventListener('click', (event) => {
    item.closest<HTMLElement>('[popover]')?.hidePopover();
    // The keyboard goes on from the opener; after a click, keys belong to the stage again.
    if (event.detail > 0 && document.activeElement instanceof HTMLElement) document.activeElement.blur();
    onChoose();
  });
  return item;
}
