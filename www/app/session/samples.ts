/** Drawings that come with the page, fetched when chosen. */

export interface Sample {
  file: string;
  title: string;
  about: string;
}

/** The first is shown on a first visit. */
export const SAMPLES: readonly Sample[] = [
  { file: 'sheet_100.dxf', title: 'Sheet, 100 contours', about: 'Gears, flanges and brackets on 1000 × 500 mm' },
  { file: 'sheet_500.dxf', title: 'Sheet, 500 contours', about: 'A full sheet with parts inside parts' },
  { file: 'qu_du_43.dxf', title: '43 contours by Qu and Du', about: 'The test sheet of a paper of 2023' },
  { file: 'lumberjack-polaris.dxf', title: 'Keyboard plate', about: 'A real drawing, by P. Jones (MIT)' },
];

/** Bytes of a sample. */
export async function fetchSample(sample: Sample): Promise<ArrayBuffer> {
  const answer = await fetch(`samples/${sample.file}`);
  if (!answer.ok) throw new Error(`The sample "${sample.title}" could not be loaded. Reload the page, or drop a DXF of your own.`);
  return answer.arrayBuffer();
}
