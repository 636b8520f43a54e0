/** The levers of the machine: abilities that make jobs shorter. */

import { h } from '../core/dom.js';
import type { MachineProfile } from 'kerfway';
import { words } from '../core/words/index.js';
import { check, field, numberInput } from './section.js';

/** The limit is that of machine profiles. */
const MOST = 100;
/** mm: what 1 mm sheet needs at 3 kW until the beam is through, with a margin. */
const OVERCUT = 0.5;

export interface LeversPanel {
  root: HTMLElement;
  show(machine: MachineProfile): void;
}

export function leversPanel(edit: (change: (m: MachineProfile) => void) => void): LeversPanel {
  const w = words.levers;
  const set = (overcut: number | null) => edit((m) => {
    if (overcut === null) delete m.levers;
    else m.levers = { ...m.levers, moving_pierce: { overcut } };
  });
  const moving = check(w.moving, (on) => set(on ? OVERCUT : null));
  const { input, show } = numberInput({ unit: 'mm', least: 0, most: MOST }, set);
  const more = h('div', { class: 'stack' }, field(w.overcut, input, 'mm'), h('p', { class: 'soft' }, w.about));
  return {
    root: h('div', { class: 'stack' }, moving.root, more),
    show({ levers, pre_cut_time }) {
      const lever = levers?.moving_pierce;
      moving.input.checked = Boolean(lever);
      // A machine that leaves contours unfinished pierces at rest.
      moving.input.disabled = !lever && typeof pre_cut_time === 'number';
      more.hidden = !lever;
      show(lever?.overcut ?? 0);
    },
  };
}
