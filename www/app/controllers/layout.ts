/** What is open and how large it is: the panel, the bottom sheet of a phone, the table. The sheet is fitted into what they leave free. */

import type { TableDrawer } from '../panels/table-drawer.js';
import type { Viewport } from '../stage/viewport.js';

/** Pixels around the fitted sheet. */
const MARGIN = { top: 60, right: 24, bottom: 40, left: 40 };
/** When the table covers more than this share of the stage, the sheet is fitted as if the table were not there. */
const MOST_COVERED = 0.7;

interface Parts {
  stage: HTMLElement;
  hint: HTMLElement;
  toolbar: HTMLElement;
  table: TableDrawer;
  /** The card of what is selected. */
  card: HTMLElement;
  /** The buttons that open and close the table and the panel. */
  toggles: { table: HTMLButtonElement; panel: HTMLButtonElement };
}

export class Layout {
  constructor(private readonly viewport: Viewport, private readonly parts: Parts) {
    const sizes = new ResizeObserver(() => this.update());
    sizes.observe(parts.stage);
    sizes.observe(parts.card);
  }

  hideHint(): void {
    this.parts.hint.hidden = true;
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
  update(): void {
    const { stage, toolbar, table, card } = this.parts;
    const box = stage.getBoundingClientRect();
    const cover = table.open ? table.root.getBoundingClientRect().width : 0;
    const side = cover < box.width * MOST_COVERED ? cover : 0;
    stage.style.setProperty('--cover', `${side}px`);
    // The toolbar is a column at the right, or a row at the bottom of a narrow stage.
    const { offsetWidth: wide, offsetHeight: high } = toolbar;
    const isNarrow = wide > high;
    // On a narrow stage the card has the whole width, and the sheet the room above it.
    const [right, bottom] = isNarrow ? [0, high + card.offsetHeight] : [wide, 0];
    // Side by side, both stages show the same part of the sheet; on a narrow screen one is above the other.
    const split = document.body.classList.contains('split');
    const [across, down] = !split ? [1, 1] : box.width > box.height ? [2, 1] : [1, 2];
    this.viewport.resize(box.width / across, box.height / down, {
      top: MARGIN.top, right: MARGIN.right + right, bottom: MARGIN.bottom + bottom, left: MARGIN.left + side,
    });
  }
}
