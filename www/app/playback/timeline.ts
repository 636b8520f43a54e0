/**
 * Where the head is at a moment of the job. The path says when the cut of each stop begins and ends. Between the end of one cut and the beginning
 * of the next are the air move and, at its end, a wait until what is near has cooled, and the piercing.
 */

import type { BestPath } from 'kerfway';
import { legTo, LIFTED, partOf, wayTo } from '../stage/legs.js';
import { chainLength, cutLength, firstStops, leadShapes, placeAfter, type Place, type Shapes } from '../stage/shapes.js';
import type { Travel } from '../stage/raster-messages.js';

export interface Moment {
  /** The stop where the head is or to which it moves; the number of stops when it is at home or moves there. */
  stop: number;
  /** The head cuts. Otherwise it is on an air move or pierces. */
  cutting: boolean;
  /** How much of the contour of the stop is already cut, and of its lead-in and lead-out, mm. */
  cut: number;
  leadIn: number;
  leadOut: number;
  x: number;
  y: number;
  /** How much of the air move to the stop is done, from 0 to 1; and whether the head is lifted over pieces that may have tipped. */
  gone: number;
  lifted: boolean;
}

export class Timeline {
  private readonly place: Place = { x: 0, y: 0, dx: 0, dy: 0 };
  private readonly first: Int32Array;

  /** `still`: seconds before each cut in which the head stands still to pierce. A contour that is continued is not pierced again. */
  constructor(
    readonly path: BestPath, readonly total: number, private readonly shapes: Shapes,
    private readonly contourLengths: Float64Array, private readonly travel: Travel, private readonly still: number,
  ) {
    this.first = firstStops(path, contourLengths.length);
  }

  get stops(): number {
    return this.path.contours.length;
  }

  /** When the cut of a stop begins, s. */
  begin(stop: number): number {
    return this.path.times[stop * 2] ?? this.total;
  }

  /** The stop that is being cut at `t`, or the next one. */
  stopAt(t: number): number {
    let low = 0, high = this.stops;
    while (low < high) {
      const mid = (low + high) >> 1;
      if (this.path.times[mid * 2 + 1]! < t) low = mid + 1;
      else high = mid;
    }
    return low;
  }

  at(t: number, out: Moment): Moment {
    const { times, contours } = this.path;
    const stop = this.stopAt(t);
    out.stop = stop;
    out.cut = out.leadIn = out.leadOut = 0;
    out.cutting = out.lifted = false;
    out.gone = 1;
    if (stop < this.stops && t >= times[stop * 2]!) {
      const begin = times[stop * 2]!, end = times[stop * 2 + 1]!;
      const chain = contours[stop]!;
      out.cutting = true;
      const whole = cutLength(this.path, stop, this.contourLengths[chain]!);
      const leads = leadShapes(this.path);
      const [into, away] = leads ? [chainLength(leads, 2 * stop), chainLength(leads, 2 * stop + 1)] : [0, 0];
      const gone = (into + whole + away) * (end > begin ? Math.min(1, (t - begin) / (end - begin)) : 1);
      out.leadIn = Math.min(into, gone);
      out.cut = Math.min(whole, Math.max(0, gone - into));
      out.leadOut = Math.max(0, gone - into - whole);
      if (leads && gone < into) placeAfter(leads, 2 * stop, 0, false, gone, this.place);
      else if (leads && out.leadOut > 0) placeAfter(leads, 2 * stop + 1, 0, false, out.leadOut, this.place);
      else placeAfter(this.shapes, chain, this.path.along[stop]!, this.path.reversed[stop] === 1, out.cut, this.place);
      out.x = this.place.x;
      out.y = this.place.y;
      return out;
    }
    const leg = legTo(this.path, this.travel, stop);
    const [x0, y0] = leg[0]!;
    const left = stop === 0 ? 0 : times[stop * 2 - 1]!;
    const last = stop === this.stops;
    if (last && !this.travel.returnHome) {
      out.x = x0;
      out.y = y0;
      return out;
    }
    // Until what was cut nearby has cooled, it stands still, too.
    const still = (this.first[contours[stop]!] === stop ? this.still : 0) + (this.path.waits?.[stop] ?? 0);
    const arrive = Math.max(left, last ? this.total : times[stop * 2]! - still);
    out.gone = arrive > left ? Math.min(1, (t - left) / (arrive - left)) : 1;
    out.lifted = out.gone < 1 && wayTo(this.path, stop) === LIFTED;
    if (leg.length === 2) this.along(x0, y0, ...leg[1]!, out.gone, out);
    else [out.x, out.y] = partOf(leg, out.gone).at(-1)!;
    return out;
  }

  /** The point of an air move after a share of its time, with the axes moving as on the machine. */
  private along(x0: number, y0: number, x1: number, y1: number, share: number, out: Moment): void {
    const dx = x1 - x0, dy = y1 - y0;
    let sx = share, sy = share;
    if (this.travel.perAxis) {
      const tx = Math.abs(dx) / this.travel.perAxis[0], ty = Math.abs(dy) / this.travel.perAxis[1];
      const whole = Math.max(tx, ty);
      sx = tx > 0 ? Math.min(1, (share * whole) / tx) : 1;
      sy = ty > 0 ? Math.min(1, (share * whole) / ty) : 1;
    }
    out.x = x0 + dx * sx;
    out.y = y0 + dy * sy;
  }
}
