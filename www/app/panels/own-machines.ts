/** A person's own machines: kept under a name, forgotten, saved to a file, taken from one. */

import { button, h } from '../core/dom.js';
import { choose, save } from '../core/files.js';
import { messageOf } from '../core/strings.js';
import type { MachineProfile } from 'kerfway';
import { asFile, forget, fromFile, keep, kept, named } from '../session/profiles.js';
import type { Session } from '../session/session.js';

export function ownMachines(session: Session, tell: (sentence: string) => void): { root: HTMLElement; show(machine: MachineProfile): void } {
  const name = h('input', { type: 'text', 'aria-label': 'Name of your machine', placeholder: 'Name of your machine', maxlength: 60 });
  const take = (profile: MachineProfile) => {
    if (!keep(profile)) tell('This browser keeps nothing: export the machine to a file instead.');
    session.setMachine(structuredClone(profile));
  };
  const form = h('form', { class: 'row' }, name, h('button', { type: 'submit', class: 'small' }, 'Keep'));
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const { machine } = session.state;
    const title = name.value.trim();
    if (machine && title) take(named(machine, title));
    name.value = '';
  });
  const drop = button('Forget', { class: 'small', onclick: () => {
    const { machine } = session.state;
    const [first] = session.machines;
    if (machine) forget(machine.name);
    if (first) session.setMachine(structuredClone(first));
  } });
  const out = button('Export', { class: 'small', onclick: () => {
    const { machine } = session.state;
    if (machine) save(asFile(machine), `${machine.name}.machine.json`, 'application/json');
  } });
  const into = button('Import', { class: 'small', onclick: () => choose((file) => {
    file.text().then((text) => take(fromFile(text))).catch((error: unknown) => tell(messageOf(error)));
  }, '.json,application/json') });
  const root = h('details', { class: 'more' }, h('summary', {}, 'Your machines'),
    h('div', { class: 'stack' }, form, h('div', { class: 'row' }, out, into, drop)));
  return { root, show: (machine) => (drop.hidden = !kept().some((m) => m.name === machine.name)) };
}
