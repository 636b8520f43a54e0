/** The section of the plan: its heading says how long is searched. The controls are loaded when it is first opened. */

import { upTo } from '../core/format.js';
import { words } from '../core/words/index.js';
import type { Session } from '../session/session.js';
import { laterSection } from './section.js';

/** `notify` shows a sentence to the person. */
export function planSection(session: Session, notify: (sentence: string) => void): HTMLElement {
  const { root, setGist } = laterSection(words.plan.title, async () => (await import('./plan.js')).planControls(session), notify);
  session.store.on('change', ({ search }) => setGist(span(search.seconds)));
  return root;
}

/** A time budget, s, in words. */
export const span = (s: number) => (s < 60 || s % 60 > 0 ? `${upTo(s, 3)} s` : `${s / 60} min`);
