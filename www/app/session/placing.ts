/** Where the job lies on the bed of the machine: a choice of the person, and what follows from it. Lengths in mm. */

import { type Anchor, type Loaded, type MachineProfile, type Place, type PlanOptions, pointOf, type Start } from 'kerfway';
import type { Box } from './extent.js';

export interface Placing {
  /** Null: as drawn. */
  readonly place: Place | null;
  readonly start: Start;
  /** Whether programs may reach beyond the bed. */
  readonly allowOffBed: boolean;
}

export const AS_DRAWN: Placing = { place: null, start: 'absolute', allowOffBed: false };

/** What is chosen about where the job lies and what it is cut from, as options of a plan. */
export function jobOptions({ placing: { place, start, allowOffBed }, material }: { placing: Placing; material: string | null }): PlanOptions {
  return { start, allowOffBed, ...(place === null ? {} : { place }), ...(material === null ? {} : { material }) };
}

/** How far beyond the edge still counts as on the bed, as in the planner. */
const EDGE = 0.0005;

/** From the coordinates of the drawing to those of the machine. */
export function shiftOf({ place }: Placing, loaded: Loaded | null): [number, number] {
  if (place === null || loaded === null) return [0, 0];
  const [x, y] = place.from ?? pointOf(place.point ?? 'lower-left', loaded.bounds);
  return [place.at[0] - x, place.at[1] - y];
}

/** The box of the job in machine coordinates: of its drawn lines, or of another box around it. */
export function jobBox(placing: Placing, loaded: Loaded, [x0, y0, x1, y1]: Box = loaded.bounds): Box {
  const [dx, dy] = shiftOf(placing, loaded);
  return [x0 + dx, y0 + dy, x1 + dx, y1 + dy];
}

/** The bed as seen from the drawing; null where the machine has none, or where it is not known where on it the job lies. */
export function bedAround(placing: Placing, machine: MachineProfile | null, loaded: Loaded | null): Box | null {
  if (!machine?.bed || placing.start === 'current') return null;
  const [dx, dy] = shiftOf(placing, loaded);
  const [x0, y0, x1, y1] = machine.bed;
  return [x0 - dx, y0 - dy, x1 - dx, y1 - dy];
}

/** Where the head starts, as seen from the drawing. */
export function homeAround(placing: Placing, machine: MachineProfile, loaded: Loaded | null): [number, number] {
  const [dx, dy] = shiftOf(placing, loaded);
  const [x, y] = placing.start === 'current' ? [0, 0] : machine.home;
  return [x - dx, y - dy];
}

/** Whether the job lies on the bed. `box`: as above. */
export function fitsBed(placing: Placing, machine: MachineProfile | null, loaded: Loaded, box?: Box): boolean {
  if (!machine?.bed) return true;
  const [x0, y0, x1, y1] = machine.bed;
  const job = jobBox(placing, loaded, box);
  // The head begins at the origin, so that place has to be on the bed as well.
  const reach = (from: number, to: number) => Math.max(to, 0) - Math.min(from, 0);
  if (placing.start === 'current') return reach(job[0], job[2]) <= x1 - x0 + 2 * EDGE && reach(job[1], job[3]) <= y1 - y0 + 2 * EDGE;
  return job[0] >= x0 - EDGE && job[1] >= y0 - EDGE && job[2] <= x1 + EDGE && job[3] <= y1 + EDGE;
}

/** A place in hundredths of a millimetre. */
export const hundredths = (mm: number) => Math.round(mm * 100) / 100 + 0;

/** The placement that puts the job's point `anchor` where it lies now, so that choosing another point moves nothing. */
export function anchoredAt(anchor: Anchor, placing: Placing, loaded: Loaded): Place {
  const [x, y] = pointOf(anchor, jobBox(placing, loaded));
  return { point: anchor, at: [hundredths(x), hundredths(y)] };
}

/** The placement after the job was dragged by a vector. */
export function dragged(placing: Placing, loaded: Loaded, dx: number, dy: number): Place {
  const { point, at } = placing.place?.point === undefined ? anchoredAt('lower-left', placing, loaded) : placing.place;
  return { point: point ?? 'lower-left', at: [hundredths(at[0] + dx), hundredths(at[1] + dy)] };
}
