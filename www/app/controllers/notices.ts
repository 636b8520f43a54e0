/** Sentences over the stage: a notice that disappears by itself, and the card of a file that cannot be used. */

import { button, h, icon } from '../core/dom.js';
import { leave } from '../core/refill.js';
import { words } from '../core/words/index.js';
import type { State } from '../session/state.js';

/** Milliseconds for which a notice is shown. */
const SHOWN = 12_000;

export class Notices {
  readonly notice = h('div', { class: 'notice', role: 'alert', hidden: true });
  readonly failure = h('div', { class: 'card failure', role: 'alert', hidden: true });
  private timer = 0;
  private refused: State['refused'] = null;

  /** `action`: what the person may do about it. */
  show(sentence: string, action?: { label: string; act: () => void }): void {
    const press = () => {
      this.hide();
      action?.act();
    };
    leave(this.notice);
    this.notice.replaceChildren(h('span', {}, sentence), ...(action ? [button(action.label, { class: 'quiet small', onclick: press })] : []));
    this.notice.hidden = false;
    this.hideLater();
  }

  hide(): void {
    leave(this.notice);
    this.notice.hidden = true;
  }

  /** Not under the hands of a person who is about to press its button. */
  private hideLater(): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => (this.notice.matches(':hover, :focus-within') ? this.hideLater() : this.hide()), SHOWN);
  }

  /** Shows why a file cannot be used, until the person has seen it. Where a drawing stays, the card can be closed. */
  showRefusal({ refused, loaded }: State, close: () => void): void {
    if (refused === this.refused) return;
    this.refused = refused;
    const isLeft = this.failure.contains(document.activeElement);
    leave(this.failure);
    this.failure.hidden = refused === null;
    if (refused === null) {
      if (isLeft) document.querySelector<HTMLElement>('.question:not([hidden])')?.focus({ preventScroll: true });
      return;
    }
    const { file, sentence } = refused;
    const stays = loaded === null ? [] : [h('p', { class: 'soft' }, words.page.stays), button(words.page.close, { class: 'primary', onclick: close })];
    this.failure.replaceChildren(h('h2', {}, icon('error'), file), h('p', {}, sentence), ...stays);
    // A question beneath the card is hidden, and the next key must not answer it.
    this.failure.querySelector('button')?.focus({ preventScroll: true });
  }
}
