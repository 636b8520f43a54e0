/**
 * The drawing of the page: opening it, asking about what the file leaves open, and reading it again with other options. Planning follows by
 * itself. Only the newest reading counts; the results of older ones are discarded.
 */

import type { Finding, Loaded, LoadOptions, Operation, Unit } from 'kerfway';
import { Latest } from '../core/latest.js';
import { messageOf } from '../core/strings.js';
import { words } from '../core/words/index.js';
import type { Catalog } from './catalog.js';
import type { Planning } from './planning.js';
import { type Rule, RULES, sameContours, withoutRules, withRule } from './rules.js';
import type { Question } from './state.js';
import type { Store } from './store.js';

/** The finding about a rectangle around everything that may be the sheet; undefined if that is clear or decided. */
export function borderInDoubt({ findings }: Loaded): Finding | undefined {
  return findings.find((f) => f.code === 'sheet-outline' && f.severity === 'warning');
}

/** A drawing as it was given. */
export interface Source {
  bytes: ArrayBuffer | Uint8Array;
  name: string;
}

export class Drawing {
  private readonly latest = new Latest();
  private readonly answered = new Set<Question>();
  private opened: Source | null = null;

  /** `record` is called before each choice that reads the drawing again, so that it can be undone. */
  constructor(private readonly store: Store, private readonly catalog: Catalog, private readonly planning: Planning, private readonly record: () => void) {}

  /** The current drawing as it was given. */
  get source(): Source | null {
    return this.opened;
  }

  /** Opens another drawing. */
  async open(source: Source, sample: boolean, options: LoadOptions = {}): Promise<void> {
    const isLatest = this.begin();
    this.opened = source;
    this.answered.clear();
    this.store.openDrawing(source.name, sample, options);
    try {
      const planner = await this.catalog.ready;
      if (!isLatest()) return;
      const loaded = await planner.load(source.bytes, source.name, options);
      if (isLatest()) this.accept(loaded, { fresh: true, same: false });
    } catch (error) {
      if (isLatest()) this.fail(error);
    }
  }

  /** Reports that a file could not even be opened. */
  refuse(name: string, error: unknown): void {
    this.begin();
    this.store.drawingFailed(messageOf(error), name);
  }

  fail(error: unknown): void {
    this.planning.cancel();
    this.store.drawingFailed(messageOf(error));
  }

  /** Reads the drawing with other options, as a choice that can be undone. */
  async choose(options: LoadOptions): Promise<void> {
    const { loaded, load } = this.store.state;
    if (!loaded) return;
    this.record();
    if (sameContours(options, load)) return this.readAgain(options);
    if (RULES.some((rule) => options[rule]?.length)) this.store.notify(words.page.pinsGone);
    return this.readAgain(withoutRules(options));
  }

  /** Reads the drawing with other options. */
  async readAgain(options: LoadOptions): Promise<void> {
    const { loaded: before, load } = this.store.state;
    const { planner } = this.catalog;
    if (!before || !planner) return;
    const isLatest = this.begin();
    const same = sameContours(options, load);
    this.store.readAgain(options);
    try {
      const loaded = await planner.reload(options);
      if (isLatest()) this.accept(loaded, { fresh: false, same });
    } catch (error) {
      if (isLatest()) this.fail(error);
    }
  }

  setUnits(units: Unit): void {
    this.answered.add('units');
    this.change({ units });
  }

  setOperation(layer: string, operation: Operation): void {
    this.change({ layers: this.layers().map((l) => (l.name === layer ? { name: layer, operation } : l)) });
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

  /** Cuts a contour before or after all others or skips it; with `null` it has no rule any more. */
  setRule(contour: number, rule: Rule | null): void {
    void this.choose(withRule(this.store.state.load, contour, rule));
  }

  /** Removes a rule from all contours that have it. */
  clearRule(rule: Rule): void {
    this.change({ [rule]: [] });
  }

  /** Changes some of the options. */
  change(options: LoadOptions): void {
    void this.choose({ ...this.store.state.load, ...options });
  }

  private layers(): { name: string; operation: Operation }[] {
    const { loaded, load } = this.store.state;
    const known = loaded?.layers.map(({ name, operation }) => ({ name, operation })) ?? [];
    const order = new Map(load.layers?.map((l, i) => [l.name, i]) ?? []);
    return known.sort((a, b) => (order.get(a.name) ?? known.length) - (order.get(b.name) ?? known.length));
  }

  /** Whatever is being read or planned is of no use any more. */
  private begin(): () => boolean {
    this.planning.cancel();
    return this.latest.begin();
  }

  private accept(loaded: Loaded, as: { fresh: boolean; same: boolean }): void {
    this.planning.cancel();
    this.store.drawingRead(loaded, as);
    this.askOrPlan();
  }

  /** Asks the next open question. When there is none, it plans. */
  private askOrPlan(): void {
    const { loaded, load } = this.store.state;
    if (!loaded) return;
    const damaged = loaded.findings.some((f) => f.code === 'damaged-entity');
    if (loaded.units.doubtful && !this.answered.has('units')) this.store.ask('units');
    else if (damaged && !load.keepDamaged && !this.answered.has('damaged')) this.store.ask('damaged');
    else if (borderInDoubt(loaded) && !this.answered.has('border')) this.store.ask('border');
    else {
      this.store.questionsAnswered();
      this.planning.start();
    }
  }
}
