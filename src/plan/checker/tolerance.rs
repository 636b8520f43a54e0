//! How near places have to be to count as one.

use crate::geometry::Segment;

/// Moves are joined within this, mm: far below any machine's step, far above the last bits of a coordinate.
pub(super) const JOIN: f64 = 1e-9;
/// Places on a contour agree within this and [`rounding`], mm: far below what a laser resolves.
pub(super) const SAME: f64 = 1e-6;
/// Roundings a place may have gone through: the plan turns a point (two products and a sum for each coordinate) and
/// takes an angle times a radius for a length, the checker does both again; three dozen in all, here with room.
const ROUNDINGS: f64 = 64.0;

/// How far rounding may carry a place on an element, mm: each rounding by up to the machine epsilon of the largest
/// number met, which is a coordinate or, on a nearly straight arc, the radius. 9 nm at 600 m.
pub(super) fn rounding(element: &Segment) -> f64 {
    let ends = element.start().abs().max(element.end().abs()).max_element();
    let radius = if let Segment::Arc(a) = element { a.radius() } else { 0.0 };
    ROUNDINGS * f64::EPSILON * (ends + radius)
}
