/**
 * Builds the page from code: elements, text and inline icons. Text is always added as text nodes, so that nothing from a drawing (names of
 * layers and files, messages) can become markup.
 */

import { ICONS, type IconName } from './icons.js';

type Child = Node | string | null | undefined | false;
type Props = Record<string, unknown>;

/** An element with its class, `on...` listeners and attributes. `true` sets an attribute without a value, `false` sets none; ARIA attributes get the word. */
export function h<K extends keyof HTMLElementTagNameMap>(tag: K, props: Props = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(props)) {
    if (value === undefined || value === null) continue;
    if (name.startsWith('aria-')) element.setAttribute(name, String(value));
    else if (value === false) continue;
    else if (name.startsWith('on')) element.addEventListener(name.slice(2), value as EventListener);
    else if (name === 'class') element.className = String(value);
    else element.setAttribute(name, value === true ? '' : String(value));
  }
  element.append(...children.filter((c): c is Node | string => c !== null && c !== undefined && c !== false));
  return element;
}

/** An icon on a square of 16 units, in the colour of the text around it, hidden from screen readers. */
export function icon(name: IconName): SVGSVGElement {
  const space = 'http://www.w3.org/2000/svg';
  const svg = document.createElementNS(space, 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('class', 'icon');
  svg.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', ICONS[name]);
  svg.append(path);
  return svg;
}

/** A button with an icon, a label, or both. With `iconOnly` the label is the tooltip and the name for screen readers. */
export function button(label: string, props: Props & { icon?: IconName; iconOnly?: boolean } = {}): HTMLButtonElement {
  const { icon: name, iconOnly, ...rest } = props;
  const extra = iconOnly ? { 'aria-label': label, title: label } : {};
  return h('button', { type: 'button', ...extra, ...rest }, name ? icon(name) : null, iconOnly ? null : h('span', {}, label));
}

/** Disables a button while there is a reason for that, which is then its tooltip and its description. */
export function disable(control: HTMLButtonElement, why: string): void {
  control.dataset.usual ??= control.title;
  control.disabled = why !== '';
  control.title = why || control.dataset.usual;
}

/** Sets the text of an element if it differs, so that screen readers and the layout do not notice when it does not. */
export function setText(element: Element, text: string): void {
  if (element.textContent !== text) element.textContent = text;
}

/** Whether the person asked for less motion. */
export function lessMotion(): boolean {
  return matchMedia('(prefers-reduced-motion: reduce)').matches;
}
