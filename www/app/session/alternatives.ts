/**
 * Other ways to cut the same drawing, for comparison: in the order of the drawing, nearest first, and with one kind of decision left out. A planner
 * of its own works on them one after the other, so that the plan on the page goes on, and none ends the search of another.
 */

import { createPlanner, LEVERS, withoutLever, type BestPath, type Lever, type LoadOptions, type PlanOptions, type Planner, type Progress, type Summary } from 'kerfway';
import { jobOptions } from './placing.js';
import { pathContours } from './rules.js';
import type { Session } from './session.js';
import type { State } from './state.js';

/** A path with its job time, s. */
export interface Alternative {
  readonly path: BestPath;
  readonly total: number;
}

/** Kinds of decisions that can be left out of a plan. */
export type Decision = 'order' | 'entry' | 'common' | 'partial' | 'leads' | Lever;

/** A decision, and the time of the job without it, s. */
export interface Without {
  decision: Decision;
  total: number;
}

export class Alternatives {
  /** Resolves when the plan before has been made. */
  private turn: Promise<unknown> = Promise.resolve();
  private held: { planner: Promise<Planner>; source: unknown; load: LoadOptions } | null = null;

  constructor(private readonly session: Session) {
    session.store.on('cleared', () => this.release());
    session.store.on('loaded', ({ fresh }) => fresh && this.release());
  }

  /** The path nearest first, as most programs cut. */
  async nearest(): Promise<Alternative> {
    const { progress, path } = await this.planned({}, { moves: 0 });
    return { path, total: progress.summary.total_time };
  }

  /** The current job without each kind of decision. `searched`: the seconds of search for a plan without a decision, where one is needed. */
  async *savings(searched: number): AsyncGenerator<Without> {
    const { state } = this.session;
    const { progress, baselines, path, machine } = state;
    if (!progress || !baselines || !path || !machine) return;
    const save = (decision: Decision, without: Summary): Without => ({ decision, total: without.total_time });
    yield save('order', baselines.greedy);
    // The same order, with every closed contour entered where its line begins. Leads, stretches, cuts on the run and chains have places of their own.
    const whole = path.along.every((along, k) => along === path.until[k]);
    if (whole && path.leads.length === 0 && !progress.summary.fly_cuts && !progress.summary.chains && !progress.summary.loops && !progress.summary.rounded_corners && machine.levers?.common_cuts == null) {
      const { contours, reversed } = path;
      const zero = new Float64Array(contours.length);
      yield save('entry', (await this.planned({}, { moves: 0, warm: { contours, reversed, along: zero, until: zero } })).progress.summary);
    }
    const search: PlanOptions = { seconds: searched };
    if ((state.common?.offsets.length ?? 0) > 1 && state.load.commonCuts !== 'off' && machine.levers?.common_cuts == null && machine.levers?.bridges == null) yield save('common', (await this.planned({ commonCuts: 'off' }, search)).progress.summary);
    if (typeof machine.pre_cut_time === 'number' && (path.preCuts.length > 0 || !whole)) yield save('partial', (await this.planned({}, { ...search, machine: { ...machine, pre_cut_time: null } })).progress.summary);
    for (const lever of LEVERS) {
      const without = withoutLever(machine, lever);
      if (without !== null) yield save(lever, (await this.planned({}, { ...search, machine: without })).progress.summary);
    }
    const { leads, ...without } = machine;
    if (path.leads.length > 0 && leads) yield save('leads', (await this.planned({}, { ...search, machine: without })).progress.summary);
  }

  /** A plan of the current drawing with other options. */
  private planned(reading: LoadOptions, planning: PlanOptions): Promise<{ progress: Progress; path: BestPath }> {
    const made = this.turn.then(() => this.plan(reading, planning));
    this.turn = made.catch(() => {});
    return made;
  }

