/** The dialect of G-code: a shipped one, or one's own. */

import { h } from '../core/dom.js';
import type { MachineProfile } from 'kerfway';
import type { Session } from '../session/session.js';
import type { DialectEditor } from './dialect-editor.js';
import { field, laterDetails, select } from './section.js';
import { words } from '../core/words/index.js';

/** `failed` gets the reason if the editor cannot be loaded. */
export function dialectPanel(session: Session, edit: (change: (m: MachineProfile) => void) => void, failed: (sentence: string) => void): { root: HTMLElement; show(machine: MachineProfile): void } {
  const w = words.dialect;
  const choice = select<string>((name) => edit((m) => (m.dialect = name)), { wide: true });
  let editor: DialectEditor | null = null;
  const details = laterDetails(w.own, async () => (editor = (await import('./dialect-editor.js')).dialectEditor(session, edit)).root, failed);
  details.addEventListener('toggle', () => editor?.tryOut());
  const show = (machine: MachineProfile) => {
    const own = typeof machine.dialect === 'object' ? machine.dialect : null;
    const names = (session.catalog.planner?.dialects ?? []).map((d) => ({ value: d.name, label: d.title }));
    const name = own === null ? machine.dialect as string : own.name;
    choice.fill(own === null ? names : [...names.filter((n) => n.value !== own.name), { value: own.name, label: w.mine(own.title) }], name);
    editor?.show();
  };
  return { root: h('div', { class: 'stack' }, field(w.title, choice.root), details), show };
}
