/** What the page knows of a job, as a project that can be saved, and back. */

import type { MachineProfile, PlanOptions, Project, SavedPlan } from 'kerfway';
import type { Source } from './drawing.js';
import { type KeptPlan, keptPlan } from './kept-plan.js';
import { AS_DRAWN, jobOptions, type Placing } from './placing.js';
import type { Search, State } from './state.js';

/** The current job; null while there is no drawing. */
export function projectOf(state: State, source: Source | null): Project | null {
  const { loaded, load, machine, search: { method, parameters, seed, seconds } } = state;
  if (source === null || loaded === null || machine === null) return null;
  const planning: PlanOptions = {
    machine, method, seconds, ...jobOptions(state), ...(seed === null ? {} : { seed }), ...(Object.keys(parameters).length === 0 ? {} : { parameters }),
  };
  return { name: source.name, drawing: source.bytes instanceof Uint8Array ? source.bytes : new Uint8Array(source.bytes), reading: load, planning, plan: saved(state) };
}

function saved(state: State): SavedPlan | null {
  const kept = keptPlan(state);
  if (kept === null || state.path === null) return null;
  const { contours, along, until, reversed } = state.path;
  const { seed, moves, seconds, reason, bound: lower_bound } = kept;
  return { seed, moves, seconds, total_time: state.progress?.summary.total_time ?? 0, lower_bound, done: reason !== null, curve: { at: [...state.curve.at], total: [...state.curve.total] }, path: { contours, along, until, reversed } };
}

/** The choices in a project; where it has none, those of the page. `machines`: those with a name. */
export function decidedIn({ planning }: Project, { machine: own, search }: State, machines: readonly MachineProfile[]): { machine: MachineProfile | null; search: Search; placing: Placing; material: string | null } {
  const { machine, method, parameters, seed, seconds, place, start, allowOffBed, material } = planning;
  const profile = typeof machine === 'string' ? machines.find((m) => m.name === machine) : machine;
  return {
    machine: profile ?? own,
    search: { method: method ?? search.method, parameters: parameters ?? {}, seed: seed ?? null, seconds: seconds ?? search.seconds },
    material: material ?? null,
    placing: { place: place ?? null, start: start ?? AS_DRAWN.start, allowOffBed: allowOffBed ?? AS_DRAWN.allowOffBed },
  };
}

/** The plan of a project, to go on with. */
export function keptIn({ planning }: Project, { seed, moves, seconds, lower_bound = 0, done, curve, path }: SavedPlan): KeptPlan {
  return { seed, moves, seconds, path, curve, budget: Math.max(planning.seconds ?? 0, seconds), reason: done ? 'budget' : null, bound: lower_bound, shown: null };
}