  private async plan(reading: LoadOptions, planning: PlanOptions): Promise<{ progress: Progress; path: BestPath }> {
    const { state } = this.session;
    const { load, machine } = state;
    if (machine === null) throw new Error('there is no machine');
    const planner = await this.reading({ ...load, ...reading });
    let path: BestPath | null = null;
    const options: PlanOptions = { machine, ...jobOptions(state), seed: 1, ...planning };
    const { progress } = await planner.plan(options, (p) => (path = p.path ?? path)).done;
    const found = progress.path ?? path;
    if (found === null) throw new Error('the plan has no path');
    return { progress, path: found };
  }

  /** The planner, with the drawing read with these options. */
  private async reading(load: LoadOptions): Promise<Planner> {
    const { source } = this.session.drawing;
    if (source === null) throw new Error('there is no drawing');
    if (this.held?.source !== source) {
      this.release();
      const planner = createPlanner();
      this.held = { planner, source, load };
      await (await planner).load(source.bytes, source.name, load);
    } else if (JSON.stringify(this.held.load) !== JSON.stringify(load)) {
      await (await this.held.planner).reload(load);
      this.held.load = load;
    }
    return this.held.planner;
  }

  private release(): void {
    this.held?.planner.then((planner) => planner.close(), () => {});
    this.held = null;
  }
}

/**
 * The order of the drawing: each contour as it is drawn, from where its line begins. The planner gives its times as sums: they are shared out among
 * the cuts by what each takes in the current plan, and among the air moves by their length.
 */
export function asDrawn(state: State): Alternative | null {
  const { path, baselines, loaded, machine } = state;
  if (!path || !baselines || !loaded || !machine) return null;
  const total = baselines.drawing.total_time;
  const infos = pathContours(state);
  const geometry = state.beam?.geometry ?? loaded.geometry;
  const cutFor = new Map<number, number>();
  path.contours.forEach((c, k) => cutFor.set(c, (cutFor.get(c) ?? 0) + path.times[2 * k + 1]! - path.times[2 * k]!));
  const contours = infos.filter(({ id, operation }) => operation !== 'ignore' && (geometry.offsets[id + 1] ?? 0) > geometry.offsets[id]!).map((c) => c.id);
  const n = contours.length;
  const points = new Float64Array(4 * n);
  contours.forEach((c, k) => {
    const first = geometry.offsets[c]! * 7, last = (geometry.offsets[c + 1]! - 1) * 7;
    points.set([geometry.segments[first]!, geometry.segments[first + 1]!, geometry.segments[last + 2]!, geometry.segments[last + 3]!], 4 * k);
    if (infos[c]?.closed) points.set([geometry.segments[first]!, geometry.segments[first + 1]!], 4 * k + 2);
  });
  const legs = contours.map((_, k) => (k === 0 ? 0 : Math.hypot(points[4 * k]! - points[4 * k - 2]!, points[4 * k + 1]! - points[4 * k - 1]!)));
  const cuts = contours.map((c) => cutFor.get(c) ?? 0);
  const sum = (list: readonly number[]) => list.reduce((a, b) => a + b, 0);
  const air = baselines.drawing.air_time, cut = total - air;
  const still = (machine.pierce_time + machine.beam_on_delay) * n;
  const [airRate, cutRate] = [air / Math.max(1e-9, sum(legs)), Math.max(0, cut - still) / Math.max(1e-9, sum(cuts))];
  const times = new Float64Array(2 * n);
  let at = 0;
  contours.forEach((_, k) => {
    at += legs[k]! * airRate + still / Math.max(1, n);
    times[2 * k] = at;
    at += cuts[k]! * cutRate;
    times[2 * k + 1] = at;
  });
  const none = new Float64Array(0);
  return { total, path: { contours: Uint32Array.from(contours), points, along: new Float64Array(n), until: new Float64Array(n), reversed: new Uint8Array(n), times, leads: none, leadOffsets: new Uint32Array(0), joints: none, jointOffsets: new Uint32Array(0), preCuts: none, pauses: none, ways: new Uint8Array(0), via: none, viaOf: new Uint32Array(0), tips: new Uint32Array(0), freedBy: new Uint32Array(0), waits: none, loops: none, loopOffsets: new Uint32Array(0) } };
}
