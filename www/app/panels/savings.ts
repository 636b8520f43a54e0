/** What each kind of decision saves, found by leaving it out. Loaded when it is opened, and worked out when somebody asks for it. */

import { button, h } from '../core/dom.js';
import { seconds } from '../core/format.js';
import { messageOf } from '../core/strings.js';
import { words } from '../core/words/index.js';
import type { Alternatives, Without } from '../session/alternatives.js';
import type { Session } from '../session/session.js';

/** Seconds of search for a plan without a decision, at most: five bring most of what the whole time of the plan brings. */
const SEARCHED = 5;

export function savingsPanel(session: Session, alternatives: () => Promise<Alternatives>): HTMLElement {
  const list = h('dl', { class: 'parts savings' });
  const note = h('p', { class: 'soft', role: 'status' });
  const ask = button(words.savings.ask, { class: 'small', onclick: () => void work() });
  const root = h('div', { class: 'stack' }, h('p', { class: 'soft' }, words.savings.about), list, ask, note);
  let asked = 0;
  let found: Without[] = [];

  // A decision may cost time itself, as leads do.
  const draw = () => {
    const now = session.state.progress?.summary.total_time ?? 0;
    list.replaceChildren(...found.flatMap(({ decision, total }) => [h('dt', {}, words.savings.decisions[decision]), h('dd', { class: 'number' }, total >= now ? words.savings.saves(seconds(total - now)) : words.savings.costs(seconds(now - total)))]));
  };
  const reset = () => {
    asked += 1;
    found = [];
    draw();
    ask.hidden = false;
    ask.disabled = session.state.phase !== 'done';
    note.textContent = ask.disabled ? words.savings.notYet : '';
  };
  const work = async () => {
    const now = (asked += 1);
    ask.hidden = true;
    note.textContent = words.savings.working;
    const searched = Math.min(SEARCHED, session.state.search.seconds);
    try {
      for await (const without of (await alternatives()).savings(searched)) {
        if (now !== asked) return;
        found.push(without);
        draw();
      }
      if (now === asked) note.textContent = words.savings.done(searched);
    } catch (error) {
      if (now === asked) note.textContent = messageOf(error);
    }
  };
  let { phase } = session.state;
  session.store.on('change', async () => {
    // A plan that becomes better after its search is planned for no time at all. What was worked out still holds, and saves more.
    await null;
    if (session.state.phase === phase) return draw();
    phase = session.state.phase;
    reset();
  });
  reset();
  return root;
}
