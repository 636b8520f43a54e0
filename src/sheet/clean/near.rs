//! Near copies: elements within the tolerance of each other on different carriers.
//!
//! Where two elements run side by side, an end of one lies on the other. So each end queries the box index for elements
//! that pass through it in the same direction, and only such pairs are intersected. The element of the pair with the
//! later rank loses the stretch they share. A stretch begins and ends at an end of one of the two. The legs of a sharp
//! corner are near each other too, but they diverge, so they are kept. A shape that runs close to itself is also kept,
//! because a sliver that tapers to a point is intended.

use super::cover::rest;
use super::remainder::Remainder;
use crate::geometry::{Aabb, BoxIndex, DVec2, Segment, intersect};
use crate::order;
use crate::sheet::element::Element;

/// Elements are copies within at most this fraction of their length, so an element as short as the tolerance is not a
/// copy of everything around it.
const TOLERANCE_PER_LENGTH: f64 = 0.125;
/// Sine of the largest angle between two elements that run side by side, at the end of one of them. Two lines within
/// the tolerance over eight tolerances of length differ by at most 1/8; arcs bend a little more.
const MAX_SINE: f64 = 0.25;
/// Largest number of boxes visited around one end. Even splines that run into one point need a few dozen. A hatch of
/// thousands of slanted lines needs thousands; a finding then reports that not all were checked.
const MAX_BOXES_PER_END: usize = 400;
/// Part of the tolerance that is added to it, so that what is drawn exactly as far apart as the tolerance is a copy, whatever its shape: rounding
/// to six decimals moves two elements 1.4e-6 mm towards or away from each other, which is less than a thousandth of 0.01 mm.
pub(in crate::sheet) const SLACK: f64 = 1e-3;
/// Number of pairs compared per piece on average, and for a small drawing in total. Real drawings have one or two per
/// piece; a star of 20,000 lines from one point would have millions.
const PAIRS_PER_PIECE: usize = 8;
const MIN_PAIRS: usize = 100_000;

/// Elements shorter than this many tolerances are not compared, because fits leave short elements at kinks, each close
/// to its neighbours. Exact copies of them lie on one carrier and are found there.
const MIN_LENGTH: f64 = 2.0;

/// A part of an element that still exists.
struct Piece {
    element: u32,
    from: f64,
    to: f64,
    segment: Segment,
    /// The remaining parts of the piece, as fractions of its length.
    left: Vec<(f64, f64)>,
}

/// Removes near copies from the remainders. Returns `false` when not every pair could be compared.
pub(super) fn unite(elements: &[Element], rank: &[u32], tolerance: f64, kept: &mut [Remainder]) -> bool {
    let tolerance = tolerance * (1.0 + SLACK);
    let mut pieces = pieces(elements, kept);
    pieces.retain(|p| p.segment.length() >= MIN_LENGTH * tolerance);
    order::sort_by(&mut pieces, |p| [rank[p.element as usize].into(), p.element.into(), 0]);
    let (pairs, complete) = pairs(elements, &pieces, tolerance);
    // Pieces are in order of rank: the first of a pair stays and the second loses, so the one that stays is final.
    for group in pairs.chunk_by(|a, b| a.1 == b.1) {
        let loser = group[0].1;
        let shared = group.iter().flat_map(|&(winner, _)| shared(&pieces[loser], &pieces[winner], tolerance));
        let mut shared: Vec<Shared> = shared.collect();
        if !shared.is_empty() {
            let is_copy = shared.iter().any(|s| s.is_copy);
            order::sort_by(&mut shared, |s| [order::real(s.from), 0, 0]);
            take(&mut pieces[loser], &shared, is_copy, tolerance, kept);
        }
    }
    complete
}

fn pieces(elements: &[Element], kept: &[Remainder]) -> Vec<Piece> {
    let mut out = Vec::with_capacity(elements.len());
    for ((element, e), kept) in (0_u32..).zip(elements).zip(kept) {
        let mut add = |from, to, segment| {
            out.push(Piece { element, from, to, segment, left: vec![(0.0, 1.0)] });
        };
        match kept {
            Remainder::Whole => add(0.0, 1.0, e.segment),
            Remainder::Pieces(p) => p.iter().for_each(|&(a, b)| add(a, b, e.segment.piece(a, b))),
            Remainder::Copy | Remainder::Covered => {}
        }
    }
    out
}

