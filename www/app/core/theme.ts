/**
 * The light and the dark theme. The system decides until the person chooses; the choice is stored in this browser. All colours are in
 * `styles/tokens.css`, where code that draws on a canvas reads them, too.
 */

import { Emitter } from './emitter.js';
import { keep, kept } from './kept.js';

const KEY = 'kerfway.theme';

export class Theme extends Emitter<{ change: 'light' | 'dark' }> {
  private readonly system = matchMedia('(prefers-color-scheme: dark)');

  constructor() {
    super();
    const chosen = kept(KEY, ['light', 'dark']);
    if (chosen) document.documentElement.dataset.theme = chosen;
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
    keep(KEY, next);
    this.emit('change', next);
  }
}
