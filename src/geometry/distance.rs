//! The shortest distance between two elements.

use super::intersect::intersect;
use super::segment::Segment;
use glam::DVec2;

/// Elements that meet within this distance, mm, touch each other.
const TOUCHING: f64 = 1e-9;

/// The distance between two elements, mm, and a place between them.
pub fn distance(a: &Segment, b: &Segment) -> (f64, DVec2) {
    if let Some(m) = intersect(a, b, TOUCHING).points.first() {
        return (0.0, m.point);
    }
    let mut best = (f64::INFINITY, a.start());
    let mut from = |p: DVec2, other: &Segment| {
        let (f, d2) = other.nearest(p);
        if d2.sqrt() < best.0 {
            best = (d2.sqrt(), (p + other.at(f)) * 0.5);
        }
    };
    for (s, other) in [(a, b), (b, a)] {
        from(s.start(), other);
        from(s.end(), other);
        // In the interior of both elements the shortest connection is perpendicular to both, so it lies on a line
        // through an arc's centre.
        if let Segment::Arc(arc) = other {
            from(s.at(s.nearest(arc.center).0), other);
            if let Segment::Arc(own) = s {
                from(s.at(s.nearest(own.center * 2.0 - arc.center).0), other);
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Arc;

    /// Compares with the smallest distance between many places.
    #[test]
    fn distance_equals_that_of_the_nearest_sampled_places() {
        let p = DVec2::new;
        let arc = |c: DVec2, r: f64, from: f64, sweep: f64| Segment::Arc(Arc::from_angles(c, r, from, sweep));
        let all = [
            Segment::line(p(0.0, 0.0), p(10.0, 0.0)),
            Segment::line(p(3.0, 1.0), p(8.0, 4.0)),
            Segment::line(p(-2.0, -3.0), p(-2.0, 7.0)),
            arc(p(5.0, 5.0), 3.0, 3.5, 2.0),
            arc(p(5.0, 5.0), 4.0, 0.2, -2.6),
            arc(p(6.0, 4.5), 1.0, 0.0, 6.0),
            arc(p(14.0, 3.0), 2.5, 1.0, 4.0),
            Segment::Arc(Arc::circle(p(5.0, 8.0), 1.5)),
        ];
        let places = |s: &Segment| (0..=4000).map(|k| s.at(f64::from(k) / 4000.0)).collect::<Vec<_>>();
        for (i, a) in all.iter().enumerate() {
            for b in &all[..i] {
                let sampled =
                    places(a).into_iter().map(|p| b.nearest(p).1.sqrt()).fold(f64::INFINITY, f64::min);
                let found = distance(a, b).0;
                assert!(found <= sampled + 1e-12 && sampled - found < 5e-3, "{found} {sampled}: {a:?} {b:?}");
                assert_eq!(found.to_bits(), distance(a, b).0.to_bits());
            }
        }
    }
}
