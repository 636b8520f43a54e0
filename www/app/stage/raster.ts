/**
 * The page's side of the drawing worker. It requests bitmaps of the view, with a margin for panning, and keeps the last one of each layer until
 * a newer one arrives. Each layer has one request at a time. A slow redraw is replaced by a new request when the view has changed, but not
 * when only the path has.
 */

import { Emitter } from '../core/emitter.js';
import type { BestPath, Geometry } from 'kerfway';
import type { Palette } from './palette.js';
import { type Colors, LAYERS, type FromRaster, type Layer, type ToRaster, type Travel, type View } from './raster-messages.js';

/** The largest size of a bitmap, pixels. The margin shrinks on large or dense screens. */
const MOST_PIXELS = 6e6;
/** Margin around the screen, as a share of it: how far one can pan without waiting. */
const MARGIN = 0.3;
/** A redraw that has taken this many milliseconds may be replaced by one of a newer view. */
const PATIENCE = 120;

interface Slot {
  drawn: { bitmap: ImageBitmap; view: View; upto: number } | null;
  /** The current request. */
  asked: { serial: number; view: View; at: number } | null;
  /** The bitmap is out of date. */
  stale: boolean;
}

export class Raster extends Emitter<{ drawn: Layer }> {
  private readonly worker = new Worker(new URL('./raster-worker.ts', import.meta.url), { type: 'module' });
  private readonly slots: Record<Layer, Slot>;
  private serial = 0;
  /** Messages from a drawing on that is about to be sent. */
  private held: ToRaster[] | null = null;

  constructor() {
    super();
    this.slots = Object.fromEntries(LAYERS.map((l) => [l, { drawn: null, asked: null, stale: true }])) as unknown as Record<Layer, Slot>;
    this.worker.onmessage = (event: MessageEvent<FromRaster>) => this.receive(event.data);
  }

  /** Another drawing, so all bitmaps are dropped. `drawn`: the drawn outlines, where the contours are the lines of the beam beside them. */
  setGeometry(geometry: Geometry, roles: Uint8Array, ignored: Geometry, drawn: Geometry | null, layers: Uint8Array): void {
    // In a task of its own: copying a drawing of 100,000 contours takes as long as everything else that is done with it.
    if (this.held === null) setTimeout(() => this.release());
    this.held ??= [];
    this.send({ type: 'geometry', geometry, roles, ignored, drawn, layers });
    for (const slot of Object.values(this.slots)) {
      slot.drawn?.bitmap.close();
      slot.drawn = slot.asked = null;
      slot.stale = true;
    }
  }

  /** Stretches that are cut once for two parts. */
  setCommon(common: Geometry | null): void {
    this.send({ type: 'common', common });
    this.slots.sheet.stale = true;
  }

  setPath(path: BestPath | null, travel: Travel, changed: Uint8Array | null, colors: Colors): void {
    this.send({ type: 'path', path, travel, changed });
    for (const layer of LAYERS) if (layer !== 'sheet' || colors === 'order') this.slots[layer].stale = true;
    this.slots.glow.drawn?.bitmap.close();
    this.slots.glow.drawn = null;
  }

  setStyle(palette: Palette, colors: Colors, air: boolean): void {
    this.send({ type: 'style', palette, colors, air });
    for (const slot of Object.values(this.slots)) slot.stale = true;
  }

  /** The last bitmap of a layer, to be drawn where its view says. */
  get(layer: Layer): { bitmap: ImageBitmap; view: View; upto: number } | null {
    return this.slots[layer].drawn;
  }

  /** Whether bitmaps that were asked for are still being drawn. */
  get isDrawing(): boolean {
    return Object.values(this.slots).some((slot) => slot.asked !== null);
  }

  /** Makes sure that the layer is drawn for this view, now or when the current request is answered. */
  need(layer: Layer, screen: View, upto = 0): void {
    const slot = this.slots[layer];
    if (!slot.stale && slot.drawn && covers(slot.drawn.view, screen) && slot.drawn.upto === upto) return;
    if (slot.asked) {
      const late = performance.now() - slot.asked.at > PATIENCE;
      if (!late || covers(slot.asked.view, screen)) return;
    }
    const view = withMargin(screen);
    this.serial += 1;
    slot.asked = { serial: this.serial, view, at: performance.now() };
    slot.stale = false;
    this.send({ type: 'draw', layer, serial: this.serial, view, upto });
  }

  private receive(answer: FromRaster): void {
    const slot = this.slots[answer.layer];
    if (slot.asked?.serial !== answer.serial) {
      answer.bitmap.close();
      return;
    }
    slot.drawn?.bitmap.close();
    slot.drawn = { bitmap: answer.bitmap, view: answer.view, upto: answer.upto };
    slot.asked = null;
    this.emit('drawn', answer.layer);
  }

  private send(message: ToRaster): void {
    if (this.held !== null) this.held.push(message);
    else this.worker.postMessage(message);
  }

  private release(): void {
    const held = this.held ?? [];
    this.held = null;
    for (const message of held) this.send(message);
  }
}

/** Whether a bitmap of `view` covers the whole screen at the same scale. */
function covers(view: View, screen: View): boolean {
  if (Math.abs(view.scale / screen.scale - 1) > 1e-6 || view.ratio !== screen.ratio) return false;
  const left = screen.x - view.x, top = screen.y - view.y;
  return left <= 0.5 && top <= 0.5 && left + view.width >= screen.width - 0.5 && top + view.height >= screen.height - 0.5;
}

function withMargin(screen: View): View {
  const pixels = screen.width * screen.height;
  const share = Math.max(0, Math.min(MARGIN, (Math.sqrt(MOST_PIXELS / pixels) - 1) / 2));
  const dx = Math.round(screen.width * share), dy = Math.round(screen.height * share);
  return { ...screen, x: screen.x + dx, y: screen.y + dy, width: screen.width + 2 * dx, height: screen.height + 2 * dy };
}
