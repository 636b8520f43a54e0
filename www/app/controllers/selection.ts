/** The selected contour or finding: on the sheet, on the card, in the table; and the rules for single contours. */

import type { Finding } from 'kerfway';
import type { Announcer } from '../core/announce.js';
import { words } from '../core/words/index.js';
import { ContourCard, describe } from '../panels/contour.js';
import { OrderTable } from '../panels/table.js';
import type { Playback } from '../playback/playback.js';
import { type Rule, ruleOf } from '../session/rules.js';
import type { Session } from '../session/session.js';
import type { Scene } from '../stage/scene.js';

export class Selection {
  readonly card: ContourCard;
  readonly table: OrderTable;
  /** The stop of the last step: a contour that is cut in several stretches has several stops. */
  private stop = 0;

  constructor(
    private readonly session: Session, private readonly playback: Playback, private readonly scene: Scene,
    private readonly announcer: Announcer, closeTable: () => void,
  ) {
    this.card = new ContourCard(session, playback, { toggleRule: (contour, rule) => this.toggleRule(contour, rule), step: (by) => this.stepBy(by), close: () => this.select(null) });
    this.table = new OrderTable(session, playback, (contour) => this.reveal(contour), closeTable);
  }

  select(contour: number | null): void {
    this.scene.highlight({ selected: contour });
    this.card.show(contour);
    this.table.select(contour);
  }

  /** Selects a contour, moves the view to it if needed, and announces it. */
  reveal(contour: number): void {
    this.select(contour);
    const box = this.scene.boxOf(contour);
    if (box) this.scene.viewport.reveal(box);
    this.announcer.say(describe(this.session, this.playback, contour).join(', '));
  }

  /** Clears the selection, and the finding that is shown. */
  clear(): void {
    this.scene.highlight({ finding: null });
    this.select(null);
  }

  /** Updates the card, because the path has changed. */
  refresh(): void {
    if (this.scene.selected !== null) this.card.show(this.scene.selected);
  }

  /** Cuts a contour first or last or skips it; removes that rule if the contour already has it. */
  toggleRule(contour: number | null, rule: Rule): void {
    if (contour === null) return;
    const has = ruleOf(this.session.state.load, contour) === rule;
    const [name = ''] = describe(this.session, this.playback, contour);
    this.session.drawing.setRule(contour, has ? null : rule);
    this.announcer.say(has ? words.page.unpinned(name) : words.page.decided[rule](name));
  }

  /** The same for the selected contour. */
  toggleSelected(rule: Rule): void {
    this.toggleRule(this.scene.selected, rule);
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
    if (contour !== undefined) this.reveal(contour);
  }
}
