/**
 * The stage: puts each frame together from the drawing worker's bitmaps and the few things that change by the frame.
 * A frame is drawn only when something changed. Bitmaps that do not fit the view any more are shown scaled and moved
 * until fresh ones arrive, so panning and zooming never wait.
 */

import { lessMotion } from '../core/dom.js';
import type { Beam, BestPath, ContourInfo, Finding, Geometry, Insight, Loaded } from 'kerfway';
import { changedStops } from './changes.js';
import { HitGrid } from './hit-grid.js';
import * as overlay from './overlay.js';
import { traceCut, traceStop } from './paint.js';
import { readPalette, type Palette } from './palette.js';
import { Raster } from './raster.js';
import { Role, type Layer, type Travel, type View } from './raster-messages.js';
import { chainLength, firstStops, prepare, type Shapes } from './shapes.js';
import { traceAir } from './trace.js';
import type { Moment } from '../playback/timeline.js';
import type { Box } from '../session/extent.js';
import type { Mark } from '../session/outlook.js';
import type { Viewport } from './viewport.js';
import { words } from '../core/words/index.js';

/** Milliseconds between two paths shown: ten a second look continuous, more cost the planner time. */
const PATH_PAUSE = 100;
/** Milliseconds an improvement glows. */
const GLOW = 900;
/** Stops the layer `done` may lag behind the head before it is drawn anew; the rest is stroked by the frame. */
const LAG = 24;
/** Device pixels a CSS pixel at most: beyond two nobody sees the difference, and memory grows with the square. */
const MOST_RATIO = 2;

const NOWHERE: Travel = { home: [0, 0], returnHome: false, perAxis: null };

export class Scene {
  readonly raster = new Raster();
  shapes: Shapes | null = null;
  /** Length of each contour, mm. */
  lengths = new Float64Array(0);
  travel: Travel = NOWHERE;
  hovered: number | null = null;
  /** The selected contour. */
  selected: number | null = null;
  finding: Finding | null = null;
  /** What another reading would change, while somebody looks. */
  marks: readonly Mark[] = [];
  /** Where the head is shown; null: no playback, everything in full. */
  moment: Moment | null = null;
  /** Of a method that makes partitions. */
  partitions: Insight['partitions'] = null;
  showRamp = false;
  showAir = true;
  private loaded: Loaded | null = null;
  /** The lines of the beam where they are not those drawn. */
  private beam: Beam | null = null;
  /** Stretches that are cut once for two parts. */
  private common: Geometry | null = null;
  /** Found on the machine, besides what is told of the drawing. */
  private found: readonly Finding[] = [];
  private extent: Box = [0, 0, 1, 1];
  /** Made when the pointer first comes over the sheet. */
  private grid: HitGrid | null = null;
  private path: BestPath | null = null;
  private stopOf: Int32Array | null = null;
  private held: BestPath | null = null;
  private pathTimer = 0;
  private pathShown = -Infinity;
  private glowing = -Infinity;
  private palette: Palette;
  private readonly pen: CanvasRenderingContext2D;
  private frame = 0;

  constructor(private readonly canvas: HTMLCanvasElement, readonly viewport: Viewport, private theme: 'light' | 'dark') {
    const pen = canvas.getContext('2d', { alpha: false });
    if (!pen) throw new Error(words.page.noCanvas);
    this.pen = pen;
    this.palette = readPalette(theme);
    this.restyle();
    viewport.on('change', () => this.invalidate());
    this.raster.on('drawn', (layer) => {
      if (layer === 'glow') this.glowing = performance.now();
      this.invalidate();
    });
  }

  setTheme(theme: 'light' | 'dark'): void {
    this.theme = theme;
    this.restyle();
  }

  setView(options: { ramp?: boolean; air?: boolean }): void {
    this.showRamp = options.ramp ?? this.showRamp;
    this.showAir = options.air ?? this.showAir;
    this.restyle();
  }

  /** Another drawing, or the same one read otherwise; the view stays where it is unless `fit`. */
  setDrawing(loaded: Loaded | null, extent: Box, fit: boolean): void {
    this.loaded = loaded;
    this.extent = extent;
    this.path = this.held = this.stopOf = null;
    this.hovered = this.selected = this.finding = this.moment = null;
    this.marks = [];
    this.beam = this.common = null;
    this.found = [];
    this.showContours();
    if (loaded && fit) this.viewport.setBounds(extent);
    this.invalidate();
  }

