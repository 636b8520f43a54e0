/** The layers: name, number of contours, operation. What the name of a layer suggests can be accepted with one click. */

import { button, h } from '../core/dom.js';
import { count } from '../core/format.js';
import { OPERATIONS } from '../core/strings.js';
import type { LayerUse, Loaded } from 'kerfway';
import type { Session } from '../session/session.js';
import { words } from '../core/words/index.js';

/** The first nine colours of AutoCAD by their index. The others are shown in the colour of text. */
const COLORS = ['', '#e5484d', '#c9a400', '#3aa655', '#1ea7b8', '#4565e6', '#b34fd1', '', '#8a8f98', '#b4b8bf'];

export function layerList(session: Session, loaded: Loaded): HTMLElement {
  const ordered = session.state.load.orderByLayer === true;
  // Layers that contain nothing to cut or show are not listed.
  const shown = new Set(loaded.ignored.layers);
  const used = loaded.layers.filter((l, i) => l.contours > 0 || shown.has(i));
  const layers = ordered ? used.sort((a, b) => a.rank - b.rank) : used;
  const suggestions = layers.filter((l) => l.suggestion && l.suggestion !== l.operation);
  return h('div', { class: 'stack' },
    h('ul', { class: 'layers', 'aria-label': words.layers.title }, ...layers.map((l, i) => row(session, l, ordered ? [i > 0, i < layers.length - 1] : null))),
    ...suggestions.map((l) => suggestion(session, l)));
}

function row(session: Session, layer: LayerUse, moves: [up: boolean, down: boolean] | null): HTMLElement {
  const swatch = h('span', { class: 'swatch', 'aria-hidden': 'true' });
  swatch.style.setProperty('--swatch', COLORS[layer.color] || 'currentColor');
  const choice = h('select', { 'aria-label': words.layers.operation(layer.name), class: `operation ${layer.operation}` },
    ...OPERATIONS.map((o) => h('option', { value: o, selected: o === layer.operation }, words.operations[o])));
  choice.addEventListener('change', () => {
    const chosen = OPERATIONS[choice.selectedIndex];
    if (chosen) session.drawing.setOperation(layer.name, chosen);
  });
  const move = (label: string, icon: 'up' | 'down', by: -1 | 1, can: boolean) =>
    button(label, { icon, iconOnly: true, class: 'quiet small', disabled: !can, onclick: () => session.drawing.moveLayer(layer.name, by) });
  return h('li', { class: layer.operation === 'ignore' ? 'layer ignored' : 'layer' }, swatch,
    h('span', { class: 'layer-name', title: layer.name }, layer.name),
    h('span', { class: 'soft number', title: words.layers.contours }, count(layer.contours)),
    choice, moves && move(words.layers.earlier(layer.name), 'up', -1, moves[0]), moves && move(words.layers.later(layer.name), 'down', 1, moves[1]));
}

function suggestion(session: Session, layer: LayerUse): HTMLElement {
  const wanted = layer.suggestion!;
  return h('div', { class: 'suggestion' },
    h('span', {}, words.layers.suggested[wanted](layer.name)),
    button(words.layers.take[wanted], { class: 'small', onclick: () => session.drawing.setOperation(layer.name, wanted) }));
}
