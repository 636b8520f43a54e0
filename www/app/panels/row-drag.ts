/** Drags a row of the order table to another place: by its handle with mouse or finger, or with the arrow keys while the handle has the focus. */

import { button, h } from '../core/dom.js';

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
    const grip = button(label, { icon: 'grip', iconOnly: true, class: 'quiet small grip' });
    grip.addEventListener('keydown', (event) => {
      const by = event.key === 'ArrowUp' ? -1 : event.key === 'ArrowDown' ? 1 : 0;
      const to = row + by;
      if (by === 0 || to < 0 || to >= this.list.rows()) return;
      event.preventDefault();
      event.stopPropagation();
      this.focus = to;
      this.list.move(row, by < 0 ? to : to + 1);
    });
    grip.addEventListener('blur', () => (this.focus = null));
    grip.addEventListener('pointerdown', (event) => {
      if (event.button === 0) this.begin(event, grip, row);
    });
    return grip;
  }

  private begin(event: PointerEvent, grip: HTMLButtonElement, row: number): void {
    event.preventDefault();
    const { line, body, scroller, height } = this;
    let to = row;
    this.active = true;
    body.append(line);
    const item = grip.closest('.order-row');
    item?.classList.add('dragged');
    const follow = ({ clientY }: PointerEvent) => {
      const view = scroller.getBoundingClientRect();
      if (clientY < view.top + height + EDGE) scroller.scrollTop -= STEP;
      else if (clientY > view.bottom - EDGE) scroller.scrollTop += STEP;
      to = Math.max(0, Math.min(this.list.rows(), Math.round((clientY - body.getBoundingClientRect().top) / height)));
      line.hidden = false;
      line.style.transform = `translateY(${to * height}px)`;
    };
    const end = (keep: boolean) => {
      removeEventListener('pointermove', follow);
      removeEventListener('pointerup', drop);
      removeEventListener('pointercancel', cancel);
      removeEventListener('keydown', escape, true);
      this.active = false;
      line.hidden = true;
      item?.classList.remove('dragged');
      if (keep) this.list.move(row, to);
    };
    const drop = () => end(true);
    const cancel = () => end(false);
    const escape = (e: KeyboardEvent) => {
      if (e.key !== 'Escape') return;
      e.stopPropagation();
      end(false);
    };
    addEventListener('pointermove', follow);
    addEventListener('pointerup', drop);
    addEventListener('pointercancel', cancel);
    addEventListener('keydown', escape, true);
  }
}
