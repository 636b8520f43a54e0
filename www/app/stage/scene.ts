/**
 * The stage: composes each frame of the bitmaps from the drawing worker and the few things that change with every frame. A frame is drawn only
 * when something has changed. Bitmaps of an older view are shown scaled and shifted until new ones arrive, so panning and zooming never wait.
 */

import { lessMotion } from '../core/dom.js';
import type { Beam, BestPath, Finding, Geometry, Insight, Loaded } from 'kerfway';
import { changedStops } from './changes.js';
import { HitGrid } from './hit-grid.js';
import { drawChanges, drawFindings } from './markers.js';
import { drawMeasured, type Measured } from './measure.js';
import * as overlay from './overlay.js';
import { readPalette, type Palette } from './palette.js';
import { Raster } from './raster.js';
import { type Colors, type Layer, type Travel, type View } from './raster-messages.js';
import { drawPlayed, LAG } from './played.js';
import { layerColors } from './layer-colors.js';
import { rolesOf } from './roles.js';
import { chainLength, firstStops, prepare, type Shapes } from './shapes.js';
import type { Moment } from '../playback/timeline.js';
import type { Box } from '../session/extent.js';
import type { ChangeMark } from '../session/comparison.js';
import type { Viewport } from './viewport.js';
import { words } from '../core/words/index.js';

/** Milliseconds between two paths: ten per second look continuous, and more would take time from the planner. */
const PATH_PAUSE = 100;
/** Milliseconds for which an improvement glows. */
const GLOW = 900;
/** Most device pixels per CSS pixel: beyond two nobody sees the difference, and memory grows with the square. */
const MOST_RATIO = 2;

/** Text on the sheet grows with very wide windows, whose pixels are small. */
const textScale = () => Math.min(2, Math.max(1, innerWidth / 1920));

const NOWHERE: Travel = { home: [0, 0], returnHome: false, perAxis: null };

/** What is emphasised or marked on the sheet. */
export interface Highlights {
  /** The contour under the pointer. */
  hovered: number | null;
  /** The contour that was selected last. */
  selected: number | null;
  /** What else is selected. */
  others: readonly number[];
  /** The box that is being drawn to select what is in it, CSS pixels. */
  box: readonly [number, number, number, number] | null;
  measured: Measured;
  finding: Finding | null;
  /** What another reading of the drawing would change, during a preview. */
  marks: readonly ChangeMark[];
  /** Where the head is; null when nothing is played and everything is shown. */
  moment: Moment | null;
  /** The partitions of a method that makes them. */
  partitions: Insight['partitions'];
}

const NO_HIGHLIGHTS: Highlights = { hovered: null, selected: null, others: [], box: null, measured: null, finding: null, marks: [], moment: null, partitions: null };

export class Scene {
  private readonly raster = new Raster();
  private geometry: { shapes: Shapes; lengths: Float64Array } | null = null;
  private highlights = NO_HIGHLIGHTS;
  private travel: Travel = NOWHERE;
  private colors: Colors = 'plain';
  private showAir = true;
  private loaded: Loaded | null = null;
  /** The lines that the beam follows, where they are not the drawn ones. */
  private beam: Beam | null = null;
  /** Stretches that are cut once for two parts. */
  private common: Geometry | null = null;
  /** The findings of the plan; those about the drawing are in `loaded`. */
  private planFindings: readonly Finding[] = [];
  private extent: Box = [0, 0, 1, 1];
  /** The bed of the machine as seen from the drawing, and whether the job lies on it. */
  private bed: { box: Box; fits: boolean } | null = null;
  /** The second sheet of a comparison, which lies on the same bed. */
  private second: Scene | null = null;
  /** It is built when the pointer first moves over the sheet. */
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

  /** The contours of the path, prepared for drawing; null where there is no drawing. */
  get shapes(): Shapes | null {
    return this.geometry?.shapes ?? null;
  }

  /** Length of each contour, mm. */
  get lengths(): Float64Array {
    return this.geometry?.lengths ?? new Float64Array(0);
  }

  get selected(): number | null {
    return this.highlights.selected;
  }

  get box(): Highlights['box'] {
    return this.highlights.box;
  }

  get hovered(): number | null {
    return this.highlights.hovered;
  }

  /** Changes what is emphasised or marked. */
  highlight(changes: Partial<Highlights>): void {
    this.highlights = { ...this.highlights, ...changes };
    this.invalidate();
  }

  setTheme(theme: 'light' | 'dark'): void {
    this.theme = theme;
    this.restyle();
  }

  setView(options: { colors?: Colors; air?: boolean }): void {
    this.colors = options.colors ?? this.colors;
    this.showAir = options.air ?? this.showAir;
    this.restyle();
  }

  /** Another drawing, or the same one read with other options. The view stays where it is unless `fit`. */
  setDrawing(loaded: Loaded | null, extent: Box, fit: boolean): void {
    this.loaded = loaded;
    this.extent = extent;
    this.path = this.held = this.stopOf = null;
    this.highlights = NO_HIGHLIGHTS;
    this.beam = this.common = null;
    this.planFindings = [];
    this.showContours();
    if (loaded) this.viewport.setBounds(extent, fit);
    this.invalidate();
  }

  /** What the plan has prepared: the lines of the beam (null where it follows the drawn ones), what is cut once for two parts, findings. */
  setPrepared({ beam, common, planFindings }: { beam: Beam | null; common: Geometry | null; planFindings: readonly Finding[] }): void {
    if (beam === this.beam && common === this.common && planFindings === this.planFindings) return;
    const otherLines = beam !== this.beam;
    Object.assign(this, { beam, common, planFindings });
    if (otherLines) {
      this.path = this.held = this.stopOf = null;
      const { selected } = this;
      const contours = (beam ?? this.loaded)?.contours.length ?? 0;
      this.highlight({ hovered: null, selected: selected !== null && selected < contours ? selected : null, others: this.highlights.others.filter((c) => c < contours) });
      this.showContours();
    }
    this.raster.setCommon(common);
    this.invalidate();
  }

