// Outlines of parts, as closed polylines: vertices [x, y, bulge], mm, the bulge that of DXF (the tangent of a quarter of
// the arc's angle to the next vertex). Each has as many elements (lines and arcs) as vertices.

/** Bulge of a quarter of a circle. */
const QUARTER = 0.414214;

export const rectangle = (x, y, w, h) => [[x, y], [x + w, y], [x + w, y + h], [x, y + h]];

/** Two half circles. */
export const circle = (x, y, r) => [[x - r, y, 1], [x + r, y, 1]];

/** Two half circles joined by lines along the longer side of the box. */
export function slot(x, y, w, h) {
  const r = Math.min(w, h) / 2;
  if (w >= h) return [[x + r, y], [x + w - r, y, 1], [x + w - r, y + h], [x + r, y + h, 1]];
  return [[x, y + h - r], [x, y + r, 1], [x + w, y + r], [x + w, y + h - r, 1]];
}

/** Four lines and four quarter circles. */
export const rounded = (x, y, w, h, r) => [
  [x + r, y], [x + w - r, y, QUARTER], [x + w, y + r], [x + w, y + h - r, QUARTER],
  [x + w - r, y + h], [x + r, y + h, QUARTER], [x, y + h - r], [x, y + r, QUARTER],
];

/** Corners on an ellipse in the box. */
export function polygon(x, y, w, h, sides, turn = 0) {
  return Array.from({ length: sides }, (_, k) => {
    const angle = 2 * Math.PI * ((k + turn) / sides);
    return [x + (w / 2) * (1 + Math.cos(angle)), y + (h / 2) * (1 + Math.sin(angle))];
  });
}

/**
 * A rectangle with `elements` lines, at least 4: notches along its upper side (four lines each) and up to three bevelled
 * corners for the rest. Six lines: two corners are bevelled; 8: one notch.
 */
export function notched(x, y, w, h, elements) {
  const notches = Math.floor((elements - 4) / 4);
  const bevels = (elements - 4) % 4;
  const cut = Math.min(w, h) / 6;
  const corner = (k, at, before, after) => (k < bevels ? [before, after] : [at]);
  const points = [
    ...corner(0, [x, y], [x, y + cut], [x + cut, y]),
    ...corner(1, [x + w, y], [x + w - cut, y], [x + w, y + cut]),
    ...corner(2, [x + w, y + h], [x + w, y + h - cut], [x + w - cut, y + h]),
  ];
  const pitch = (w - 2 * cut) / Math.max(notches, 1);
  for (let k = 0; k < notches; k++) {
    const right = x + w - cut - (k + 0.3) * pitch;
    const left = right - 0.4 * pitch;
    points.push([right, y + h], [right, y + h - 2 * cut], [left, y + h - 2 * cut], [left, y + h]);
  }
  return [...points, [x, y + h]];
}

/** The same with straight sides along the box, so that neighbours are near along all of them. */
export function straight(x, y, w, h, elements, random) {
  return elements < 4 ? outline(x, y, w, h, elements, random) : notched(x, y, w, h, elements);
}

/** An outline of exactly that many elements, at least 2, in a box. */
export function outline(x, y, w, h, elements, random) {
  if (elements === 2) return circle(x + w / 2, y + h / 2, Math.min(w, h) / 2);
  if (elements === 3) return [[x, y], [x + w, y], [x + w * random.even(), y + h]];
  // A slot as wide as high would have lines of no length.
  if (elements === 4) return random.below(4) === 0 && Math.abs(w - h) > 2 ? slot(x, y, w, h) : rectangle(x, y, w, h);
  if (elements === 8 && random.below(2) === 0) return rounded(x, y, w, h, Math.min(w, h) / 6);
  if (elements <= 12 && random.below(3) === 0) return polygon(x, y, w, h, elements, random.even());
  return notched(x, y, w, h, elements);
}
