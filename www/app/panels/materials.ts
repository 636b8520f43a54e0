/** The library of materials of the machine: choosing a setting by its name, saving the present values under a name, deleting one. */

import { button, h } from '../core/dom.js';
import type { MachineProfile, MaterialSetting } from 'kerfway';
import type { Session } from '../session/session.js';
import { words } from '../core/words/index.js';
import { field, select } from './section.js';

/** The value of the choice without a material. */
const NONE = '';

export function materials(session: Session): { choice: HTMLElement; root: HTMLElement; show(machine: MachineProfile): void } {
  const chosen = select<string>((name) => session.setMaterial(name === NONE ? null : name), { wide: true });
  const choice = field(words.machine.material, chosen.root);
  const name = h('input', { type: 'text', 'aria-label': words.machine.materialName, placeholder: words.machine.materialName, maxlength: 60 });
  const form = h('form', { class: 'row' }, name, h('button', { type: 'submit', class: 'small' }, words.machine.saveMaterial));
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const { machine } = session.state;
    const title = name.value.trim();
    if (!machine || title === '') return;
    const others = (machine.materials ?? []).filter((m) => m.name.toLowerCase() !== title.toLowerCase());
    session.setMachine({ ...machine, materials: [...others, settingOf(machine, title)] });
    name.value = '';
  });
  const drop = button(words.machine.removeMaterial, { class: 'small', onclick: () => {
    const { machine, material } = session.state;
    if (!machine || material === null) return;
    session.setMachine({ ...machine, materials: (machine.materials ?? []).filter((m) => m.name !== material) });
  } });
  const root = h('details', { class: 'more' }, h('summary', {}, words.machine.materials),
    h('div', { class: 'stack' }, h('p', { class: 'soft' }, words.machine.materialsHint), form, drop));
  const show = (machine: MachineProfile) => {
    const list = machine.materials ?? [];
    const { material } = session.state;
    choice.hidden = list.length === 0;
    drop.hidden = material === null;
    chosen.fill([{ value: NONE, label: words.machine.ownSetting }, ...list.map((m) => ({ value: m.name, label: m.name }))], material ?? NONE);
  };
  return { choice, root, show };
}

/** What the machine is set to now, as a setting of its library. */
function settingOf({ cut, mark, pierce_time, kerf_width }: MachineProfile, name: string): MaterialSetting {
  const values = ({ speed, power, min_power, passes, z_step, air }: MachineProfile['cut']) => (
    { speed, power, ...(min_power ? { min_power } : {}), ...(passes && passes > 1 ? { passes } : {}), ...(z_step ? { z_step } : {}), ...(air ? { air } : {}) });
  return { name, cut: values(cut), mark: values(mark), pierce_time, kerf_width: kerf_width ?? 0 };
}
