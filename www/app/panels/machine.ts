/** The controls of the machine: a preset, and its values behind a disclosure. Every change plans again. Loaded when the section is first opened. */

import { button, h } from '../core/dom.js';
import type { MachineProfile } from 'kerfway';
import type { Session } from '../session/session.js';
import { sayWhatElse } from './also.js';
import { dialectPanel } from './dialect.js';
import { allowPartialCuts, obstacle } from './exclusions.js';
import { jointsPanel } from './joints.js';
import { leadsPanel } from './leads.js';
import { leversPanel } from './levers.js';
import { isChanged, type MachineActions, presetOf } from './machine-section.js';
import { skeletonPanel } from './skeleton.js';
import { materials } from './materials.js';
import { ownMachines } from './own-machines.js';
import { type Measure, numberInput } from './number-input.js';
import { check, field, laterDetails, select } from './section.js';
import { words } from '../core/words/index.js';

interface Quantity extends Measure {
  label: string;
  /** What the empty field says where it is not "no limit". */
  none?: string;
  /** A sentence below the field that says what the value does. */
  hint?: string;
  /** For the sides of the bed: its place in the list. */
  side?: number;
  /** Null where the profile has no value, which means "no limit" or "at once". */
  get(m: MachineProfile): number | null;
  set(m: MachineProfile, value: number): void;
}

/** One degree in radians. */
const DEGREE = Math.PI / 180;

/** The first values when pauses in corners are switched on: the corners of a triangle, and a second to cool. People replace them by their own. */
const PAUSE = { angle: 70 * DEGREE, time: 1 };

/** The limits of machine profiles, which are inclusive. */
const SPEED = { unit: 'mm/s', least: 0.01, most: 1e5 };
const ACCEL = { unit: 'mm/s²', least: 1, most: 1e7 };
const POWER = { unit: '%', least: 0, most: 100 };
const PLACE = { unit: 'mm', least: -1e6, most: 1e6 };
const WAIT = { unit: 's', least: 0, most: 600 };
const DELAY = { unit: 's', least: 0, most: 60 };

/** The bed that a side is typed into when the machine has none, mm. */
const BED: [number, number, number, number] = [0, 0, 600, 400];

const withSide = (bed: [number, number, number, number], side: number, value: number) => bed.map((v, i) => (i === side ? value : v)) as [number, number, number, number];

/** The limit of a side of the bed: at least a millimetre from the opposite one. */
function beyond(side: number | undefined, bed: () => readonly number[]): Partial<Measure> {
  if (side === undefined) return {};
  return side < 2 ? { most: () => bed()[side + 2]! - 1 } : { least: () => bed()[side - 2]! + 1 };
}

const degrees = (angle: number | undefined) => (angle === undefined ? null : Math.round((angle / DEGREE) * 1e6) / 1e6);

