/** A lever of the machine: a switch, and its values, which are shown while it is on. */

import { h } from '../core/dom.js';
import type { MachineProfile } from 'kerfway';
import { obstacle } from './exclusions.js';
import { type Measure, numberInput } from './number-input.js';
import { check, field } from './section.js';

export type Levers = NonNullable<MachineProfile['levers']>;
/** Changes the levers of the machine, and perhaps other values of it. */
export type ChangeLevers = (change: (levers: Levers, machine: MachineProfile) => void) => void;

/** The levers that have nothing but values of their own. */
type Name = 'moving_pierce' | 'fly' | 'chains' | 'bridges' | 'common_cuts';
type Lever<K extends Name> = NonNullable<Levers[K]>;

/** A number of a lever. An empty field stands for no value, and `usual` for what a profile without the value means. */
interface LeverNumber<L> extends Measure {
  name: keyof L & string;
  label: string;
  usual: number;
}

/** A yes or no of a lever; `needs`: the value without which it means nothing. */
interface LeverFlag<L> {
  name: keyof L & string;
  label: string;
  needs?: keyof L & string;
}

/** The panel of a lever. Switching it on gives it the values in `start`. */
export function leverPanel<K extends Name>(
  set: ChangeLevers,
  name: K,
  start: Lever<K>,
  { title, about }: { title: string; about: string },
  numbers: readonly LeverNumber<Lever<K>>[],
  flags: readonly LeverFlag<Lever<K>>[] = [],
): { root: HTMLElement; show(machine: MachineProfile): void } {
  const on = check(title, (checked) => set((l) => {
    if (checked) l[name] = start;
    else delete l[name];
  }));
  const change = (field: string, value: number | boolean | null) => set((l) => (l[name] = { ...start, ...l[name], [field]: value }));
  const inputs = numbers.map((n) => ({ ...n, ...numberInput(n, (value) => change(n.name, value === n.empty ? null : value)) }));
  const checks = flags.map((f) => ({ ...f, ...check(f.label, (checked) => change(f.name, checked)) }));
  const more = h('div', { class: 'stack' }, ...inputs.map((i) => field(i.label, i.input, i.unit)), ...checks.map((c) => c.root), h('p', { class: 'soft' }, about));
  return {
    root: h('div', { class: 'stack' }, on.root, more),
    show(machine) {
      const lever = machine.levers?.[name] as Partial<Record<string, number | boolean>> | null | undefined;
      on.input.checked = Boolean(lever);
      on.bar(obstacle(machine, name));
      more.hidden = !lever;
      for (const { name, usual, show } of inputs) show(Number(lever?.[name] ?? usual));
      for (const { name, needs, root, input } of checks) {
        input.checked = lever?.[name] === true;
        root.hidden = needs !== undefined && !lever?.[needs];
      }
    },
  };
}
