/** What falls, what tips: which pieces may stand up under the head, and what moves do about them. */

import { h } from '../core/dom.js';
import type { MachineProfile, RiskyMoves, Tips } from 'kerfway';
import { words } from '../core/words/index.js';
import { obstacle } from './exclusions.js';
import { type Measure, numberInput } from './number-input.js';
import { barrier, check, field, select } from './section.js';

type Name = 'nozzle_radius' | 'margin' | 'pitch' | 'angle' | 'tips_below' | 'drops_below' | 'cross_over';

/** The limits are those of machine profiles, and what an empty field stands for is what a profile without the value means. */
const QUANTITIES: readonly (Measure & { name: Name })[] = [
  { name: 'nozzle_radius', unit: 'mm', least: 0, most: 200 },
  { name: 'margin', unit: 'mm', least: 0, most: 200 },
  { name: 'pitch', unit: 'mm', least: 1, most: 1000, empty: 0 },
  { name: 'angle', unit: '°', least: -180, most: 180 },
  { name: 'tips_below', unit: 'mm', least: 0, most: 1e5 },
  { name: 'drops_below', unit: 'mm', least: 0, most: 1e5, empty: -1 },
  { name: 'cross_over', unit: 'mm', least: 0, most: 1e5 },
];
const DEFAULTS = { nozzle_radius: 10, margin: 2, tips_below: 150, cross_over: 0 };
const MOVES: readonly RiskyMoves[] = ['ignore', 'avoid'];

export interface TipsPanel {
  root: HTMLElement;
  show(machine: MachineProfile): void;
}

/** `set` changes the tips of the machine; null switches them off. */
export function tipsPanel(set: (change: ((tips: Tips) => void) | null) => void): TipsPanel {
  const w = words.tips;
  const on = check(w.title, (checked) => set(checked ? () => undefined : null));
  const moves = select<RiskyMoves>((value) => set((tips) => (tips.risky_moves = value)));
  const inputs = QUANTITIES.map((q) => {
    const { input, show } = numberInput({ ...q, placeholder: q.empty === undefined ? undefined : w.unknown }, (value) => set((tips) => change(tips, q.name, value)));
    return { q, show, row: field(w[q.name], input, q.unit) };
  });
  const onlyMarked = barrier(moves.list);
  const more = h('div', { class: 'stack' }, field(w.riskyMoves, moves.root), onlyMarked.root, ...inputs.map((i) => i.row), h('p', { class: 'soft' }, w.about));
  return {
    root: h('div', { class: 'stack' }, on.root, more),
    show(machine) {
      const tips = machine.levers?.tips;
      on.input.checked = Boolean(tips);
      on.bar(obstacle(machine, 'tips'));
      more.hidden = !tips;
      // A machine that leaves contours unfinished cannot avoid them.
      onlyMarked.bar(typeof machine.pre_cut_time === 'number' ? words.machine.first(words.machine.partialCuts) : '');
      if (!tips) return;
      moves.fill(MOVES.map((value) => ({ value, label: w.moves[value] })), tips.risky_moves ?? 'avoid');
      for (const { q, show, row } of inputs) {
        row.hidden = q.name === 'angle' && !tips.slats;
        show(valueOf(tips, q.name));
      }
    },
  };
}

function valueOf(tips: Tips, name: Name): number | null {
  if (name === 'pitch') return tips.slats?.pitch ?? null;
  if (name === 'angle') return ((tips.slats?.angle ?? 0) * 180) / Math.PI;
  if (name === 'drops_below') return tips.drops_below ?? null;
  return tips[name] ?? DEFAULTS[name];
}

function change(tips: Tips, name: Name, value: number): void {
  if (name === 'pitch') tips.slats = value > 0 ? { ...tips.slats, pitch: value } : null;
  else if (name === 'angle') tips.slats = tips.slats && { ...tips.slats, angle: (value * Math.PI) / 180 };
  else if (name === 'drops_below') tips.drops_below = value >= 0 ? value : null;
  else tips[name] = value;
}
