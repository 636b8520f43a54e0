//! Overlaps on one carrier: lines on one straight line, arcs on one circle.
//!
//! Every element becomes an interval on its carrier, in mm along the line or radians around the circle. The elements of
//! a carrier are processed in order of rank; each keeps what is not yet covered, and covers its own interval. Elements
//! are assigned to carriers by cells: lines by quantised direction and offset, arcs by centre and radius. The cells are
//! so small that two elements of one carrier are nowhere farther apart than the tolerance. Their sizes are uneven
//! numbers, so that coordinates with few decimals do not lie on their edges. Overlaps across an edge of two cells are
//! found by [`super::near`].

use super::cover::{Cover, Key, rest};
use super::remainder::Remainder;
use crate::geometry::{Aabb, Arc, Line, Segment, math};
use crate::order;
use crate::sheet::element::{Element, ROUNDING};
use rustc_hash::FxHashMap;
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};

/// Largest difference in direction (rad) of lines on one carrier: that of coordinates with six decimals over 1 mm.
const SAME_DIRECTION: f64 = 1e-6;
/// Cell size of line offsets, in tolerances. With a quarter for the direction it stays below one.
const OFFSET_CELL: f64 = 0.4711;
/// Cell size of centres and radii, in tolerances. Members differ from the first by at most one cell in each of three
/// coordinates, which is 0.8 tolerances in total.
const CIRCLE_CELL: f64 = 0.3317;
/// Number of elements tested to distinguish a copy from an overlap. The difference only affects the wording of the
/// finding.
const MAX_COPY_TESTS: usize = 16;

/// An element as an interval on its carrier.
struct Span {
    element: u32,
    from: f64,
    to: f64,
    /// Whether the element runs against the direction of the carrier.
    reversed: bool,
}

/// Removes overlaps among the elements of every carrier.
pub(super) fn unite(elements: &[Element], rank: &[u32], tolerance: f64, kept: &mut [Remainder]) {
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
            // Lines are directed to the right, and nearly vertical ones upwards, whatever the rounding of x.
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

/// The arc as an interval that starts at an angle in [0, 2 pi). A full circle starts at 0.
fn span_of(element: u32, a: &Arc) -> Span {
    let reversed = !a.ccw();
    let first = if reversed { a.end } else { a.start };
    let from = if a.is_circle() { 0.0 } else { math::wrap_tau(math::angle_of(first - a.center)) };
    Span { element, from, to: from + a.sweep.abs(), reversed }
}

/// The 26 neighbours of a cell.
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

/// Removes overlaps among the spans of one carrier, in order. `least` and `period` are in the carrier's unit.
fn unite_on_one(spans: &[Span], least: f64, period: Option<f64>, kept: &mut [Remainder]) {
    let mut cover = Cover::default();
    let mut originals: BTreeMap<Key, f64> = BTreeMap::new();
    for span in spans {
        let &Span { element, from, to, .. } = span;
        // A short element must not count as covered merely because it is shorter than the tolerance.
        let min_length = least.min((to - from) * 0.25);
        let turn = period.unwrap_or(f64::INFINITY);
        let second_turn = (to > turn).then(|| cover.within(0.0, to - turn)).into_iter().flatten();
        let covered = cover.within(from, to.min(turn)).chain(second_turn.map(|(a, b)| (a + turn, b + turn)));
        let left = rest(from, to, covered, min_length);
        let is_copy = || {
            let near = originals.range(Key(from - least)..=Key(from + least)).take(MAX_COPY_TESTS);
            near.into_iter().any(|(_, end)| (end - to).abs() <= least)
        };
        // Only the parts that are kept cover others, so that dropped short parts do not add up to a hole.
        for &(a, b) in &left {
            if a < turn {
                cover.add(a, b.min(turn));
            }
            if b > turn {
                cover.add((a - turn).max(0.0), b - turn);
            }
        }
        kept[element as usize] = match left[..] {
            [] if is_copy() => Remainder::Copy,
            [] => Remainder::Covered,
            [(a, b)] if a <= from && b >= to => Remainder::Whole,
            _ => Remainder::Pieces(fractions(span, &left)),
        };
        if !left.is_empty() {
            originals.insert(Key(from), to);
        }
    }
}

/// Converts intervals on the carrier to fractions of the element, in its own direction.
fn fractions(span: &Span, left: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let length = span.to - span.from;
    let along = |t: f64| ((t - span.from) / length).clamp(0.0, 1.0);
    if span.reversed {
        left.iter().rev().map(|&(a, b)| (1.0 - along(b), 1.0 - along(a))).collect()
    } else {
        left.iter().map(|&(a, b)| (along(a), along(b))).collect()
    }
}
