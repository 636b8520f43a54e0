//! Near copies: elements within the tolerance of each other that share no carrier.
//!
//! Where two elements run side by side, an end of one lies on the other. So each end asks the box index for elements
//! through it that leave it the same way, and only such pairs are intersected. Of a pair the one of lower rank loses
//! the stretch they share. A stretch begins and ends at an end of one of the two: legs of a sharp corner are near
//! each other, too, but drift apart, and are left alone. So is a shape that runs near itself: a sliver that tapers
//! to a point is a sliver.

use super::cover::rest;
use super::kept::Kept;
use crate::geometry::{Aabb, BoxIndex, DVec2, Segment, intersect};
use crate::order;
use crate::sheet::element::Element;

/// Elements are copies within an eighth of their length at most: what is as short as the tolerance is not a copy of
/// everything around it.
const OF_LENGTH: f64 = 0.125;
/// Sine of the largest angle between two elements that run side by side where one of them ends. Within the
/// tolerance over eight tolerances of length two lines turn by 1/8 at most; arcs bend a little more.
const PARALLEL: f64 = 0.25;
/// Boxes looked at around one end. Even splines that run into one point bring a few dozen; a hatch of thousands of
/// slanted lines brings thousands, and is told to be looked at in part.
const LOOKED_AT: usize = 400;
/// Pairs compared per piece on average, and for a small drawing in all: real drawings have one or two, a star of
/// 20,000 lines from one point would have millions.
const COMPARED: usize = 8;
const COMPARED_AT_LEAST: usize = 100_000;

/// Elements shorter than this many tolerances are left alone: fits leave crumbs at kinks, each near its neighbours.
/// Exact copies of them lie on one carrier and are found there.
const LONG_ENOUGH: f64 = 2.0;

/// A part of an element that is still there.
struct Piece {
    element: u32,
    from: f64,
    to: f64,
    segment: Segment,
    /// What is left of it, as fractions of the piece.
    left: Vec<(f64, f64)>,
}

/// Takes near copies out of what is kept. `false` when not every pair could be looked at.
pub(super) fn unite(elements: &[Element], rank: &[u32], tolerance: f64, kept: &mut [Kept]) -> bool {
    let mut pieces = pieces(elements, kept);
    pieces.retain(|p| p.segment.length() >= LONG_ENOUGH * tolerance);
    order::sort_by(&mut pieces, |p| [rank[p.element as usize].into(), p.element.into(), 0]);
    let (pairs, complete) = pairs(elements, &pieces, tolerance);
    // Pieces stand in order of rank: the first of a pair stays, the second loses; what stays is settled before.
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

fn pieces(elements: &[Element], kept: &[Kept]) -> Vec<Piece> {
    let mut out = Vec::with_capacity(elements.len());
    for ((element, e), kept) in (0_u32..).zip(elements).zip(kept) {
        let mut add = |from, to, segment| {
            out.push(Piece { element, from, to, segment, left: vec![(0.0, 1.0)] });
        };
        match kept {
            Kept::Whole => add(0.0, 1.0, e.segment),
            Kept::Pieces(p) => p.iter().for_each(|&(a, b)| add(a, b, e.segment.piece(a, b))),
            Kept::Copy | Kept::Covered => {}
        }
    }
    out
}

/// Pairs of pieces that leave an end of one of them side by side: (the one that stays, the one that loses), sorted
/// by the one that loses. And whether all were looked at.
fn pairs(elements: &[Element], pieces: &[Piece], tolerance: f64) -> (Vec<(usize, usize)>, bool) {
    let index = BoxIndex::new(pieces.iter().map(|p| p.segment.bounds().grown(tolerance)));
    let shape = |p: &Piece| elements[p.element as usize].shape;
    let mut pairs = Vec::new();
    let mut complete = true;
    // Each is found from both of its pieces, and from both ends of either.
    let most = 4 * (COMPARED * pieces.len()).max(COMPARED_AT_LEAST);
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
                looked_at < LOOKED_AT && pairs.len() < most
            });
            complete &= looked_at < LOOKED_AT && pairs.len() < most;
        }
    }
    order::sort_by(&mut pairs, |&(winner, loser)| [loser as u64, winner as u64, 0]);
    pairs.dedup();
    (pairs, complete)
}

/// Whether the segment passes within the tolerance of `p` and goes on along `inward` from there.
fn leaves_along(s: &Segment, p: DVec2, inward: DVec2, tolerance: f64) -> bool {
    // Cheap tests first: almost every candidate is a neighbour at a corner.
    let off = match s {
        Segment::Line(l) => {
            let d = l.end - l.start;
            d.perp_dot(p - l.start).abs() > tolerance * d.length()
                || d.perp_dot(inward).abs() > PARALLEL * d.length()
        }
        Segment::Arc(a) => {
            let (v, r) = (p - a.center, a.radius());
            (v.length() - r).abs() > tolerance || v.dot(inward).abs() > PARALLEL * v.length().max(r)
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

/// A stretch of a piece that another one covers, mm along it.
struct Shared {
    from: f64,
    to: f64,
    /// It is all of both.
    is_copy: bool,
}

/// The stretches of `loser` along what is left of `winner`.
fn shared(loser: &Piece, winner: &Piece, tolerance: f64) -> Vec<Shared> {
    let (length, other) = (loser.segment.length(), winner.segment.length());
    let tolerance = tolerance.min(OF_LENGTH * length.min(other));
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

/// Takes the stretches out of a piece, and out of what is kept of its element.
fn take(piece: &mut Piece, shared: &[Shared], is_copy: bool, tolerance: f64, kept: &mut [Kept]) {
    let length = piece.segment.length();
    let crumb = tolerance.min(0.25 * length);
    let left = rest(0.0, length, shared.iter().map(|s| (s.from, s.to)), crumb);
    if matches!(left[..], [(a, b)] if a <= 0.0 && b >= length) {
        return;
    }
    piece.left = left.iter().map(|(a, b)| (a / length, b / length)).collect();
    let kept = &mut kept[piece.element as usize];
    let whole = piece.to - piece.from;
    let of_element = piece.left.iter().map(|(a, b)| (piece.from + a * whole, piece.from + b * whole));
    let mut parts = match kept {
        Kept::Pieces(p) => p.iter().copied().filter(|&(a, _)| a < piece.from || a >= piece.to).collect(),
        _ => Vec::new(),
    };
    parts.extend(of_element);
    order::sort_by(&mut parts, |p: &(f64, f64)| [order::real(p.0), 0, 0]);
    *kept = match parts[..] {
        [] if is_copy && piece.from <= 0.0 && piece.to >= 1.0 => Kept::Copy,
        [] => Kept::Covered,
        _ => Kept::Pieces(parts),
    };
}
