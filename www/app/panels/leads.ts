/** The leads of the machine: the lead-in and lead-out of all closed cuts, small holes from their centres, overcut, clearance. */

import { button, h } from '../core/dom.js';
import { DEFAULT_LEADS, LEAD_KINDS, LEAD_POSITIONS, leadRules, leadSettings, type LeadKind, type LeadPosition, type LeadChoice, type MachineProfile } from 'kerfway';
import { words } from '../core/words/index.js';
import { type Measure, numberInput } from './number-input.js';
import { field, select } from './section.js';

interface Quantity extends Measure {
  name: 'length' | 'radius' | 'angle' | 'clearance' | 'centerBelow' | 'overcut';
  /** Whether it matters for a lead-in or lead-out of one of these kinds. */
  of(settings: LeadChoice): boolean;
}

const has = (...kinds: LeadKind[]) => (s: LeadChoice) => kinds.includes(s.kind) || kinds.includes(s.out);
const any = has('line', 'arc', 'line-arc');

/** The limits are those of machine profiles. */
const QUANTITIES: readonly Quantity[] = [
  { name: 'length', unit: 'mm', least: 0.01, most: 1000, of: has('line', 'line-arc') },
  { name: 'radius', unit: 'mm', least: 0.01, most: 1000, of: has('arc', 'line-arc') },
  { name: 'angle', unit: '°', least: 1, most: 180, of: any },
  { name: 'clearance', unit: 'mm', least: 0, most: 1000, of: any },
  { name: 'centerBelow', unit: 'mm', least: 0, most: 1000, of: (s) => s.kind !== 'none' },
  { name: 'overcut', unit: 'mm', least: -100, most: 1000, of: () => true },
];

const NONE: LeadChoice = { ...DEFAULT_LEADS, kind: 'none', out: 'none', overcut: 0 };

export interface LeadsPanel {
  root: HTMLElement;
  show(machine: MachineProfile): void;
}

export function leadsPanel(edit: (change: (m: MachineProfile) => void) => void): LeadsPanel {
  const w = words.leads;
  let now: LeadChoice = NONE;
  const set = (change: Partial<LeadChoice>) => {
    const next = { ...now, ...change };
    const off = next.kind === 'none' && next.out === 'none' && next.overcut === 0;
    edit((m) => {
      if (off) delete m.leads;
      else m.leads = leadRules(next);
    });
  };
  const kind = select<LeadKind>((value) => set({ kind: value }));
  const out = select<LeadKind>((value) => set({ out: value }));
  const position = select<LeadPosition>((value) => set({ position: value }), { wide: true });
  const placed = field(w.position, position.root);
  const kinds = LEAD_KINDS.map((value) => ({ value, label: w.kinds[value] }));
  const inputs = QUANTITIES.map((q) => {
    const { input, show } = numberInput(q, (value) => set({ [q.name]: value }));
    return { q, show, row: field(w[q.name], input, q.unit) };
  });
  const simple = h('div', { class: 'stack' }, field(w.kind, kind.root), field(w.out, out.root), placed, ...inputs.map((i) => i.row), h('p', { class: 'soft' }, w.about));
  const custom = h('div', { class: 'stack' }, h('p', { class: 'soft' }, w.custom), button(w.replace, { class: 'small', onclick: () => edit((m) => (m.leads = leadRules())) }));
  const gist = h('span', { class: 'soft' });
  const root = h('details', { class: 'more' }, h('summary', {}, w.title, ' ', gist), simple, custom);
  return {
    root,
    show({ leads }) {
      const settings = leads ? leadSettings(leads) : NONE;
      now = settings ?? NONE;
      simple.hidden = settings === null;
      custom.hidden = settings !== null;
      gist.textContent = settings === null ? w.ownRules : now.kind === 'none' && now.out === 'none' ? '' : w.kinds[now.kind === 'none' ? now.out : now.kind];
      kind.fill(kinds, now.kind);
      out.fill(kinds, now.out);
      position.fill(LEAD_POSITIONS.map((value) => ({ value, label: w.positions[value] })), now.position);
      placed.hidden = !any(now);
      for (const { q, show, row } of inputs) {
        row.hidden = !q.of(now);
        show(now[q.name]);
      }
    },
  };
}
