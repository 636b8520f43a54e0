/** Which abilities of a machine exclude each other: a switch says which others have to be off first. */

import type { MachineProfile } from 'kerfway';
import { words } from '../core/words/index.js';

const { machine: m, levers: l } = words;

/** The abilities, with the labels of their switches. */
const LABELS = {
  partial: m.partialCuts, pausing: m.pausing, moving_pierce: l.moving, fly: l.fly, chains: l.chains, bridges: l.bridges, common_cuts: l.shared,
  tips: words.tips.title, heat: words.heat.title,
};

export type Ability = keyof typeof LABELS;

/** The planner refuses machines with both of a pair. */
const PAIRS: readonly (readonly [Ability, Ability])[] = [
  // A cut that is left unfinished is pierced at rest, and everything else is cut in one go.
  ['partial', 'moving_pierce'], ['partial', 'fly'], ['partial', 'chains'], ['partial', 'bridges'], ['partial', 'common_cuts'], ['partial', 'heat'],
  // What is cut on the run follows at once, so nothing can cool; what bridges connect is cut in one go.
  ['fly', 'heat'], ['fly', 'bridges'],
  // Joined contours are turned with the beam on.
  ['chains', 'pausing'],
  // What may tip or has to cool is not planned with shared sides.
  ['common_cuts', 'tips'], ['common_cuts', 'heat'],
];

function has({ pre_cut_time, sharp_corner, levers }: MachineProfile, ability: Ability): boolean {
  if (ability === 'partial') return typeof pre_cut_time === 'number';
  return Boolean(ability === 'pausing' ? sharp_corner : levers?.[ability]);
}

/** What a machine with an ability cannot have. */
const excluded = (ability: Ability) => PAIRS.filter((pair) => pair.includes(ability)).map(([a, b]) => (a === ability ? b : a));

/** Why an ability cannot be switched on, in a sentence; empty if it can be, or is on. */
export function obstacle(machine: MachineProfile, ability: Ability): string {
  const others = has(machine, ability) ? [] : excluded(ability).filter((other) => has(machine, other));
  return others.length === 0 ? '' : m.first(others.map((other) => LABELS[other]).join(', '));
}

/** Lets cuts be left unfinished, with this pre-cut time in s, and switches off what cannot be planned then. */
export function allowPartialCuts(machine: MachineProfile, time: number): void {
  machine.pre_cut_time = time;
  const levers = (machine.levers = { ...machine.levers });
  for (const ability of excluded('partial')) delete levers[ability as keyof typeof levers];
  // Moves over tipped pieces are only marked then.
  if (levers.tips) levers.tips = { ...levers.tips, risky_moves: 'ignore' };
  if (Object.keys(levers).length === 0) delete machine.levers;
}
