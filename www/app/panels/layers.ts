/** The layers: name, number of contours, operation. What the name of a layer suggests can be accepted with one click. */

import { button, h } from '../core/dom.js';
import { count, upTo } from '../core/format.js';
import { shownIn, written } from '../core/lengths.js';
import { LAYER_COLORS } from '../stage/layer-colors.js';
import { OPERATIONS } from '../core/strings.js';
import type { LayerChoice, LayerUse, Loaded } from 'kerfway';
import type { Session } from '../session/session.js';
import { words } from '../core/words/index.js';
import { type Measure, numberInput } from './number-input.js';
import { check, field } from './section.js';

export function layerList(session: Session, loaded: Loaded): HTMLElement {
  const ordered = session.state.load.orderByLayer === true;
  // Layers that contain nothing to cut or show are not listed.
  const shown = new Set(loaded.ignored.layers);
  const used = loaded.layers.filter((l, i) => l.contours > 0 || shown.has(i));
  const layers = ordered ? used.sort((a, b) => a.rank - b.rank) : used;
  const suggestions = layers.filter((l) => l.contours > 0 && l.suggestion && l.suggestion !== l.operation);
  return h('div', { class: 'stack' },
    h('ul', { class: 'layers', 'aria-label': words.layers.title }, ...layers.map((l, i) => row(session, l, ordered ? [i > 0, i < layers.length - 1] : null))),
    ...suggestions.map((l) => suggestion(session, l)));
}

function row(session: Session, layer: LayerUse, moves: [up: boolean, down: boolean] | null): HTMLElement {
  const swatch = h('span', { class: 'swatch', 'aria-hidden': 'true' });
  swatch.style.setProperty('--swatch', LAYER_COLORS[layer.color] || 'currentColor');
  const choice = h('select', { 'aria-label': words.layers.operation(layer.name), class: `operation ${layer.operation}` },
    ...OPERATIONS.map((o) => h('option', { value: o, selected: o === layer.operation }, words.operations[o])));
  choice.addEventListener('change', () => {
    const chosen = OPERATIONS[choice.selectedIndex];
    if (chosen) session.drawing.setOperation(layer.name, chosen);
  });
  const move = (label: string, icon: 'up' | 'down', by: -1 | 1, can: boolean) =>
    button(label, { icon, iconOnly: true, class: 'quiet small', disabled: !can, onclick: () => session.drawing.moveLayer(layer.name, by) });
  const set = session.drawing.settingsOf(layer.name);
  const summary = inWords(set);
  const expand = layer.operation === 'ignore' ? null : button(words.layers.settings(layer.name), { icon: 'down', iconOnly: true, class: 'quiet small', 'aria-expanded': opened.has(layer.name) });
  const settings = layer.operation === 'ignore' ? null : h('div', { class: 'layer-settings', hidden: !opened.has(layer.name) }, ...settingFields(session, layer, set));
  expand?.addEventListener('click', () => {
    const open = !opened.delete(layer.name);
    if (open) opened.add(layer.name);
    expand.setAttribute('aria-expanded', String(open));
    if (settings) settings.hidden = !open;
  });
  return h('li', {}, h('div', { class: layer.operation === 'ignore' ? 'layer ignored' : 'layer' }, swatch,
    h('span', { class: 'layer-name', title: layer.name }, layer.name, summary && h('span', { class: 'soft layer-set' }, summary)),
    h('span', { class: 'soft number', title: words.layers.contours }, count(layer.contours)),
    choice, moves && move(words.layers.earlier(layer.name), 'up', -1, moves[0]), moves && move(words.layers.later(layer.name), 'down', 1, moves[1]), expand), settings);
}

/** The layers whose settings are shown. They stay open when the list is made again. */
const opened = new Set<string>();

interface Quantity extends Measure {
  key: 'speed' | 'power' | 'minPower' | 'passes' | 'zStep';
  label: string;
  /** From what is typed to the setting. */
  factor: number;
  /** The same of a material and of the machine, which holds where nothing is set. */
  field: 'speed' | 'power' | 'min_power' | 'passes' | 'z_step';
  /** What holds where these have nothing either. */
  usual?: number;
}

const QUANTITIES: readonly Quantity[] = [
  { key: 'speed', label: words.layers.speed, unit: 'mm/s', least: 0.01, most: 100_000, factor: 1, field: 'speed' },
  { key: 'power', label: words.layers.power, unit: '%', least: 0, most: 100, factor: 0.01, field: 'power' },
  { key: 'minPower', label: words.layers.minPower, unit: '%', least: 0, most: 100, factor: 0.01, field: 'min_power' },
  { key: 'passes', label: words.layers.passes, unit: '', least: 1, most: 100, factor: 1, whole: true, field: 'passes', usual: 1 },
  { key: 'zStep', label: words.layers.zStep, unit: 'mm', least: 0, most: 50, factor: 1, field: 'z_step', usual: 0 },
];

/** What an empty field stands for: nothing is set. */
const UNSET = -1;

function settingFields(session: Session, layer: LayerUse, set: LayerChoice | undefined): HTMLElement[] {
  const { machine, material } = session.state;
  const process = layer.operation === 'mark' ? 'mark' : 'cut';
  const setting = machine?.materials?.find((m) => m.name === material)?.[process];
  const fields = QUANTITIES.map((quantity) => {
    const { key, label, unit, factor, field: name } = quantity;
    const given = set?.[key];
    const usual = setting?.[name] ?? machine?.[process][name] ?? quantity.usual;
    let value = typeof given === 'number' ? given / factor : UNSET;
    const { input, show } = numberInput({ ...quantity, empty: UNSET, placeholder: typeof usual === 'number' ? written(usual / factor, unit) : words.layers.unset }, (typed) => (value = typed));
    input.setAttribute('aria-label', words.layers.settingOf(label, layer.name));
    show(value);
    // On `change`, not on every keystroke: the drawing is arranged again.
    input.addEventListener('change', () => {
      const next = value === UNSET ? undefined : value * factor;
      if (next !== (session.drawing.settingsOf(layer.name)?.[key] ?? undefined)) session.drawing.setLayer(layer.name, { [key]: next });
    });
    return field(label, input, unit || '×');
  });
  const air = check(words.layers.air, (on) => session.drawing.setLayer(layer.name, { air: on || undefined }));
  air.input.checked = set?.air === true;
  return [...fields, air.root];
}

const inUnit = (value: number, unit: string) => `${upTo(value / shownIn(unit).factor, 4)} ${shownIn(unit).unit}`;

/** What is set for a layer, in a few words. */
function inWords(set: LayerChoice | undefined): string {
  if (!set) return '';
  return [
    typeof set.speed === 'number' && inUnit(set.speed, 'mm/s'), typeof set.power === 'number' && inUnit(set.power * 100, '%'),
    typeof set.passes === 'number' && set.passes > 1 && `${set.passes} ×`, typeof set.zStep === 'number' && set.zStep > 0 && inUnit(set.zStep, 'mm'), set.air === true && words.layers.air,
  ].filter(Boolean).join(', ');
}

function suggestion(session: Session, layer: LayerUse): HTMLElement {
  const wanted = layer.suggestion!;
  return h('div', { class: 'suggestion' },
    h('span', {}, words.layers.suggested[wanted](layer.name)),
    button(words.layers.take[wanted], { class: 'small', onclick: () => session.drawing.setOperation(layer.name, wanted) }));
}
