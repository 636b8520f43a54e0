/**
 * The current job: its state, its drawing and the search for its path. Planning starts by itself, and starts again after every change of the
 * drawing, the machine or the options. Every choice can be undone.
 */

import {
  type Calibration, type LoadOptions, type MachineProfile, type Material, type MeasuredPlan, type OutputKind, type Planner, type ProgramCheck, type Project, type Quote,
} from 'kerfway';
import { messageOf } from '../core/strings.js';
import { type Shared, written } from './address.js';
import { Catalog } from './catalog.js';
import { Drawing, type Source } from './drawing.js';
import { type Choices, History } from './history.js';
import type { Decided } from './kept-sample.js';
import { type Placing, shiftOf } from './placing.js';
import { keptPlan } from './kept-plan.js';
import { Planning } from './planning.js';
import { rememberedMachine, rememberMachine } from './profiles.js';
import { decidedIn, keptIn, projectOf } from './projects.js';
import type { Sample } from './samples.js';
import { initialState, type Search, type State } from './state.js';
import { Store } from './store.js';
import { words } from '../core/words/index.js';

const DEFAULT_MACHINE = 'co2-100w';

/** A machine and the setting of its library that a person has chosen. */
export type OwnMachine = Pick<State, 'machine' | 'material'>;

export class Session {
  readonly store = new Store();
  readonly catalog = new Catalog(this.store);
  readonly planning = new Planning(this.store, this.catalog);
  readonly drawing = new Drawing(this.store, this.catalog, this.planning, () => this.record());
  private readonly history = new History();
  /** The machine of the open sample, and what was chosen before. */
  private lent: { machine: MachineProfile; own: OwnMachine } | null = null;

