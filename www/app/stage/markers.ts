/** Markers on the sheet that keep their size on screen: findings, and what another reading of the drawing would change. */

import type { Finding } from 'kerfway';
import type { ChangeMark } from '../session/comparison.js';
import type { Palette } from './palette.js';
import type { View } from './raster-messages.js';

type Pen = CanvasRenderingContext2D;

/** Markers that are closer to each other than this many CSS pixels are drawn as one. */
const CROWD = 14;

/** Findings: triangles for warnings, octagons for errors, so that they differ without colour. */
export function drawFindings(pen: Pen, view: View, palette: Palette, findings: readonly Finding[], chosen: Finding | null): void {
  const r = view.ratio;
  const taken = new Set<number>();
  for (const finding of findings) {
    if (!finding.at || (finding.severity === 'info' && finding !== chosen)) continue;
    const x = view.x + finding.at[0] * view.scale, y = view.y - finding.at[1] * view.scale;
    if (x < -20 || y < -20 || x > view.width + 20 || y > view.height + 20) continue;
    const cell = Math.floor(x / (CROWD * r)) * 65536 + Math.floor(y / (CROWD * r));
    if (taken.has(cell) && finding !== chosen) continue;
    taken.add(cell);
    drawMarker(pen, x, y, finding.severity === 'error', finding.severity === 'error' ? palette.red : palette.amber, palette.sheet, r);
    if (finding === chosen) {
      pen.strokeStyle = finding.severity === 'error' ? palette.red : palette.amber;
      pen.lineWidth = 2 * r;
      pen.beginPath();
      pen.arc(x, y, 15 * r, 0, 2 * Math.PI);
      pen.stroke();
    }
  }
}

function drawMarker(pen: Pen, x: number, y: number, error: boolean, color: string, ground: string, r: number): void {
  pen.beginPath();
  const corners = error ? 8 : 3;
  const size = (error ? 7.5 : 8.5) * r;
  const turn = error ? Math.PI / 8 : -Math.PI / 2;
  for (let i = 0; i < corners; i += 1) {
    const a = turn + (i * 2 * Math.PI) / corners;
    pen.lineTo(x + size * Math.cos(a), y + size * Math.sin(a));
  }
  pen.closePath();
  pen.fillStyle = color;
  pen.strokeStyle = ground;
  pen.lineWidth = 1.5 * r;
  pen.stroke();
  pen.fill();
  pen.fillStyle = ground;
  pen.fillRect(x - 0.8 * r, y - 3.4 * r, 1.6 * r, 4 * r);
  pen.fillRect(x - 0.8 * r, y + 1.8 * r, 1.6 * r, 1.6 * r);
}

/** What another reading would change: rings where ends would join, two bars where they would come apart, crosses where something would disappear. */
export function drawChanges(pen: Pen, view: View, palette: Palette, marks: readonly ChangeMark[]): void {
  const r = view.ratio;
  const taken = new Set<number>();
  pen.lineCap = 'round';
  for (const { kind, x: mx, y: my } of marks) {
    const x = view.x + mx * view.scale, y = view.y - my * view.scale;
    if (x < -20 || y < -20 || x > view.width + 20 || y > view.height + 20) continue;
    const cell = Math.floor(x / (CROWD * r)) * 65536 + Math.floor(y / (CROWD * r));
    if (taken.has(cell)) continue;
    taken.add(cell);
    pen.beginPath();
    const line = (x0: number, y0: number, x1: number, y1: number) => {
      pen.moveTo(x + x0 * r, y + y0 * r);
      pen.lineTo(x + x1 * r, y + y1 * r);
    };
    if (kind === 'joins') pen.arc(x, y, 8 * r, 0, 2 * Math.PI);
    else if (kind === 'opens') {
      line(-4, -8, -4, 8);
      line(4, -8, 4, 8);
    } else {
      line(-6, -6, 6, 6);
      line(-6, 6, 6, -6);
    }
    pen.strokeStyle = palette.sheet;
    pen.lineWidth = 6 * r;
    pen.stroke();
    pen.strokeStyle = kind === 'joins' ? palette.accent : palette.amber;
    pen.lineWidth = 2.5 * r;
    pen.stroke();
  }
}
