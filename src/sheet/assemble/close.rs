//! How a gap is closed, bit for bit.
//!
//! Lines give way, arcs do not: circles and arcs are bores and fits, and moving an end of an arc changes its radius
//! everywhere, while a line's end moved by half a gap bends its course by no more than half a gap. Two lines meet in
//! the middle, so the result does not depend on the direction of travel; a line meets an arc at the arc's end. Where
//! no line is long enough to give way without turning visibly, a short line is put across the gap: nothing that was
//! drawn moves. Ends within rounding are simply made the same.

use crate::geometry::{Arc, DVec2, Segment};
use crate::sheet::element::{ROUNDING, with_end, with_start};
use std::f64::consts::TAU;

/// A line gives way when it is at least this many gaps long: it then turns by under 6 degrees (one gap) or
/// 3 degrees (half a gap).
const LONG_ENOUGH: f64 = 10.0;

/// Makes `b` start where `a` ends; a short line between them where neither gives way.
pub(super) fn meet(a: Segment, b: Segment) -> (Segment, Option<Segment>, Segment) {
    let (p, q) = (a.end(), b.start());
    let gap = p.distance(q);
    if p == q {
        return (a, None, b);
    }
    let gives_way = |s: &Segment| matches!(s, Segment::Line(_)) && s.length() >= LONG_ENOUGH * gap;
    match (gives_way(&a), gives_way(&b)) {
        (true, true) => {
            let middle = (p + q) * 0.5;
            (with_end(a, middle), None, with_start(b, middle))
        }
        (true, false) => (with_end(a, q), None, b),
        (false, true) => (a, None, with_start(b, p)),
        (false, false) if gap <= ROUNDING => (a, None, with_start(b, p)),
        (false, false) => (a, Some(Segment::line(p, q)), b),
    }
}

/// Closes a single element on itself: an arc that comes round within rounding is a full circle.
pub(super) fn ring(s: Segment) -> Vec<Segment> {
    let (from, to): (DVec2, DVec2) = (s.start(), s.end());
    match s {
        _ if from == to => vec![s],
        Segment::Arc(a) if from.distance(to) <= ROUNDING => {
            vec![Segment::Arc(Arc { end: from, sweep: TAU.copysign(a.sweep), ..a })]
        }
        _ => vec![s, Segment::line(to, from)],
    }
}
