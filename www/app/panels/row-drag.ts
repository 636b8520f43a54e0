/** Drags a row of the order table to another place: by its handle with mouse or finger, or with the arrow keys while the handle has the focus. */

import { h } from '../core/dom.js';
import { followPointer, grip } from '../core/grip.js';

/** Pixels from the edge of the list where dragging scrolls it, and how far with each move of the pointer. */
const EDGE = 28;
const STEP = 12;

interface Rows {
  rows(): number;
  /** Moves a row before another one; `to` is the number of rows for the end. */
  move(from: number, to: number): void;
}

export class RowDrag {
  /** A row is being dragged. */
  active = false;
  /** The row whose handle gets the focus when the rows are made again, after a move by keyboard. */
  focus: number | null = null;
  private readonly line = h('div', { class: 'drop-line', hidden: true });

  constructor(private readonly scroller: HTMLElement, private readonly body: HTMLElement, private readonly height: number, private readonly list: Rows) {}

  handle(label: string, row: number): HTMLButtonElement {
    const made = grip(label, { step: (by) => this.step(row, by), press: (_, pressed) => this.begin(pressed, row) });
    made.addEventListener('blur', () => (this.focus = null));
    return made;
  }

  private step(row: number, by: number): boolean {
    const to = row + by;
    if (to < 0 || to >= this.list.rows()) return false;
    this.focus = to;
    this.list.move(row, by < 0 ? to : to + 1);
    return true;
  }

  private begin(pressed: HTMLButtonElement, row: number): void {
    const { line, body, scroller, height } = this;
    let to = row;
    this.active = true;
    body.append(line);
    const item = pressed.closest('.order-row');
    item?.classList.add('dragged');
    const follow = ({ clientY }: PointerEvent) => {
      const view = scroller.getBoundingClientRect();
      if (clientY < view.top + height + EDGE) scroller.scrollTop -= STEP;
      else if (clientY > view.bottom - EDGE) scroller.scrollTop += STEP;
      to = Math.max(0, Math.min(this.list.rows(), Math.round((clientY - body.getBoundingClientRect().top) / height)));
      line.hidden = false;
      line.style.transform = `translateY(${to * height}px)`;
    };
    followPointer(follow, (keep) => {
      this.active = false;
      line.hidden = true;
      item?.classList.remove('dragged');
      if (keep) this.list.move(row, to);
    });
  }
}
