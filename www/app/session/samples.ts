/** The drawings that come with the page. They are fetched when they are chosen. */

import { jointRules, leadRules, type LoadOptions, type MachineProfile } from 'kerfway';
import { words } from '../core/words/index.js';

export interface Sample {
  /** The name of its file; its title is in `words.samples`. */
  file: string;
  /** The choices that somebody who knows the drawing would make. */
  options: LoadOptions;
  /** The machine that shows an ability; left out: the one the person has. */
  machine?: { preset: string; changes: Partial<MachineProfile> };
}

const THIN = 'fibre-3kw-thin';
const LIFT = { height: 10, stay_down: 10 };

/** The first is shown on a first visit. */
export const SAMPLES: readonly Sample[] = [
  { file: 'sheet_500.dxf', options: {} },
  { file: 'sheet_100.dxf', options: {} },
  { file: 'qu_du_43.dxf', options: {} },
  { file: 'gaps-and-copies.dxf', options: {} },
  { file: 'layers.dxf', options: {} },
  { file: 'no-units.dxf', options: {} },
  { file: 'parts-in-parts.dxf', options: {} },
  { file: 'perforated.dxf', options: {}, machine: { preset: THIN, changes: { levers: { fly: { reach: 20, overcut: 0 } } } } },
  { file: 'held-plates.dxf', options: {}, machine: { preset: THIN, changes: { leads: leadRules(), joints: jointRules() } } },
  {
    file: 'tips-and-skeleton.dxf', options: {},
    machine: { preset: THIN, changes: { z_speed: 100, levers: { lift: LIFT, tips: { slats: { pitch: 60, angle: Math.PI / 2 } } }, skeleton: { spacing_x: 300, spacing_y: 300, clearance: 2, joint_width: 1 } } },
  },
  { file: 'luggage-tags.svg', options: {} },
  { file: 'lumberjack-polaris.dxf', options: {} },
];

/** Fetches a sample. */
export async function fetchSample(sample: Sample): Promise<ArrayBuffer> {
  const response = await fetch(`samples/${sample.file}`).catch(() => null);
  if (!response?.ok) throw new Error(words.page.noSample(words.samples[sample.file]?.[0] ?? sample.file));
  return response.arrayBuffer();
}
