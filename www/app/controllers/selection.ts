/** The selected contours or finding: on the sheet, on the card, in the table; and the rules for what is selected. */

import type { ContourChoice, Finding } from 'kerfway';
import type { Announcer } from '../core/announce.js';
import { count } from '../core/format.js';
import { words } from '../core/words/index.js';
import { ContourCard, describe } from '../panels/contour.js';
import { TableDrawer } from '../panels/table-drawer.js';
import type { Playback } from '../playback/playback.js';
import { partsOf } from '../session/parts.js';
import { choosing, groupOf, withChoice, withGroup, withoutGroup } from '../session/groups.js';
import { holds, isDrawn, namedBy, type Rule, shifted, withSequence } from '../session/rules.js';
import type { Session } from '../session/session.js';
import type { Scene } from '../stage/scene.js';

export class Selection {
  readonly card: ContourCard;
  readonly table: TableDrawer;
  /** The stop of the last step: a contour that is cut in several stretches has several stops. */
  private stop = 0;
  /** What is selected, in the order in which it was. */
  private chosen: readonly number[] = [];
  /** Clicks and steps add to the selection. */
  private adding = false;

  constructor(
    private readonly session: Session, private readonly playback: Playback, private readonly scene: Scene,
    private readonly announcer: Announcer, closeTable: () => void, private readonly relayout: () => void,
  ) {
    this.card = new ContourCard(session, playback, {
      toggleRule: (rule) => this.toggleSelected(rule), whole: () => this.selectWhole(), like: () => this.selectLike(), keepOrder: () => this.keepOrder(),
      group: () => this.toggleGroup(), choose: (what, value) => this.choose(what, value),
      step: (by) => this.stepBy(by), close: () => this.select(null),
    });
    this.table = new TableDrawer(session, playback, { select: (contour) => this.reveal(contour), shift: (contour, to) => this.shift(contour, to), close: closeTable, loaded: relayout });
  }

  get contours(): readonly number[] {
    return this.chosen;
  }

  /** Whether clicks and steps add to the selection. */
  get several(): boolean {
    return this.adding;
  }

  set several(on: boolean) {
    this.adding = on;
  }

  select(contour: number | null): void {
    this.selectAll(contour === null ? [] : [contour]);
  }

  /** Selects contours; the last one is shown in the table. What was not drawn is selected only by itself. */
  selectAll(chosen: readonly number[]): void {
    const { loaded } = this.session.state;
    const contours = chosen.length < 2 || !loaded ? chosen : chosen.filter((c) => isDrawn(loaded, c));
    this.chosen = contours;
    const last = contours.at(-1) ?? null;
    this.scene.highlight({ selected: last, others: contours.slice(0, -1) });
    this.card.show(contours);
    this.table.select(last);
  }

  private sayHowMany(): void {
    this.announcer.say(words.contour.selected(this.chosen.length, count(this.chosen.length)));
  }

  /** Adds contours to the selection, or removes them if all of them are in it. */
  toggle(contours: readonly number[]): void {
    const had = new Set(this.chosen);
    const rest = this.chosen.filter((c) => !contours.includes(c));
    this.selectAll(contours.every((c) => had.has(c)) ? rest : [...rest, ...contours]);
    this.sayHowMany();
  }

  /** Selects what lies in a box, mm, in addition to what is selected while several are being selected. */
  selectBox(x0: number, y0: number, x1: number, y1: number): void {
    const { loaded } = this.session.state;
    if (!loaded) return;
    const inside = partsOf(loaded).within(Math.min(x0, x1), Math.min(y0, y1), Math.max(x0, x1), Math.max(y0, y1));
    this.selectAll([...this.chosen.filter((c) => this.adding && !inside.includes(c)), ...inside]);
    this.sayHowMany();
  }

  /** Selects the whole parts of what is selected. */
  selectWhole(): void {
    const { loaded } = this.session.state;
    if (loaded) this.selectAll(partsOf(loaded).whole(this.chosen));
  }

  /** Selects everything like what is selected. */
  selectLike(): void {
    const { loaded } = this.session.state;
    if (!loaded || this.chosen.length === 0) return;
    this.selectAll(partsOf(loaded).like(this.chosen));
    this.sayHowMany();
  }

  /** Selects a contour, moves the view to it if needed, and announces it. */
  reveal(contour: number): void {
    this.select(contour);
    // A sheet that is fitted makes room for the card, which shows the contour without moving the view.
    this.relayout();
    const box = this.scene.boxOf(contour);
    const { offsetLeft, offsetTop, offsetWidth } = this.card.root;
    if (box) this.scene.viewport.reveal(box, { right: offsetLeft + offsetWidth, top: offsetTop });
    this.announcer.say(describe(this.session, this.playback, contour).join(', '));
  }

