/**
 * The drawing of the page: opening it, asking about what the file leaves open, and reading it again with other options. Planning follows by
 * itself. A file or an option that cannot be used leaves everything as it was.
 */

import { type Finding, given, type LayerChoice, type Loaded, type LoadOptions, type Operation } from 'kerfway';
import { Latest } from '../core/latest.js';
import { messageOf } from '../core/strings.js';
import { words } from '../core/words/index.js';
import type { Catalog } from './catalog.js';
import { type KeptPlan, keptPlan } from './kept-plan.js';
import type { Planning } from './planning.js';
import { namesContours, type Rule, sameContours, withoutRules, withRule } from './rules.js';
import { type Question, QUESTIONS, type State } from './state.js';
import type { Store } from './store.js';
import { prepareSlowly } from '../stage/shapes.js';

/** The finding about a rectangle around everything that may be the sheet; undefined if that is clear or decided. */
export function borderInDoubt({ findings }: Loaded): Finding | undefined {
  return findings.find((f) => f.code === 'sheet-outline' && f.severity === 'warning');
}

/** A drawing as it was given. */
export interface Source {
  bytes: ArrayBuffer | Uint8Array;
  name: string;
}

/** How a drawing is opened. */
export interface Opening {
  /** It is one of the samples, not the person's own. */
  sample: boolean;
  load?: LoadOptions;
  /** A plan of it that was kept. Its questions were answered then. */
  plan?: KeptPlan | null;
  /** Called when the file has been read and takes the place of the one before. */
  opened?: () => void;
}

export class Drawing {
  private readonly latest = new Latest();
  private answered = new Set<Question>();
  /** Resolves when the file before has been read. */
  private turn: Promise<void> = Promise.resolve();
  private opened: Source | null = null;
  /** The options that the shown drawing was read with. */
  private readWith: LoadOptions = {};

  /** `record` is called before each choice that reads the drawing again, so that it can be undone. */
  constructor(private readonly store: Store, private readonly catalog: Catalog, private readonly planning: Planning, private readonly record: () => void) {}

  /** The current drawing as it was given. */
  get source(): Source | null {
    return this.opened;
  }

  /** Whether the drawing is shown as it was last chosen; otherwise it is being read again. */
  get isRead(): boolean {
    return this.store.state.load === this.readWith;
  }

  /**
   * Opens another drawing. One that cannot be used leaves the drawing before as it was. Resolves to the reason, one sentence, or to null. Files
   * are read one after the other, and of those that wait only the newest is.
   */
  async open(source: Source, { sample, load = {}, plan = null, opened = () => {} }: Opening): Promise<string | null> {
    const isLatest = this.latest.begin();
    const before = this.store.state;
    this.store.reading(source.name);
    const turn = this.turn;
    const reading = turn.then(() => (isLatest() ? this.read(source, load) : null));
    this.turn = reading.then(() => {}, () => {});
    try {
      const loaded = await reading;
      if (loaded === null) return null;
      this.planning.cancel();
      this.opened = source;
      this.readWith = load;
      this.answered = new Set(plan === null ? [] : QUESTIONS);
      opened();
      this.store.drawingOpened(loaded, { name: source.name, sample, load });
      this.askOrPlan(plan);
      return null;
    } catch (error) {
      const sentence = this.refuse(source.name, error, before);
      // A choice that was being read when the file came is read now.
      if (!this.isRead) void this.readAgain(this.store.state.load);
      return sentence;
    }
  }

  private async read(source: Source, load: LoadOptions): Promise<Loaded> {
    this.store.reading(source.name);
    const loaded = await (await this.catalog.ready).load(source.bytes, source.name, load);
    await prepareSlowly(loaded.geometry);
    return loaded;
  }

  /** Reports that a file cannot be used, and returns the sentence. `before`: the state when it was chosen. */
  refuse(name: string, error: unknown, before: State = this.store.state): string {
    const sentence = messageOf(error);
    this.store.fileRefused(name, sentence);
    // What was chosen meanwhile counts from now on.
    const { machine, search, placing } = this.store.state;
    if (machine !== before.machine || search !== before.search || placing !== before.placing) this.planning.restart();
    return sentence;
  }

  /** Reads the drawing with other options, as a choice that can be undone. */
  async choose(options: LoadOptions): Promise<void> {
    const { loaded, load, opening } = this.store.state;
    if (!loaded || opening !== null) return;
    this.record();
    // While contours get other numbers, a choice is still about those that are shown.
    if (sameContours(options, load) && sameContours(load, this.readWith)) return this.readAgain(options);
    if (namesContours(options)) this.store.notify(words.page.pinsGone);
    return this.readAgain(withoutRules(options));
  }

