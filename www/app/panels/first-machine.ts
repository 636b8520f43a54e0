/** The first choice: which machine cuts. It is asked once, and the answer stays in this browser. */

import { button, h } from '../core/dom.js';
import { leave } from '../core/refill.js';
import { words } from '../core/words/index.js';
import { rememberMachine, rememberedMachine } from '../session/profiles.js';
import type { Session } from '../session/session.js';
import { select } from './section.js';

export function firstMachine(session: Session): HTMLElement {
  const choice = select<string>((name) => {
    const chosen = session.catalog.machines.find((m) => m.name === name);
    if (chosen) session.setMachine(structuredClone(chosen));
  }, { wide: true });
  choice.list.setAttribute('aria-label', words.machine.which);
  let isAnswered = rememberedMachine() !== null;
  const keep = button(words.machine.keep, { class: 'small', onclick: () => {
    const { machine } = session.state;
    if (machine && !rememberMachine(machine.name)) session.store.notify(words.page.nothingKept);
    isAnswered = true;
    leave(keep);
    show();
  } });
  const root = h('section', { class: 'first-machine' }, h('p', {}, words.machine.which), choice.root, keep);
  const show = () => {
    const { machine, phase } = session.state;
    // It has its place before the machines are known, so that the sections below stay where they are.
    root.hidden = isAnswered || (machine === null && phase === 'failed');
    choice.list.disabled = keep.disabled = machine === null;
    if (machine) choice.fill(session.catalog.machines.map((m) => ({ value: m.name, label: m.title })), machine.name);
  };
  session.store.on('change', show);
  show();
  return root;
}
