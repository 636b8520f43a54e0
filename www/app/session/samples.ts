/** Drawings that come with the page, fetched when chosen. */

import type { LoadOptions } from 'kerfway';

export interface Sample {
  file: string;
  title: string;
  about: string;
  /** What a person who knows the drawing has already decided. */
  options: LoadOptions;
}

/** The border of our sheets is the sheet itself, not a cut. */
const BORDER: LoadOptions = { layers: [{ name: 'SHEET', operation: 'ignore' }] };

/** The first is shown on a first visit. */
export const SAMPLES: readonly Sample[] = [
  { file: 'sheet_500.dxf', title: 'Sheet, 500 contours', about: 'A full sheet with parts inside parts', options: BORDER },
  { file: 'sheet_100.dxf', title: 'Sheet, 100 contours', about: 'Gears, flanges and brackets on 1000 × 500 mm', options: BORDER },
  { file: 'qu_du_43.dxf', title: '43 contours by Qu and Du', about: 'The test sheet of a paper of 2023', options: {} },
  { file: 'lumberjack-polaris.dxf', title: 'Keyboard plate', about: 'A real drawing, by Paul James (MIT)', options: {} },
];

/** Bytes of a sample. */
export async function fetchSample(sample: Sample): Promise<ArrayBuffer> {
  const answer = await fetch(`samples/${sample.file}`);
  if (!answer.ok) throw new Error(`The sample "${sample.title}" could not be loaded. Reload the page, or drop a DXF of your own.`);
  return answer.arrayBuffer();
}
