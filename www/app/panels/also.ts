/** Says below a switch what it has changed besides itself, so that nothing goes off silently. */

import { h, setText } from '../core/dom.js';
import { words } from '../core/words/index.js';

type Control = HTMLInputElement | HTMLSelectElement;

/** `body` holds the switches; what they change has been shown there when their event gets to it. `forget` removes what was said. */
export function sayWhatElse(body: HTMLElement): { forget(): void } {
  const note = h('p', { class: 'soft reason', role: 'status' });
  let before = new Map<Control, string>();
  body.addEventListener('change', () => (before = shownIn(body)), true);
  body.addEventListener('change', ({ target }) => {
    if (!(target instanceof HTMLInputElement) || target.type !== 'checkbox') return;
    const changed = [...shownIn(body)].filter(([c, state]) => c !== target && before.has(c) && before.get(c) !== state);
    if (changed.length === 0) return;
    target.closest('label')?.after(note);
    setText(note, words.machine.also(changed.map(([c, state]) => `${c.labels?.[0]?.querySelector('span')?.textContent} (${state})`).join(', ')));
  });
  return { forget: () => note.remove() };
}

/** The switches and choices that can be seen, with their states in words. */
function shownIn(body: HTMLElement): Map<Control, string> {
  const all = [...body.querySelectorAll<Control>('.check > input, .field select')].filter((c) => c.checkVisibility());
  return new Map(all.map((c) => [c, c instanceof HTMLSelectElement ? c.selectedOptions[0]?.textContent ?? '' : c.checked ? words.machine.on : words.machine.off]));
}
