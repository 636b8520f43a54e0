// An instance of the benchmark as a DXF drawing, and a plan's geometry as contours of an instance.

import { drawing, polyline } from '../benches/common/dxf.mjs';

/** The text of a DXF drawing, one closed or open polyline for each contour. */
export function asDxf({ contours }) {
  return drawing(contours.flatMap(({ start, closed, path }) => polyline(vertices(start, closed, path), closed)));
}

function vertices(start, closed, path) {
  const all = [];
  let at = start;
  for (const piece of path) {
    if (piece.line) all.push([...at, 0]);
    else for (const [from, bulge] of bulges(at, piece)) all.push([...from, bulge]);
    at = piece.line ?? piece.arc;
  }
  if (!closed) all.push([...at, 0]);
  return all;
}

/** An arc in halves, which have a bulge also where the whole is a full turn: the point where each begins, and its bulge. */
function bulges(from, { arc: to, center: [x, y], ccw }) {
  const angle = (p) => Math.atan2(p[1] - y, p[0] - x);
  const turn = 2 * Math.PI;
  const sweep = (((angle(to) - angle(from)) * (ccw ? 1 : -1)) % turn + turn) % turn || turn;
  const [radius, middle] = [Math.hypot(from[0] - x, from[1] - y), angle(from) + ((ccw ? 1 : -1) * sweep) / 2];
  const bulge = (ccw ? 1 : -1) * Math.tan(sweep / 8);
  return [[from, bulge], [[x + radius * Math.cos(middle), y + radius * Math.sin(middle)], bulge]];
}

/** The contours of a drawing, from a plan for it in which each is cut in one go. */
export function contoursOf(plan) {
  const cut = new Map();
  let here = plan.machine.home;
  for (const move of plan.moves) {
    if (move.kind === 'air') here = move.to;
    if (move.kind !== 'cut') continue;
    cut.set(move.contour, { start: here.map(rounded), path: move.path.map(roundedPiece) });
    const last = move.path.at(-1);
    here = last.line ?? last.arc;
  }
  const kept = plan.contours.filter((c) => cut.has(c.id));
  const index = new Map(kept.map((c, k) => [c.id, k]));
  return kept.map((c) => ({ closed: c.closed, inside: index.get(c.inside) ?? null, ...cut.get(c.id) }));
}

/** A closed polygon as a contour. */
export function polygon(corners, inside = null) {
  return { closed: true, inside, start: corners[0], path: [...corners.slice(1), corners[0]].map((line) => ({ line })) };
}

/** mm, to a millionth. */
function rounded(value) {
  return Number(value.toFixed(6));
}

function roundedPiece(piece) {
  if (piece.line) return { line: piece.line.map(rounded) };
  return { arc: piece.arc.map(rounded), center: piece.center.map(rounded), ccw: piece.ccw };
}
