//! Tolerances for comparing positions.

use crate::geometry::{Segment, math};

/// Largest gap between joined moves, mm: far below the step of any machine, far above rounding errors of a coordinate.
pub(super) const JOIN: f64 = 1e-9;
/// Positions on a contour agree within this plus [`rounding`], mm: far below the resolution of a laser.
pub(super) const SAME: f64 = 1e-6;
/// Number of roundings that a position may have undergone. The plan rotates a point (two products and a sum for each
/// coordinate) and multiplies an angle by a radius for a length, and the checker does both again; that is three dozen in
/// all, with a margin here.
const ROUNDINGS: f64 = 64.0;

/// Largest effect of rounding on a position on an element, mm. Each rounding is at most the machine epsilon times the
/// largest number involved, which is a coordinate or, on a nearly straight arc, the radius. At 600 m this is 9 nm.
pub(super) fn rounding(element: &Segment) -> f64 {
    let ends = element.start().abs().max(element.end().abs()).max_element();
    let radius = if let Segment::Arc(a) = element { a.radius() } else { 0.0 };
    ROUNDINGS * f64::EPSILON * (ends + radius)
}

/// How much longer or shorter an element may be backwards, mm. The length of an arc is taken on the circle that it begins on, and
/// its ends may lie at different distances from its centre.
pub(super) fn stretch(element: &Segment) -> f64 {
    let Segment::Arc(a) = element else { return 0.0 };
    (a.end.distance(a.center) - a.radius()).abs() * a.sweep.abs()
}

/// Largest deviation of points on an element that is not a fault, mm: rounding, plus the distance of its ends from its own circle,
/// which joining over a gap causes, plus what it is longer or shorter backwards.
pub(super) fn slack(element: &Segment) -> f64 {
    let ends = match element {
        Segment::Line(_) => 0.0,
        // Where an end was moved along the circle as well, its sweep does not lead to it exactly.
        Segment::Arc(a) if a.is_circle() => 0.0,
        Segment::Arc(a) => {
            let turned = a.center + math::unit(a.sweep).rotate(a.start - a.center);
            turned.distance(a.end)
        }
    };
    ends + rounding(element) + stretch(element)
}
