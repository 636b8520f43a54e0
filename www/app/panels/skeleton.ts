/** Skeleton cuts: cuts through the waste after everything else, and a strip of the sheet that is kept. */

import { h } from '../core/dom.js';
import type { MachineProfile } from 'kerfway';
import { words } from '../core/words/index.js';
import { numberInput } from './number-input.js';
import { check, field } from './section.js';

/** The limits are those of machine profiles. */
const SPACING = { unit: 'mm', least: 10, most: 1e5 };
/** mm: pieces that one person carries, and what holds a long piece until it is broken off. */
const DEFAULT: Skeleton = { spacing_x: 300, spacing_y: 300, clearance: 2, joint_spacing: 500, joint_width: 1 };
/** mm: a narrower strip is rarely used again. */
const STRIP = 200;

type Skeleton = NonNullable<MachineProfile['skeleton']>;
/** Settings that may be left out, each with an empty field. */
type Optional = 'spacing_x' | 'spacing_y' | 'joint_spacing';

export interface SkeletonPanel {
  root: HTMLElement;
  show(machine: MachineProfile): void;
}

export function skeletonPanel(edit: (change: (m: MachineProfile) => void) => void): SkeletonPanel {
  const w = words.skeleton;
  const set = (change: Skeleton) => edit((m) => (m.skeleton = { ...m.skeleton, ...change }));
  const on = check(w.on, (wanted) => edit((m) => {
    if (wanted) m.skeleton = DEFAULT;
    else delete m.skeleton;
  }));
  const optional = (name: Optional) => numberInput({ ...SPACING, empty: 0 }, (value) => edit((m) => {
    const { [name]: _, ...rest } = m.skeleton ?? {};
    m.skeleton = value === 0 ? rest : { ...rest, [name]: value };
  }));
  const x = optional('spacing_x'), y = optional('spacing_y'), joints = optional('joint_spacing');
  const clearance = numberInput({ unit: 'mm', least: 0.1, most: 1000 }, (value) => set({ clearance: value }));
  const width = numberInput({ unit: 'mm', least: 0.01, most: 100 }, (value) => set({ joint_width: value }));
  const strip = check(w.strip, (wanted) => edit((m) => {
    const { remainder: _, ...rest } = m.skeleton ?? {};
    m.skeleton = wanted ? { ...rest, remainder: STRIP } : rest;
  }));
  const least = numberInput(SPACING, (value) => set({ remainder: value }));
  const leastField = field(w.least, least.input, 'mm');
  const more = h('div', { class: 'stack' },
    field(w.x, x.input, 'mm'), field(w.y, y.input, 'mm'), field(w.clearance, clearance.input, 'mm'), field(w.joints, joints.input, 'mm'), field(w.width, width.input, 'mm'),
    strip.root, leastField, h('p', { class: 'soft' }, w.about));
  return {
    root: h('div', { class: 'stack' }, on.root, more),
    show({ skeleton }) {
      on.input.checked = Boolean(skeleton);
      more.hidden = !skeleton;
      x.show(skeleton?.spacing_x ?? null);
      y.show(skeleton?.spacing_y ?? null);
      clearance.show(skeleton?.clearance ?? 2);
      joints.show(skeleton?.joint_spacing ?? null);
      width.show(skeleton?.joint_width ?? 1);
      strip.input.checked = typeof skeleton?.remainder === 'number';
      leastField.hidden = !strip.input.checked;
      least.show(skeleton?.remainder ?? STRIP);
    },
  };
}
