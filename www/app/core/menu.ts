/**
 * Menus and small panels that open below a button. They are native popovers, so the browser handles Escape, a click elsewhere and the top
 * layer.
 */

import { h } from './dom.js';

/** Pixels between a popover and the edge of the window. */
const EDGE = 8;

let made = 0;

/** Opens `content` below `opener`. `fill` runs before it opens. Returns the popover, which the caller adds to the page. */
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

/** One entry of a menu: a title, and a description. */
export function menuItem(title: string, about: string | null, chosen: boolean, onChoose: () => void): HTMLButtonElement {
  const item = h('button', { type: 'button', class: 'menu-item', 'aria-current': chosen ? 'true' : undefined },
    h('span', { class: 'menu-title' }, title), about ? h('span', { class: 'soft' }, about) : null);
  item.addEventListener('click', (event) => {
    item.closest<HTMLElement>('[popover]')?.hidePopover();
    // After a choice by keyboard the focus returns to the opener; after a click the keys act on the stage again.
    if (event.detail > 0 && document.activeElement instanceof HTMLElement) document.activeElement.blur();
    onChoose();
  });
  return item;
}
