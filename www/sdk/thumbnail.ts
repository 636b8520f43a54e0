/** Pictures of parts, made from the contents of a drawing without planning it. */

import { check, optional, shown, type Range, type Shape } from './check.js';
import { checkLoaded } from './contours.js';
import { KerfwayError } from './errors.js';
import type { Loaded } from './protocol.js';

/** How a thumbnail is drawn. */
export interface ThumbnailOptions {
  /** Width and height of the picture in pixels; the part fills it in its own proportions. Default 96. */
  size?: number;
}

const SIZE: Range = { least: 8, most: 4096, or_zero: false, unit: 'pixels', why: 'smaller pictures show nothing' };
const OPTIONS: Shape = { owner: 'A thumbnail', item: 'option', value: 'The option', fields: [optional('size', { number: SIZE })] };

/** Room around the part, as a fraction of its longer side. */
const ROOM = 0.04;

/**
 * An SVG of one part with its holes, and the marks and open cuts on it as lines. `id` is the id of its outer contour: `outer` of `Loaded.parts`,
 * `id` of the items of a quote. It has the text colour of the page around it.
 */
export function partThumbnail(loaded: Pick<Loaded, 'contours' | 'geometry' | 'parts'>, id: number, options: ThumbnailOptions = {}): string {
  checkLoaded(loaded, 'contours', 'parts', 'geometry');
  check(OPTIONS, options);
  const part = loaded.parts.find((p) => p.outer === id);
  if (part === undefined) throw new KerfwayError('unknown-contour', `Contour ${shown(id)} is not the outer contour of a part.`, { contour: typeof id === 'number' ? id : shown(id), count: loaded.contours.length });
  return thumbnailOf(loaded, part, options);
}

/** The same for a part that is at hand, without looking for it among all parts. */
export function thumbnailOf(loaded: Pick<Loaded, 'contours' | 'geometry'>, part: Loaded['parts'][number], { size = 96 }: ThumbnailOptions = {}): string {
  const isArea = (contour: number) => loaded.contours[contour]?.closed === true && loaded.contours[contour]?.operation === 'cut';
  const lines = [part.outer, ...part.holes].map((contour) => ({ area: isArea(contour), elements: elementsOf(loaded.geometry, contour) }));
  const outer = boxOf(lines[0]?.elements ?? []);
  const room = ROOM * Math.max(outer.x1 - outer.x0, outer.y1 - outer.y0);
  const [width, height] = [outer.x1 - outer.x0 + 2 * room, outer.y1 - outer.y0 + 2 * room];
  const place = (x: number, y: number) => `${short(x - outer.x0 + room)} ${short(outer.y1 - y + room)}`;
  const drawn = (area: boolean) => lines.filter((line) => line.area === area).map((line) => pathOf(line.elements, place, area)).join('');
  const [body, marks] = [drawn(true), drawn(false)];
  const scale = size / Math.max(width, height, Number.MIN_VALUE);
  const style = 'vector-effect="non-scaling-stroke" stroke="currentColor" stroke-width="1"';
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${short(width * scale)}" height="${short(height * scale)}" viewBox="0 0 ${short(width)} ${short(height)}" role="img">` +
    `<path d="${body}" fill="currentColor" fill-opacity="0.15" fill-rule="evenodd" ${style}/>` +
    (marks === '' ? '' : `<path d="${marks}" fill="none" ${style}/>`) +
    '</svg>'
  );
}

/** A line or an arc: ends, centre, and sweep in rad (0 for a line). */
interface Element {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
  cx: number;
  cy: number;
  sweep: number;
}

/** Numbers of an element in `Geometry.segments`. */
const NUMBERS = 7;

function elementsOf({ segments, offsets }: Loaded['geometry'], contour: number): Element[] {
  const elements: Element[] = [];
  for (let k = offsets[contour] ?? 0; k < (offsets[contour + 1] ?? 0); k += 1) {
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0, cx = 0, cy = 0, sweep = 0] = Array.from({ length: NUMBERS }, (_, i) => segments[k * NUMBERS + i]);
    elements.push({ x0, y0, x1, y1, cx, cy, sweep });
  }
  return elements;
}

/** The point of an arc at a fraction of its sweep. */
function along({ x0, y0, cx, cy, sweep }: Element, fraction: number): [number, number] {
  const [cos, sin] = [Math.cos(sweep * fraction), Math.sin(sweep * fraction)];
  const [dx, dy] = [x0 - cx, y0 - cy];
  return [cx + dx * cos - dy * sin, cy + dx * sin + dy * cos];
}

/** Points per full turn of an arc for its box: within 0.5 % of its radius. */
const BOX_POINTS = 32;

function boxOf(elements: readonly Element[]): { x0: number; y0: number; x1: number; y1: number } {
  const box = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };
  for (const e of elements) {
    const pieces = e.sweep === 0 ? 1 : Math.max(2, Math.ceil((Math.abs(e.sweep) / (2 * Math.PI)) * BOX_POINTS));
    for (let k = 0; k <= pieces; k += 1) {
      const [x, y] = e.sweep === 0 ? (k === 0 ? [e.x0, e.y0] : [e.x1, e.y1]) : along(e, k / pieces);
      box.x0 = Math.min(box.x0, x);
      box.y0 = Math.min(box.y0, y);
      box.x1 = Math.max(box.x1, x);
      box.y1 = Math.max(box.y1, y);
    }
  }
  return box.x0 <= box.x1 ? box : { x0: 0, y0: 0, x1: 0, y1: 0 };
}

/** Elements as path data. An arc is written in two halves, because SVG cannot draw a full circle as one. */
function pathOf(elements: readonly Element[], place: (x: number, y: number) => string, closed: boolean): string {
  const [first] = elements;
  if (first === undefined) return '';
  const steps = elements.map((e) => {
    if (e.sweep === 0) return `L${place(e.x1, e.y1)}`;
    const radius = short(Math.hypot(e.x0 - e.cx, e.y0 - e.cy));
    // y points up in the drawing and down in SVG, so a counter-clockwise arc has the flag 0.
    const flag = e.sweep > 0 ? 0 : 1;
    return `A${radius} ${radius} 0 0 ${flag} ${place(...along(e, 0.5))}A${radius} ${radius} 0 0 ${flag} ${place(e.x1, e.y1)}`;
  });
  return `M${place(first.x0, first.y0)}${steps.join('')}${closed ? 'Z' : ''}`;
}

/** A number with at most three decimals: a thousandth of a millimetre cannot be seen. */
function short(n: number): string {
  return String(Math.round(n * 1000) / 1000);
}
