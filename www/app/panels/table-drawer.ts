/** The drawer of the order table. The table itself is loaded when it is first opened. */

import { h } from '../core/dom.js';
import { messageOf } from '../core/strings.js';
import type { Playback } from '../playback/playback.js';
import type { Session } from '../session/session.js';
import type { OrderTable, TableActions } from './table.js';

export class TableDrawer {
  /** Holds the table's place until it is loaded. */
  root: HTMLElement = h('section', { hidden: true });
  open = false;
  private table: OrderTable | null = null;
  private selected: number | null = null;

  constructor(private readonly session: Session, private readonly playback: Playback, private readonly actions: TableActions & { loaded(): void }) {}

  toggle(open: boolean): void {
    this.open = open;
    if (this.table !== null) this.table.toggle(open);
    else if (open) {
      this.load().catch((error: unknown) => {
        this.actions.close();
        this.session.store.notify(messageOf(error));
      });
    }
  }

  /** Marks a contour and brings its row into view. */
  select(contour: number | null): void {
    this.selected = contour;
    this.table?.select(contour);
  }

  private async load(): Promise<void> {
    const { OrderTable } = await import('./table.js');
    if (this.table !== null) return;
    this.table = new OrderTable(this.session, this.playback, this.actions);
    this.root.replaceWith(this.table.root);
    this.root = this.table.root;
    this.table.toggle(this.open);
    this.table.select(this.selected);
    this.actions.loaded();
  }
}