  private showContours(): void {
    const { loaded, beam } = this;
    this.geometry = this.grid = null;
    this.highlight({ partitions: null });
    if (!loaded) return;
    const { geometry, contours } = beam ?? loaded;
    const shapes = prepare(geometry);
    const lengths = new Float64Array(shapes.count);
    for (let c = 0; c < shapes.count; c += 1) lengths[c] = chainLength(shapes, c);
    this.geometry = { shapes, lengths };
    this.raster.setGeometry(geometry, rolesOf(contours, loaded.outline), loaded.ignored.geometry, beam && loaded.geometry, layerColors(contours, loaded.layers));
  }

  /** The bed of the machine as seen from the drawing, if it is known; `fits`: the job lies on it. */
  setBed(box: Box | null, fits: boolean): void {
    this.bed = box && { box, fits };
    this.second?.setBed(box, fits);
    this.invalidate();
  }

  /** Another scene shows this bed as well from now on. */
  shareBed(second: Scene): void {
    this.second = second;
    second.setBed(this.bed?.box ?? null, this.bed?.fits ?? true);
  }

  /** The best path. The stage shows at most ten paths per second. */
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
    this.raster.setPath(path, this.travel, changed, this.colors);
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
    return this.loaded?.findings.find(hit) ?? this.planFindings.find(hit) ?? null;
  }

  /** The box of a contour, mm. */
  boxOf(contour: number): [number, number, number, number] | null {
    const b = this.shapes?.boxes;
    if (!b || contour * 4 + 3 >= b.length) return null;
    return [b[contour * 4]!, b[contour * 4 + 1]!, b[contour * 4 + 2]!, b[contour * 4 + 3]!];
  }

  private invalidate(): void {
    if (this.frame) return;
    this.frame = requestAnimationFrame(() => this.draw());
    if (this.canvas.ariaBusy !== 'true') this.canvas.ariaBusy = 'true';
  }

  private restyle(): void {
    this.palette = readPalette(this.theme);
    this.raster.setStyle(this.palette, this.colors, this.showAir);
    this.invalidate();
  }

  private view(): View {
    const { viewport: v } = this;
    const ratio = Math.min(MOST_RATIO, devicePixelRatio || 1);
    return { scale: v.scale * ratio, x: v.x * ratio, y: v.y * ratio, width: Math.round(v.width * ratio), height: Math.round(v.height * ratio), ratio, text: ratio * textScale() };
  }

  private draw(): void {
    this.frame = 0;
    this.drawFrame();
    // Assistive technology, and tests, know when the picture is finished.
    const busy = String(this.frame !== 0 || this.held !== this.path || this.raster.isDrawing);
    if (this.canvas.ariaBusy !== busy) this.canvas.ariaBusy = busy;
  }

  private drawFrame(): void {
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
    const { loaded, shapes, path } = this;
    const { hovered, selected, others, box, measured, finding, marks, moment, partitions } = this.highlights;
    if (!loaded || !shapes) return;
    overlay.drawSheet(pen, view, palette, this.extent);
    if (this.bed) overlay.drawBed(pen, view, palette, this.bed.box, this.bed.fits);
    overlay.drawSizes(pen, view, palette, this.extent);
    const playing = moment !== null && path !== null;
    this.blit('sheet', view, playing ? 0.25 : 1);
    if (playing) this.drawPlayed(view, shapes, path, moment);
    else if (path) {
      if (partitions?.parents.length) overlay.drawPartitions(pen, view, palette, shapes, partitions);
      this.blit('path', view, 1);
      this.drawGlow(view);
      overlay.drawCutMarks(pen, view, palette, path);
    }
    if (hovered !== null && hovered !== selected) overlay.drawEmphasis(pen, view, palette, shapes, hovered, false);
    if (others.length > 0) overlay.drawSelection(pen, view, palette, shapes, others);
    if (selected !== null) {
      overlay.drawEmphasis(pen, view, palette, shapes, selected, true);
      const stop = this.stopFor(selected);
      if (path && stop !== null) overlay.drawTravel(pen, view, palette, path, this.travel, stop);
    }
    drawFindings(pen, view, palette, [...loaded.findings, ...this.planFindings], finding);
    drawChanges(pen, view, palette, marks);
    if (path && !playing) overlay.drawStart(pen, view, palette, this.travel);
    if (measured) drawMeasured(pen, view, palette, measured);
    if (box) overlay.drawBox(pen, view.ratio, palette, box);
    if (playing) overlay.drawHead(pen, view, palette, moment);
  }

  /** Draws the bitmap of a layer where the view has it, and requests a new one if it is out of date. */
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

  /** Draws what the bitmap of the layer `done` holds, and the rest on top of it. */
  private drawPlayed(view: View, shapes: Shapes, path: BestPath, moment: Moment): void {
    const drawn = this.raster.get('done')?.upto ?? -1;
    const usable = drawn >= 0 && drawn <= moment.stop && moment.stop - drawn < LAG;
    this.blit('done', view, 1, usable ? drawn : moment.stop);
    drawPlayed(this.pen, view, this.palette, { shapes, path, travel: this.travel, air: this.showAir }, moment, usable ? drawn : moment.stop - LAG);
  }

  /** The place of a contour in the current order. */
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
