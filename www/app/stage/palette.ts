/** The colours of the stage, read from the custom properties of `styles/tokens.css`. */

import { colorOf } from '../core/color.js';
import { ramp } from './ramp.js';

export interface Palette {
  ground: string;
  sheet: string;
  line: string;
  ink: string;
  inkSoft: string;
  faint: string;
  /** Of text on the ground. */
  text: string;
  accent: string;
  amber: string;
  red: string;
  ramp: string[];
}

export function readPalette(theme: 'light' | 'dark'): Palette {
  return {
    ground: colorOf('ground'), sheet: colorOf('sheet'), line: colorOf('line'), ink: colorOf('contour'), inkSoft: colorOf('contour-inner'),
    faint: colorOf('contour-ignored'), text: colorOf('ink-soft'), accent: colorOf('accent'), amber: colorOf('amber-mark'), red: colorOf('red-mark'), ramp: ramp(theme),
  };
}
