//! Closes a gap between two elements, so that their ends meet bit for bit.
//!
//! Lines are moved, arcs are not. Circles and arcs are bores and fits, and moving an end of an arc changes its radius
//! everywhere, while moving a line's end by half a gap shifts the line by no more than half a gap. Two lines meet in
//! the middle of the gap, so the result does not depend on the direction of travel; a line meets an arc at the arc's
//! end. If neither line is long enough to move without turning visibly, a short line bridges the gap, and nothing that
//! was drawn moves. Ends that differ only by rounding are made equal.

use crate::geometry::{Arc, DVec2, Segment};
use crate::sheet::element::{ROUNDING, with_end, with_start};
use std::f64::consts::TAU;

/// Smallest length of a line that is moved, in gaps. Such a line turns by less than 6 degrees when moved by one gap,
/// and by less than 3 degrees when moved by half a gap.
const MIN_LENGTH_IN_GAPS: f64 = 10.0;

/// Makes `b` start where `a` ends. The middle element is a short line that bridges the gap where neither can move.
pub(super) fn meet(a: Segment, b: Segment) -> (Segment, Option<Segment>, Segment) {
    let (p, q) = (a.end(), b.start());
    let gap = p.distance(q);
    if p == q {
        return (a, None, b);
    }
    let gives_way = |s: &Segment| matches!(s, Segment::Line(_)) && s.length() >= MIN_LENGTH_IN_GAPS * gap;
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

/// Closes a single element on itself. An arc whose ends coincide within rounding becomes a full circle.
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
