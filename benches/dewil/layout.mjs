// Parts on a sheet. A drawing is filled in boxes, row by row, until exactly as many elements are drawn as asked for.

import { circle, outline, rounded, slot, straight } from './shapes.mjs';

/** A drawing under way. */
export class Sheet {
  constructor(elements, random) {
    this.random = random;
    this.contours = [];
    this.left = elements;
  }

  draw(contour) {
    this.contours.push(contour);
    this.left -= contour.length;
  }

  /** As many of the wanted elements as leave either none or enough for another contour. */
  elements(wanted) {
    if (this.left - wanted >= 2) return wanted;
    return this.left <= wanted || this.left - wanted === 1 ? this.left : wanted;
  }
}

/** Boxes in rows from the lower left, without end: of random widths, `gap` apart, rows up to `width` mm wide. */
export function* rows(width, gap, size) {
  let [x, y, high] = [10, 10, 0];
  for (;;) {
    const [w, h] = size();
    if (x > 10 && x - 10 + w > width) [x, y, high] = [10, y + high + gap(), 0];
    yield [x, y, w, h];
    x += w + gap();
    high = Math.max(high, h);
  }
}

/** Inner contours evenly spread in a box, every one of `kind(k)` elements: 2, 4 or 8. */
export function spread(sheet, [x, y, w, h], columns, lines, kind) {
  const [dx, dy] = [w / columns, h / lines];
  for (let k = 0; k < columns * lines && sheet.left >= 2; k++) {
    const [cx, cy] = [x + dx * ((k % columns) + 0.5), y + dy * (Math.floor(k / columns) + 0.5)];
    const r = Math.min(dx, dy) / 5;
    const elements = sheet.elements(kind(k));
    if (elements === 2) sheet.draw(circle(cx, cy, r));
    else if (elements === 4 && k % 2 === 0) sheet.draw(slot(cx - 2 * r, cy - r / 2, 4 * r, r));
    else if (elements === 8) sheet.draw(rounded(cx - r, cy - r, 2 * r, 2 * r, r / 3));
    else sheet.draw(outline(cx - r, cy - r, 2 * r, 2 * r, elements, sheet.random));
  }
}

/** Small parts far apart, now and then with a hole. */
export function apart(sheet, { width, side, gap, elements, holes }) {
  const { random } = sheet;
  const size = () => [random.between(...side), random.between(...side)];
  for (const [x, y, w, h] of rows(width, () => random.between(...gap), size)) {
    if (sheet.left === 0) return;
    const own = sheet.elements(random.between(...elements));
    sheet.draw(outline(x, y, w, h, own, random));
    if (random.even() < holes && sheet.left >= 2 && own >= 4) {
      sheet.draw(outline(x + w * 0.4, y + h * 0.35, w * 0.2, h * 0.2, sheet.elements(2 + 2 * random.below(2)), random));
    }
  }
}

/** Large parts with many inner contours evenly spread. */
export function perforated(sheet, { width, size, gap, columns, lines, kinds }) {
  const { random } = sheet;
  for (const [x, y, w, h] of rows(width, () => gap, () => size)) {
    if (sheet.left === 0) return;
    sheet.draw(sheet.left < 12 ? outline(x, y, w, h, sheet.left, random) : rounded(x, y, w, h, 20));
    spread(sheet, [x + 15, y + 15, w - 30, h - 30], columns, lines, (k) => kinds[k % kinds.length]);
  }
}

/** Large parts close together, some with a large hole: as high as each other in a row, so that all four sides are near. */
export function close(sheet, { width, side, gap, elements, holes = 0 }) {
  const { random } = sheet;
  let [filled, high] = [width, 0];
  const size = () => {
    const wide = random.between(...side);
    if (filled + wide > width) [filled, high] = [0, random.between(...side)];
    filled += wide + gap;
    return [wide, high];
  };
  for (const [x, y, w, h] of rows(width, () => gap, size)) {
    if (sheet.left === 0) return;
    sheet.draw(straight(x, y, w, h, sheet.elements(random.between(...elements)), random));
    if (random.even() < holes && sheet.left >= 4) {
      sheet.draw(straight(x + w * 0.3, y + h * 0.25, w * 0.4, h * 0.4, sheet.elements(random.between(...elements)), random));
    }
  }
}

