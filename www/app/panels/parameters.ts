/** The parameters of a method from a paper, behind a disclosure. They start with the values of the paper. Loaded with the first such method. */

import { button, h } from '../core/dom.js';
import type { PaperMethod } from 'kerfway';
import type { Session } from '../session/session.js';
import { CHOICES } from './parameter-choices.js';
import { check, field, select } from './section.js';
import { words } from '../core/words/index.js';

/** The control that sets a parameter. */
interface Control {
  root: HTMLElement;
  show(value: unknown): void;
}

export function parameters(session: Session): { root: HTMLElement; show(method: PaperMethod | undefined): void } {
  const controls = h('div', { class: 'stack' });
  const root = h('details', { class: 'more', hidden: true }, h('summary', {}, words.plan.parameters), controls);
  let shown: PaperMethod | undefined;
  let all: [string, Control][] = [];
  const set = (name: string, value: unknown) => session.setSearch({ parameters: { ...session.state.search.parameters, [name]: value } }, true);
  const show = (method: PaperMethod | undefined) => {
    root.hidden = method === undefined;
    if (method === undefined) return;
    if (shown?.name !== method.name) {
      shown = method;
      all = Object.entries(method.parameters).map(([name, value]) => [name, control(name, value, (to) => set(name, to))]);
      const back = button(words.plan.paperValues, { class: 'small', onclick: () => session.setSearch({ parameters: {} }) });
      controls.replaceChildren(...all.map(([, c]) => c.root), back);
    }
    const now = { ...method.parameters, ...session.state.search.parameters };
    for (const [name, c] of all) c.show(now[name]);
  };
  return { root, show };
}

function control(name: string, initial: unknown, set: (value: unknown) => void): Control {
  const label = name.replaceAll('_', ' ').replace(/^./, (c) => c.toUpperCase());
  if (typeof initial === 'boolean') {
    const { root, input } = check(label, set);
    return { root, show: (value) => (input.checked = value === true) };
  }
  const choices = typeof initial === 'string' ? CHOICES[name] : undefined;
  if (choices !== undefined) {
    const { root, fill } = select<string>(set);
    return { root: field(label, root), show: (value) => fill(choices.map((c) => ({ value: c, label: c })), String(value)) };
  }
  const input = h('input', { type: 'number', step: 'any', inputmode: 'decimal', placeholder: initial === null ? words.plan.noValue : '' });
  input.addEventListener('input', () => {
    if (!Number.isNaN(input.valueAsNumber)) set(input.valueAsNumber);
    else if (initial === null && input.value === '') set(null);
  });
  const show = (value: unknown) => {
    if (document.activeElement !== input) input.value = value === null ? '' : String(value);
  };
  return { root: field(label, input), show };
}
