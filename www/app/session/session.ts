/**
 * The job in hand: reads a drawing, asks what is in doubt, plans, and goes on. Planning starts by itself; any change of
 * drawing, machine or options starts it anew. The newest wish wins: answers to older ones are dropped.
 */

import { createPlanner, type LoadOptions, type Loaded, type MachineProfile, type Material, type MethodInfo, type Operation, type OutputKind, type PaperMethod, type PlanHandle, type Planner, type Progress, type Quote, type Unit } from 'kerfway';
import { Emitter } from '../core/emitter.js';
import { messageOf } from '../core/strings.js';
import { type Shared, written } from './address.js';
import { type Choices, decided, type Fate, FATES, History, sameContours, undecided } from './choices.js';
import { extentOf } from './extent.js';
import { learn, noInsights } from './insights.js';
import { kept } from './profiles.js';
import { initialState, type Question, type Search, type State } from './state.js';
import { worked } from './worked.js';
import { words } from '../core/words/index.js';

/** Milliseconds typed numbers rest before the plan starts anew, so that it does not at each digit. */
const SETTLE = 350;

/**
 * Searches side by side: a core is left for the page and the person's other work; more than four hold the drawing more
 * often than they gain.
 */
const WORKERS = Math.min(Math.max((navigator.hardwareConcurrency || 2) - 1, 1), 4);

const DEFAULT_MACHINE = 'co2-100w';

interface Events extends Record<string, unknown> {
  /** Anything but progress changed. */
  change: State;
  /**
   * A drawing was read; `fresh`: another file, not the same one read otherwise; `same`: its contours are those of before, and
   * so are their numbers.
   */
  loaded: { loaded: Loaded; fresh: boolean; same: boolean };
  /** No drawing, or none that can be used. */
  cleared: void;
  progress: State;
  /** Something to tell that is no state: the planner was replaced. */
  notice: string;
}

/** A drawing as it was given. */
export interface Source {
  bytes: ArrayBuffer | Uint8Array;
  name: string;
}

export class Session extends Emitter<Events> {
  readonly state: State = initialState();
  /** The way back. */
  readonly history = new History();
  /** The drawing in hand. */
  source: Source | null = null;
  private readonly answered = new Set<Question>();
  private run: PlanHandle | null = null;
  private wish = 0;
  private settle = 0;

  /** There from the moment its worker answers. */
  private planner: Planner | null = null;
  private readonly ready: Promise<Planner>;

  constructor(private readonly shared: Shared) {
    super();
    this.ready = createPlanner({ onReplaced: (message) => this.emit('notice', message) }).then((planner) => this.greet(planner));
    this.ready.catch((error: unknown) => this.fail(error));
  }

  /** The machines and methods there are; none before the planner is there. */
  get machines(): readonly MachineProfile[] {
    return [...(this.planner?.machines ?? []), ...kept()];
  }

  get methods(): readonly MethodInfo[] {
    return this.planner?.methods ?? [];
  }

  /** The methods of papers, once somebody has asked for them. */
  papers: readonly PaperMethod[] = [];

  // A method of a paper was shared: its code is loaded first.
  private async chooseShared(method: string): Promise<void> {
    await this.askPapers();
    if (!this.papers.some((m) => m.name === method)) return;
    this.state.search.method = method;
    this.emit('change', this.state);
    this.restart(false);
  }

  /** The settings, for an address that shares them. */
  address(): string {
    const [method] = this.methods;
    return written(this.state, { machine: DEFAULT_MACHINE, method: method?.name ?? '', seconds: initialState().search.seconds });
  }

  /** Loads them. */
  async askPapers(): Promise<void> {
    if (this.papers.length > 0) return;
    try {
      this.papers = await (await this.ready).paperMethods();
      this.emit('change', this.state);
    } catch (error) {
      this.emit('notice', words.page.noPapers(messageOf(error)));
    }
  }

  private greet(planner: Planner): Planner {
    this.planner = planner;
    const { shared, state } = this;
    state.machine = [shared.machine, DEFAULT_MACHINE].map((name) => this.machines.find((m) => m.name === name)).find(Boolean) ?? null;
    state.search.method = this.methods.find((m) => m.name === shared.method)?.name ?? planner.methods[0]?.name ?? '';
    Object.assign(state.search, { seed: shared.seed, seconds: shared.seconds ?? state.search.seconds });
    this.emit('change', state);
    if (shared.method !== null && shared.method !== state.search.method) void this.chooseShared(shared.method);
    return planner;
  }

