/** Corners: where the beam cuts a loop through waste, or an arc, instead of turning in them. */

import { h } from '../core/dom.js';
import { CORNER_KINDS, type CornerKind, type Corners, type MachineProfile } from 'kerfway';
import { words } from '../core/words/index.js';
import { type Measure, numberInput } from './number-input.js';
import { check, field, select } from './section.js';

const SIDES = ['outer', 'hole'] as const;
/** The limits and the values are those of machine profiles. Each measure is for one of the kinds. */
const QUANTITIES: readonly (Measure & { name: 'loop_radius' | 'clearance' | 'round_radius' | 'deviation'; kind: CornerKind; usual: number })[] = [
  { name: 'loop_radius', kind: 'loop', unit: 'mm', least: 0.05, most: 100, usual: 2 },
  { name: 'clearance', kind: 'loop', unit: 'mm', least: 0, most: 100, usual: 1 },
  { name: 'round_radius', kind: 'round', unit: 'mm', least: 0.05, most: 100, usual: 1 },
  { name: 'deviation', kind: 'round', unit: 'mm', least: 0.001, most: 10, usual: 0.1 },
];

export interface CornersPanel {
  root: HTMLElement;
  show(machine: MachineProfile): void;
}

/** `set` changes the corners of the machine; null switches them off. */
export function cornersPanel(set: (change: Corners | null) => void): CornersPanel {
  const w = words.corners;
  const on = check(w.title, (checked) => set(checked ? { outer: 'loop' } : null));
  const kinds = SIDES.map((side) => ({ side, list: select<CornerKind>((value) => set({ [side]: value })) }));
  const inputs = QUANTITIES.map((q) => {
    const { input, show } = numberInput(q, (value) => set({ [q.name]: value }));
    return { q, show, row: field(w[q.name], input, q.unit) };
  });
  const more = h('div', { class: 'stack' }, ...kinds.map(({ side, list }) => field(w[side], list.root)), ...inputs.map((i) => i.row), h('p', { class: 'soft' }, w.about));
  return {
    root: h('div', { class: 'stack' }, on.root, more),
    show({ levers }) {
      const corners = levers?.corners;
      on.input.checked = Boolean(corners);
      more.hidden = !corners;
      for (const { side, list } of kinds) list.fill(CORNER_KINDS.map((value) => ({ value, label: w.kinds[value] })), corners?.[side] ?? 'stop');
      for (const { q, show } of inputs) show(corners?.[q.name] ?? q.usual);
    },
  };
}