  /** Clears the selection, and the finding that is shown. */
  clear(): void {
    this.scene.highlight({ finding: null });
    this.select(null);
  }

  /** Updates the card, because the path has changed. */
  refresh(): void {
    if (this.chosen.length > 0) this.card.show(this.chosen);
  }

  /** Gives contours a rule, or removes it if all of them have it. */
  toggleRule(contours: readonly number[], rule: Rule): void {
    const { state: { load, loaded }, drawing } = this.session;
    if (contours.length === 0 || !loaded || !contours.every((c) => isDrawn(loaded, c))) return;
    const has = holds(load, loaded, contours, rule);
    const name = contours.length === 1 ? (describe(this.session, this.playback, contours[0]!)[0] ?? '') : words.drawing.contours(contours.length, count(contours.length));
    drawing.setRule(has ? contours : namedBy(loaded, contours, rule), has ? null : rule);
    this.announcer.say(has ? words.page.unpinned(name) : words.page.decided[rule](name));
  }

  /** The same for what is selected. */
  toggleSelected(rule: Rule): void {
    this.toggleRule(this.chosen, rule);
  }

  /** Keeps what is selected together, or not any more if it is a group. */
  toggleGroup(): void {
    const { state: { load, loaded }, drawing } = this.session;
    if (!loaded || this.chosen.length < 2) return;
    const group = groupOf(load, loaded, this.chosen);
    drawing.change(group ? withoutGroup(load, group) : withGroup(load, loaded, this.chosen));
    const name = words.drawing.contours(this.chosen.length, count(this.chosen.length));
    this.announcer.say(group ? words.page.unpinned(name) : words.drawing.together(name));
  }

  /** Gives what is selected a number of micro-joints, a lead or corners; null: by the rules of the machine. */
  private choose<K extends 'joints' | 'lead' | 'corners'>(what: K, value: NonNullable<ContourChoice[K]> | null): void {
    const { state: { load, loaded }, drawing } = this.session;
    if (loaded) drawing.change(withChoice(load, choosing(loaded, this.chosen, what), what, value));
  }

  /** Fixes the order in which the selected parts are cut now. */
  keepOrder(): void {
    const { state: { load, loaded }, drawing } = this.session;
    if (!loaded) return;
    const named = namedBy(loaded, this.chosen, 'first').filter((c) => this.playback.stopOf(c) !== null);
    const order = named.sort((a, b) => this.playback.stopOf(a)! - this.playback.stopOf(b)!);
    if (order.length > 1) drawing.change(withSequence(load, [], order));
  }

  /** Moves a contour in the cutting order. `to`: the stop before which it comes. */
  shift(contour: number, to: number): void {
    const { state: { load, loaded }, drawing, store } = this.session;
    const { path } = this.playback;
    if (!loaded || !path) return;
    if (!isDrawn(loaded, contour)) return store.notify(words.contour.why.skeleton);
    const order = [...new Set(path.contours)].filter((c) => isDrawn(loaded, c));
    const before = path.contours[to];
    const next = shifted(load, loaded, { order, contour, to: before === undefined || !isDrawn(loaded, before) ? order.length : order.indexOf(before) });
    if (next === null) store.notify(words.table.inside);
    else drawing.change(next);
  }

  stepToFirst(): void {
    this.stepTo(0);
  }

  stepToLast(): void {
    this.stepTo(this.playback.stops - 1);
  }

  /** Steps forwards or backwards in the order, from the selected contour. */
  stepBy(by: 1 | -1): void {
    const { selected } = this.scene;
    const atStop = selected !== null && this.playback.path?.contours[this.stop] === selected;
    const from = selected === null ? null : atStop ? this.stop : this.playback.stopOf(selected);
    if (from !== null) this.stepTo(from + by);
    else if (by > 0) this.stepToFirst();
    else this.stepToLast();
  }

  /** Emphasises a finding. */
  showFinding(finding: Finding | null): void {
    this.scene.highlight({ finding });
  }

  private stepTo(stop: number): void {
    this.stop = Math.max(0, Math.min(this.playback.stops - 1, stop));
    const contour = this.playback.path?.contours[this.stop];
    if (contour === undefined) return;
    const before = this.chosen.filter((c) => c !== contour);
    this.reveal(contour);
    if (this.adding) this.selectAll([...before, contour]);
  }
}