  /** What a plan began with: the lines of the beam over those drawn (null: it follows these), what is cut once, findings. */
  setPlanned({ beam, common, found }: { beam: Beam | null; common: Geometry | null; found: readonly Finding[] }): void {
    if (beam === this.beam && common === this.common && found === this.found) return;
    const other = beam !== this.beam;
    Object.assign(this, { beam, common, found });
    if (other) {
      this.path = this.held = this.stopOf = this.hovered = null;
      if (this.selected !== null && this.selected >= (beam ?? this.loaded)!.contours.length) this.selected = null;
      this.showContours();
    }
    this.raster.setCommon(common);
    this.invalidate();
  }

  private showContours(): void {
    const { loaded, beam } = this;
    this.shapes = this.grid = this.partitions = null;
    this.lengths = new Float64Array(0);
    if (!loaded) return;
    const { geometry, contours } = beam ?? loaded;
    const shapes = (this.shapes = prepare(geometry));
    this.lengths = new Float64Array(shapes.count);
    for (let c = 0; c < shapes.count; c += 1) this.lengths[c] = chainLength(shapes, c);
    this.raster.setGeometry(geometry, rolesOf(contours, loaded.outline), loaded.ignored.geometry, beam && loaded.geometry);
  }

  /** The best path, shown at most ten times a second. */
  setPath(path: BestPath | null, travel: Travel): void {
    this.travel = travel;
    this.held = path;
    clearTimeout(this.pathTimer);
    const wait = this.pathShown + PATH_PAUSE - performance.now();
    if (path && wait > 0) this.pathTimer = window.setTimeout(() => this.showPath(), wait);
    else this.showPath();
  }

  private showPath(): void {
    const path = this.held;
    this.pathShown = performance.now();
    const changed = path && !lessMotion() ? changedStops(this.path, path) : null;
    this.path = path;
    this.stopOf = null;
    this.raster.setPath(path, this.travel, changed, this.showRamp);
    this.glowing = -Infinity;
    if (changed) this.raster.need('glow', this.view());
    this.invalidate();
  }

  /** The contour under a point of the screen, within `reach` CSS pixels. */
  pick(x: number, y: number, reach: number): number | null {
    const { viewport: v, shapes, loaded } = this;
    if (!shapes || !loaded) return null;
    this.grid ??= new HitGrid(shapes, loaded.bounds);
    return this.grid.nearest(v.worldX(x), v.worldY(y), reach / v.scale);
  }

  /** The finding whose marker is under a point of the screen. */
  pickFinding(x: number, y: number, reach: number): Finding | null {
    const v = this.viewport;
    const hit = (f: Finding) => f.at && f.severity !== 'info' && Math.hypot(v.x + f.at[0] * v.scale - x, v.y - f.at[1] * v.scale - y) < reach;
    return this.loaded?.findings.find(hit) ?? this.found.find(hit) ?? null;
  }

  /** Box of a contour, mm. */
  boxOf(contour: number): [number, number, number, number] | null {
    const b = this.shapes?.boxes;
    if (!b || contour * 4 + 3 >= b.length) return null;
    return [b[contour * 4]!, b[contour * 4 + 1]!, b[contour * 4 + 2]!, b[contour * 4 + 3]!];
  }

  /** Draws a frame soon. */
  invalidate(): void {
    if (!this.frame) this.frame = requestAnimationFrame(() => this.draw());
  }

  private restyle(): void {
    this.palette = readPalette(this.theme);
    this.raster.setStyle(this.palette, this.showRamp, this.showAir);
    this.invalidate();
  }

  private view(): View {
    const { viewport: v } = this;
    const ratio = Math.min(MOST_RATIO, devicePixelRatio || 1);
    return { scale: v.scale * ratio, x: v.x * ratio, y: v.y * ratio, width: Math.round(v.width * ratio), height: Math.round(v.height * ratio), ratio };
  }

  private draw(): void {
    this.frame = 0;
    const { pen, palette, canvas } = this;
    const view = this.view();
    if (canvas.width !== view.width || canvas.height !== view.height) {
      canvas.width = view.width;
      canvas.height = view.height;
    }
    pen.setTransform(1, 0, 0, 1, 0, 0);
    pen.globalAlpha = 1;
    pen.fillStyle = palette.ground;
    pen.fillRect(0, 0, view.width, view.height);
    const { loaded, shapes } = this;
    if (!loaded || !shapes) return;
    overlay.drawSheet(pen, view, palette, this.extent);
    const playing = this.moment !== null && this.path !== null;
    this.blit('sheet', view, playing ? 0.25 : 1);
    if (playing) this.drawPlayed(view);
    else if (this.path) {
      if (this.partitions?.parents.length) overlay.drawPartitions(pen, view, palette, shapes, this.partitions);
      this.blit('path', view, 1);
      this.drawGlow(view);
      overlay.drawMarks(pen, view, palette, this.path);
    }
    if (this.hovered !== null && this.hovered !== this.selected) overlay.drawEmphasis(pen, view, palette, shapes, this.hovered, false);
    if (this.selected !== null) {
      overlay.drawEmphasis(pen, view, palette, shapes, this.selected, true);
      const stop = this.stopFor(this.selected);
      if (this.path && stop !== null) overlay.drawWays(pen, view, palette, this.path, this.travel, stop);
    }
    overlay.drawFindings(pen, view, palette, [...loaded.findings, ...this.found], this.finding);
    overlay.drawOutlook(pen, view, palette, this.marks);
    if (playing) overlay.drawHead(pen, view, palette, this.moment!.x, this.moment!.y, this.moment!.cutting);
  }

