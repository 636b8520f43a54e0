/** A person's own machines: saving under a name, deleting, exporting to a file, importing from one. */

import { button, h } from '../core/dom.js';
import { choose, save } from '../core/files.js';
import { messageOf } from '../core/strings.js';
import type { MachineProfile } from 'kerfway';
import { asFile, deleteMachine, fromFile, named, savedMachines, saveMachine, withOwnName } from '../session/profiles.js';
import type { Session } from '../session/session.js';
import { words } from '../core/words/index.js';

export function ownMachines(session: Session, notify: (sentence: string) => void): { root: HTMLElement; show(machine: MachineProfile): void } {
  const name = h('input', { type: 'text', 'aria-label': words.machine.name, placeholder: words.machine.name, maxlength: 60 });
  const take = (profile: MachineProfile) => {
    if (!saveMachine(profile)) notify(words.machine.notSaved);
    session.setMachine(structuredClone(profile));
  };
  const form = h('form', { class: 'row' }, name, h('button', { type: 'submit', class: 'small' }, words.machine.save));
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const { machine } = session.state;
    const title = name.value.trim();
    if (machine && title) take(named(machine, title));
    name.value = '';
  });
  const drop = button(words.machine.remove, { class: 'small', onclick: () => {
    const { machine } = session.state;
    const [first] = session.catalog.machines;
    if (machine) deleteMachine(machine.name);
    if (first) session.setMachine(structuredClone(first));
  } });
  const out = button(words.machine.export, { class: 'small', onclick: () => {
    const { machine } = session.state;
    if (machine) save(asFile(machine), `${machine.name}.machine.json`, 'application/json');
  } });
  const into = button(words.machine.import, { class: 'small', onclick: () => choose(([file]) => {
    if (file === undefined) return;
    file.text().then((text) => take(withOwnName(fromFile(text)))).catch((error: unknown) => notify(messageOf(error)));
  }, { accept: '.json,application/json' }) });
  const root = h('details', { class: 'more' }, h('summary', {}, words.machine.own),
    h('div', { class: 'stack' }, form, h('div', { class: 'row' }, out, into, drop)));
  return { root, show: (machine) => (drop.hidden = !savedMachines().some((m) => m.name === machine.name)) };
}
