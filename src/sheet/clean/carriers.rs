//! Overlaps on one carrier: lines on one straight line, arcs on one circle.
//!
//! Every element becomes an interval on its carrier: mm along the line, radians around the circle. The elements of
//! a carrier are taken in order of rank; each keeps what is not covered yet and covers its own interval. Lines are
//! put on a carrier by quantised direction and offset, arcs by centre and radius; the cells are so small that two
//! elements of one carrier are nowhere farther apart than the tolerance, and so odd that coordinates with few
//! decimals do not sit on their edges. What falls on two sides of an edge all the same is left to [`super::near`].

use super::cover::{Cover, Key, rest};
use super::kept::Kept;
use crate::geometry::{Aabb, Arc, Line, Segment, math};
use crate::order;
use crate::sheet::element::{Element, ROUNDING};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Lines are on one carrier only when their directions agree to this, rad: coordinates of six decimals over 1 mm.
const SAME_DIRECTION: f64 = 1e-6;
/// Cell of line offsets, in tolerances: with a quarter for the direction it stays below one.
const OFFSET_CELL: f64 = 0.4711;
/// Cell of centres and radii, in tolerances: in each of three coordinates members differ from the first by one cell
/// at most, 0.8 tolerances together.
const CIRCLE_CELL: f64 = 0.3317;
/// Elements looked at to tell a copy from an overlap; they differ in the word used in the finding, no more.
const LOOKED_AT: usize = 16;

/// An element as an interval on its carrier.
struct Span {
    element: u32,
    from: f64,
    to: f64,
    /// The element runs against the carrier.
    reversed: bool,
}

/// Unites all elements on their carriers.
pub(super) fn unite(elements: &[Element], rank: &[u32], tolerance: f64, kept: &mut [Kept]) {
    let tolerance = tolerance.max(ROUNDING);
    for mut spans in on_lines(elements, tolerance) {
        order::sort_by(&mut spans, |s| [rank[s.element as usize].into(), 0, 0]);
        unite_on_one(&spans, tolerance, None, kept);
    }
    for (radius, mut spans) in on_circles(elements, tolerance) {
        order::sort_by(&mut spans, |s| [rank[s.element as usize].into(), 0, 0]);
        unite_on_one(&spans, tolerance / radius, Some(TAU), kept);
    }
}

/// The lines on each straight line that carries more than one.
fn on_lines(elements: &[Element], tolerance: f64) -> Vec<Vec<Span>> {
    let lines: Vec<(u32, Line)> = (0_u32..)
        .zip(elements)
        .filter_map(|(i, e)| match e.segment {
            Segment::Line(l) => Some((i, l)),
            Segment::Arc(_) => None,
        })
        .collect();
    let bounds = lines.iter().fold(Aabb::EMPTY, |b, (_, l)| b.with(l.start).with(l.end));
    let (center, reach) = (bounds.center(), bounds.size().length() * 0.5);
    let direction_cell = SAME_DIRECTION.min(tolerance / (4.0 * reach.max(1.0)));
    let mut keyed: Vec<(i64, i64, Span)> = lines
        .into_iter()
        .map(|(element, l)| {
            let v = (l.end - l.start).normalize_or_zero();
            // Rightwards; upwards when upright, whatever the last bit of x says.
            let reversed = if v.x.abs() < 1e-9 { v.y < 0.0 } else { v.x < 0.0 };
            let d = if reversed { -v } else { v };
            let angle = if d.x.abs() < 1e-9 { FRAC_PI_2 } else { math::angle_of(d) };
            let (s, e) = (l.start - center, l.end - center);
            let (from, to) = if reversed { (e.dot(d), s.dot(d)) } else { (s.dot(d), e.dot(d)) };
            let offset = cell(d.perp_dot(s), tolerance * OFFSET_CELL);
            (cell(angle, direction_cell), offset, Span { element, from, to, reversed })
        })
        .collect();
    order::sort_by(&mut keyed, |(a, o, s)| [order::whole(*a), order::whole(*o), s.element.into()]);
    let mut groups: Vec<Vec<Span>> = Vec::new();
    let mut last = None;
    for (angle, offset, span) in keyed {
        match groups.last_mut() {
            Some(group) if last == Some((angle, offset)) => group.push(span),
            _ => groups.push(vec![span]),
        }
        last = Some((angle, offset));
    }
    groups.retain(|g| g.len() > 1);
    groups
}

