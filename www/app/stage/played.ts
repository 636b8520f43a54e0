/** Draws, with every frame of the playback, the last few stops before the head: the bitmap of the layer `done` holds those before them. */

import type { BestPath } from 'kerfway';
import type { Moment } from '../playback/timeline.js';
import type { Palette } from './palette.js';
import type { Travel, View } from './raster-messages.js';
import type { Shapes } from './shapes.js';
import { legTo, partOf, traceLeg, type Point } from './legs.js';
import { traceCut, traceLeads, traceStop } from './trace.js';

/** How many stops the layer `done` may be behind the head before it is drawn again. */
export const LAG = 24;

/** What is played. */
interface Job {
  shapes: Shapes;
  path: BestPath;
  travel: Travel;
  /** Whether air moves are shown. */
  air: boolean;
}

/** Draws everything from stop `from` to the moment. */
export function drawPlayed(pen: CanvasRenderingContext2D, view: View, palette: Palette, job: Job, moment: Moment, from: number): void {
  const { shapes, path } = job;
  const first = Math.max(0, from);
  if (job.air) strokeAirMoves(pen, view, palette, job, moment, first);
  pen.strokeStyle = palette.ink;
  pen.lineWidth = 1.6 * view.ratio;
  pen.beginPath();
  for (let k = first; k < moment.stop; k += 1) traceStop(pen, view, shapes, path, k);
  if (moment.cutting && moment.stop < path.contours.length) {
    traceLeads(pen, view, path, moment.stop, moment.leadIn, moment.leadOut);
    traceCut(pen, view, shapes, path, moment.stop, moment.cut);
  }
  pen.stroke();
}

function strokeAirMoves(pen: CanvasRenderingContext2D, view: View, palette: Palette, { path, travel }: Job, moment: Moment, first: number): void {
  const stops = path.contours.length;
  pen.strokeStyle = palette.accent;
  pen.lineWidth = view.ratio;
  pen.beginPath();
  for (let k = first; k < moment.stop; k += 1) traceLeg(pen, view, travel, legTo(path, travel, k));
  if (moment.stop < stops || travel.returnHome) {
    const k = moment.stop;
    // An unfinished move is drawn as a straight line to the head.
    const leg = legTo(path, travel, k);
    const begun: Point[] = leg.length > 2 ? partOf(leg, moment.gone) : [leg[0]!, [moment.x, moment.y]];
    if (moment.cutting) traceLeg(pen, view, travel, leg);
    else traceLeg(pen, view, { ...travel, perAxis: null }, begun);
  }
  pen.stroke();
}
