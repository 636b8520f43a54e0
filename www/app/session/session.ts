/**
 * The current job: its state, its drawing and the search for its path. Planning starts by itself, and starts again after every change of the
 * drawing, the machine or the options. Every choice can be undone.
 */

import type { LoadOptions, MachineProfile, Material, OutputKind, Planner, ProgramCheck, Quote } from 'kerfway';
import { type Shared, written } from './address.js';
import { Catalog } from './catalog.js';
import { Drawing, type Source } from './drawing.js';
import { type Choices, History } from './history.js';
import type { Placing } from './placing.js';
import { Planning } from './planning.js';
import { initialState, type Search, type State } from './state.js';
import { Store } from './store.js';

const DEFAULT_MACHINE = 'co2-100w';

export class Session {
  readonly store = new Store();
  readonly catalog = new Catalog(this.store);
  readonly planning = new Planning(this.store, this.catalog);
  readonly drawing = new Drawing(this.store, this.catalog, this.planning, () => this.record());
  private readonly history = new History();

  /** `shared`: the settings of the address that the page was opened with. */
  constructor(private readonly shared: Shared) {
    this.catalog.ready.then((planner) => this.applyShared(planner)).catch((error: unknown) => this.drawing.fail(error));
  }

  get state(): State {
    return this.store.state;
  }

  get canUndo(): boolean {
    return this.history.canUndo;
  }

  get canRedo(): boolean {
    return this.history.canRedo;
  }

  /** Opens another drawing; the choices for the previous one cannot be undone any more. */
  open(source: Source, sample: boolean, options: LoadOptions = {}): Promise<void> {
    this.history.clear();
    return this.drawing.open(source, sample, options);
  }

  /** `typed`: the change is one of many keystrokes. */
  setMachine(machine: MachineProfile, typed = false): void {
    this.record(typed);
    this.store.choose({ machine });
    this.planning.restart(typed);
  }

  /** `typed`: the change is one of many keystrokes. */
  setSearch(search: Partial<Search>, typed = false): void {
    this.record(typed);
    this.store.choose({ search: { ...this.state.search, ...search } });
    this.planning.restart(typed);
  }

  /** `typed`: the change is one of many keystrokes. */
  setPlacing(placing: Partial<Placing>, typed = false): void {
    this.record(typed);
    this.store.choose({ placing: { ...this.state.placing, ...placing } });
    this.planning.restart(typed);
  }

  undo(): void {
    this.restore(this.history.undo(this.choices()));
  }

  redo(): void {
    this.restore(this.history.redo(this.choices()));
  }

  /** The settings, as the part of an address behind `#`. */
  address(): string {
    const [method] = this.catalog.methods;
    return written(this.state, { machine: DEFAULT_MACHINE, method: method?.name ?? '', seconds: initialState().search.seconds });
  }

  /** One of the outputs of the best plan. */
  async output(kind: OutputKind, width?: number): Promise<string | Uint8Array> {
    return (await this.catalog.ready).output(kind, width);
  }

  /** What the check says of the program of the best plan. */
  async preflight(): Promise<ProgramCheck> {
    return (await this.catalog.ready).check();
  }

  /** A small program, which shows what the dialect of a machine looks like. */
  async sampleProgram(machine: MachineProfile): Promise<string> {
    return (await this.catalog.ready).sampleProgram({ machine });
  }

  /** The report that a quote of the best plan is based on. */
  async quote(material: Material): Promise<Quote> {
    return (await this.catalog.ready).quote({ material });
  }

  private choices(): Choices {
    const { load, machine, search, placing } = this.state;
    return { load, machine, search, placing };
  }

  private record(typed = false): void {
    this.history.record(this.choices(), typed);
  }

  private restore(choices: Choices | null): void {
    if (choices === null) return;
    const { load, ...others } = choices;
    this.store.choose(others);
    if (JSON.stringify(load) === JSON.stringify(this.state.load)) this.planning.restart();
    else void this.drawing.readAgain(load);
  }

  /** Takes over the shared settings as far as the planner knows their names. */
  private applyShared({ methods }: Planner): void {
    const { machine, method, seed, seconds, placing } = this.shared;
    const { catalog, state: { search } } = this;
    const named = (name: string | null) => catalog.machines.find((m) => m.name === name);
    const known = methods.find((m) => m.name === method) ?? methods[0];
    this.store.choose({
      machine: named(machine) ?? named(DEFAULT_MACHINE) ?? null,
      placing,
      search: { ...search, method: known?.name ?? '', seed, seconds: seconds ?? search.seconds },
    });
    if (method !== null && method !== known?.name) void this.applySharedPaper(method);
  }

  /** The method may be one from a paper, which is loaded on demand. */
  private async applySharedPaper(method: string): Promise<void> {
    await this.catalog.loadPapers();
    if (!this.catalog.papers.some((m) => m.name === method)) return;
    this.store.choose({ search: { ...this.state.search, method } });
    this.planning.restart();
  }
}
