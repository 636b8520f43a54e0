/**
 * The picture of a drawing and its path. The contours are on one canvas, which is drawn once for each size; travel moves
 * and entry points are on another canvas above it. CSS sets the colours of both, and a change of theme is a transition to
 * another colour, at whose end the canvas is drawn again.
 */

import type { BestPath, Geometry, Loaded } from '../protocol.js';
import type { Home } from './home.js';

/** Numbers per element of a contour; see `Geometry`. */
const STRIDE = 7;
/** The margin around the drawing, in pixels. */
const MARGIN = 12;
/** The radius of the dot at an entry point, in pixels. */
const DOT = 2;
/** Paths with more stops have no dots: they would cover the drawing. */
const MOST_DOTS = 2000;

export class Picture {
  private sheet: { cut: Path2D; ignored: Path2D; bounds: Loaded['bounds'] } | null = null;
  private path: BestPath | null = null;
  private home: Home | null = null;
  private frameRequested = false;
  private readonly resized: ResizeObserver;

  constructor(
    private readonly contours: HTMLCanvasElement,
    private readonly travel: HTMLCanvasElement,
  ) {
    this.resized = new ResizeObserver(() => {
      this.drawContours();
      this.drawPath();
    });
    contours.addEventListener('transitionend', () => this.drawContours());
    travel.addEventListener('transitionend', () => this.drawPath());
  }

  /** Redraws when the size of the canvases changes. */
  watch(): void {
    this.resized.observe(this.contours);
  }

  unwatch(): void {
    this.resized.disconnect();
  }

  /** Shows another drawing without a path, or nothing for `null`. */
  show(loaded: Loaded | null, home: Home | null): void {
    this.sheet = loaded && { cut: traced(loaded.geometry, (id) => loaded.contours[id]?.operation !== 'ignore'), ignored: traced(loaded.ignored.geometry), bounds: loaded.bounds };
    this.home = home;
    this.path = null;
    this.drawContours();
    this.drawPath();
  }

  /** Shows another path at the next frame. */
  follow(path: BestPath): void {
    this.path = path;
    if (this.frameRequested) return;
    this.frameRequested = true;
    requestAnimationFrame(() => {
      this.frameRequested = false;
      this.drawPath();
    });
  }

  private drawContours(): void {
    const { sheet } = this;
    const pen = this.pen(this.contours);
    if (pen === null || sheet === null) return;
    const { context, scale, ratio } = pen;
    context.lineWidth = (1.2 * ratio) / scale;
    context.stroke(sheet.cut);
    context.globalAlpha = 0.4;
    context.setLineDash([4 * context.lineWidth, 3 * context.lineWidth]);
    context.stroke(sheet.ignored);
  }

  private drawPath(): void {
    const { path, home } = this;
    const pen = this.pen(this.travel);
    if (pen === null || path === null) return;
    const { context, scale, ratio } = pen;
    const p = path.points;
    const stops = path.contours.length;
    const entry = (k: number): [number, number] => [p[4 * k] ?? 0, p[4 * k + 1] ?? 0];
    const exit = (k: number): [number, number] => [p[4 * k + 2] ?? 0, p[4 * k + 3] ?? 0];
    context.lineWidth = ratio / scale;
    context.beginPath();
    context.moveTo(...(home?.home ?? entry(0)));
    // Way points are in the order of the stops.
    let next = 0;
    const around = (stop: number) => {
      for (; path.viaOf[next] === stop; next += 1) context.lineTo(path.via[2 * next] ?? 0, path.via[2 * next + 1] ?? 0);
    };
    for (let k = 0; k < stops; k += 1) {
      around(k);
      context.lineTo(...entry(k));
      context.moveTo(...exit(k));
    }
    around(stops);
    if (home?.return_home === true) context.lineTo(...home.home);
    context.stroke();
    if (stops > MOST_DOTS) return;
    const radius = (DOT * ratio) / scale;
    context.beginPath();
    for (let k = 0; k < stops; k += 1) {
      const [x, y] = entry(k);
      context.moveTo(x + radius, y);
      context.arc(x, y, radius, 0, 2 * Math.PI);
    }
    context.fill();
  }

  // Clears a canvas, gives it its size on the screen, and sets up coordinates in mm with y upwards.
  private pen(canvas: HTMLCanvasElement): { context: CanvasRenderingContext2D; scale: number; ratio: number } | null {
    const ratio = globalThis.devicePixelRatio;
    canvas.width = Math.round(canvas.clientWidth * ratio);
    canvas.height = Math.round(canvas.clientHeight * ratio);
    const context = canvas.getContext('2d');
    if (context === null || this.sheet === null) return null;
    const [x0, y0, x1, y1] = this.sheet.bounds;
    const room = (pixels: number) => Math.max(pixels - 2 * MARGIN * ratio, 1);
    const scale = Math.min(room(canvas.width) / Math.max(x1 - x0, 1e-6), room(canvas.height) / Math.max(y1 - y0, 1e-6));
    context.setTransform(scale, 0, 0, -scale, canvas.width / 2 - (scale * (x0 + x1)) / 2, canvas.height / 2 + (scale * (y0 + y1)) / 2);
    context.strokeStyle = context.fillStyle = getComputedStyle(canvas).color;
    context.lineJoin = 'round';
    return { context, scale, ratio };
  }
}

function traced({ segments: s, offsets }: Geometry, shown = (_chain: number) => true): Path2D {
  const path = new Path2D();
  for (let chain = 0; chain + 1 < offsets.length; chain += 1) {
    if (!shown(chain)) continue;
    const [first, end] = [STRIDE * (offsets[chain] ?? 0), STRIDE * (offsets[chain + 1] ?? 0)];
    path.moveTo(s[first] ?? 0, s[first + 1] ?? 0);
    for (let i = first; i < end; i += STRIDE) {
      const [x0 = 0, y0 = 0, x1 = 0, y1 = 0, cx = 0, cy = 0, sweep = 0] = s.subarray(i, i + STRIDE);
      const start = Math.atan2(y0 - cy, x0 - cx);
      if (sweep === 0) path.lineTo(x1, y1);
      else path.arc(cx, cy, Math.hypot(x0 - cx, y0 - cy), start, start + sweep, sweep < 0);
    }
  }
  return path;
}
