/** The levers of the machine: abilities that make jobs shorter, and lifting the head. */

import { h } from '../core/dom.js';
import type { MachineProfile } from 'kerfway';
import { words } from '../core/words/index.js';
import { cornersPanel } from './corners.js';
import { obstacle } from './exclusions.js';
import { heatPanel } from './heat.js';
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

type Levers = NonNullable<MachineProfile['levers']>;

export interface LeversPanel {
  root: HTMLElement;
  show(machine: MachineProfile): void;
}

export function leversPanel(edit: (change: (m: MachineProfile) => void) => void): LeversPanel {
  const w = words.levers;
  const set = (change: (levers: Levers, machine: MachineProfile) => void) => edit((m) => {
    m.levers = { ...m.levers };
    change(m.levers, m);
    if (Object.keys(m.levers).length === 0) delete m.levers;
  });
  /** The switch of a lever, which starts with these values. */
  const switched = <K extends keyof Levers>(label: string, name: K, start: NonNullable<Levers[K]>) => check(label, (on) => set((l) => {
    if (on) l[name] = start;
    else delete l[name];
  }));
  /** Changes some values of a lever, and switches it on. */
  const changed = <K extends keyof Levers>(name: K, start: NonNullable<Levers[K]>) => (change: Partial<NonNullable<Levers[K]>>) => set((l) => (l[name] = { ...start, ...l[name], ...change }));
  const moving = switched(w.moving, 'moving_pierce', { overcut: OVERCUT });
  const overcut = numberInput({ unit: 'mm', least: 0, most: MOST.overcut }, (value) => set((l) => (l.moving_pierce = { overcut: value })));
  const more = h('div', { class: 'stack' }, field(w.overcut, overcut.input, 'mm'), h('p', { class: 'soft' }, w.about));

  const lift = check(w.lift, (on) => set((l, m) => {
    if (on) [l.lift, m.z_speed] = [LIFT, m.z_speed ?? Z_SPEED];
    else {
      delete l.lift;
      if (l.tips) l.tips = { ...l.tips, risky_moves: 'ignore' };
    }
  }));
  const lifted = changed('lift', LIFT);
  const height = numberInput({ unit: 'mm', least: 0.1, most: MOST.height }, (value) => lifted({ height: value }));
  const speed = numberInput({ unit: 'mm/s', least: 0.01, most: 1e5 }, (value) => edit((m) => (m.z_speed = value)));
  const down = numberInput({ unit: 'mm', least: 0, most: MOST.down }, (value) => lifted({ stay_down: value }));
  const atRest = check(w.atRest, (on) => lifted({ at_rest: on }));
  const about = h('div', { class: 'stack' },
    field(w.height, height.input, 'mm'), field(words.machine.zSpeed, speed.input, 'mm/s'), field(w.stayDown, down.input, 'mm'), atRest.root, h('p', { class: 'soft' }, w.aboutLift));

  const fly = switched(w.fly, 'fly', FLY);
  const flown = changed('fly', FLY);
  const reach = numberInput({ unit: 'mm', least: 0.1, most: MOST.reach }, (value) => flown({ reach: value }));
  const again = numberInput({ unit: 'mm', least: 0, most: MOST.overcut }, (value) => flown({ overcut: value }));
  const run = h('div', { class: 'stack' }, field(w.reach, reach.input, 'mm'), field(w.flyOvercut, again.input, 'mm'), h('p', { class: 'soft' }, w.aboutFly));
  const chains = switched(w.chains, 'chains', CHAINS);
  const chained = changed('chains', CHAINS);
  const chainReach = numberInput({ unit: 'mm', least: 0.1, most: MOST.reach }, (value) => chained({ reach: value }));
  const clearance = numberInput({ unit: 'mm', least: 0, most: MOST.overcut }, (value) => chained({ clearance: value }));
  const edges = check(w.edgeStarts, (on) => chained({ edge_starts: on }));
  const joined = h('div', { class: 'stack' }, field(w.chainReach, chainReach.input, 'mm'), field(w.chainClearance, clearance.input, 'mm'), edges.root, h('p', { class: 'soft' }, w.aboutChains));
  const bridges = switched(w.bridges, 'bridges', BRIDGES);
  const bridged = changed('bridges', BRIDGES);
  const width = numberInput({ unit: 'mm', least: 0.1, most: MOST.reach }, (value) => bridged({ width: value }));
  const span = numberInput({ unit: 'mm', least: 0.1, most: MOST.reach }, (value) => bridged({ reach: value }));
  const apart = numberInput({ unit: 'mm', least: 0, most: MOST.overcut }, (value) => bridged({ clearance: value }));
  const most = numberInput({ unit: '', least: 2, most: 1e6, empty: 0, whole: true, placeholder: words.machine.unlimited }, (value) => bridged({ most: value || null }));
  const cutLater = check(w.cutLater, (on) => bridged({ cut_later: on }));
  const strips = h('div', { class: 'stack' }, field(w.bridgeWidth, width.input, 'mm'), field(w.bridgeReach, span.input, 'mm'), field(w.chainClearance, apart.input, 'mm'), field(w.bridgeMost, most.input, ''), cutLater.root, h('p', { class: 'soft' }, w.aboutBridges));
  const shared = switched(w.shared, 'common_cuts', {});
  const sharing = changed('common_cuts', {});
  const shift = numberInput({ unit: 'mm', least: 0, most: MOST.overcut }, (value) => sharing({ shift: value }));
  const shiftParts = check(w.shiftParts, (on) => sharing({ shift_parts: on }));
  const aboutShared = h('div', { class: 'stack' }, field(w.shift, shift.input, 'mm'), shiftParts.root, h('p', { class: 'soft' }, w.aboutShared));
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
  return {
    root: h('div', { class: 'stack' }, moving.root, more, fly.root, run, chains.root, joined, bridges.root, strips, shared.root, aboutShared, corners.root, lift.root, about, tips.root, heat.root),
    show(machine) {
      const { levers, z_speed } = machine;
      tips.show(machine);
      heat.show(machine);
      corners.show(machine);
      const pierce = levers?.moving_pierce, lifting = levers?.lift;
      moving.input.checked = Boolean(pierce);
      moving.bar(obstacle(machine, 'moving_pierce'));
      more.hidden = !pierce;
      overcut.show(pierce?.overcut ?? 0);
      fly.input.checked = Boolean(levers?.fly);
      fly.bar(obstacle(machine, 'fly'));
      run.hidden = !levers?.fly;
      reach.show(levers?.fly?.reach ?? FLY.reach);
      again.show(levers?.fly?.overcut ?? 0);
      chains.input.checked = Boolean(levers?.chains);
      chains.bar(obstacle(machine, 'chains'));
      joined.hidden = !levers?.chains;
      chainReach.show(levers?.chains?.reach ?? CHAINS.reach);
      clearance.show(levers?.chains?.clearance ?? CHAINS.clearance);
      edges.input.checked = levers?.chains?.edge_starts === true;
      bridges.input.checked = Boolean(levers?.bridges);
      bridges.bar(obstacle(machine, 'bridges'));
      strips.hidden = !levers?.bridges;
      width.show(levers?.bridges?.width ?? BRIDGES.width);
      span.show(levers?.bridges?.reach ?? BRIDGES.reach);
      apart.show(levers?.bridges?.clearance ?? BRIDGES.clearance);
      most.show(levers?.bridges?.most ?? 0);
      cutLater.input.checked = levers?.bridges?.cut_later === true;
      shared.input.checked = Boolean(levers?.common_cuts);
      shared.bar(obstacle(machine, 'common_cuts'));
      aboutShared.hidden = !levers?.common_cuts;
      shift.show(levers?.common_cuts?.shift ?? 0);
      shiftParts.input.checked = levers?.common_cuts?.shift_parts === true;
      // There is nothing to shift without a distance.
      shiftParts.root.hidden = !levers?.common_cuts?.shift;
      lift.input.checked = Boolean(lifting);
      about.hidden = !lifting;
      height.show(lifting?.height ?? LIFT.height);
      speed.show(z_speed ?? null);
      down.show(lifting?.stay_down ?? 0);
      atRest.input.checked = lifting?.at_rest === true;
    },
  };
}
