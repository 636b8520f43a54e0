/** The drawings that come with the page. They are fetched when they are chosen. */

import type { LoadOptions } from 'kerfway';
import { words } from '../core/words/index.js';

export interface Sample {
  /** The name of its file; its title is in `words.samples`. */
  file: string;
  /** The choices that somebody who knows the drawing would make. */
  options: LoadOptions;
}

/** The first is shown on a first visit. */
export const SAMPLES: readonly Sample[] = [
  { file: 'sheet_500.dxf', options: {} },
  { file: 'sheet_100.dxf', options: {} },
  { file: 'qu_du_43.dxf', options: {} },
  { file: 'gaps-and-copies.dxf', options: {} },
  { file: 'layers.dxf', options: {} },
  { file: 'no-units.dxf', options: {} },
  { file: 'parts-in-parts.dxf', options: {} },
  { file: 'luggage-tags.svg', options: {} },
  { file: 'lumberjack-polaris.dxf', options: {} },
];

/** Fetches a sample. */
export async function fetchSample(sample: Sample): Promise<ArrayBuffer> {
  const response = await fetch(`samples/${sample.file}`);
  if (!response.ok) throw new Error(words.page.noSample(words.samples[sample.file]?.[0] ?? sample.file));
  return response.arrayBuffer();
}
