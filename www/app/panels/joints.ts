/** The micro-joints of the machine: how many, how wide, how far apart, on which contours. */

import { DEFAULT_JOINTS, JOINT_KINDS, JOINT_SIDES, jointRules, jointSettings, type JointKind, type JointPattern, type JointSide, type LoadOptions, type MachineProfile } from 'kerfway';
import { button, h } from '../core/dom.js';
import { count } from '../core/format.js';
import { words } from '../core/words/index.js';
import type { Session } from '../session/session.js';
import { type Measure, numberInput } from './number-input.js';
import { check, field, select } from './section.js';

interface Quantity extends Measure {
  most: number;
  name: 'count' | 'width' | 'spacing' | 'cornerClearance' | 'least' | 'most';
  get(settings: JointPattern): number;
  set(value: number): Partial<JointPattern>;
}

const w = words.joints;

const ANY = { empty: 0, placeholder: w.any };

/** The limits are those of machine profiles. */
const QUANTITIES: readonly Quantity[] = [
  { name: 'count', unit: '', least: 0, most: 1000, whole: true, get: (s) => s.count, set: (count) => ({ count }) },
  { name: 'width', unit: 'mm', least: 0.01, most: 100, get: (s) => s.width, set: (width) => ({ width }) },
  { name: 'spacing', unit: 'mm', least: 1, most: 1e6, ...ANY, get: (s) => s.spacing, set: (spacing) => ({ spacing }) },
  { name: 'cornerClearance', unit: 'mm', least: 0, most: 1000, get: (s) => s.cornerClearance, set: (cornerClearance) => ({ cornerClearance }) },
  { name: 'least', unit: 'mm', least: 0, most: 1e6, ...ANY, get: (s) => s.sizeMin[0], set: (v) => ({ sizeMin: [v, v] }) },
  { name: 'most', unit: 'mm', least: 0, most: 1e6, ...ANY, get: (s) => s.sizeMax[0], set: (v) => ({ sizeMax: [v, v] }) },
];

export interface JointsPanel {
  root: HTMLElement;
  show(machine: MachineProfile, load: LoadOptions): void;
}

export function jointsPanel(session: Session, edit: (change: (m: MachineProfile) => void) => void, place: (show: (on: boolean) => void) => void): JointsPanel {
  let now: JointPattern = DEFAULT_JOINTS;
  const set = (change: Partial<JointPattern>) => edit((m) => (m.joints = jointRules({ ...now, ...change })));
  const on = check(w.on, (checked) => edit((m) => {
    if (checked) m.joints = jointRules();
    else delete m.joints;
  }));
  const side = select<JointSide>((value) => set({ side: value }), { wide: true });
  const kind = select<JointKind>((value) => set({ kind: value }), { wide: true });
  const inputs = QUANTITIES.map((q) => {
    const { input, show } = numberInput({ ...q, ...(q.name === 'least' ? { most: () => now.sizeMax[0] || q.most } : q.name === 'most' ? { least: () => now.sizeMin[0] } : {}) }, (value) => set(q.set(value)));
    return { q, show, row: field(w[q.name], input, q.unit) };
  });
  const simple = h('div', { class: 'stack' }, field(w.side, side.root), ...inputs.map((i) => i.row), field(w.kind, kind.root), h('p', { class: 'soft' }, w.about));
  const custom = h('div', { class: 'stack' }, h('p', { class: 'soft' }, w.custom), button(w.replace, { class: 'small', onclick: () => edit((m) => (m.joints = jointRules())) }));
  const placed = h('span', { class: 'soft' });
  const clear = button(w.clear, { class: 'quiet small', onclick: () => session.drawing.change({ joints: [] }) });
  // The button that began it ends it: fingers have no Escape.
  const placing = button(w.place, { class: 'small', title: w.placing, 'aria-pressed': false, onclick: () => place((on) => placing.setAttribute('aria-pressed', String(on))) });
  const byHand = h('div', { class: 'by-hand' }, placing, placed, clear);
  const gist = h('span', { class: 'soft' });
  return {
    root: h('details', { class: 'more' }, h('summary', {}, w.title, ' ', gist), h('div', { class: 'stack' }, on.root, simple, custom, byHand)),
    show({ joints }, load) {
      const settings = joints ? jointSettings(joints) : DEFAULT_JOINTS;
      now = settings ?? DEFAULT_JOINTS;
      on.input.checked = Boolean(joints);
      simple.hidden = !joints || settings === null;
      custom.hidden = settings !== null;
      const own = load.joints?.length ?? 0;
      placed.textContent = own > 0 ? w.placed(own, count(own)) : '';
      clear.hidden = own === 0;
      gist.textContent = !joints ? placed.textContent : settings === null ? w.ownRules : w.sides[now.side];
      side.fill(JOINT_SIDES.map((value) => ({ value, label: w.sides[value] })), now.side);
      kind.fill(JOINT_KINDS.map((value) => ({ value, label: w.kinds[value] })), now.kind);
      for (const { q, show } of inputs) show(q.get(now));
    },
  };
}
