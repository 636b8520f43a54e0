/** The small controls on the stage: zoom, fit, what is shown; and the legend. */

import { button, h } from '../core/dom.js';
import type { Viewport } from '../stage/viewport.js';
import { words } from '../core/words/index.js';

export interface StageSwitches {
  /** Contours are coloured by order. */
  ramp(on: boolean): void;
  /** Contours have the colours of their layers. */
  layers(on: boolean): void;
  air(on: boolean): void;
  /** Clicks measure distances. */
  measure(on: boolean): void;
  /** Clicks add to the selection, and dragging draws a box around more. */
  several(on: boolean): void;
}

export function toolbar(viewport: Viewport, switches: StageSwitches): { root: HTMLElement; legend: HTMLElement; flip(which: keyof StageSwitches): void; colors(ramp: readonly string[]): void; common(shown: boolean): void } {
  const scale = h('span', { class: 'ramp', 'aria-hidden': 'true' });
  const order = h('span', { class: 'legend-part', hidden: true }, words.stage.first, scale, words.stage.last);
  const once = h('span', { class: 'legend-part', hidden: true }, h('span', { class: 'common', 'aria-hidden': 'true' }), words.stage.common);
  const legend = h('div', { class: 'legend', hidden: true }, once, order);
  const tell = (part: HTMLElement, shown: boolean) => {
    part.hidden = !shown;
    legend.hidden = order.hidden && once.hidden;
  };
  const toggle = (label: string, icon: keyof StageSwitches, on: boolean, set: (on: boolean) => void) => {
    const b = button(label, { icon, iconOnly: true, 'aria-pressed': on });
    b.addEventListener('click', () => {
      const now = b.getAttribute('aria-pressed') !== 'true';
      b.setAttribute('aria-pressed', String(now));
      set(now);
    });
    return b;
  };
  const ramp: HTMLButtonElement = toggle(words.stage.colours, 'ramp', false, (on) => {
    if (on && layers.getAttribute('aria-pressed') === 'true') layers.click();
    tell(order, on);
    switches.ramp(on);
  });
  const air = toggle(words.stage.air, 'air', true, switches.air);
  const layers = toggle(words.stage.layers, 'layers', false, (on) => {
    if (on && ramp.getAttribute('aria-pressed') === 'true') ramp.click();
    switches.layers(on);
  });
  const several = toggle(words.stage.several, 'several', false, switches.several);
  const measure = toggle(words.stage.measure, 'measure', false, switches.measure);
  const switchOf = { ramp, layers, air, several, measure };
  const root = h('div', { class: 'toolbar', role: 'toolbar', 'aria-label': words.stage.view, 'aria-orientation': 'vertical' },
    button(words.stage.zoomIn, { icon: 'plus', iconOnly: true, onclick: () => viewport.zoom(1.4) }),
    button(words.stage.zoomOut, { icon: 'minus', iconOnly: true, onclick: () => viewport.zoom(1 / 1.4) }),
    button(words.stage.fit, { icon: 'fit', iconOnly: true, onclick: () => viewport.fit() }),
    ramp, layers, air, several, measure);
  return {
    root, legend,
    flip: (which) => switchOf[which].click(),
    common: (shown) => tell(once, shown),
    colors: (steps) => scale.style.setProperty('--ramp', steps.join(',')),
  };
}