/// Pairs of pieces that leave an end of one of them side by side, as (the one that stays, the one that loses), sorted
/// by the latter. The flag says whether all boxes were visited.
fn pairs(elements: &[Element], pieces: &[Piece], tolerance: f64) -> (Vec<(usize, usize)>, bool) {
    let index = BoxIndex::new(pieces.iter().map(|p| p.segment.bounds().grown(tolerance)));
    let shape = |p: &Piece| elements[p.element as usize].shape;
    let mut pairs = Vec::new();
    let mut complete = true;
    // Each pair is found from both of its pieces, and from both ends of each.
    let most = 4 * (PAIRS_PER_PIECE * pieces.len()).max(MIN_PAIRS);
    for (i, piece) in pieces.iter().enumerate() {
        let s = &piece.segment;
        for (end, inward) in [(s.start(), s.tangent(0.0)), (s.end(), -s.tangent(1.0))] {
            let mut looked_at = 0;
            index.visit(Aabb::of(end), |j| {
                looked_at += 1;
                if shape(piece) != shape(&pieces[j])
                    && leaves_along(&pieces[j].segment, end, inward, tolerance)
                {
                    pairs.push((i.min(j), i.max(j)));
                }
                looked_at < MAX_BOXES_PER_END && pairs.len() < most
            });
            complete &= looked_at < MAX_BOXES_PER_END && pairs.len() < most;
        }
    }
    order::sort_by(&mut pairs, |&(winner, loser)| [loser as u64, winner as u64, 0]);
    pairs.dedup();
    (pairs, complete)
}

/// Whether the segment passes within the tolerance of `p` and continues in direction `inward` from there.
fn leaves_along(s: &Segment, p: DVec2, inward: DVec2, tolerance: f64) -> bool {
    // Cheap tests come first, because almost every candidate is a neighbour at a corner.
    let off = match s {
        Segment::Line(l) => {
            let d = l.end - l.start;
            d.perp_dot(p - l.start).abs() > tolerance * d.length()
                || d.perp_dot(inward).abs() > MAX_SINE * d.length()
        }
        Segment::Arc(a) => {
            let (v, r) = (p - a.center, a.radius());
            (v.length() - r).abs() > tolerance || v.dot(inward).abs() > MAX_SINE * v.length().max(r)
        }
    };
    if off {
        return false;
    }
    let (f, distance2) = s.nearest(p);
    let along = s.tangent(f).dot(inward);
    let circle = matches!(s, Segment::Arc(a) if a.is_circle());
    let ends_here = !circle && if along > 0.0 { f >= 1.0 } else { f <= 0.0 };
    distance2 <= tolerance * tolerance && !ends_here
}

/// A stretch of a piece that another piece covers, in mm along it.
struct Shared {
    from: f64,
    to: f64,
    /// Whether it covers both pieces completely.
    is_copy: bool,
}

/// The stretches of `loser` along the remaining parts of `winner`.
fn shared(loser: &Piece, winner: &Piece, tolerance: f64) -> Vec<Shared> {
    let (length, other) = (loser.segment.length(), winner.segment.length());
    let tolerance = tolerance.min(TOLERANCE_PER_LENGTH * length.min(other));
    let mut out = Vec::new();
    for o in intersect(&loser.segment, &winner.segment, tolerance).overlaps {
        let (low, high) = (o.b[0].min(o.b[1]), o.b[0].max(o.b[1]));
        for &(from, to) in &winner.left {
            let (from, to) = (from.max(low), to.min(high));
            if to <= from {
                continue;
            }
            let along = |g: f64| o.a[0] + (o.a[1] - o.a[0]) * (g - o.b[0]) / (o.b[1] - o.b[0]);
            let (a, b) = (along(from) * length, along(to) * length);
            let whole =
                (a - b).abs() >= length - 2.0 * tolerance && (to - from) * other >= other - 2.0 * tolerance;
            out.push(Shared { from: a.min(b), to: a.max(b), is_copy: whole });
        }
    }
    out
}

/// Removes the stretches from a piece, and from the remainder of its element.
fn take(piece: &mut Piece, shared: &[Shared], is_copy: bool, tolerance: f64, kept: &mut [Remainder]) {
    let length = piece.segment.length();
    let min_length = tolerance.min(0.25 * length);
    let left = rest(0.0, length, shared.iter().map(|s| (s.from, s.to)), min_length);
    if matches!(left[..], [(a, b)] if a <= 0.0 && b >= length) {
        return;
    }
    piece.left = left.iter().map(|(a, b)| (a / length, b / length)).collect();
    let kept = &mut kept[piece.element as usize];
    let whole = piece.to - piece.from;
    let of_element = piece.left.iter().map(|(a, b)| (piece.from + a * whole, piece.from + b * whole));
    let mut parts = match kept {
        Remainder::Pieces(p) => p.iter().copied().filter(|&(a, _)| a < piece.from || a >= piece.to).collect(),
        _ => Vec::new(),
    };
    parts.extend(of_element);
    order::sort_by(&mut parts, |p: &(f64, f64)| [order::real(p.0), 0, 0]);
    *kept = match parts[..] {
        [] if is_copy && piece.from <= 0.0 && piece.to >= 1.0 => Remainder::Copy,
        [] => Remainder::Covered,
        _ => Remainder::Pieces(parts),
    };
}
