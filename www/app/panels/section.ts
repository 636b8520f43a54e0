/** A section of the right panel: a heading that opens and closes it, with a summary in a few words beside it; and the controls in it. */

import { h, setText } from '../core/dom.js';
import { shownIn } from '../core/lengths.js';
import { messageOf } from '../core/strings.js';

export interface Section {
  root: HTMLDetailsElement;
  body: HTMLElement;
  /** Sets the summary in the heading, coloured as findings of that severity are. */
  setGist(text: string, severity?: 'warning' | 'error' | ''): void;
}

export function section(title: string, open: boolean): Section {
  const gist = h('span', { class: 'gist' });
  const body = h('div', { class: 'section-body' });
  const root = h('details', { class: 'section', open }, h('summary', {}, h('h2', {}, title), gist), body);
  const setGist = (text: string, severity = '') => {
    setText(gist, text);
    gist.className = `gist ${severity}`;
  };
  return { root, body, setGist };
}

/** Details whose content is loaded when they are opened. `failed` gets the reason if it cannot be. */
export function laterDetails(title: string, load: () => Promise<HTMLElement>, failed: (sentence: string) => void): HTMLElement {
  const root = h('details', { class: 'more' }, h('summary', {}, title));
  fillWhenOpened(root, async () => root.append(await load()), failed);
  return root;
}

/** A closed section whose content is loaded when it is opened. `failed`: as above. `open` opens it, and resolves when its content is there. */
export function laterSection(title: string, load: (section: Section) => Promise<HTMLElement>, failed: (sentence: string) => void): Section & { open(): Promise<void> } {
  const made = section(title, false);
  const filled = fillWhenOpened(made.root, async () => made.body.append(await load(made)), failed);
  const open = () => {
    made.root.open = true;
    return filled();
  };
  return { ...made, open };
}

/** Returns what fills the details, once: it resolves when the content is there. */
function fillWhenOpened(root: HTMLDetailsElement, fill: () => Promise<void>, failed: (sentence: string) => void): () => Promise<void> {
  let content: Promise<void> | null = null;
  const filled = () => (content ??= fill().catch((error) => {
    content = null;
    root.open = false;
    failed(messageOf(error));
  }));
  root.addEventListener('toggle', () => {
    if (root.open) void filled();
  });
  return filled;
}

/** A label above or beside its control. `unit`: that of the value; a length is shown in the unit that the person has chosen. */
export function field(label: string, control: HTMLElement, unit?: string): HTMLLabelElement {
  return h('label', { class: 'field' }, h('span', { class: 'field-label' }, label), h('span', { class: 'field-control' }, control, unit !== undefined ? h('span', { class: 'unit' }, shownIn(unit).unit) : null));
}

/** A checkbox with its label. `bar` says below it why it cannot be switched on; with an empty reason it can be. */
export function check(label: string, onChange: (on: boolean) => void): { root: HTMLElement; input: HTMLInputElement; bar(why: string): void } {
  const input = h('input', { type: 'checkbox' });
  input.addEventListener('change', () => onChange(input.checked));
  const { root: reason, bar } = barrier(input);
  return { root: h('div', {}, h('label', { class: 'check' }, input, h('span', {}, label)), reason), input, bar };
}

/** Disables a control while there is a reason for that, and shows the reason. To screen readers it is the description of the control. */
export function barrier(control: HTMLInputElement | HTMLSelectElement): { root: HTMLElement; bar(why: string): void } {
  const root = h('p', { class: 'soft reason', 'aria-hidden': true });
  const bar = (why: string) => {
    root.hidden = !why;
    control.disabled = Boolean(why);
    setText(root, why);
    control.setAttribute('aria-description', why);
  };
  bar('');
  return { root, bar };
}

interface Option<T> {
  value: T;
  label: string;
}

/**
 * A choice from a list. Further options can follow in groups, each with a heading. `wide`: the names are long, so the list is as wide as the panel, and
 * the chosen name is written over it, because browsers cut it off where it needs a second line.
 */
export function select<T extends string | number>(onChange: (value: T) => void, { wide = false } = {}): { root: HTMLElement; list: HTMLSelectElement; fill(options: Option<T>[], chosen: T, groups?: Record<string, Option<T>[]>): void } {
  const list = h('select');
  const name = h('span', { 'aria-hidden': true });
  const root = wide ? h('span', { class: 'wide' }, list, name) : list;
  let values: T[] = [];
  let shown = '';
  list.addEventListener('change', () => {
    const value = values[list.selectedIndex];
    if (value !== undefined) onChange(value);
  });
  return {
    root,
    list,
    fill(options, chosen, groups = {}) {
      values = [...options, ...Object.values(groups).flat()].map((o) => o.value);
      const now = JSON.stringify([options, groups]);
      const item = (o: Option<T>) => h('option', { value: o.value }, o.label);
      const headed = Object.entries(groups).filter(([, list]) => list.length > 0);
      if (now !== shown) list.replaceChildren(...options.map(item), ...headed.map(([label, group]) => h('optgroup', { label }, ...group.map(item))));
      shown = now;
      list.selectedIndex = values.indexOf(chosen);
      setText(name, list.selectedOptions[0]?.text ?? '');
    },
  };
}
