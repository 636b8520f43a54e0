/** What the stage and its drawing worker say to each other. */

import type { BestPath, Geometry } from 'kerfway';
import type { Palette } from './palette.js';

/**
 * The bitmaps a frame is put together from.
 * sheet: all contours. path: air moves, entries, arrows, numbers. done: what is cut up to a stop. glow: what the last
 * improvement changed.
 */
export type Layer = 'sheet' | 'path' | 'done' | 'glow';
export const LAYERS: readonly Layer[] = ['sheet', 'path', 'done', 'glow'];

/** A bitmap's place: pixels x + world x * scale, y - world y * scale; device pixels. */
export interface View {
  scale: number;
  x: number;
  y: number;
  width: number;
  height: number;
  /** Device pixels a CSS pixel. */
  ratio: number;
}

/** How a contour is drawn; one left out is drawn with what is ignored. */
export const Role = { outer: 0, inner: 1, mark: 2, none: 3 } as const;

/** How the head moves between contours. */
export interface Travel {
  home: [number, number];
  returnHome: boolean;
  /** Top speeds of x and y where each axis runs at its own; null where the head moves straight. */
  perAxis: [number, number] | null;
}

export type ToRaster =
  | { type: 'geometry'; geometry: Geometry; roles: Uint8Array; ignored: Geometry; drawn: Geometry | null }
  | { type: 'common'; common: Geometry | null }
  /** `changed`: 1 for each stop the improvement moved. */
  | { type: 'path'; path: BestPath | null; travel: Travel; changed: Uint8Array | null }
  | { type: 'style'; palette: Palette; ramp: boolean; air: boolean }
  /** `upto`: stops drawn in the layer `done`. */
  | { type: 'draw'; layer: Layer; serial: number; view: View; upto: number };

export type FromRaster = { type: 'drawn'; layer: Layer; serial: number; view: View; upto: number; bitmap: ImageBitmap };
