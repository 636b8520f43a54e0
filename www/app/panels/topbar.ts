/** The top bar: opening a file or a sample; the name, the units and the size of the drawing; undo, table, theme, help. */

import { button, h, icon, setText } from '../core/dom.js';
import { fileName } from '../core/file-name.js';
import { menuItem, popover } from '../core/menu.js';
import { extent } from '../core/format.js';
import { SAMPLES, type Sample } from '../session/samples.js';
import type { Session } from '../session/session.js';
import type { Theme } from '../core/theme.js';
import type { Queue } from '../session/queue.js';
import { fileList } from './files.js';
import { otherTheme, settingsMenu } from './settings.js';
import { reasonOf } from '../core/strings.js';
import { isTaken, sizeIn, unitChoices, unitName } from './question.js';
import { words } from '../core/words/index.js';

export interface TopActions {
  open(): void;
  sample(sample: Sample): void;
  table(): void;
  help(): void;
  panel(): void;
  /** Reloads the page after another language or unit of lengths was chosen. */
  restart(): void;
  /** Says that the browser does not keep what was chosen. */
  notKept(): void;
}

export function topBar(session: Session, queue: Queue, theme: Theme, actions: TopActions): { nodes: Node[]; toggles: { table: HTMLButtonElement; panel: HTMLButtonElement } } {
  const samples = button(words.top.samples, { class: 'quiet' });
  samples.append(icon('down'));
  const list = h('div', { class: 'menu' }, ...SAMPLES.map((s) => menuItem(...sampleWords(s.file), false, () => actions.sample(s))));

  const name = fileName('file-name');
  const units = h('button', { type: 'button', class: 'quiet units' });
  const unitList = h('div', { class: 'menu rows-only' });
  const unitMenu = popover(units, words.top.units, unitList, () => fillUnits(session, unitList));
  const measure = h('span', { class: 'measure number' });

  const themes = button(words.top.dark, { icon: 'moon', iconOnly: true, class: 'quiet theme', onclick: () => theme.toggle() });
  const undo = button(words.top.undo, { icon: 'undo', iconOnly: true, class: 'quiet', onclick: () => session.undo() });
  const redo = button(words.top.redo, { icon: 'redo', iconOnly: true, class: 'quiet redo', onclick: () => session.redo() });
  const table = button(words.top.order, { icon: 'table', iconOnly: true, class: 'quiet', 'aria-pressed': false, onclick: actions.table });
  const panel = button(words.top.panel, { icon: 'panel', iconOnly: true, class: 'quiet panel-toggle', 'aria-expanded': true, 'aria-controls': 'panel', onclick: actions.panel });

  const showTheme = () => {
    const label = otherTheme(theme);
    themes.title = label;
    themes.setAttribute('aria-label', label);
    themes.replaceChildren(icon(theme.current === 'dark' ? 'sun' : 'moon'));
  };
  theme.on('change', showTheme);
  showTheme();

  const show = () => {
    const { loaded, name: file, extent: [x0, y0, x1, y1] } = session.state;
    name.show(file);
    undo.disabled = !session.canUndo;
    redo.disabled = !session.canRedo;
    units.hidden = measure.hidden = loaded === null;
    if (!loaded) return;
    const { unit, dpi, source, doubtful } = loaded.units;
    units.replaceChildren(h('span', { class: 'hidden' }, words.top.unitsAre), h('span', {}, dpi === null ? unit : words.top.resolution(dpi)), h('span', { class: source === 'guessed' ? 'soft source guessed' : 'soft source' }, words.unitSources[source]), icon('down'));
    units.title = reasonOf(loaded.units);
    units.classList.toggle('doubtful', doubtful);
    setText(measure, extent(x1 - x0, y1 - y0));
  };
  session.store.on('change', show);
  session.store.on('loaded', show);
  show();

  return {
    nodes: [
      h('div', { class: 'brand', 'aria-hidden': 'true' }, 'Kerfway'),
      button(words.top.open, { icon: 'open', class: 'quiet open', 'aria-label': words.top.openFile, onclick: actions.open }),
      samples, popover(samples, words.top.samples, list),
      h('div', { class: 'file' }, name.root, ...fileList(queue), units, unitMenu, measure),
      h('div', { class: 'tools' }, undo, redo, table, ...settingsMenu(theme, actions), themes, button(words.top.help, { icon: 'help', iconOnly: true, class: 'quiet help-opener', onclick: actions.help }), panel),
    ],
    toggles: { table, panel },
  };
}

function sampleWords(file: string): readonly [title: string, about: string] {
  return words.samples[file] ?? [file, ''];
}

function fillUnits(session: Session, list: HTMLElement): void {
  const { loaded } = session.state;
  if (!loaded) return;
  list.replaceChildren(
    h('p', { class: 'menu-note' }, reasonOf(loaded.units)),
    ...unitChoices(loaded).map((c) => menuItem(unitName(c), sizeIn(session.state, c), isTaken(loaded, c), () => session.drawing.setUnits(c))));
}
