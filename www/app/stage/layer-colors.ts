/** The colours of layers as drawn. */

import type { ContourInfo, LayerUse } from 'kerfway';

/** The first nine colours of AutoCAD by their index. The others are shown in the colour of text. */
export const LAYER_COLORS = ['', '#e5484d', '#c9a400', '#3aa655', '#1ea7b8', '#4565e6', '#b34fd1', '', '#8a8f98', '#b4b8bf'];

/** By contour: the index of the colour of its layer. */
export function layerColors(contours: readonly ContourInfo[], layers: readonly LayerUse[]): Uint8Array {
  const of = new Map(layers.map(({ name, color }) => [name, LAYER_COLORS[color] ? color : 0]));
  const colors = new Uint8Array(contours.length);
  contours.forEach((c, k) => (colors[k] = of.get(c.layer) ?? 0));
  return colors;
}
