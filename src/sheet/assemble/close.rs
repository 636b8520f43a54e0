//! Closes a gap between two elements, so that their ends meet bit for bit.
//!
//! Lines are moved, arcs are not. Circles and arcs are bores and fits, and moving an end of an arc changes its radius
//! everywhere, while moving a line's end by half a gap shifts the line by no more than half a gap. Two lines meet in
//! the middle of the gap, so the result does not depend on the direction of travel; a line meets an arc at the arc's
//! end. If neither line is long enough to move without turning visibly, a short line bridges the gap, and nothing that
//! was drawn moves. Ends that differ only by rounding are made equal.
//!
//! A gap that no program can show is not bridged: the line would be lost when coordinates are rounded, and the plan would
//! slow down for two corners that the machine never sees. There the start of the second element is moved. An arc stays a part
//! of a circle, one that is as much larger or smaller.

use crate::geometry::{Arc, DVec2, Segment, math};
use crate::sheet::element::{ROUNDING, with_end, with_start};
use std::f64::consts::TAU;

/// Smallest length of a line that is moved, in gaps. Such a line turns by less than 6 degrees when moved by one gap,
/// and by less than 3 degrees when moved by half a gap.
const MIN_LENGTH_IN_GAPS: f64 = 10.0;

/// The gap that is too small for programs, whose coordinates have three decimals of a millimetre: half a step, mm.
pub(super) const INVISIBLE: f64 = 5e-4;
/// The shortest chord of an arc whose start is moved over such a gap, in gaps: it turns by at most 0.6 degrees.
const MIN_CHORD_IN_GAPS: f64 = 100.0;

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
        (false, false) => match starting(b, p).filter(|_| gap <= INVISIBLE) {
            Some(b) => (a, None, b),
            None => (a, Some(Segment::line(p, q)), b),
        },
    }
}

/// The element with its start moved to `p`, if that turns it little enough.
fn starting(s: Segment, p: DVec2) -> Option<Segment> {
    let Segment::Arc(a) = s else { return None };
    let is_long = p.distance(a.end) >= MIN_CHORD_IN_GAPS * p.distance(a.start);
    Arc::from_bulge(p, a.end, math::tan(0.25 * a.sweep)).filter(|_| is_long).map(Segment::Arc)
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
