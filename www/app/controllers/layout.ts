/** What is open and how large it is: the panel, the bottom sheet of a phone, the table. The sheet is fitted into what they leave free. */

import type { OrderTable } from '../panels/table.js';
import type { Viewport } from '../stage/viewport.js';

/** Pixels around the fitted sheet. */
const MARGIN = { top: 32, right: 24, bottom: 40, left: 40 };
/** The same at the top while the hint is shown. */
const BELOW_HINT = 60;
/** When the table covers more than this share of the stage, the sheet is fitted as if the table were not there. */
const MOST_COVERED = 0.7;

interface Parts {
  stage: HTMLElement;
  hint: HTMLElement;
  toolbar: HTMLElement;
  table: OrderTable;
  /** The buttons that open and close the table and the panel. */
  toggles: { table: HTMLButtonElement; panel: HTMLButtonElement };
}

export class Layout {
  constructor(private readonly viewport: Viewport, private readonly parts: Parts) {
    new ResizeObserver(() => this.update()).observe(parts.stage);
  }

  hideHint(): void {
    this.parts.hint.hidden = true;
    this.update();
  }

  toggleTable(open = !this.parts.table.open): void {
    const { table, toggles } = this.parts;
    table.toggle(open);
    toggles.table.setAttribute('aria-pressed', String(open));
    if (!open) toggles.table.focus();
    this.update();
  }

  togglePanel(): void {
    const closed = document.body.classList.toggle('panel-closed');
    this.parts.toggles.panel.setAttribute('aria-expanded', String(!closed));
  }

  /** Opens or closes the bottom sheet. */
  toggleSheet(): void {
    const open = document.body.classList.toggle('sheet-open');
    document.querySelector('.sheet-toggle')?.setAttribute('aria-expanded', String(open));
  }

  /** Closes the bottom sheet, which covers the stage. */
  closeSheet(): void {
    if (document.body.classList.contains('sheet-open')) this.toggleSheet();
  }

  /** Tells the viewport its size, and what covers it. */
  private update(): void {
    const { stage, hint, toolbar, table } = this.parts;
    const box = stage.getBoundingClientRect();
    const cover = table.open ? table.root.getBoundingClientRect().width : 0;
    const side = cover < box.width * MOST_COVERED ? cover : 0;
    stage.style.setProperty('--cover', `${side}px`);
    // The toolbar is a column at the right, or a row at the bottom of a narrow stage.
    const { offsetWidth: wide, offsetHeight: high } = toolbar;
    const [right, bottom] = wide > high ? [0, high] : [wide, 0];
    this.viewport.resize(box.width, box.height, {
      top: hint.hidden ? MARGIN.top : BELOW_HINT, right: MARGIN.right + right, bottom: MARGIN.bottom + bottom, left: MARGIN.left + side,
    });
  }
}
