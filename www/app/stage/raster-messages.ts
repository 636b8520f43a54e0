/** The messages between the stage and its drawing worker. */

import type { BestPath, Geometry } from 'kerfway';
import type { Palette } from './palette.js';

/**
 * The bitmaps that a frame is composed of.
 * sheet: all contours. path: air moves, entries, arrows, numbers. done: what is cut before a stop. glow: what the last improvement changed.
 */
export type Layer = 'sheet' | 'path' | 'done' | 'glow';
export const LAYERS: readonly Layer[] = ['sheet', 'path', 'done', 'glow'];

/** Where the sheet is in a bitmap: a point is at x + its x * scale and y - its y * scale, in device pixels. */
export interface View {
  scale: number;
  x: number;
  y: number;
  width: number;
  height: number;
  /** Device pixels per CSS pixel. */
  ratio: number;
  /** The same for text. */
  text: number;
}

/** How a contour is drawn. Skipped contours have no role, because they are drawn with the ignored ones. */
export const Role = { outer: 0, inner: 1, mark: 2, none: 3 } as const;

/** What the colours of contours show: outer and inner contours, the order, or the layers as drawn. */
export type Colors = 'plain' | 'order' | 'layers';

/** How the head moves between contours. */
export interface Travel {
  home: [number, number];
  returnHome: boolean;
  /** The top speeds of x and y where the axes move independently; null where the head moves in a straight line. */
  perAxis: [number, number] | null;
}

export type ToRaster =
  | { type: 'geometry'; geometry: Geometry; roles: Uint8Array; ignored: Geometry; drawn: Geometry | null; layers: Uint8Array }
  | { type: 'common'; common: Geometry | null }
  /** `changed`: 1 for each stop that the improvement changed. */
  | { type: 'path'; path: BestPath | null; travel: Travel; changed: Uint8Array | null }
  | { type: 'style'; palette: Palette; colors: Colors; air: boolean }
  /** `upto`: the stop before which everything is drawn in the layer `done`. */
  | { type: 'draw'; layer: Layer; serial: number; view: View; upto: number };

export type FromRaster = { type: 'drawn'; layer: Layer; serial: number; view: View; upto: number; bitmap: ImageBitmap };