  /** Reads the drawing with other options. `plan`: the plan that was found with them, if there is one. */
  async readAgain(options: LoadOptions, plan: KeptPlan | null = null): Promise<void> {
    const { loaded: before, load, opening } = this.store.state;
    const { planner } = this.catalog;
    if (!before || !planner || opening !== null) return;
    const present = keptPlan(this.store.state);
    this.planning.cancel();
    const isLatest = this.latest.begin();
    const same = sameContours(options, this.readWith);
    this.store.readAgain(options, same);
    try {
      const loaded = await planner.reload(options);
      if (isLatest()) await prepareSlowly(loaded.geometry);
      if (!isLatest()) return;
      this.planning.cancel();
      this.readWith = options;
      this.store.drawingRead(loaded, { fresh: false, same });
      this.askOrPlan(plan);
    } catch (error) {
      if (!isLatest()) return;
      this.store.notify(messageOf(error));
      // A choice before this one may have been overtaken by it: that one is read now.
      const before = options === load ? this.readWith : load;
      this.store.readAsBefore(before);
      if (before !== this.readWith) return this.readAgain(before);
      this.planning.continueFrom(present);
    }
  }

  /** Reads the drawing in a unit, or in pixels of a resolution. */
  setUnits({ units, dpi }: Pick<LoadOptions, 'units' | 'dpi'>): void {
    const { units: _, dpi: __, ...load } = this.store.state.load;
    void this.choose({ ...load, ...(units === undefined ? {} : { units }), ...(dpi === undefined ? {} : { dpi }) });
  }

  setOperation(layer: string, operation: Operation): void {
    this.setLayer(layer, { operation });
  }

  /** Changes what is done with a layer; `undefined` takes a setting back. */
  setLayer(layer: string, choice: Partial<LayerChoice>): void {
    this.change({ layers: this.layers().map((l) => (l.name === layer ? given({ ...l, ...choice }) : l)) });
  }

  /** What was set for a layer. */
  settingsOf(layer: string): LayerChoice | undefined {
    return this.store.state.load.layers?.find((l) => l.name === layer);
  }

  /** Moves a layer in the list that "order by layer" follows. */
  moveLayer(layer: string, by: -1 | 1): void {
    const layers = this.layers();
    const from = layers.findIndex((l) => l.name === layer);
    const [moved] = layers.splice(from, 1);
    if (!moved) return;
    layers.splice(Math.max(0, Math.min(layers.length, from + by)), 0, moved);
    this.change({ layers });
  }

  /** Answers a question: the units are right, damaged entities are skipped or kept, or the border is. */
  answer(question: Question, options: LoadOptions = {}): void {
    this.answered.add(question);
    if (Object.keys(options).length > 0) this.change(options);
    else this.askOrPlan();
  }

  /** Cuts contours before or after all others, marks or skips them; with `null` they have no rule any more. */
  setRule(contours: readonly number[], rule: Rule | null): void {
    void this.choose(withRule(this.store.state.load, contours, rule));
  }

  /** Removes a rule from all contours that have it. */
  clearRule(rule: Rule): void {
    const { load } = this.store.state;
    void this.choose(withRule(load, load[rule] ?? [], null));
  }

  /** Changes some of the options. */
  change(options: LoadOptions): void {
    void this.choose({ ...this.store.state.load, ...options });
  }

  /** What is decided for each layer, but not for those about which there is a question; also while the drawing is being read again with it. */
  private layers(): LayerChoice[] {
    const { loaded, load } = this.store.state;
    const known = loaded?.layers.map(({ name, operation, suggestion }): LayerChoice => ({ name, ...(suggestion ? {} : { operation }), ...load.layers?.find((l) => l.name === name) })) ?? [];
    const order = new Map(load.layers?.map((l, i) => [l.name, i]) ?? []);
    return known.sort((a, b) => (order.get(a.name) ?? known.length) - (order.get(b.name) ?? known.length));
  }

  /** Asks the next open question. When there is none, it plans, or goes on with a plan that was kept. */
  private askOrPlan(plan: KeptPlan | null = null): void {
    const { loaded, load } = this.store.state;
    if (!loaded) return;
    const damaged = loaded.findings.some((f) => f.code === 'damaged-entity');
    // A unit that was chosen is not in doubt; it is again when the choice is undone.
    if (loaded.units.doubtful) this.store.ask('units');
    else if (damaged && !load.keepDamaged && !this.answered.has('damaged')) this.store.ask('damaged');
    else if (borderInDoubt(loaded) && !this.answered.has('border')) this.store.ask('border');
    else {
      this.store.questionsAnswered();
      this.planning.start(plan);
    }
  }
}
