/** Sentences over the stage: a notice that disappears by itself, and the card of a file that cannot be used. */

import { h, icon } from '../core/dom.js';
import type { State } from '../session/state.js';

/** Milliseconds for which a notice is shown. */
const SHOWN = 12_000;

export class Notices {
  readonly notice = h('div', { class: 'notice', role: 'alert', hidden: true });
  readonly failure = h('div', { class: 'card failure', role: 'alert', hidden: true });
  private timer = 0;

  show(sentence: string): void {
    this.notice.textContent = sentence;
    this.notice.hidden = false;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.hide(), SHOWN);
  }

  hide(): void {
    this.notice.hidden = true;
  }

  /** Shows why the file cannot be used, if that is the state. */
  showFailure({ phase, name, error }: State): void {
    this.failure.hidden = phase !== 'failed';
    this.failure.replaceChildren(h('h2', {}, icon('error'), name), h('p', {}, error ?? ''));
  }
}
