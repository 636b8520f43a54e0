/** The list of keys, which is loaded when somebody asks for it. */

import { button, h } from '../core/dom.js';
import { words } from '../core/words/index.js';

let shown: HTMLDialogElement | null = null;

export function showHelp(): void {
  if (shown === null) document.body.append((shown = helpDialog()));
  shown.showModal();
}

function helpDialog(): HTMLDialogElement {
  const dialog = h('dialog', { class: 'help', 'aria-labelledby': 'help-title' });
  dialog.append(
    h('div', { class: 'dialog-head' }, h('h2', { id: 'help-title' }, words.help.title), button(words.help.close, { icon: 'close', iconOnly: true, class: 'quiet', onclick: () => dialog.close() })),
    h('dl', { class: 'keys' }, ...words.help.keys.flatMap(([key, what]) => [h('dt', {}, ...key.split(' ').map((k) => (k === words.help.with ? ` ${k} ` : h('kbd', {}, k)))), h('dd', {}, what)])),
    h('p', { class: 'soft' }, words.help.more));
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}
