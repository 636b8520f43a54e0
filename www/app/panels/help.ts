/** The list of keys. */

import { button, h } from '../core/dom.js';

const KEYS: readonly [string, string][] = [
  ['O', 'Open a DXF file'],
  ['S', 'Stop planning, keep the best path'],
  ['P', 'Pause or resume planning'],
  ['K', 'Keep improving'],
  ['Space', 'Play or pause the cut'],
  ['← →', 'Previous or next contour in the order'],
  ['Home End', 'First or last contour'],
  ['+ −', 'Zoom in or out'],
  ['F', 'Fit the sheet'],
  ['Shift with arrows', 'Move the view'],
  ['C', 'Colours by order'],
  ['A', 'Air moves'],
  ['T', 'Table of the cutting order'],
  ['Ctrl Z', 'Undo a choice; with Shift, redo'],
  ['Esc', 'Clear the selection'],
  ['?', 'This list'],
];

export function helpDialog(): HTMLDialogElement {
  const dialog = h('dialog', { class: 'help', 'aria-labelledby': 'help-title' });
  dialog.append(
    h('div', { class: 'dialog-head' }, h('h2', { id: 'help-title' }, 'Keys'), button('Close', { icon: 'close', iconOnly: true, class: 'quiet', onclick: () => dialog.close() })),
    h('dl', { class: 'keys' }, ...KEYS.flatMap(([key, what]) => [h('dt', {}, ...key.split(' ').map((k) => (k === 'with' ? ' with ' : h('kbd', {}, k)))), h('dd', {}, what)])),
    h('p', { class: 'soft' }, 'Wheel or pinch zooms about the pointer, drag moves the sheet, a click selects a contour. The drawing never leaves this machine.'));
  dialog.addEventListener('click', (event) => {
    if (event.target === dialog) dialog.close();
  });
  return dialog;
}