  /** Takes a drawing into work. */
  async open(bytes: ArrayBuffer | Uint8Array, name: string, sample: boolean, options: LoadOptions = {}): Promise<void> {
    const { state } = this;
    const wish = this.begin();
    this.source = { bytes, name };
    this.answered.clear();
    this.history.clear();
    Object.assign(state, { phase: 'reading', name, sample, load: options, loaded: null, question: null, error: null });
    this.forget();
    this.emit('cleared', undefined);
    this.emit('change', state);
    try {
      const planner = await this.ready;
      if (wish !== this.wish) return;
      const loaded = await planner.load(bytes, name, state.load);
      if (wish === this.wish) this.take(loaded, { fresh: true, same: false });
    } catch (error) {
      if (wish === this.wish) this.fail(error);
    }
  }

  /** Reads the same drawing with other options. */
  async reread(options: LoadOptions): Promise<void> {
    const { state } = this;
    if (!state.loaded) return;
    this.keep();
    if (!sameContours(options, state.load)) {
      if (FATES.some((fate) => options[fate]?.length)) this.emit('notice', words.page.pinsGone);
      options = undecided(options);
    }
    await this.readAs(options);
  }

  private async readAs(options: LoadOptions): Promise<void> {
    const { state, planner } = this;
    if (!state.loaded || !planner) return;
    const wish = this.begin();
    const same = sameContours(options, state.load);
    state.load = options;
    try {
      const loaded = await planner.reload(options);
      if (wish === this.wish) this.take(loaded, { fresh: false, same });
    } catch (error) {
      if (wish === this.wish) this.fail(error);
    }
  }

  /** A file could not even be opened. */
  refuse(name: string, error: unknown): void {
    this.begin();
    Object.assign(this.state, { name, sample: false, loaded: null });
    this.fail(error);
  }

  setUnits(units: Unit): void {
    this.answered.add('units');
    void this.reread({ ...this.state.load, units });
  }

  setOperation(layer: string, operation: Operation): void {
    const layers = this.layers().map((l) => (l.name === layer ? { name: layer, operation } : l));
    void this.reread({ ...this.state.load, layers });
  }

  /** Moves a layer in the order by layer. */
  moveLayer(layer: string, by: -1 | 1): void {
    const layers = this.layers();
    const from = layers.findIndex((l) => l.name === layer);
    const [moved] = layers.splice(from, 1);
    if (!moved) return;
    layers.splice(Math.max(0, Math.min(layers.length, from + by)), 0, moved);
    void this.reread({ ...this.state.load, layers });
  }

  /** The units stand, or damaged entities stay out or are kept: the question is answered. */
  answer(question: Question, options: LoadOptions = {}): void {
    this.answered.add(question);
    if (Object.keys(options).length > 0) void this.reread({ ...this.state.load, ...options });
    else this.ask();
  }

  /** Works a contour before or after all others, leaves it out, or works it whenever it is best. */
  decide(contour: number, fate: Fate | null): void {
    void this.reread(decided(this.state.load, contour, fate));
  }

  /** Works what was pinned to one end of the order, or left out, whenever it is best. */
  loosen(fate: Fate): void {
    void this.reread({ ...this.state.load, [fate]: [] });
  }

  /** Back to what was chosen before. */
  undo(): void {
    this.recall(this.history.undo(this.choices()));
  }

  /** And on again. */
  redo(): void {
    this.recall(this.history.redo(this.choices()));
  }

  private choices(): Choices {
    const { load, machine, search } = this.state;
    return { load, machine, search };
  }

  private keep(typed = false): void {
    this.history.keep(this.choices(), typed);
  }

  private recall(choices: Choices | null): void {
    if (choices === null) return;
    const { load, ...others } = choices;
    Object.assign(this.state, others);
    this.emit('change', this.state);
    if (JSON.stringify(load) === JSON.stringify(this.state.load)) this.restart(false);
    else void this.readAs(load);
  }

  setMachine(machine: MachineProfile, typed = false): void {
    this.keep(typed);
    this.state.machine = machine;
    this.emit('change', this.state);
    this.restart(typed);
  }

  setSearch(search: Partial<Search>, typed = false): void {
    this.keep(typed);
    this.state.search = { ...this.state.search, ...search };
    this.emit('change', this.state);
    this.restart(typed);
  }

  /** Stops, keeping the best path. */
  stop(): void {
    this.run?.stop();
  }

  pause(): void {
    if (this.state.phase !== 'planning') return;
    this.run?.pause();
    this.state.phase = 'paused';
    this.emit('change', this.state);
  }

  resume(): void {
    if (this.state.phase !== 'paused') return;
    this.run?.resume();
    this.state.phase = 'planning';
    this.emit('change', this.state);
  }

  /** Goes on with the plan for another budget. */
  keepImproving(): void {
    const { state, planner } = this;
    if (state.phase !== 'done' || !planner) return;
    state.budget = (state.progress?.seconds ?? 0) + state.search.seconds;
    const { wish } = this;
    this.follow(planner.continue({ seconds: state.search.seconds }, (p) => this.hear(p, wish)), wish);
  }