/// The arcs on each circle that carries more than one, with its radius.
fn on_circles(elements: &[Element], tolerance: f64) -> Vec<(f64, Vec<Span>)> {
    let side = tolerance * CIRCLE_CELL;
    let mut group_at: FxHashMap<[i64; 3], usize> = FxHashMap::default();
    let mut groups: Vec<([f64; 3], Vec<Span>)> = Vec::new();
    for (element, e) in (0_u32..).zip(elements) {
        let Segment::Arc(a) = e.segment else { continue };
        let place = [a.center.x, a.center.y, a.radius()];
        let at = place.map(|v| cell(v, side));
        let group = group_at.get(&at).copied().or_else(|| {
            around(at)
                .filter_map(|n| group_at.get(&n).copied())
                .find(|&g| groups[g].0.iter().zip(place).all(|(x, y)| (x - y).abs() <= side))
        });
        let group = group.unwrap_or_else(|| {
            group_at.insert(at, groups.len());
            groups.push((place, Vec::new()));
            groups.len() - 1
        });
        groups[group].1.push(span_of(element, &a));
    }
    groups.into_iter().filter(|(_, g)| g.len() > 1).map(|(place, g)| (place[2], g)).collect()
}

/// The arc as an interval from an angle in [0, 2 pi) on; a full circle starts at 0.
fn span_of(element: u32, a: &Arc) -> Span {
    let reversed = !a.ccw();
    let first = if reversed { a.end } else { a.start };
    let from = if a.is_circle() { 0.0 } else { math::wrap_tau(math::angle_of(first - a.center)) };
    Span { element, from, to: from + a.sweep.abs(), reversed }
}

/// The 26 cells around a cell.
fn around(at: [i64; 3]) -> impl Iterator<Item = [i64; 3]> {
    (0..27_i64).filter(|&k| k != 13).map(move |k| {
        let shift = [k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1];
        [0, 1, 2].map(|i: usize| at[i].saturating_add(shift[i]))
    })
}

fn cell(v: f64, side: f64) -> i64 {
    #[allow(
        clippy::cast_possible_truncation,
        reason = "saturates; coordinates are bounded by the reader's limit"
    )]
    ((v / side).round() as i64)
}

/// Takes the spans of one carrier in order. `least` and `period` in the carrier's unit.
fn unite_on_one(spans: &[Span], least: f64, period: Option<f64>, kept: &mut [Kept]) {
    let mut cover = Cover::default();
    let mut originals: BTreeMap<Key, f64> = BTreeMap::new();
    for span in spans {
        let &Span { element, from, to, .. } = span;
        // A short element is not within a tolerance of its neighbours merely because it is short.
        let crumb = least.min((to - from) * 0.25);
        let turn = period.unwrap_or(f64::INFINITY);
        let second_turn = (to > turn).then(|| cover.within(0.0, to - turn)).into_iter().flatten();
        let covered = cover.within(from, to.min(turn)).chain(second_turn.map(|(a, b)| (a + turn, b + turn)));
        let left = rest(from, to, covered, crumb);
        let is_copy = || {
            let near = originals.range(Key(from - least)..=Key(from + least)).take(LOOKED_AT);
            near.into_iter().any(|(_, end)| (end - to).abs() <= least)
        };
        // Only what is kept covers: crumbs that were dropped do not add up to a hole.
        for &(a, b) in &left {
            if a < turn {
                cover.add(a, b.min(turn));
            }
            if b > turn {
                cover.add((a - turn).max(0.0), b - turn);
            }
        }
        kept[element as usize] = match left[..] {
            [] if is_copy() => Kept::Copy,
            [] => Kept::Covered,
            [(a, b)] if a <= from && b >= to => Kept::Whole,
            _ => Kept::Pieces(fractions(span, &left)),
        };
        if !left.is_empty() {
            originals.insert(Key(from), to);
        }
    }
}

/// Intervals on the carrier as fractions of the element, in its own direction.
fn fractions(span: &Span, left: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let length = span.to - span.from;
    let along = |t: f64| ((t - span.from) / length).clamp(0.0, 1.0);
    if span.reversed {
        left.iter().rev().map(|&(a, b)| (1.0 - along(b), 1.0 - along(a))).collect()
    } else {
        left.iter().map(|&(a, b)| (along(a), along(b))).collect()
    }
}
