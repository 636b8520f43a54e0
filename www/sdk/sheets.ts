/**
 * An estimate of how many sheets some parts need: their boxes are packed on shelves, the highest first (first-fit decreasing
 * height). A nesting program that looks at the outlines needs fewer, so the number is an upper bound for it, not an offer. The
 * same parts give the same number everywhere.
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

/** Packs boxes on sheets. */
export function sheetsFor(boxes: readonly Boxes[], stock: Stock): SheetEstimate {
  const { width, height, gap = GAP, margin = MARGIN } = stock;
  // Each box carries a gap at its right and top; the last one on a shelf does not need it.
  const room = { width: width - 2 * margin + gap, height: height - 2 * margin + gap };
  const fits = (w: number, h: number) => w + gap <= room.width + ROUNDING && h + gap <= room.height + ROUNDING;
  let tooLarge = 0;
  let area = 0;
  const laid = boxes.flatMap(({ width: a, height: b, count }) => {
    const [long, short] = [exact(Math.max(a, b)), exact(Math.min(a, b))];
    const lying = fits(long, short);
    if (!lying && !fits(short, long)) {
      tooLarge += count;
      return [];
    }
    area += a * b * count;
    return [lying ? { width: long, height: short, count } : { width: short, height: long, count }];
  });
  laid.sort((a, b) => b.height - a.height || b.width - a.width);
  const kinds = merged(laid);
  const shelves: Shelf[] = [];
  /** Height that is left on each sheet. */
  const sheets: number[] = [];
  for (const box of kinds) {
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
      shelves.push(shelf);
    }
  }
  const count = sheets.length;
  const covered = count === 0 ? 0 : area / (count * width * height);
  return { count, covered, too_large: tooLarge, estimate: true, stock: { width, height, gap, margin } };
}

/** A length without the last digits, in which the same part differs from place to place. */
const exact = (length: number) => Math.round(length * 1e6) / 1e6;

/** Sorted boxes with equal ones together: shelves are looked through once for each kind of box. */
function merged(sorted: readonly Boxes[]): Boxes[] {
  const kinds: Boxes[] = [];
  for (const box of sorted) {
    const last = kinds.at(-1);
    if (last?.width === box.width && last.height === box.height) last.count += box.count;
    else kinds.push({ ...box });
  }
  return kinds;
}
