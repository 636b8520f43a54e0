/** The levers of the machine: abilities that make jobs shorter, and lifting the head. */

import { h } from '../core/dom.js';
import type { MachineProfile } from 'kerfway';
import { words } from '../core/words/index.js';
import { cornersPanel } from './corners.js';
import { heatPanel } from './heat.js';
import { type ChangeLevers, type Levers, leverPanel } from './lever.js';
import { numberInput } from './number-input.js';
import { check, field } from './section.js';
import { tipsPanel } from './tips.js';

/** The limits are those of machine profiles. */
const MOST = { overcut: 100, height: 500, down: 1e5, reach: 1000 };
/** mm: what 1 mm sheet needs at 3 kW until the beam is through, with a margin. */
const OVERCUT = 0.5;
/** mm: over a part that stands up a little, and holes that lie close together. */
const LIFT = { height: 10, stay_down: 10 };
/** mm: the ways between the holes of most perforated sheets, and no ways across a plate. */
const FLY = { reach: 20, overcut: 0 };
/** mm and s, guesses for plate of some millimetres. */
const HEAT = { distance: 20, seconds: 5 };
/** mm: between parts as they are usually nested; a longer cut takes about as long as piercing. */
const CHAINS = { reach: 30, clearance: 1 };
/** mm: what holds small parts, and is broken by hand. */
const BRIDGES = { width: 2, reach: 30, clearance: 1 };
/** mm/s, for a machine whose profile has none: the heads of fibre lasers are faster, tables are slower. */
const Z_SPEED = 100;

export interface LeversPanel {
  root: HTMLElement;
  show(machine: MachineProfile): void;
}

type Edit = (change: (m: MachineProfile) => void) => void;

export function leversPanel(edit: Edit): LeversPanel {
  const set: ChangeLevers = (change) => edit((m) => {
    m.levers = { ...m.levers };
    change(m.levers, m);
    if (Object.keys(m.levers).length === 0) delete m.levers;
  });
  const tips = tipsPanel((change) => set((l, m) => {
    if (!change) {
      delete l.tips;
      return;
    }
    l.tips = { ...l.tips };
    change(l.tips);
    // Where cuts are left unfinished, risky moves are only marked.
    if (typeof m.pre_cut_time === 'number') l.tips.risky_moves = 'ignore';
    // Moves that avoid tipped pieces lift the head where they cannot go around.
    if (l.tips.risky_moves !== 'ignore') [l.lift, m.z_speed] = [l.lift ?? LIFT, m.z_speed ?? Z_SPEED];
  }));
  const heat = heatPanel((change) => set((l) => {
    if (change === null) delete l.heat;
    else change((l.heat = { ...HEAT, ...l.heat }));
  }));
  const corners = cornersPanel((change) => set((l) => {
    if (change === null) delete l.corners;
    else l.corners = { ...l.corners, ...change };
  }));
  const panels = [...cuttingPanels(set), corners, liftPanel(edit, set), tips, heat];
  return {
    root: h('div', { class: 'stack' }, ...panels.map((panel) => panel.root)),
    show: (machine) => panels.forEach((panel) => panel.show(machine)),
  };
}

/** The levers that begin and join cuts in other ways, each a switch with its values. */
function cuttingPanels(set: ChangeLevers): LeversPanel[] {
  const w = words.levers;
  const mm = (least: number, most: number) => ({ unit: 'mm', least, most });
  return [
    leverPanel(set, 'moving_pierce', { overcut: OVERCUT }, { title: w.moving, about: w.about }, [{ name: 'overcut', label: w.overcut, usual: 0, ...mm(0, MOST.overcut) }]),
    leverPanel(set, 'fly', FLY, { title: w.fly, about: w.aboutFly }, [
      { name: 'reach', label: w.reach, usual: FLY.reach, ...mm(0.1, MOST.reach) },
      { name: 'overcut', label: w.flyOvercut, usual: 0, ...mm(0, MOST.overcut) },
    ]),
    leverPanel(set, 'chains', CHAINS, { title: w.chains, about: w.aboutChains }, [
      { name: 'reach', label: w.chainReach, usual: CHAINS.reach, ...mm(0.1, MOST.reach) },
      { name: 'clearance', label: w.chainClearance, usual: CHAINS.clearance, ...mm(0, MOST.overcut) },
    ], [{ name: 'edge_starts', label: w.edgeStarts }]),
    leverPanel(set, 'bridges', BRIDGES, { title: w.bridges, about: w.aboutBridges }, [
      { name: 'width', label: w.bridgeWidth, usual: BRIDGES.width, ...mm(0.1, MOST.reach) },
      { name: 'reach', label: w.bridgeReach, usual: BRIDGES.reach, ...mm(0.1, MOST.reach) },
      { name: 'clearance', label: w.chainClearance, usual: BRIDGES.clearance, ...mm(0, MOST.overcut) },
      { name: 'most', label: w.bridgeMost, usual: 0, unit: '', least: 2, most: 1e6, empty: 0, whole: true, placeholder: words.machine.unlimited },
    ], [{ name: 'cut_later', label: w.cutLater }]),
    leverPanel(set, 'common_cuts', {}, { title: w.shared, about: w.aboutShared }, [{ name: 'shift', label: w.shift, usual: 0, ...mm(0, MOST.overcut) }],
      // There is nothing to shift without a distance.
      [{ name: 'shift_parts', label: w.shiftParts, needs: 'shift' }]),
  ];
}

/** Lifting the head, which needs a speed of the machine as well, and which moves that avoid tipped pieces need. */
function liftPanel(edit: Edit, set: ChangeLevers): LeversPanel {
  const w = words.levers;
  const lift = check(w.lift, (on) => set((l, m) => {
    if (on) [l.lift, m.z_speed] = [LIFT, m.z_speed ?? Z_SPEED];
    else {
      delete l.lift;
      if (l.tips) l.tips = { ...l.tips, risky_moves: 'ignore' };
    }
  }));
  const lifted = (change: Partial<NonNullable<Levers['lift']>>) => set((l) => (l.lift = { ...LIFT, ...l.lift, ...change }));
  const height = numberInput({ unit: 'mm', least: 0.1, most: MOST.height }, (value) => lifted({ height: value }));
  const speed = numberInput({ unit: 'mm/s', least: 0.01, most: 1e5 }, (value) => edit((m) => (m.z_speed = value)));
  const down = numberInput({ unit: 'mm', least: 0, most: MOST.down }, (value) => lifted({ stay_down: value }));
  const atRest = check(w.atRest, (on) => lifted({ at_rest: on }));
  const more = h('div', { class: 'stack' },
    field(w.height, height.input, 'mm'), field(words.machine.zSpeed, speed.input, 'mm/s'), field(w.stayDown, down.input, 'mm'), atRest.root, h('p', { class: 'soft' }, w.aboutLift));
  return {
    root: h('div', { class: 'stack' }, lift.root, more),
    show({ levers, z_speed }) {
      const now = levers?.lift;
      lift.input.checked = Boolean(now);
      more.hidden = !now;
      height.show(now?.height ?? LIFT.height);
      speed.show(z_speed ?? null);
      down.show(now?.stay_down ?? 0);
      atRest.input.checked = now?.at_rest === true;
    },
  };
}
