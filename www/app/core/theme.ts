/**
 * The light and the dark theme. The system decides until the person chooses; the choice is stored in this browser. All colours are in
 * `styles/tokens.css`, where code that draws on a canvas reads them, too.
 */

import { Emitter } from './emitter.js';

const KEY = 'kerfway.theme';

export class Theme extends Emitter<{ change: 'light' | 'dark' }> {
  private readonly system = matchMedia('(prefers-color-scheme: dark)');

  constructor() {
    super();
    const kept = stored();
    if (kept) document.documentElement.dataset.theme = kept;
    this.system.addEventListener('change', () => this.emit('change', this.current));
  }

  get current(): 'light' | 'dark' {
    const chosen = document.documentElement.dataset.theme;
    if (chosen === 'light' || chosen === 'dark') return chosen;
    return this.system.matches ? 'dark' : 'light';
  }

  toggle(): void {
    const next = this.current === 'dark' ? 'light' : 'dark';
    document.documentElement.dataset.theme = next;
    try {
      localStorage.setItem(KEY, next);
    } catch {
      // Private windows have no storage: the choice then lasts as long as the page.
    }
    this.emit('change', next);
  }
}

function stored(): 'light' | 'dark' | null {
  try {
    const kept = localStorage.getItem(KEY);
    return kept === 'light' || kept === 'dark' ? kept : null;
  } catch {
    return null;
  }
}
