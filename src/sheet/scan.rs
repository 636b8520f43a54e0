//! Where a contour crosses a horizontal line, exactly for arcs.
//!
//! Every element falls into pieces that rise or fall throughout (a line is one, an arc has up to three, split at the
//! top and bottom of its circle). A piece crosses the line at height y when exactly one of its ends lies above it:
//! pieces that meet share the same bits for their common end, so a line through a corner is counted neither twice
//! nor not at all, and one along an edge is not counted.

use crate::geometry::{Arc, DVec2, Line, Segment, math};
use std::f64::consts::{FRAC_PI_2, PI};

/// Calls `hit` with the x of every crossing of the element with the horizontal line at `y`.
pub(super) fn crossings(segment: &Segment, y: f64, mut hit: impl FnMut(f64)) {
    match segment {
        Segment::Line(l) => {
            if (l.start.y > y) != (l.end.y > y) {
                hit(x_on_line(l, y));
            }
        }
        Segment::Arc(a) => {
            let radius = a.radius();
            // The ends count as they are: by rounding they may lie a hair outside the circle.
            let low = (a.center.y - radius).min(a.start.y).min(a.end.y);
            let high = (a.center.y + radius).max(a.start.y).max(a.end.y);
            if low <= y && y <= high {
                on_arc(a, radius, y, hit);
            }
        }
    }
}

fn x_on_line(l: &Line, y: f64) -> f64 {
    l.start.x + (l.end.x - l.start.x) * ((y - l.start.y) / (l.end.y - l.start.y))
}

fn on_arc(a: &Arc, radius: f64, y: f64, mut hit: impl FnMut(f64)) {
    // Counter-clockwise from the first end on; crossings do not depend on the direction.
    let (first, last) = if a.ccw() { (a.start, a.end) } else { (a.end, a.start) };
    let from = math::angle_of(first - a.center);
    let to = from + a.sweep.abs();
    let half_width = (radius * radius - (y - a.center.y) * (y - a.center.y)).max(0.0).sqrt();
    // Number of the half circle: even ones are on the right (-pi/2 to pi/2), odd ones on the left.
    let mut half = ((from + FRAC_PI_2) / PI).floor();
    let mut below = first.y;
    loop {
        let right = half.rem_euclid(2.0) < 0.5;
        let turning = half * PI + FRAC_PI_2;
        let is_last = turning >= to;
        let above = if is_last { last.y } else { a.center.y + if right { radius } else { -radius } };
        if (below > y) != (above > y) {
            hit(a.center.x + if right { half_width } else { -half_width });
        }
        if is_last {
            return;
        }
        below = above;
        half += 1.0;
    }
}

/// Whether `p` lies inside the closed contour of these elements (odd number of crossings to the right of it).
pub(super) fn contains<'a>(segments: impl IntoIterator<Item = &'a Segment>, p: DVec2) -> bool {
    let mut inside = false;
    for s in segments {
        crossings(s, p.y, |x| inside ^= x > p.x);
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::*;

    fn xs(s: &Segment, y: f64) -> Vec<f64> {
        let mut out = Vec::new();
        crossings(s, y, |x| out.push(x));
        out.sort_by(f64::total_cmp);
        out
    }

    #[test]
    fn a_circle_is_crossed_twice_wherever_it_starts() {
        for k in 0..16 {
            let start = f64::from(k) * PI / 8.0;
            for sweep in [2.0 * PI, -2.0 * PI] {
                let a = Segment::Arc(Arc::from_angles(DVec2::new(3.0, 4.0), 5.0, start, sweep));
                let hits = xs(&a, 7.0);
                assert_eq!(hits.len(), 2, "start {start} sweep {sweep}");
                assert!((hits[0] + 1.0).abs() < 1e-12 && (hits[1] - 7.0).abs() < 1e-12);
                assert!(contains([&a], DVec2::new(3.0, 4.0)));
                assert!(!contains([&a], DVec2::new(8.1, 4.0)));
                assert!(xs(&a, 9.5).is_empty() && xs(&a, -1.5).is_empty());
            }
        }
    }

    #[test]
    fn halves_of_a_circle_are_crossed_as_often_as_the_whole() {
        for k in 0..32 {
            let at = f64::from(k) * PI / 16.0;
            let one = Arc::from_angles(DVec2::ZERO, 2.0, at, 2.5);
            let two = Arc::new(one.end, one.start, DVec2::ZERO, true);
            for y in [-1.9, -1.0, 0.0, 0.3, 1.7, one.start.y, one.end.y] {
                let n = xs(&Segment::Arc(one), y).len() + xs(&Segment::Arc(two), y).len();
                assert_eq!(n, 2, "at {at} y {y}");
            }
        }
    }
}
