/**
 * An estimate of how many sheets some parts need: their boxes are packed on shelves, the highest first (first-fit decreasing
 * height), with the shelves along either side of the sheet and the boxes lying or standing; the fewest sheets count. A nesting
 * program that looks at the outlines needs fewer, so the number is an upper bound for it, not an offer. The same parts give the
 * same number everywhere, and a sheet of 3000 x 1500 mm that of one of 1500 x 3000 mm.
 */

/** The sheets in stock. Lengths in mm. */
export interface Stock {
  width: number;
  height: number;
  /** Least distance between parts. Default 5. */
  gap?: number;
  /** Width of the edge that stays free. Default 10. */
  margin?: number;
}

/** Some equal boxes. */
export interface Boxes {
  width: number;
  height: number;
  count: number;
}

/** How many sheets the boxes need. */
export interface SheetEstimate {
  /** Number of sheets. */
  count: number;
  /** Share of the area of these sheets that the boxes cover. */
  covered: number;
  /** Number of boxes that are larger than a sheet; they are not in `count`. */
  too_large: number;
  /** Says that this is no nest: a real one needs at most as many. */
  estimate: true;
  /** What was assumed. */
  stock: Required<Stock>;
}

export const GAP = 5;
export const MARGIN = 10;

interface Shelf {
  height: number;
  /** Width that is left. */
  left: number;
}

/** Slack for sums of lengths, mm. */
const ROUNDING = 1e-9;

/** The room on a sheet. Each box carries a gap at its right and top; the last one on a shelf does not need it. */
interface Room {
  width: number;
  height: number;
  gap: number;
}

/** Packs boxes on sheets. */
export function sheetsFor(boxes: readonly Boxes[], stock: Stock): SheetEstimate {
  const { width, height, gap = GAP, margin = MARGIN } = stock;
  const room: Room = { width: width - 2 * margin + gap, height: height - 2 * margin + gap, gap };
  const sides = boxes.map(({ width: a, height: b, count }) => ({ width: exact(Math.max(a, b)), height: exact(Math.min(a, b)), count, area: a * b * count }));
  const takes = (box: Boxes) => fits(box, room) || fits(turned(box), room);
  const fitting = sides.filter(takes);
  const kinds = merged(fitting);
  const packings = [room, turned(room)].flatMap((way) => [true, false].map((lying) => packed(kinds, way, lying)));
  const count = Math.min(...packings);
  const covered = count === 0 ? 0 : fitting.reduce((sum, { area }) => sum + area, 0) / (count * width * height);
  const tooLarge = sides.reduce((sum, box) => sum + (takes(box) ? 0 : box.count), 0);
  return { count, covered, too_large: tooLarge, estimate: true, stock: { width, height, gap, margin } };
}

const fits = (box: Pick<Boxes, 'width' | 'height'>, { width, height, gap }: Room) => box.width + gap <= width + ROUNDING && box.height + gap <= height + ROUNDING;
const turned = <T extends { width: number; height: number }>(box: T): T => ({ ...box, width: box.height, height: box.width });

/** The number of sheets when the shelves run along the width. `lying`: whether boxes lie where they fit either way, instead of standing. */
function packed(boxes: readonly Boxes[], room: Room, lying: boolean): number {
  const { gap } = room;
  const laid = boxes.map((box) => {
    const [wanted, other] = lying ? [box, turned(box)] : [turned(box), box];
    return fits(wanted, room) ? wanted : other;
  });
  laid.sort(highestFirst);
  const narrowest = laid.reduce((least, { width }) => Math.min(least, width), Infinity) + gap;
  const shelves: Shelf[] = [];
  /** Height that is left on each sheet. */
  const sheets: number[] = [];
  for (const box of laid) {
    let left = box.count;
    const [w, h] = [box.width + gap, box.height + gap];
    const put = (shelf: Shelf) => {
      const n = Math.min(left, Math.floor((shelf.left + ROUNDING) / w));
      shelf.left -= n * w;
      left -= n;
    };
    for (const shelf of shelves) {
      if (left === 0) break;
      put(shelf);
    }
    // Shelves are opened in order of falling height, so the first sheet with room is looked for once for each kind of box.
    for (let sheet = 0; left > 0; ) {
      const free = sheets[sheet];
      if (free !== undefined && free + ROUNDING < h) {
        sheet += 1;
        continue;
      }
      if (free === undefined) sheets.push(room.height);
      sheets[sheet] = (sheets[sheet] ?? 0) - h;
      const shelf = { height: h, left: room.width };
      put(shelf);
      // Full shelves are forgotten: large orders fill millions.
      if (shelf.left + ROUNDING >= narrowest) shelves.push(shelf);
    }
  }
  return sheets.length;
}

/** A length without the last digits, in which the same part differs from place to place. */
const exact = (length: number) => Math.round(length * 1e6) / 1e6;

const highestFirst = (a: Boxes, b: Boxes) => b.height - a.height || b.width - a.width;

/** Boxes with equal ones together: shelves are looked through once for each kind of box. */
function merged(boxes: readonly Boxes[]): Boxes[] {
  const kinds: Boxes[] = [];
  for (const { width, height, count } of [...boxes].sort(highestFirst)) {
    const last = kinds.at(-1);
    if (last?.width === width && last.height === height) last.count += count;
    else kinds.push({ width, height, count });
  }
  return kinds;
}
