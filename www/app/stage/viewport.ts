/**
 * The part of the sheet that is on screen. World: mm, y up. Screen: CSS pixels, y down, origin at the top left corner of the canvas.
 * screen x = x + world x * scale; screen y = y - world y * scale.
 */

import { Emitter } from '../core/emitter.js';
import { lessMotion } from '../core/dom.js';

/** The largest scale, pixels per mm: a contour of 0.05 mm still fills a good part of the screen. */
const CLOSEST = 4000;
/** The smallest scale, as a share of the scale at which the sheet fits. */
const FARTHEST = 1 / 6;
/** Seconds of an animated move: long enough to see where it goes. */
const FLIGHT = 0.28;
/** Pixels between the card and a box that slides up above it. */
const ABOVE = 24;

export type Box = readonly [number, number, number, number];

/** How many pixels at each side of the canvas are covered by bars and panels. */
export interface Insets {
  top: number;
  right: number;
  bottom: number;
  left: number;
}

export class Viewport extends Emitter<{ change: void }> {
  scale = 1;
  x = 0;
  y = 0;
  width = 1;
  height = 1;
  insets: Insets = { top: 0, right: 0, bottom: 0, left: 0 };
  private bounds: Box = [0, 0, 1, 1];
  private fitted = true;
  private flight = 0;

  /** Takes over the size of the canvas and what covers it. A fitted sheet stays fitted. */
  resize(width: number, height: number, insets: Insets): void {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
    this.insets = insets;
    if (this.fitted) this.fit(false);
    else this.emit('change', undefined);
  }

  /** Takes over the size of the sheet. The view stays where it is unless `fit`. */
  setBounds(bounds: Box, fit: boolean): void {
    const [x0, y0, x1, y1] = bounds;
    const sound = [x0, y0, x1, y1].every(Number.isFinite) && x1 >= x0 && y1 >= y0;
    this.bounds = sound ? bounds : [0, 0, 1, 1];
    if (fit) this.fit(false);
  }

  /** Shows the whole sheet. */
  fit(animated = true): void {
    this.moveTo(...this.framing(this.bounds, 0.94), animated);
    this.fitted = true;
  }

  /** Shows a box. */
  show(box: Box): void {
    this.moveTo(...this.framing(box, 0.94), true);
  }

  /** Shows a place with its surroundings: a fifth of the sheet around it. */
  showPlace(x: number, y: number): void {
    const room = this.span() / 10;
    this.moveTo(...this.framing([x - room, y - room, x + room, y + room], 1), true);
  }

  /** Moves the view so that a box is visible, if it is not. One whose middle is behind the card, which reaches from the lower left corner to `right` and `top`, slides up above it. */
  reveal(box: Box, card: { right: number; top: number }): void {
    const { left, right, top, bottom } = this.insets;
    const x0 = this.x + box[0] * this.scale, x1 = this.x + box[2] * this.scale;
    const y0 = this.y - box[3] * this.scale, y1 = this.y - box[1] * this.scale;
    const within = x0 >= left && x1 <= this.width - right && y0 >= top && y1 <= this.height - bottom;
    if (within) {
      const isBehind = (x0 + x1) / 2 < card.right && (y0 + y1) / 2 > card.top;
      if (isBehind) this.moveTo(this.scale, this.x, this.y + card.top - ABOVE - y1, true);
      return;
    }
    const cx = (left + this.width - right) / 2, cy = (top + this.height - bottom) / 2;
    this.moveTo(this.scale, cx - ((box[0] + box[2]) / 2) * this.scale, cy + ((box[1] + box[3]) / 2) * this.scale, true);
  }

  /** Zooms by a factor about the point under the pointer. */
  zoomAt(px: number, py: number, factor: number): void {
    this.land();
    const scale = this.clamp(this.scale * factor);
    const ratio = scale / this.scale;
    this.x = px + (this.x - px) * ratio;
    this.y = py + (this.y - py) * ratio;
    this.scale = scale;
    this.fitted = false;
    this.emit('change', undefined);
  }

  /** Zooms about the centre of the visible part. */
  zoom(factor: number): void {
    const { left, right, top, bottom } = this.insets;
    this.zoomAt((left + this.width - right) / 2, (top + this.height - bottom) / 2, factor);
  }

  pan(dx: number, dy: number): void {
    this.land();
    this.x += dx;
    this.y += dy;
    this.fitted = false;
    this.emit('change', undefined);
  }

  worldX(px: number): number {
    return (px - this.x) / this.scale;
  }

  worldY(py: number): number {
    return (this.y - py) / this.scale;
  }

  private span(): number {
    return Math.max(this.bounds[2] - this.bounds[0], this.bounds[3] - this.bounds[1], 1e-6);
  }

  private clamp(scale: number): number {
    const [fit] = this.framing(this.bounds, 0.94);
    return Math.min(CLOSEST, Math.max(Math.min(fit * FARTHEST, this.scale), scale));
  }

  /** Scale and offsets that centre a box in the uncovered part. */
  private framing(box: Box, fill: number): [number, number, number] {
    const { left, right, top, bottom } = this.insets;
    const width = Math.max(40, this.width - left - right), height = Math.max(40, this.height - top - bottom);
    const w = Math.max(box[2] - box[0], 1e-6), h = Math.max(box[3] - box[1], 1e-6);
    const scale = Math.min(CLOSEST, fill * Math.min(width / w, height / h));
    return [scale, left + width / 2 - ((box[0] + box[2]) / 2) * scale, top + height / 2 + ((box[1] + box[3]) / 2) * scale];
  }

  private moveTo(scale: number, x: number, y: number, animated: boolean): void {
    this.land();
    this.fitted = false;
    if (!animated || lessMotion()) {
      this.set(scale, x, y);
      return;
    }
    const from = { scale: this.scale, x: this.x, y: this.y };
    const began = performance.now();
    const step = () => {
      const t = Math.min(1, (performance.now() - began) / (FLIGHT * 1000));
      const k = 1 - (1 - t) ** 3;
      const s = from.scale * (scale / from.scale) ** k;
      // The centre of the screen moves in proportion to the scale, so that the path is straight.
      const u = scale === from.scale ? k : (s - from.scale) / (scale - from.scale);
      this.set(s, from.x + (x - from.x) * u, from.y + (y - from.y) * u);
      this.flight = t < 1 ? requestAnimationFrame(step) : 0;
    };
    this.flight = requestAnimationFrame(step);
  }

  private set(scale: number, x: number, y: number): void {
    this.scale = scale;
    this.x = x;
    this.y = y;
    this.emit('change', undefined);
  }

  private land(): void {
    if (this.flight) cancelAnimationFrame(this.flight);
    this.flight = 0;
  }
}
