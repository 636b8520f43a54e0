/**
 * The colours of the order: viridis, which is perceptually uniform and readable with every common colour blindness (Smith and van der Walt,
 * 2015, CC0). Each theme uses the part that stands out from its background: the darker part on light, the lighter part on dark.
 */

const VIRIDIS = ['#440154', '#482878', '#3e4989', '#31688e', '#26828e', '#1f9e89', '#35b779', '#6ece58', '#b5de2b', '#fde725'];

/** Number of colours: more cannot be distinguished, and each one is a batch of strokes. */
export const RAMP_STEPS = 24;

const STRETCH = { light: [0, 0.74], dark: [0.3, 1] } as const;

/** The colours from first to last. */
export function ramp(theme: 'light' | 'dark'): string[] {
  const [from, to] = STRETCH[theme];
  return Array.from({ length: RAMP_STEPS }, (_, i) => mix(from + ((to - from) * i) / (RAMP_STEPS - 1)));
}

function mix(at: number): string {
  const place = at * (VIRIDIS.length - 1);
  const i = Math.min(VIRIDIS.length - 2, Math.floor(place));
  const [a, b] = [channels(VIRIDIS[i]!), channels(VIRIDIS[i + 1]!)];
  return `rgb(${a.map((value, c) => Math.round(value + (b[c]! - value) * (place - i))).join(' ')})`;
}

function channels(hex: string): number[] {
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
}
