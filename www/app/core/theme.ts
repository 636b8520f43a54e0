/**
 * Light and dark. The system decides until the person chooses; the choice is kept on this machine. Colours live in
 * `styles/tokens.css` alone: what draws on a canvas reads them from there.
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
      // Storage is closed in private windows: the choice then lasts as long as the page.
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
