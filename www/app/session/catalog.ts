/** The planner of the page, and what it offers: machines, methods, and on demand the methods from published papers. */

import { createPlanner, type MachineProfile, type MethodInfo, type PaperMethod, type Planner } from 'kerfway';
import { messageOf } from '../core/strings.js';
import { words } from '../core/words/index.js';
import { savedMachines } from './profiles.js';
import type { Store } from './store.js';

export class Catalog {
  /** Resolves when the worker of the planner answers. */
  readonly ready: Promise<Planner>;
  private current: Planner | null = null;
  private paperList: readonly PaperMethod[] = [];

  constructor(private readonly store: Store) {
    this.ready = createPlanner({ onReplaced: (sentence) => store.notify(sentence) }).then((planner) => (this.current = planner));
  }

  /** The planner, or null while it is being loaded. */
  get planner(): Planner | null {
    return this.current;
  }

  /** The presets and the person's own machines. There are no presets before the planner is ready. */
  get machines(): readonly MachineProfile[] {
    return [...(this.current?.machines ?? []), ...savedMachines()];
  }

  get methods(): readonly MethodInfo[] {
    return this.current?.methods ?? [];
  }

  /** The methods from papers; none before `loadPapers`. */
  get papers(): readonly PaperMethod[] {
    return this.paperList;
  }

  /** Loads the methods from papers, once. */
  async loadPapers(): Promise<void> {
    if (this.paperList.length > 0) return;
    try {
      this.paperList = await (await this.ready).paperMethods();
      this.store.catalogChanged();
    } catch (error) {
      this.store.notify(words.page.noPapers(messageOf(error)));
    }
  }
}