  /** `shared`: the settings of the address that the page was opened with. */
  constructor(private readonly shared: Shared) {
    this.catalog.ready.then((planner) => this.applyShared(planner)).catch((error: unknown) => this.store.plannerFailed(messageOf(error)));
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

  /** Opens another drawing; the choices for the previous one cannot be undone any more. Resolves to why it cannot be used, or to null. */
  open(source: Source, load: LoadOptions = {}): Promise<string | null> {
    return this.drawing.open(source, { sample: false, load, opened: () => this.begin(null) });
  }

  /** Opens a sample. Its machine, if it has one, is there until the next drawing is opened. `isWanted`: nothing else was chosen meanwhile. */
  async openSample({ file, machine }: Sample, bytes: ArrayBuffer, { load, own }: Decided, isWanted: () => boolean): Promise<string | null> {
    if (machine || own) await this.catalog.ready;
    if (!isWanted()) return null;
    const preset = this.catalog.machines.find((m) => m.name === machine?.preset);
    const lent = machine && preset ? { ...structuredClone(preset), ...machine.changes } : null;
    const opened = () => {
      this.begin(lent);
      if (own) this.store.choose(own);
    };
    return this.drawing.open({ bytes, name: file }, { sample: true, load, opened });
  }

  /** Begins with another drawing, on the machine of a sample or the person's own. */
  private begin(machine: MachineProfile | null): void {
    this.history.clear();
    const own = this.own();
    this.lent = machine && { machine, own };
    this.store.choose(machine ? { machine, material: null } : own);
  }

  /** The person's own machine. Once somebody has changed the machine of a sample, it is their own. */
  private own(): OwnMachine {
    const { state: { machine, material }, lent } = this;
    return lent?.machine === machine ? lent.own : { machine, material };
  }

  /** The machine that somebody has chosen for the open sample; null where the address and the sample say which one it has. */
  chosenMachine(): OwnMachine | null {
    const { state: { machine, material }, lent } = this;
    if (machine === null || machine === lent?.machine) return null;
    const isUsual = lent === null && material === null && JSON.stringify(machine) === JSON.stringify(this.catalog.machines.find((m) => m.name === machine.name));
    return isUsual ? null : { machine, material };
  }

  /** Opens a project: its drawing, with everything that was decided about it, and its plan. `isWanted`: as above. Resolves as `open` does. */
  async openProject(project: Project, isWanted: () => boolean): Promise<string | null> {
    const { method } = project.planning;
    await this.catalog.ready;
    if (method !== undefined && !this.catalog.methods.some((m) => m.name === method)) await this.catalog.loadPapers();
    if (!isWanted()) return null;
    const opened = () => {
      this.history.clear();
      this.store.choose(decidedIn(project, this.state, this.catalog.machines));
    };
    const { name, drawing, reading, plan } = project;
    return this.drawing.open({ bytes: drawing, name }, { sample: false, load: reading, plan: plan === null ? null : keptIn(project, plan), opened });
  }

  /** The current job as a project; null while there is no drawing. */
  get project(): Project | null {
    return projectOf(this.state, this.drawing.source);
  }

  /** `typed`: the change is one of many keystrokes. */
  setMachine(machine: MachineProfile, typed = false): void {
    this.record(typed);
    // A material that the machine has no setting for is not kept.
    const { material } = this.state;
    // Once a machine was kept, the last one chosen is the one the page starts with.
    if (rememberedMachine() !== null && this.catalog.machines.some((m) => m.name === machine.name)) rememberMachine(machine.name);
    const known = machine.materials?.some((m) => m.name === material) === true;
    this.store.choose({ machine, material: known ? material : null });
    this.planning.restart(typed);
  }

  /** `typed`: the change is one of many keystrokes. */
  setSearch(search: Partial<Search>, typed = false): void {
    this.record(typed);
    this.store.choose({ search: { ...this.state.search, ...search } });
    this.planning.restart(typed);
  }

  /** Chooses a setting of the machine's library, or its own values. */
  setMaterial(material: string | null): void {
    this.record();
    this.store.choose({ material });
    this.planning.restart();
  }

  /** `typed`: the change is one of many keystrokes. */
  setPlacing(placing: Partial<Placing>, typed = false): void {
    this.record(typed);
    this.store.choose({ placing: { ...this.state.placing, ...placing } });
    this.planning.restart(typed);
  }

  undo(): void {
    if (this.state.opening === null) this.restore(this.history.undo(this.choices()));
  }

  redo(): void {
    if (this.state.opening === null) this.restore(this.history.redo(this.choices()));
  }

  /** The settings, as the part of an address behind `#`. The machine of a sample is not among them. */
  address(): string {
    const [method] = this.catalog.methods;
    return written({ ...this.state, machine: this.own().machine }, { machine: DEFAULT_MACHINE, method: method?.name ?? '', seconds: initialState().search.seconds });
  }

  /** One of the outputs of the best plan. */
  async output(kind: OutputKind, width?: number): Promise<string | Uint8Array> {
    return (await this.withPlan()).output(kind, width);
  }

  /** What the check says of the program of the best plan. */
  async preflight(): Promise<ProgramCheck> {
    return (await this.withPlan()).check();
  }

  /** A small program, which shows what the dialect of a machine looks like. */
  async sampleProgram(machine: MachineProfile): Promise<string> {
    return (await this.catalog.ready).sampleProgram({ machine });
  }

  /** Fits the machine to the seconds that jobs took. */
  async calibrate(measured: readonly MeasuredPlan[]): Promise<Calibration> {
    const { machine, material } = this.state;
    if (machine === null) throw new Error(words.page.somethingElse);
    const pierce = machine.materials?.find((m) => m.name === material)?.pierce_time;
    return (await this.catalog.ready).calibrate({ ...machine, pierce_time: pierce ?? machine.pierce_time }, measured);
  }

  /** The report that a quote of the best plan is based on. */
  async quote(material: Material): Promise<Quote> {
    return (await this.withPlan()).quote({ material });
  }

  /** The report of the best plan, as HTML; null while there is none. */
  async report(): Promise<string | null> {
    const { loaded, progress, baselines, path, beam, placing, planFindings: findings } = this.state;
    if (loaded === null || progress === null || baselines === null || path === null) return null;
    const [svg, quote] = [(await this.output('svg')) as string, await this.quote({})];
    // What cannot be written has no program.
    const program = (await this.output('gcode').catch(() => null)) as string | null;
    const { jobReport, reportText } = await import('./report-text.js');
    return jobReport({ loaded, summary: progress.summary, baselines, path, beam, findings, shift: shiftOf(placing, loaded), svg, program, quote, date: new Date(), text: reportText() });
  }

  /** The planner, to be asked about the best plan. */
  private async withPlan(): Promise<Planner> {
    const planner = await this.catalog.ready;
    // The plan of before is not that of the choice.
    if (this.state.applying) throw new Error(words.page.stillApplying);
    return planner;
  }

  private choices(): Choices {
    const { load, machine, search, placing, material } = this.state;
    // A plan is of the drawing as it is shown.
    return { load, machine, search, placing, material, plan: this.drawing.isRead ? keptPlan(this.state) : null };
  }

  private record(typed = false): void {
    this.history.record(this.choices(), typed);
  }

  private restore(choices: Choices | null): void {
    if (choices === null) return;
    const { load, plan, ...others } = choices;
    this.store.choose(others);
    if (JSON.stringify(load) === JSON.stringify(this.state.load)) this.planning.continueFrom(plan);
    else void this.drawing.readAgain(load, plan);
  }

  /** Takes over the shared settings as far as the planner knows their names. */
  private applyShared({ methods }: Planner): void {
    const { machine, method, seed, seconds, placing } = this.shared;
    const { catalog, state: { search } } = this;
    const named = (name: string | null) => catalog.machines.find((m) => m.name === name);
    const known = methods.find((m) => m.name === method) ?? methods[0];
    this.store.choose({
      machine: named(machine) ?? named(rememberedMachine()) ?? named(DEFAULT_MACHINE) ?? null,
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