const QUANTITIES: readonly Quantity[] = [
  { label: words.machine.cutSpeed, ...SPEED, get: (m) => m.cut.speed, set: (m, v) => (m.cut.speed = v) },
  { label: words.machine.cutAccel, ...ACCEL, get: (m) => m.cut.accel, set: (m, v) => (m.cut.accel = v) },
  { label: words.machine.cutPower, ...POWER, get: (m) => Math.round(m.cut.power * 1000) / 10, set: (m, v) => (m.cut.power = v / 100) },
  { label: words.machine.kerf, hint: words.machine.kerfHint, unit: 'mm', least: 0, most: 10, get: (m) => m.kerf_width ?? 0, set: (m, v) => (m.kerf_width = v) },
  { label: words.machine.markSpeed, ...SPEED, get: (m) => m.mark.speed, set: (m, v) => (m.mark.speed = v) },
  { label: words.machine.markPower, ...POWER, get: (m) => Math.round(m.mark.power * 1000) / 10, set: (m, v) => (m.mark.power = v / 100) },
  { label: words.machine.rapidX, ...SPEED, get: (m) => m.rapid.speed[0], set: (m, v) => (m.rapid.speed[0] = v) },
  { label: words.machine.rapidY, ...SPEED, get: (m) => m.rapid.speed[1], set: (m, v) => (m.rapid.speed[1] = v) },
  { label: words.machine.rapidAccelX, ...ACCEL, get: (m) => m.rapid.accel?.[0] ?? null, set: (m, v) => (m.rapid.accel = [v, m.rapid.accel?.[1] ?? v]) },
  { label: words.machine.rapidAccelY, ...ACCEL, get: (m) => m.rapid.accel?.[1] ?? null, set: (m, v) => (m.rapid.accel = [m.rapid.accel?.[0] ?? v, v]) },
  { label: words.machine.corners, unit: 'mm', least: 0, most: 10, get: (m) => m.junction_deviation, set: (m, v) => (m.junction_deviation = v) },
  { label: words.machine.pierce, ...WAIT, get: (m) => m.pierce_time, set: (m, v) => (m.pierce_time = v) },
  { label: words.machine.preCut, ...WAIT, none: words.machine.whole, get: (m) => m.pre_cut_time ?? null, set: allowPartialCuts },
  { label: words.machine.preCutLength, unit: 'mm', least: 0, most: 1000, get: (m) => m.pre_cut_length ?? 0, set: (m, v) => (m.pre_cut_length = v) },
  { label: words.machine.sharpAngle, unit: '°', least: 0, most: 180, none: words.machine.noPauses, get: (m) => degrees(m.sharp_corner?.angle), set: (m, v) => (m.sharp_corner = { ...PAUSE, ...m.sharp_corner, angle: v * DEGREE }) },
  { label: words.machine.sharpTime, ...WAIT, get: (m) => m.sharp_corner?.time ?? null, none: words.machine.noPauses, set: (m, v) => (m.sharp_corner = { ...PAUSE, ...m.sharp_corner, time: v }) },
  { label: words.machine.beamOn, ...DELAY, get: (m) => m.beam_on_delay, set: (m, v) => (m.beam_on_delay = v) },
  { label: words.machine.beamOff, ...DELAY, get: (m) => m.beam_off_delay, set: (m, v) => (m.beam_off_delay = v) },
  { label: words.machine.zSpeed, ...SPEED, none: words.machine.noZ, get: (m) => m.z_speed ?? null, set: (m, v) => (m.z_speed = v) },
  { label: words.machine.homeX, ...PLACE, get: (m) => m.home[0], set: (m, v) => (m.home[0] = v) },
  { label: words.machine.homeY, ...PLACE, get: (m) => m.home[1], set: (m, v) => (m.home[1] = v) },
  ...[words.machine.bedX0, words.machine.bedY0, words.machine.bedX1, words.machine.bedY1].map((label, i): Quantity => (
    { label, ...PLACE, side: i, none: words.machine.noBed, get: (m) => m.bed?.[i] ?? null, set: (m, v) => (m.bed = withSide(m.bed ?? BED, i, v)) })),
  { label: words.machine.fullPower, unit: '', least: 1, most: 1e6, get: (m) => m.max_s, set: (m, v) => (m.max_s = v) },
];

/** The first pre-cut time when partial cuts are switched on, s: a few millimetres of cut. People replace it by their own. */
const PRE_CUT = 0.2;

const TRAVELS: { value: MachineProfile['travel']; label: string }[] = [
  { value: 'straight', label: words.machine.travel.straight },
  { value: 'vector', label: words.machine.travel.vector },
  { value: 'per-axis', label: words.machine.travel['per-axis'] },
];

