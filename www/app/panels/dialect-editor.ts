/** The editor of a dialect: a document of one's own with a live preview of the first lines of a program. It is loaded when it is opened. */

import { button, disable, h } from '../core/dom.js';
import { choose, save } from '../core/files.js';
import { messageOf } from '../core/strings.js';
import type { Dialect, MachineProfile } from 'kerfway';
import type { Session } from '../session/session.js';
import { words } from '../core/words/index.js';

/** Lines of the preview. */
const SHOWN = 24;
/** Milliseconds without a keystroke before the document is tried. */
const PAUSE = 300;

export interface DialectEditor {
  root: HTMLElement;
  /** Shows the dialect of the machine. */
  show(): void;
  /** Tries the document out while it can be seen. */
  tryOut(): void;
}

export function dialectEditor(session: Session, edit: (change: (m: MachineProfile) => void) => void): DialectEditor {
  const w = words.dialect;
  const current = () => dialectOf(session);
  const text = h('textarea', { class: 'document', rows: 14, spellcheck: false, autocapitalize: 'off', 'aria-label': w.document });
  const problem = h('p', { class: 'grave', role: 'status' });
  const preview = h('pre', { class: 'program', tabindex: 0, role: 'region', 'aria-label': w.preview });
  const file = button(w.import, { class: 'small', onclick: () => choose(([given]) => {
    void given?.text().then((content) => { text.value = content; tryOut(); });
  }, { accept: '.json,application/json' }) });
  const out = button(w.export, { class: 'small', onclick: () => {
    save(text.value, `${current()?.name ?? 'my'}.dialect.json`, 'application/json');
  } });
  const take = button(w.take, { class: 'small primary', onclick: () => {
    const document = parsed();
    if (document !== null) edit((m) => (m.dialect = document));
  } });
  const root = h('div', { class: 'stack' }, h('p', { class: 'soft' }, w.hint), text, problem, take, h('div', { class: 'row' }, file, out), h('p', { class: 'field-label' }, w.preview), preview);

  const parsed = (): Dialect | null => {
    try {
      return JSON.parse(text.value) as Dialect;
    } catch (error) {
      problem.textContent = w.noJson(messageOf(error));
      return null;
    }
  };
  let asked = 0;
  let timer = 0;
  const tryOut = () => {
    window.clearTimeout(timer);
    timer = window.setTimeout(() => void draw(), PAUSE);
  };
  const draw = async () => {
    const now = (asked += 1);
    const { machine } = session.state;
    const document = root.checkVisibility() ? parsed() : null;
    take.disabled = true;
    if (document === null || machine === null) return;
    try {
      const program = await session.sampleProgram({ ...machine, dialect: document });
      if (now !== asked) return;
      const lines = program.split(/\r?\n/);
      preview.textContent = lines.slice(0, SHOWN).join('\n') + (lines.length > SHOWN ? '\n…' : '');
      problem.textContent = '';
      disable(take, JSON.stringify(document) === JSON.stringify(current()) ? w.same : '');
    } catch (error) {
      if (now === asked) problem.textContent = messageOf(error);
    }
  };
  text.addEventListener('input', tryOut);

  let shown = '';
  const show = () => {
    const document = current();
    const key = JSON.stringify(document ?? null);
    if (document === undefined || key === shown) return;
    shown = key;
    text.value = `${JSON.stringify(document, null, 2)}\n`;
    tryOut();
  };
  show();
  return { root, show, tryOut };
}

/** The document of the machine's dialect; undefined while the planner is not there, or does not know the dialect. */
function dialectOf({ state, catalog }: Session): Dialect | undefined {
  const dialect = state.machine?.dialect;
  return typeof dialect === 'object' ? dialect : catalog.planner?.dialects.find((d) => d.name === dialect);
}
