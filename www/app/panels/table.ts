/**
 * The cutting order as a table. Only the visible rows are in the page, so that 10,000 contours scroll as smoothly as ten. Screen readers are
 * told the number of rows and the place of each.
 */

import { button, h } from '../core/dom.js';
import { clock, count, millimetres, place } from '../core/format.js';
import { shownIn } from '../core/lengths.js';
import { cutLength } from '../stage/shapes.js';
import type { Session } from '../session/session.js';
import type { Playback } from '../playback/playback.js';
import { shiftOf } from '../session/placing.js';
import { pathContours, ruleOf } from '../session/rules.js';
import { longestTime, type Phase } from '../session/state.js';
import { RowDrag } from './row-drag.js';
import { words } from '../core/words/index.js';

/** Height of a row, CSS pixels: in a narrow window a row has two lines, and on a phone it is as high as a finger needs. `styles/table.css` has the same. */
const ROW = matchMedia('(max-width: 899px)').matches ? 44 : 32;
/** Rows that are kept above and below the visible ones. */
const SPARE = 8;
/** The column whose values have no unit of their own. */
const ENTRY = 5;
/** Milliseconds between two refreshes while the path improves: a table that jumps cannot be read. */
const PAUSE = 1000;

/** The phases in which a path is there or follows by itself: while the drawing is read again, the phase is still that of the plan before. */
const BEFORE_A_PATH: ReadonlySet<Phase> = new Set(['reading', 'planning', 'paused', 'done']);

export interface TableActions {
  select(contour: number): void;
  /** Moves a contour before a stop. */
  shift(contour: number, to: number): void;
  close(): void;
}

export class OrderTable {
  readonly root: HTMLElement;
  private readonly body = h('div', { role: 'rowgroup', class: 'rows' });
  private readonly grid = h('div', { role: 'table', class: 'order', 'aria-label': words.table.title, 'aria-colcount': words.table.columns.length });
  private readonly scroller: HTMLElement;
  private readonly drag: RowDrag;
  private selected: number | null = null;
  private timer = 0;
  /** The rows are those of the plan before. */
  private waits = false;

  constructor(private readonly session: Session, private readonly playback: Playback, private readonly actions: TableActions) {
    this.grid.append(
      h('div', { role: 'rowgroup', class: 'order-head' }, h('div', { role: 'row', class: 'order-row', 'aria-rowindex': 1 }, ...words.table.columns.map((c, i) => h('span', { role: 'columnheader' }, i === ENTRY ? `${c}, ${shownIn('mm').unit}` : c)))),
      this.body);
    this.scroller = h('div', { class: 'order-scroll', tabindex: 0, role: 'region', 'aria-label': words.table.rows }, this.grid);
    this.root = h('section', { class: 'drawer', 'aria-labelledby': 'order-title', hidden: true },
      h('div', { class: 'dialog-head' }, h('h2', { id: 'order-title' }, words.table.title), h('span', { class: 'soft' }, words.table.drag), button(words.table.close, { icon: 'close', iconOnly: true, class: 'quiet', onclick: actions.close })),
      this.scroller);
    this.drag = new RowDrag(this.scroller, this.body, ROW, { rows: () => this.playback.stops, move: (stop, to) => this.move(stop, to) });
    this.scroller.addEventListener('scroll', () => this.draw());
    new ResizeObserver(() => this.draw()).observe(this.scroller);
    playback.on('path', () => {
      if (!this.open) return;
      // While the job is planned again, the rows of the plan before stay until the first new path, which is shown at once.
      if (this.waits && playback.stops > 0) this.draw();
      else if (!this.timer) this.timer = window.setTimeout(() => this.draw(), PAUSE);
    });
  }

  get open(): boolean {
    return !this.root.hidden;
  }

  toggle(open: boolean): void {
    this.root.hidden = !open;
    this.draw();
    if (open) this.scroller.focus({ preventScroll: true });
  }

  /** Marks a contour and brings its row into view. */
  select(contour: number | null): void {
    this.selected = contour;
    if (!this.open) return;
    const stop = contour === null ? null : this.playback.stopOf(contour);
    if (stop !== null) {
      const top = stop * ROW, room = this.scroller.clientHeight - 2 * ROW;
      if (top < this.scroller.scrollTop) this.scroller.scrollTop = top;
      else if (top > this.scroller.scrollTop + room) this.scroller.scrollTop = top - room;
    }
    this.draw();
  }

  /** Moves the contour of a stop before another stop. */
  private move(stop: number, to: number): void {
    const contour = this.playback.path?.contours[stop];
    if (contour !== undefined && to !== stop && to !== stop + 1) this.actions.shift(contour, to);
  }

  private draw(): void {
    clearTimeout(this.timer);
    this.timer = 0;
    // The rows stay while one of them is dragged.
    if (!this.open || this.drag.active) return;
    const { stops } = this.playback;
    this.waits = stops === 0 && BEFORE_A_PATH.has(this.session.state.phase);
    if (this.waits) return;
    const first = Math.max(0, Math.floor(this.scroller.scrollTop / ROW) - SPARE);
    const last = Math.min(stops, first + Math.ceil(this.scroller.clientHeight / ROW) + 2 * SPARE);
    this.grid.setAttribute('aria-rowcount', String(stops + 1));
    this.body.style.height = `${stops * ROW}px`;
    const focus = (document.activeElement as HTMLElement | null)?.closest<HTMLElement>('.order-row')?.dataset.stop;
    const onGrip = document.activeElement?.classList.contains('grip') ?? false;
    const rows: HTMLElement[] = [];
    for (let stop = first; stop < last; stop += 1) rows.push(this.row(stop));
    this.body.replaceChildren(...rows);
    if (focus !== undefined) this.body.querySelector<HTMLElement>(`[data-stop="${this.drag.focus ?? focus}"] ${onGrip ? '.grip' : 'button'}`)?.focus({ preventScroll: true });
  }

  private row(stop: number): HTMLElement {
    const path = this.playback.path!;
    const contour = path.contours[stop]!;
    const info = pathContours(this.session.state)[contour];
    const cell = (text: string, extra = '') => h('span', { role: 'cell', class: extra }, text);
    const { load, loaded, placing } = this.session.state;
    const [dx, dy] = shiftOf(placing, loaded);
    const fixed = ruleOf(load, contour) !== null || (load.sequences?.some((s) => s.includes(contour)) ?? false);
    const row = h('div', { role: 'row', class: `order-row${contour === this.selected ? ' selected' : ''}${fixed ? ' fixed' : ''}`, 'aria-rowindex': stop + 2, 'data-stop': stop },
      h('span', { role: 'cell' }, h('button', { type: 'button', class: 'row-button number', 'aria-label': words.table.show(stop + 1), onclick: () => this.actions.select(contour) }, count(stop + 1))),
      h('span', { role: 'cell' }, this.drag.handle(words.table.move(stop + 1), stop)),
      cell(info?.layer ?? ''), cell(info ? millimetres(cutLength(path, stop, info.length)) : '', 'number'), cell(clock(this.playback.begin(stop), this.playback.total, longestTime(this.session.state)), 'number'),
      cell(place(path.points[stop * 4]! + dx, path.points[stop * 4 + 1]! + dy), 'number'),
      cell(info?.closed ? (path.reversed[stop] ? words.table.reversed : words.table.asDrawn) : words.table.open));
    row.style.transform = `translateY(${stop * ROW}px)`;
    return row;
  }
}