/** `notify` shows a sentence to the person. */
export function machineControls(session: Session, notify: (sentence: string) => void, { chooseHome, placeJoints }: MachineActions): HTMLElement {
  const edit = (change: (m: MachineProfile) => void) => {
    const { machine } = session.state;
    if (!machine) return;
    const copy = structuredClone(machine);
    change(copy);
    session.setMachine(copy, isTyping());
  };

  const choice = select<string>((name) => {
    const chosen = session.catalog.machines.find((m) => m.name === name);
    if (chosen) session.setMachine(structuredClone(chosen));
  }, { wide: true });
  const library = materials(session);
  const fitting = laterDetails(words.calibration.title, async () => (await import('./calibration.js')).calibration(session, notify), notify);
  choice.list.setAttribute('aria-label', words.machine.preset);
  const travel = select<MachineProfile['travel']>((value) => edit((m) => (m.travel = value)), { wide: true });
  const home = check(words.machine.home, (on) => edit((m) => (m.return_home = on)));
  const partialCuts = check(words.machine.partialCuts, (on) => edit((m) => {
    if (on) allowPartialCuts(m, PRE_CUT);
    else m.pre_cut_time = null;
  }));
  const pausing = check(words.machine.pausing, (on) => edit((m) => (m.sharp_corner = on ? PAUSE : null)));
  const inputs = QUANTITIES.map((q) => quantityInput({ ...q, ...beyond(q.side, () => session.state.machine?.bed ?? BED) }, edit));
  const back = button(words.machine.back, { class: 'small', onclick: () => {
    const { machine } = session.state;
    const original = machine && presetOf(session, machine);
    if (original) session.setMachine(structuredClone(original));
  } });
  const dialect = dialectPanel(session, edit, notify);
  const leads = leadsPanel(edit);
  const joints = jointsPanel(session, edit, placeJoints);
  const levers = leversPanel(edit);
  const skeleton = skeletonPanel(edit);
  const own = ownMachines(session, notify);
  const advanced = h('details', { class: 'more' }, h('summary', {}, words.machine.advanced),
    h('div', { class: 'stack' }, field(words.machine.air, travel.root), ...QUANTITIES.flatMap((q, i) => [field(q.label, inputs[i]!.input, q.unit), hintOf(q)]), home.root,
      button(words.machine.start, { class: 'small', onclick: chooseHome }), back));
  const root = h('div', { class: 'stack' }, choice.root, library.choice, advanced, partialCuts.root, pausing.root, levers.root, leads.root, joints.root, skeleton.root, dialect.root, library.root, fitting, own.root);
  const whatElse = sayWhatElse(root);
  let shown: MachineProfile | null = null;

  const show = () => {
    const { machine } = session.state;
    if (!machine) return;
    if (machine !== shown) whatElse.forget();
    shown = machine;
    choice.fill(session.catalog.machines.map((m) => ({ value: m.name, label: m.title })), machine.name);
    travel.fill(TRAVELS, machine.travel);
    home.input.checked = machine.return_home;
    partialCuts.input.checked = typeof machine.pre_cut_time === 'number';
    pausing.input.checked = Boolean(machine.sharp_corner);
    pausing.bar(obstacle(machine, 'pausing'));
    back.hidden = !isChanged(session, machine);
    own.show(machine);
    dialect.show(machine);
    library.show(machine);
    leads.show(machine);
    joints.show(machine, session.state.load);
    levers.show(machine);
    skeleton.show(machine);
    QUANTITIES.forEach((q, i) => inputs[i]!.show(q.get(machine)));
  };
  session.store.on('change', show);
  show();
  return root;
}

/** Whether a change comes from a keystroke in a field. Switches and lists are choices of their own, however fast they follow each other. */
function isTyping(): boolean {
  const { activeElement } = document;
  return activeElement instanceof HTMLInputElement && activeElement.type !== 'checkbox';
}

/** The hint is outside the label, so that the accessible name of the field stays short. */
const hintId = ({ label }: Quantity) => `hint-${label.toLowerCase().replace(/[^a-z]+/g, '-')}`;

function hintOf(quantity: Quantity): HTMLElement | null {
  return quantity.hint === undefined ? null : h('p', { class: 'soft', id: hintId(quantity) }, quantity.hint);
}

function quantityInput(quantity: Quantity, edit: (change: (m: MachineProfile) => void) => void): ReturnType<typeof numberInput> {
  const made = numberInput({ ...quantity, placeholder: quantity.none ?? words.machine.unlimited }, (value) => edit((m) => quantity.set(m, value)));
  if (quantity.hint !== undefined) made.input.setAttribute('aria-describedby', hintId(quantity));
  return made;
}