  /** One of the outputs of the best plan. */
  async output(kind: OutputKind, width?: number): Promise<string | Uint8Array> {
    return (await this.ready).output(kind, width);
  }

  /** The report of a quote of the best plan. */
  async quote(material: Material): Promise<Quote> {
    return (await this.ready).quote(material);
  }

  private layers(): { name: string; operation: Operation }[] {
    const known = this.state.loaded?.layers.map(({ name, operation }) => ({ name, operation })) ?? [];
    const order = new Map(this.state.load.layers?.map((l, i) => [l.name, i]) ?? []);
    return known.sort((a, b) => (order.get(a.name) ?? known.length) - (order.get(b.name) ?? known.length));
  }

  /** Whatever is under way is of no use any more. */
  private begin(): number {
    clearTimeout(this.settle);
    this.run?.stop();
    this.run = null;
    this.wish += 1;
    return this.wish;
  }

  private forget(): void {
    Object.assign(this.state, { baselines: null, found: [], beam: null, common: null, progress: null, path: null, reason: null, seed: null, history: { at: [], total: [] }, insights: noInsights() });
  }

  private take(loaded: Loaded, as: { fresh: boolean; same: boolean }): void {
    this.state.loaded = loaded;
    this.state.extent = extentOf(loaded);
    this.state.error = null;
    this.forget();
    this.emit('loaded', { loaded, ...as });
    this.ask();
  }

  /** Asks the next open question, or plans. */
  private ask(): void {
    const { state } = this;
    const { loaded } = state;
    if (!loaded) return;
    const damaged = loaded.findings.some((f) => f.code === 'damaged-entity');
    const question: Question | null = loaded.units.doubtful && !this.answered.has('units') ? 'units'
      : damaged && !state.load.keepDamaged && !this.answered.has('damaged') ? 'damaged' : null;
    state.question = question;
    if (question) {
      state.phase = 'question';
      this.emit('change', state);
    } else this.plan();
  }

  private restart(typed: boolean): void {
    clearTimeout(this.settle);
    if (!this.state.loaded || this.state.phase === 'question') return;
    if (typed) this.settle = window.setTimeout(() => this.plan(), SETTLE);
    else this.plan();
  }

  /** Plans from the start. */
  plan(): void {
    const { state, planner } = this;
    if (!state.loaded || !state.machine || !planner) return;
    const wish = this.begin();
    this.forget();
    if (worked(state.loaded).length === 0) {
      state.phase = 'ready';
      this.emit('change', state);
      return;
    }
    const { method, parameters, seed, seconds } = state.search;
    // They work alone.
    const paper = this.papers.some((m) => m.name === method);
    state.budget = seconds;
    const options = { machine: state.machine, method, seconds, ...(paper ? { parameters } : { workers: WORKERS }), ...(seed === null ? {} : { seed }) };
    this.follow(planner.plan(options, (p) => this.hear(p, wish)), wish);
  }

  private follow(run: PlanHandle, wish: number): void {
    this.run = run;
    Object.assign(this.state, { phase: 'planning', reason: null, error: null });
    this.emit('change', this.state);
    run.started.then(({ seed, baselines, findings, beam, common }) => {
      if (wish !== this.wish) return;
      Object.assign(this.state, { seed, baselines, found: findings, beam, common });
      this.emit('change', this.state);
    }, () => {
      // A search that cannot start fails in `done`, where it is told.
    });
    run.done.then(
      ({ reason, progress }) => {
        if (wish !== this.wish) return;
        this.run = null;
        this.hear(progress, wish);
        Object.assign(this.state, { phase: 'done', reason });
        this.emit('change', this.state);
      },
      (error: unknown) => {
        if (wish === this.wish) this.halt(error);
      },
    );
  }

  /** There is no plan with these options; the drawing stays. */
  private halt(error: unknown): void {
    this.run = null;
    Object.assign(this.state, { phase: 'ready', error: messageOf(error) });
    this.forget();
    this.emit('change', this.state);
  }

  private hear(progress: Progress, wish: number): void {
    if (wish !== this.wish) return;
    const { state } = this;
    const { history: { at, total } } = state;
    state.progress = progress;
    if (progress.path) state.path = progress.path;
    if (progress.insight) learn(state.insights, progress.insight);
    const best = progress.summary.total_time;
    // While nothing changes, the last point of the chart moves along instead of a new one being set.
    if (at.length > 1 && total.at(-1) === best && total.at(-2) === best) at[at.length - 1] = progress.seconds;
    else {
      at.push(progress.seconds);
      total.push(best);
    }
    this.emit('progress', state);
  }

  private fail(error: unknown): void {
    this.run = null;
    Object.assign(this.state, { phase: 'failed', error: messageOf(error), loaded: null, question: null });
    this.forget();
    this.emit('cleared', undefined);
    this.emit('change', this.state);
  }
}