  /** Shows a layer's bitmap where the view wants it, and asks for a fresh one. */
  private blit(layer: Layer, view: View, alpha: number, upto = 0): void {
    this.raster.need(layer, view, upto);
    const drawn = this.raster.get(layer);
    if (!drawn) return;
    const zoom = view.scale / drawn.view.scale;
    const x = view.x - drawn.view.x * zoom, y = view.y - drawn.view.y * zoom;
    this.pen.globalAlpha = alpha;
    if (zoom === 1) this.pen.drawImage(drawn.bitmap, Math.round(x), Math.round(y));
    else this.pen.drawImage(drawn.bitmap, x, y, drawn.view.width * zoom, drawn.view.height * zoom);
    this.pen.globalAlpha = 1;
  }

  private drawGlow(view: View): void {
    const age = performance.now() - this.glowing;
    if (age > GLOW || !this.raster.get('glow')) return;
    this.blit('glow', view, 0.55 * (1 - age / GLOW) ** 2);
    this.invalidate();
  }

  /** What is cut so far in full, and the stop under way as far as it has come. */
  private drawPlayed(view: View): void {
    const { pen, palette, path, shapes, moment } = this;
    if (!path || !shapes || !moment) return;
    const drawn = this.raster.get('done')?.upto ?? -1;
    const fresh = drawn >= 0 && drawn <= moment.stop && moment.stop - drawn < LAG;
    const upto = fresh ? drawn : moment.stop;
    this.blit('done', view, 1, upto);
    const p = path.points;
    const stops = path.contours.length;
    const from = Math.max(0, fresh ? drawn : moment.stop - LAG);
    if (this.showAir) {
      pen.strokeStyle = palette.accent;
      pen.lineWidth = view.ratio;
      pen.beginPath();
      for (let k = from; k < moment.stop; k += 1) traceAir(pen, view, this.travel, k ? p[k * 4 - 2]! : this.travel.home[0], k ? p[k * 4 - 1]! : this.travel.home[1], p[k * 4]!, p[k * 4 + 1]!);
      if (moment.stop <= stops && !(moment.stop === stops && !this.travel.returnHome)) {
        const k = moment.stop;
        const to = moment.cutting ? [p[k * 4]!, p[k * 4 + 1]!] as const : [moment.x, moment.y] as const;
        traceAir(pen, view, { ...this.travel, perAxis: moment.cutting ? this.travel.perAxis : null }, k ? p[k * 4 - 2]! : this.travel.home[0], k ? p[k * 4 - 1]! : this.travel.home[1], to[0], to[1]);
      }
      pen.stroke();
    }
    pen.strokeStyle = palette.ink;
    pen.lineWidth = 1.6 * view.ratio;
    pen.beginPath();
    for (let k = from; k < moment.stop; k += 1) traceStop(pen, view, shapes, path, k);
    if (moment.cutting && moment.stop < stops) traceCut(pen, view, shapes, path, moment.stop, moment.cut);
    pen.stroke();
  }

  /** Place of a contour in the order shown. */
  private stopFor(contour: number): number | null {
    const { path } = this;
    if (!path || !this.shapes) return null;
    if (!this.stopOf) {
      this.stopOf = firstStops(path, this.shapes.count);
    }
    const stop = this.stopOf[contour] ?? -1;
    return stop < 0 ? null : stop;
  }
}

function rolesOf(contours: ContourInfo[], outline: number | null): Uint8Array {
  return Uint8Array.from(contours, (contour) => {
    if (contour.operation !== 'cut') return contour.operation === 'mark' ? Role.mark : Role.none;
    let inner = false;
    // The border of the sheet is no part: what lies in it is outside all parts. The bound keeps bad data from going round.
    let at = contour.inside;
    for (let steps = 0; at !== null && at !== outline && steps < 64; steps += 1) {
      inner = !inner;
      at = contours[at]?.inside ?? null;
    }
    return inner ? Role.inner : Role.outer;
  });
}
