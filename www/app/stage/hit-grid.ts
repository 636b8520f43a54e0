/**
 * Finds the contour under the pointer, by a uniform grid over the sheet. Each cell lists the elements whose boxes touch it, in two flat arrays
 * (starts, members).
 */

import { distance2, STRIDE, type Shapes } from './shapes.js';

/** Elements per cell on average: few enough to test quickly, many enough to keep the grid small. */
const PER_CELL = 4;
/** The largest number of cells, which bounds the memory for drawings of two million elements. */
const MOST_CELLS = 1 << 18;

export class HitGrid {
  private readonly starts: Uint32Array;
  private readonly members: Uint32Array;
  private readonly owner: Uint32Array;
  private readonly columns: number;
  private readonly rows: number;
  private readonly cell: number;

  constructor(private readonly shapes: Shapes, private readonly bounds: readonly [number, number, number, number]) {
    const [x0, y0, x1, y1] = bounds;
    const elements = shapes.lengths.length;
    const width = Math.max(x1 - x0, 1e-9), height = Math.max(y1 - y0, 1e-9);
    const cells = Math.min(MOST_CELLS, Math.max(1, elements / PER_CELL));
    this.cell = Math.max(Math.sqrt((width * height) / cells), Math.max(width, height) / 4096, 1e-9);
    this.columns = Math.floor(width / this.cell) + 1;
    this.rows = Math.floor(height / this.cell) + 1;
    this.owner = new Uint32Array(elements);
    for (let chain = 0; chain < shapes.count; chain += 1) this.owner.fill(chain, shapes.offsets[chain], shapes.offsets[chain + 1]);

    this.starts = new Uint32Array(this.columns * this.rows + 1);
    this.each((cell) => this.starts[cell + 1]!++);
    for (let i = 1; i < this.starts.length; i += 1) this.starts[i]! += this.starts[i - 1]!;
    this.members = new Uint32Array(this.starts[this.starts.length - 1]!);
    const next = this.starts.slice();
    this.each((cell, element) => {
      this.members[next[cell]!++] = element;
    });
  }

  /** The chain nearest to a point within `reach` mm, or null. */
  nearest(x: number, y: number, reach: number): number | null {
    let best = reach * reach;
    let found: number | null = null;
    const [c0, c1] = [this.column(x - reach), this.column(x + reach)];
    const [r0, r1] = [this.row(y - reach), this.row(y + reach)];
    for (let r = r0; r <= r1; r += 1) {
      for (let c = c0; c <= c1; c += 1) {
        const cell = r * this.columns + c;
        for (let i = this.starts[cell]!; i < this.starts[cell + 1]!; i += 1) {
          const d = distance2(this.shapes, this.members[i]!, x, y);
          if (d < best) {
            best = d;
            found = this.owner[this.members[i]!]!;
          }
        }
      }
    }
    return found;
  }

  private column(x: number): number {
    return Math.min(this.columns - 1, Math.max(0, Math.floor((x - this.bounds[0]) / this.cell)));
  }

  private row(y: number): number {
    return Math.min(this.rows - 1, Math.max(0, Math.floor((y - this.bounds[1]) / this.cell)));
  }

  /** Visits each cell that the box of an element touches. */
  private each(visit: (cell: number, element: number) => void): void {
    const s = this.shapes.segments;
    for (let e = 0; e < this.shapes.lengths.length; e += 1) {
      const i = e * STRIDE;
      const arc = s[i + 6] !== 0;
      const radius = this.shapes.arcs[e * 2]!;
      const x0 = arc ? s[i + 4]! - radius : Math.min(s[i]!, s[i + 2]!);
      const x1 = arc ? s[i + 4]! + radius : Math.max(s[i]!, s[i + 2]!);
      const y0 = arc ? s[i + 5]! - radius : Math.min(s[i + 1]!, s[i + 3]!);
      const y1 = arc ? s[i + 5]! + radius : Math.max(s[i + 1]!, s[i + 3]!);
      for (let r = this.row(y0); r <= this.row(y1); r += 1) {
        for (let c = this.column(x0); c <= this.column(x1); c += 1) visit(r * this.columns + c, e);
      }
    }
  }
}
