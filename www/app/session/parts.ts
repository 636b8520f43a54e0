/**
 * Parts, as people think of a drawing: an outer contour with its holes and what is marked on it. Parts of the same shape are copies of each
 * other, wherever they lie and however they are turned or mirrored.
 */

import type { Loaded } from 'kerfway';
import { inSlices, pause } from '../core/slices.js';
import { chainLength, onElement, prepare, type Place, type Shapes } from '../stage/shapes.js';

/** Lengths that differ by less than this, mm, are the same: readers round coordinates. */
const SAME = 0.02;

export interface Copies {
  /** The parts of this shape, by index. */
  readonly parts: readonly number[];
}

/** Parts whose shapes are found at once. */
const AT_ONCE = 2_000;

/** The shapes of parts: which each part has, and the parts of each. */
class Grouping {
  readonly of: number[] = [];
  readonly all: { parts: number[] }[] = [];
  private readonly known = new Map<string, number>();

  /** `signature`: what parts of the same shape have in common. */
  add(part: number, signature: string): void {
    const group = this.known.get(signature) ?? this.all.push({ parts: [] }) - 1;
    this.known.set(signature, group);
    this.all[group]!.parts.push(part);
    this.of[part] = group;
  }
}

/** What is known of the parts of a drawing. */
export class Parts {
  private readonly shapes: Shapes;
  /** The part of each contour; -1 for contours of none. */
  private readonly partOf: Int32Array;
  private groups: Grouping | null = null;
  private work: Promise<void> | null = null;

  constructor(private readonly loaded: Loaded) {
    this.shapes = prepare(loaded.geometry);
    this.partOf = new Int32Array(loaded.contours.length).fill(-1);
    loaded.parts.forEach((part, i) => {
      this.partOf[part.outer] = i;
      for (const hole of part.holes) this.partOf[hole] = i;
    });
  }

  /** The part of a contour, or null. */
  of(contour: number): number | null {
    const part = this.partOf[contour] ?? -1;
    return part < 0 ? null : part;
  }

  /** The contours of a part, the outer one first. */
  contours(part: number): number[] {
    const known = this.loaded.parts[part];
    return known ? [known.outer, ...known.holes] : [];
  }

  /** The whole parts of these contours, and those of them that belong to none. */
  whole(contours: readonly number[]): number[] {
    return [...new Set(contours.flatMap((c) => {
      const part = this.of(c);
      return part === null ? [c] : this.contours(part);
    }))];
  }

  /** The part whose area holds a point, the smallest if parts lie in holes of others; null if there is none. */
  at(x: number, y: number): number | null {
    let found: number | null = null;
    let least = Infinity;
    this.loaded.parts.forEach(({ outer, holes }, i) => {
      const area = this.loaded.contours[outer]?.area ?? 0;
      if (area >= least || !this.holds(outer, x, y) || holes.some((h) => this.loaded.contours[h]?.closed === true && this.holds(h, x, y))) return;
      [found, least] = [i, area];
    });
    return found;
  }

  /** The contours that lie wholly within a box, mm. */
  within(x0: number, y0: number, x1: number, y1: number): number[] {
    const { boxes } = this.shapes;
    return this.loaded.contours.filter(({ id }) => boxes[id * 4]! >= x0 && boxes[id * 4 + 1]! >= y0 && boxes[id * 4 + 2]! <= x1 && boxes[id * 4 + 3]! <= y1).map((c) => c.id);
  }

  /** The box around contours, mm. */
  boxOf(contours: readonly number[]): [number, number, number, number] {
    const box: [number, number, number, number] = [Infinity, Infinity, -Infinity, -Infinity];
    const { boxes } = this.shapes;
    for (const c of contours) {
      box[0] = Math.min(box[0], boxes[c * 4] ?? Infinity);
      box[1] = Math.min(box[1], boxes[c * 4 + 1] ?? Infinity);
      box[2] = Math.max(box[2], boxes[c * 4 + 2] ?? -Infinity);
      box[3] = Math.max(box[3], boxes[c * 4 + 3] ?? -Infinity);
    }
    return box;
  }

  /** The shapes of which there are several copies, the most frequent first. */
  repeated(): readonly Copies[] {
    return this.grouped().all.filter((g) => g.parts.length > 1).sort((a, b) => b.parts.length - a.parts.length);
  }

  /** How many different shapes the parts have. */
  get kinds(): number {
    return this.grouped().all.length;
  }

  /** The parts of the same shape as a part, itself included. */
  copies(part: number): readonly number[] {
    const { of, all } = this.grouped();
    return all[of[part] ?? -1]?.parts ?? [];
  }

  /**
   * All contours like these: the copies of whole parts if all of a part is among them, otherwise contours of the same layer, kind and size.
   */
  like(contours: readonly number[]): number[] {
    const chosen = new Set(contours);
    const wholes = new Set(contours.map((c) => this.of(c)).filter((p): p is number => p !== null && this.contours(p).every((c) => chosen.has(c))));
    const single = contours.filter((c) => !wholes.has(this.of(c) ?? -1));
    const keys = new Set(single.map((c) => this.key(c)));
    const alike = keys.size === 0 ? [] : this.loaded.contours.filter(({ id }) => keys.has(this.key(id))).map((c) => c.id);
    return [...new Set([...[...wholes].flatMap((p) => this.copies(p).flatMap((q) => this.contours(q))), ...alike])];
  }

