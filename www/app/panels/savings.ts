/** What each kind of decision saves, found by leaving it out. Loaded when it is opened, and worked out when somebody asks for it. */

import { button, h } from '../core/dom.js';
import { seconds } from '../core/format.js';
import { messageOf } from '../core/strings.js';
import { words } from '../core/words/index.js';
import type { Alternatives } from '../session/alternatives.js';
import type { Session } from '../session/session.js';

/** Seconds of search for a plan without a decision, at most: five bring most of what the whole time of the plan brings. */
const SEARCHED = 5;

export function savingsPanel(session: Session, alternatives: () => Promise<Alternatives>): HTMLElement {
  const list = h('dl', { class: 'parts savings' });
  const note = h('p', { class: 'soft', role: 'status' });
  const ask = button(words.savings.ask, { class: 'small', onclick: () => void work() });
  const root = h('div', { class: 'stack' }, h('p', { class: 'soft' }, words.savings.about), list, note, ask);
  let asked = 0;

  const reset = () => {
    asked += 1;
    list.replaceChildren();
    ask.hidden = false;
    ask.disabled = session.state.phase !== 'done';
    note.textContent = ask.disabled ? words.savings.notYet : '';
  };
  const work = async () => {
    const now = (asked += 1);
    ask.hidden = true;
    list.replaceChildren();
    note.textContent = words.savings.working;
    const searched = Math.min(SEARCHED, session.state.search.seconds);
    try {
      for await (const { decision, seconds: saved } of (await alternatives()).savings(searched)) {
        if (now !== asked) return;
        list.append(h('dt', {}, words.savings.decisions[decision]), h('dd', { class: 'number' }, saved >= 0 ? words.savings.saves(seconds(saved)) : words.savings.costs(seconds(-saved))));
      }
      if (now === asked) note.textContent = words.savings.done(searched);
    } catch (error) {
      if (now === asked) note.textContent = messageOf(error);
    }
  };
  let shown = session.state.progress?.summary.total_time;
  let phase = '';
  session.store.on('change', (state) => {
    if (state.phase === phase && state.progress?.summary.total_time === shown) return;
    [phase, shown] = [state.phase, state.progress?.summary.total_time];
    reset();
  });
  reset();
  return root;
}
