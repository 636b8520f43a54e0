/** Sentences over the stage: a notice that disappears by itself, and the card of a file that cannot be used. */

import { button, h, icon } from '../core/dom.js';
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
    this.notice.replaceChildren(h('span', {}, sentence), ...(action ? [button(action.label, { class: 'quiet small', onclick: press })] : []));
    this.notice.hidden = false;
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => this.hide(), SHOWN);
  }

  hide(): void {
    this.notice.hidden = true;
  }

  /** Shows why a file cannot be used, until the person has seen it. Where a drawing stays, the card can be closed. */
  showRefusal({ refused, loaded }: State, close: () => void): void {
    if (refused === this.refused) return;
    this.refused = refused;
    this.failure.hidden = refused === null;
    if (refused === null) return;
    const { file, sentence } = refused;
    const stays = loaded === null ? [] : [h('p', { class: 'soft' }, words.page.stays), button(words.page.close, { class: 'primary', onclick: close })];
    this.failure.replaceChildren(h('h2', {}, icon('error'), file), h('p', {}, sentence), ...stays);
  }
}
