/** The stage's colours, read from the custom properties of `styles/tokens.css`. */

import { ramp } from './ramp.js';

export interface Palette {
  ground: string;
  sheet: string;
  line: string;
  ink: string;
  inkSoft: string;
  faint: string;
  accent: string;
  amber: string;
  red: string;
  ramp: string[];
}

export function readPalette(theme: 'light' | 'dark'): Palette {
  const style = getComputedStyle(document.documentElement);
  const get = (name: string) => style.getPropertyValue(`--${name}`).trim();
  return {
    ground: get('ground'), sheet: get('sheet'), line: get('line'), ink: get('contour'), inkSoft: get('contour-inner'),
    faint: get('contour-ignored'), accent: get('accent'), amber: get('amber-mark'), red: get('red-mark'), ramp: ramp(theme),
  };
}
