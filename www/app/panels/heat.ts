/** Heat: how far from each other cuts have to be, in place or in time, and which holes come first in thick plate. */

import { h } from '../core/dom.js';
import type { Heat, MachineProfile } from 'kerfway';
import { words } from '../core/words/index.js';
import { obstacle } from './exclusions.js';
import { type Measure, numberInput } from './number-input.js';
import { check, field } from './section.js';

type Name = 'distance' | 'seconds' | 'charge' | 'thickness' | 'ratio';

/** The limits are those of machine profiles, and what an empty field stands for is what a profile without the value means. */
const QUANTITIES: readonly (Measure & { name: Name })[] = [
  { name: 'distance', unit: 'mm', least: 0, most: 500 },
  { name: 'seconds', unit: 's', least: 0, most: 600 },
  { name: 'charge', unit: 's', least: 0, most: 600, empty: -1 },
  { name: 'thickness', unit: 'mm', least: 0.1, most: 300, empty: 0 },
  { name: 'ratio', unit: '', least: 0.1, most: 20 },
];

export interface HeatPanel {
  root: HTMLElement;
  show(machine: MachineProfile): void;
}

/** `set` changes the heat of the machine; null switches it off. */
export function heatPanel(set: (change: ((heat: Heat) => void) | null) => void): HeatPanel {
  const w = words.heat;
  const on = check(w.title, (checked) => set(checked ? () => undefined : null));
  const empty: Partial<Record<Name, string>> = { charge: w.noCharge, thickness: w.noThickness };
  const inputs = QUANTITIES.map((q) => {
    const { input, show } = numberInput({ ...q, placeholder: empty[q.name] }, (value) => set((heat) => change(heat, q.name, value)));
    return { q, show, row: field(w[q.name], input, q.unit) };
  });
  const more = h('div', { class: 'stack' }, ...inputs.map((i) => i.row), h('p', { class: 'soft' }, w.about));
  return {
    root: h('div', { class: 'stack' }, on.root, more),
    show(machine) {
      const heat = machine.levers?.heat;
      on.input.checked = Boolean(heat);
      on.bar(obstacle(machine, 'heat'));
      more.hidden = !heat;
      if (!heat) return;
      for (const { q, show, row } of inputs) {
        row.hidden = q.name === 'ratio' && !heat.small_holes;
        show(valueOf(heat, q.name));
      }
    },
  };
}

function valueOf({ distance, seconds, charge, small_holes }: Heat, name: Name): number | null {
  switch (name) {
    case 'distance': return distance;
    case 'seconds': return seconds;
    case 'charge': return charge ?? null;
    case 'thickness': return small_holes?.thickness ?? null;
    case 'ratio': return small_holes?.ratio ?? 1;
  }
}

function change(heat: Heat, name: Name, value: number): void {
  if (name === 'charge') heat.charge = value >= 0 ? value : null;
  else if (name === 'thickness') heat.small_holes = value > 0 ? { ...heat.small_holes, thickness: value } : null;
  else if (name === 'ratio') heat.small_holes = heat.small_holes && { ...heat.small_holes, ratio: value };
  else heat[name] = value;
}
