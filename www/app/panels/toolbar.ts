/** Small controls on the stage: zoom, fit, what is shown. */

import { button, h } from '../core/dom.js';
import type { Viewport } from '../stage/viewport.js';

export interface StageSwitches {
  ramp(on: boolean): void;
  air(on: boolean): void;
}

export function toolbar(viewport: Viewport, switches: StageSwitches): { root: HTMLElement; legend: HTMLElement; flip(which: keyof StageSwitches): void; colors(ramp: readonly string[]): void } {
  const scale = h('span', { class: 'ramp', 'aria-hidden': 'true' });
  const legend = h('div', { class: 'legend', hidden: true }, h('span', {}, 'first'), scale, h('span', {}, 'last'));
  const toggle = (label: string, icon: 'ramp' | 'air', on: boolean, set: (on: boolean) => void) => {
    const b = button(label, { icon, iconOnly: true, 'aria-pressed': on });
    b.addEventListener('click', () => {
      const now = b.getAttribute('aria-pressed') !== 'true';
      b.setAttribute('aria-pressed', String(now));
      set(now);
    });
    return b;
  };
  const ramp = toggle('Colours by order (C)', 'ramp', false, (on) => {
    legend.hidden = !on;
    switches.ramp(on);
  });
  const air = toggle('Air moves (A)', 'air', true, switches.air);
  const root = h('div', { class: 'toolbar', role: 'toolbar', 'aria-label': 'View', 'aria-orientation': 'vertical' },
    button('Zoom in (+)', { icon: 'plus', iconOnly: true, onclick: () => viewport.zoom(1.4) }),
    button('Zoom out (−)', { icon: 'minus', iconOnly: true, onclick: () => viewport.zoom(1 / 1.4) }),
    button('Fit the sheet (F)', { icon: 'fit', iconOnly: true, onclick: () => viewport.fit() }),
    ramp, air);
  return {
    root, legend,
    flip: (which) => (which === 'ramp' ? ramp : air).click(),
    colors: (steps) => scale.style.setProperty('--ramp', steps.join(',')),
  };
}
