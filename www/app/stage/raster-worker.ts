/**
 * Draws the sheet and the path into bitmaps in a worker, so that panning and zooming stay smooth however long a redraw takes. A request is
 * dropped half way when a newer one for the same layer has arrived; `raster.ts` decides when to send one.
 */

import { paintGlow } from './paint/air.js';
import { paintDone } from './paint/done.js';
import { paintPath } from './paint/path.js';
import { paintSheet } from './paint/sheet.js';
import type { Subject } from './paint/strokes.js';
import { prepare } from './shapes.js';
import { LAYERS, type FromRaster, type Layer, type ToRaster } from './raster-messages.js';

type Draw = Extract<ToRaster, { type: 'draw' }>;

/** Milliseconds of drawing before the worker looks for newer requests. */
const SLICE = 12;

const subject: Partial<Subject> = {};
const waiting = new Map<Layer, Draw>();
let working = false;
let epoch = 0;

const nextTask = (() => {
  const channel = new MessageChannel();
  let wake = () => {};
  channel.port1.onmessage = () => wake();
  return () => new Promise<void>((resolve) => {
    wake = resolve;
    channel.port2.postMessage(null);
  });
})();

onmessage = (event: MessageEvent<ToRaster>) => {
  const message = event.data;
  switch (message.type) {
    case 'geometry':
      subject.shapes = prepare(message.geometry);
      subject.ignored = prepare(message.ignored);
      subject.drawn = message.drawn && prepare(message.drawn);
      subject.roles = message.roles;
      subject.layers = message.layers;
      subject.path = subject.common = null;
      epoch += 1;
      break;
    case 'common':
      subject.common = message.common && prepare(message.common);
      break;
    case 'path':
      subject.path = message.path;
      subject.travel = message.travel;
      subject.changed = message.changed;
      break;
    case 'style':
      subject.palette = message.palette;
      subject.colors = message.colors;
      subject.air = message.air;
      break;
    case 'draw':
      waiting.set(message.layer, message);
      if (!working) void work();
  }
};

async function work(): Promise<void> {
  working = true;
  for (let request = next(); request; request = next()) await draw(request);
  working = false;
}

function next(): Draw | undefined {
  const layer = LAYERS.find((l) => waiting.has(l));
  const request = layer && waiting.get(layer);
  if (layer) waiting.delete(layer);
  return request;
}

async function draw(request: Draw): Promise<void> {
  const { layer, view, upto, serial } = request;
  if (!subject.shapes || !subject.palette) return;
  const canvas = new OffscreenCanvas(view.width, view.height);
  const pen = canvas.getContext('2d');
  if (!pen) return;
  const began = epoch;
  // The painter gets a copy, because a path that arrives meanwhile belongs to the next redraw.
  const painting = painter(layer, pen, request, { ...subject } as Subject);
  let slice = performance.now();
  while (!painting.next().done) {
    if (performance.now() - slice < SLICE) continue;
    await nextTask();
    slice = performance.now();
    if (waiting.has(layer) || epoch !== began) return;
  }
  const bitmap = canvas.transferToImageBitmap();
  const answer: FromRaster = { type: 'drawn', layer, serial, view, upto, bitmap };
  postMessage(answer, { transfer: [bitmap] });
}

function painter(layer: Layer, pen: OffscreenCanvasRenderingContext2D, request: Draw, whole: Subject): Generator<void> {
  switch (layer) {
    case 'sheet': return paintSheet(pen, request.view, whole);
    case 'path': return paintPath(pen, request.view, whole);
    case 'done': return paintDone(pen, request.view, whole, request.upto);
    case 'glow': return paintGlow(pen, request.view, whole);
  }
}
