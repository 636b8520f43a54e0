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
  /** The card of a question about the drawing. */
  question: HTMLElement;
  /** The buttons that open and close the table and the panel. */
  toggles: { table: HTMLButtonElement; panel: HTMLButtonElement };
  /** Shows one sheet instead of two side by side. */
  showOne(): void;
}

export class Layout {
  constructor(private readonly viewport: Viewport, private readonly parts: Parts) {
    const sizes = new ResizeObserver(() => this.update());
    sizes.observe(parts.stage);
    sizes.observe(parts.card);
    sizes.observe(parts.question);
  }

  hideHint(): void {
    this.parts.hint.hidden = true;
  }

  /** The table would cover the first of two sheets, so it closes when they begin, and they end when it opens. */
  toggleTable(open = !this.parts.table.open): void {
    const { table, toggles, showOne } = this.parts;
    if (open) showOne();
    else if (table.root.contains(document.activeElement)) toggles.table.focus();
    table.toggle(open);
    toggles.table.setAttribute('aria-pressed', String(open));
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

  /** Opens the panel; on a phone the bottom sheet that holds it. */
  showPanel(): void {
    const isPhone = document.querySelector('.sheet-toggle')?.checkVisibility() === true;
    if (isPhone && !document.body.classList.contains('sheet-open')) this.toggleSheet();
    if (document.body.classList.contains('panel-closed')) this.togglePanel();
  }

  /** Closes the bottom sheet, which covers the stage. */
  closeSheet(): void {
    if (document.body.classList.contains('sheet-open')) this.toggleSheet();
  }

  /** Tells the viewport its size, and what covers it. */
  update(): void {
    const { stage, toolbar, table, card, question } = this.parts;
    const box = stage.getBoundingClientRect();
    const cover = table.open ? table.root.getBoundingClientRect().width : 0;
    const side = cover < box.width * MOST_COVERED ? cover : 0;
    stage.style.setProperty('--cover', `${side}px`);
    // The toolbar is a column at the right, or a row at the bottom of a narrow stage.
    const { offsetWidth: wide, offsetHeight: high } = toolbar;
    const isNarrow = wide > high;
    // On a narrow stage the card has the whole width, and the sheet the room above it. In a low window the card lies over the toolbar.
    const isOver = card.offsetHeight > 0 && card.getBoundingClientRect().bottom > toolbar.getBoundingClientRect().top;
    const [right, below] = isNarrow ? [0, card.offsetHeight + (isOver ? 0 : high)] : [wide, 0];
    // A question lies over the bottom of the stage, and there over a toolbar; in a low window it lies over the panel, or over the right if that is closed.
    const asked = question.getBoundingClientRect();
    const covered = { right: box.right - asked.left, below: box.bottom - asked.top };
    const isAsked = asked.height > 0 && asked.left < box.right;
    const isBeside = covered.right * box.height < covered.below * box.width;
    const [top, bottom] = isAsked && !isBeside ? [MARGIN.bottom, covered.below] : [MARGIN.top, below];
    // Both sheets of a comparison show the same part of the drawing.
    const division = divisionOf(box);
    stage.dataset.division = division;
    const isSplit = document.body.classList.contains('split');
    const [across, down] = !isSplit ? [1, 1] : division === 'across' ? [2, 1] : [1, 2];
    this.viewport.resize(box.width / across, box.height / down, {
      top, right: MARGIN.right + (isAsked && isBeside ? covered.right : right), bottom: MARGIN.bottom + bottom, left: MARGIN.left + side,
    });
  }
}

/** The least width and height of each of two sheets that can be compared, pixels. */
const SHEET = { width: 300, height: 200 };

/** How a stage is divided for two sheets: beside each other, or one above the other; `none` where there is no room for that. */
function divisionOf({ width, height }: { width: number; height: number }): 'across' | 'down' | 'none' {
  const across = width >= 2 * SHEET.width, down = height >= 2 * SHEET.height;
  if (across && (width > height || !down)) return 'across';
  return down ? 'down' : 'none';
}
