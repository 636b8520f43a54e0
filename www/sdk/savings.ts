/**
 * What each lever of a machine saves on a job: the job is planned again without it, with the same options and budget, and the seconds are compared.
 */

import { checkOne } from './check.js';
import { checkOptions, checkProfile } from './options.js';
import type { MachineProfile, PlanOptions } from './protocol.js';

/** What can be left out of a machine: piercing in motion, cuts on the run, chains, starts on a kerf, bridges between parts, cutting what shares cuts together, lifting on the way, staying down on short moves, avoiding pieces that tip instead of lifting for every move, minding heat, which costs more than it saves, corners in which the beam does not stop, joints without a stop. */
export const LEVERS = ['moving-pierce', 'fly', 'chains', 'edge-starts', 'bridges', 'common-cuts', 'lift-on-the-way', 'stay-down', 'avoid-tips', 'heat', 'corners', 'flying-joints'] as const;
/** The name of a lever that can be left out. */
export type Lever = (typeof LEVERS)[number];

/** What a lever saves in a plan. */
export interface LeverSaving {
  readonly lever: Lever;
  /** Seconds of the job without the lever minus those of the plan; negative if the plan without it is shorter. */
  readonly seconds: number;
}

/** A planner, or anything that plans with other options. */
export interface Replanner {
  /** Plans the loaded drawing; `done` settles with the plan. */
  plan(options: PlanOptions): { readonly done: Promise<{ readonly progress: { readonly summary: { readonly total_time: number } } }> };
}

/** A machine without one of its levers; `null` if it does not have it. */
export function withoutLever(machine: MachineProfile, lever: Lever): MachineProfile | null {
  checkProfile(machine);
  checkOne('The option', 'lever', { choice: LEVERS }, lever);
  const { moving_pierce, lift, fly, chains, bridges, common_cuts, tips, heat, corners } = machine.levers ?? {};
  const avoids = tips != null && tips.risky_moves !== 'ignore';
  switch (lever) {
    case 'moving-pierce': return moving_pierce == null ? null : levered(machine, { moving_pierce: undefined });
    case 'fly': return fly == null ? null : levered(machine, { fly: undefined });
    case 'chains': return chains == null ? null : levered(machine, { chains: undefined });
    case 'edge-starts': return chains == null || !chains.edge_starts ? null : levered(machine, { chains: { ...chains, edge_starts: false } });
    case 'bridges': return bridges == null ? null : levered(machine, { bridges: undefined });
    case 'common-cuts': return common_cuts == null ? null : levered(machine, { common_cuts: undefined });
    case 'lift-on-the-way': return lift == null || lift.at_rest === true ? null : levered(machine, { lift: { ...lift, at_rest: true } });
    case 'stay-down': return lift == null || !lift.stay_down || avoids ? null : levered(machine, { lift: { ...lift, stay_down: 0 } });
    // Then the head is lifted for every move, however short.
    case 'avoid-tips': return lift == null || !avoids ? null : levered(machine, { tips: undefined, lift: { ...lift, stay_down: 0 } });
    // The seconds are negative: what minding heat costs.
    case 'heat': return heat == null ? null : levered(machine, { heat: undefined });
    case 'corners': return corners == null ? null : levered(machine, { corners: undefined });
    case 'flying-joints': {
      const rules = machine.joints?.rules ?? [];
      return rules.some((rule) => rule.kind === 'flying') ? { ...machine, joints: { rules: rules.map((rule) => ({ ...rule, kind: 'stop' })) } } : null;
    }
  }
}

/** The machine with some levers changed; those that are undefined are gone. */
function levered(machine: MachineProfile, change: { [K in keyof NonNullable<MachineProfile['levers']>]?: NonNullable<MachineProfile['levers']>[K] | undefined }): MachineProfile {
  const levers = Object.fromEntries(Object.entries({ ...machine.levers, ...change }).filter(([, value]) => value !== undefined));
  return { ...machine, levers };
}

/**
 * What each lever of the machine in `options` saves: `seconds` are those of the job planned with these options, which have the machine as a profile. The
 * planner has the plan without the last lever afterwards.
 */
export async function* leverSavings(planner: Replanner, options: PlanOptions, seconds: number): AsyncGenerator<LeverSaving> {
  const { machine } = checkOptions(options, 'planning');
  if (typeof machine !== 'object') return;
  for (const lever of LEVERS) {
    const without = withoutLever(machine, lever);
    if (without === null) continue;
    const { progress } = await planner.plan({ ...options, machine: without }).done;
    yield { lever, seconds: progress.summary.total_time - seconds };
  }
}

/** The text of a plan document with what the levers save in it. */
export function withSavings(document: string, savings: readonly LeverSaving[]): string {
  return document.replace(/\}\s*$/, `,"savings":${JSON.stringify(savings)}}\n`);
}