  private key(contour: number): string {
    const info = this.loaded.contours[contour];
    if (!info) return '';
    return [info.layer, info.operation, info.closed, this.isInner(contour), rounded(info.length), rounded(Math.sqrt(info.area))].join(' ');
  }

  private isInner(contour: number): boolean {
    const part = this.of(contour);
    return part !== null && this.loaded.parts[part]?.outer !== contour;
  }

  /** Whether the shapes are known, or found in no time. */
  get isGrouped(): boolean {
    return this.groups !== null || this.loaded.parts.length <= AT_ONCE;
  }

  /** Finds the shapes little by little, so that the page does not wait for a drawing of 100,000 parts. */
  group(): Promise<void> {
    return (this.work ??= this.groupSlowly());
  }

  private async groupSlowly(): Promise<void> {
    await pause();
    const grouping = new Grouping();
    await inSlices(this.loaded.parts.length, (part) => grouping.add(part, this.signature(part)));
    this.groups ??= grouping;
  }

  private grouped(): Grouping {
    if (this.groups) return this.groups;
    const grouping = new Grouping();
    this.loaded.parts.forEach((_, part) => grouping.add(part, this.signature(part)));
    return (this.groups = grouping);
  }

  /**
   * What stays the same when a part is moved, turned or mirrored: the length and area of each contour, how far its elements and its holes lie from
   * the middle of the part.
   */
  private signature(part: number): string {
    const [outer = 0, ...holes] = this.contours(part);
    const middle = this.middle(outer);
    const size = (c: number) => {
      const info = this.loaded.contours[c];
      const at = this.middle(c);
      return [info?.layer, info?.operation, rounded(info?.length ?? 0), rounded(Math.sqrt(info?.area ?? 0)), rounded(Math.hypot(at.x - middle.x, at.y - middle.y))].join(' ');
    };
    return [size(outer), rounded(this.spread(outer, middle)), ...holes.map(size).sort()].join(';');
  }

  /** The mean of the points of a contour, weighted by length. */
  private middle(contour: number): { x: number; y: number } {
    let x = 0, y = 0, sum = 0;
    this.eachPoint(contour, (place, weight) => {
      x += place.x * weight;
      y += place.y * weight;
      sum += weight;
    });
    return sum > 0 ? { x: x / sum, y: y / sum } : { x: 0, y: 0 };
  }

  /** The root mean square distance of the points of a contour from a point. */
  private spread(contour: number, from: { x: number; y: number }): number {
    const length = chainLength(this.shapes, contour);
    let sum = 0;
    this.eachPoint(contour, (place, weight) => (sum += weight * ((place.x - from.x) ** 2 + (place.y - from.y) ** 2)));
    return length > 0 ? Math.sqrt(sum / length) : 0;
  }

  private eachPoint(contour: number, visit: (place: Place, weight: number) => void): void {
    const { offsets, lengths } = this.shapes;
    const place: Place = { x: 0, y: 0, dx: 0, dy: 0 };
    for (let e = offsets[contour]!; e < offsets[contour + 1]!; e += 1) {
      // Quarters, symmetric about the middle, so that the direction of an element does not matter.
      for (const part of [0.125, 0.375, 0.625, 0.875]) visit(onElement(this.shapes, e, part, place), lengths[e]! / 4);
    }
  }

  /** Whether a closed contour encloses a point: the crossings of a ray to the right are odd. Arcs are followed in short chords. */
  private holds(contour: number, x: number, y: number): boolean {
    const { boxes, offsets, segments } = this.shapes;
    if (x < boxes[contour * 4]! || x > boxes[contour * 4 + 2]! || y < boxes[contour * 4 + 1]! || y > boxes[contour * 4 + 3]!) return false;
    const place: Place = { x: 0, y: 0, dx: 0, dy: 0 };
    let inside = false;
    for (let e = offsets[contour]!; e < offsets[contour + 1]!; e += 1) {
      const chords = Math.max(1, Math.ceil(Math.abs(segments[e * 7 + 6]!) / CHORD));
      let [px, py] = [segments[e * 7]!, segments[e * 7 + 1]!];
      for (let k = 1; k <= chords; k += 1) {
        onElement(this.shapes, e, k / chords, place);
        if ((py > y) !== (place.y > y) && x < px + ((y - py) / (place.y - py)) * (place.x - px)) inside = !inside;
        [px, py] = [place.x, place.y];
      }
    }
    return inside;
  }
}

/** The angle of a chord, rad. */
const CHORD = 0.2;

const rounded = (mm: number) => Math.round(mm / SAME);

/** The parts of a drawing, found when they are first asked for. */
export function partsOf(loaded: Loaded): Parts {
  const known = KNOWN.get(loaded);
  if (known) return known;
  const parts = new Parts(loaded);
  KNOWN.set(loaded, parts);
  return parts;
}

const KNOWN = new WeakMap<Loaded, Parts>();
