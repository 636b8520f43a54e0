//! A contour as a polyline that is fine enough to measure widths.

use crate::geometry::{Aabb, Budget, DVec2, Path, Segment, inscribed, math};
use crate::order::{real, sort_by};

/// Largest distance between an arc and its chords, mm: a tenth of the precision of laser cutting.
pub(super) const FINE: f64 = 0.01;
/// Largest number of chords of an arc: those of a full circle of 20 m radius at that distance.
const MOST: f64 = 1024.0;
/// Number of circles that are tried along each chord of a hole.
const SAMPLES: u32 = 9;
/// Chords compared for each chord of a hole on average, and at least in all. A bent slot of straight lines needs about 200.
const COMPARISONS_PER_CHORD: usize = 400;
const MIN_COMPARISONS: usize = 20_000;

/// Points along a contour, in order. Stretches follow each other as they are cut.
#[derive(Clone, Debug, Default)]
pub(super) struct Shape {
    pub(super) points: Vec<DVec2>,
}

impl Shape {
    /// Adds another stretch.
    pub(super) fn add(&mut self, path: &[Segment]) {
        self.points.extend(path.first().map(Segment::start));
        for segment in path {
            let pieces = match segment {
                Segment::Line(_) => 1.0,
                Segment::Arc(a) => {
                    let half = math::acos((1.0 - FINE / a.radius()).clamp(-1.0, 1.0));
                    (a.sweep.abs() / (2.0 * half)).ceil().clamp(1.0, MOST)
                }
            };
            let mut k = 1.0;
            while k < pieces {
                self.points.push(segment.at(k / pieces));
                k += 1.0;
            }
            self.points.push(segment.end());
        }
    }

    /// The box around it.
    pub(super) fn bounds(&self) -> Aabb {
        self.points.iter().fold(Aabb::EMPTY, |b, &p| b.with(p))
    }

    /// Its chords.
    pub(super) fn chords(&self) -> impl Iterator<Item = [DVec2; 2]> {
        self.points.windows(2).map(|w| [w[0], w[1]]).filter(|[a, b]| a != b)
    }

    /// Diameter of the largest circle inside the contour, mm, if it is less than `limit`: the diameter of a circle, the width of
    /// a slot, straight or bent. If a circle as wide as the hull fits, it is the width of the hull; also if the contour has so
    /// many chords around any circle that not all can be compared.
    pub(super) fn narrower_than(&self, limit: f64) -> Option<f64> {
        let hull = self.hull_width();
        let path = Path::new(self.chords().map(|[a, b]| Segment::line(a, b)).collect(), true);
        let mut budget = Budget::new(COMPARISONS_PER_CHORD * path.segments.len() + MIN_COMPARISONS);
        let mut below = |cap: f64| inscribed(&path, [cap, FINE], SAMPLES, &mut budget);
        // Nearly all holes are soon found to be wider than the limit. The width of the others does not depend on it.
        let narrow = below(hull.min(limit)).and_then(|_| below(hull));
        Some(narrow.map_or(hull, |(width, _)| width)).filter(|width| *width < limit)
    }

    /// Width of the narrowest strip between two parallel lines that contains the contour, mm. It is found by rotating calipers
    /// around the convex hull.
    fn hull_width(&self) -> f64 {
        let hull = hull(&self.points);
        let n = hull.len();
        if n < 3 {
            return 0.0;
        }
        let mut least = f64::INFINITY;
        let mut far = 1;
        for k in 0..n {
            let (a, edge) = (hull[k], hull[(k + 1) % n] - hull[k]);
            let away = |i: usize| edge.perp_dot(hull[i % n] - a);
            // While the edge goes around the hull once, so does the farthest corner.
            while away(far + 1) > away(far) {
                far += 1;
            }
            least = least.min(away(far) / edge.length());
        }
        least
    }

    /// Area, centroid and the two principal second moments of the enclosed area. All except the centroid stay the same when
    /// it is rotated or mirrored.
    pub(super) fn moments(&self) -> Moments {
        let Some(&o) = self.points.first() else { return Moments::default() };
        let (mut area, mut first, mut xx, mut yy, mut xy) = (0.0, DVec2::ZERO, 0.0, 0.0, 0.0);
        for [a, b] in self.chords() {
            let (a, b) = (a - o, b - o);
            let cross = a.perp_dot(b);
            area += cross / 2.0;
            first += (a + b) * cross / 6.0;
            xx += cross * (a.x * a.x + a.x * b.x + b.x * b.x) / 12.0;
            yy += cross * (a.y * a.y + a.y * b.y + b.y * b.y) / 12.0;
            xy += cross * (2.0 * (a.x * a.y + b.x * b.y) + a.x * b.y + b.x * a.y) / 24.0;
        }
        if area == 0.0 {
            return Moments { area: 0.0, centroid: o, principal: [0.0; 2] };
        }
        let c = first / area;
        let [xx, yy, xy] =
            [xx - area * c.x * c.x, yy - area * c.y * c.y, xy - area * c.x * c.y].map(|m| m * area.signum());
        let half = (xx - yy) / 2.0;
        let (middle, reach) = ((xx + yy) / 2.0, (half * half + xy * xy).sqrt());
        Moments { area: area.abs(), centroid: o + c, principal: [middle - reach, middle + reach] }
    }
}

/// See [`Shape::moments`]: mm2, mm, mm4.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Moments {
    pub(super) area: f64,
    pub(super) centroid: DVec2,
    pub(super) principal: [f64; 2],
}

/// The convex hull, counter-clockwise (Andrew's chain).
fn hull(points: &[DVec2]) -> Vec<DVec2> {
    let mut sorted = points.to_vec();
    sort_by(&mut sorted, |p| [real(p.x + 0.0), real(p.y + 0.0), 0]);
    sorted.dedup();
    let mut hull: Vec<DVec2> = Vec::new();
    // The lower chain from left to right, then the upper one back; each starts where the other ended.
    for back in [false, true] {
        if back {
            sorted.reverse();
        }
        let base = hull.len().saturating_sub(1);
        for &p in sorted.iter().skip(usize::from(back)) {
            while let [.., a, b] = hull[base..]
                && (b - a).perp_dot(p - b) <= 0.0
            {
                hull.pop();
            }
            hull.push(p);
        }
    }
    hull.pop();
    hull
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Arc;

    fn shape(path: &[Segment]) -> Shape {
        let mut shape = Shape::default();
        shape.add(path);
        shape
    }

    fn rectangle(w: f64, h: f64, angle: f64) -> Vec<Segment> {
        let corner = |x, y| math::rotate(DVec2::new(x, y), angle) + DVec2::new(300.0, -70.0);
        let c = [corner(0.0, 0.0), corner(w, 0.0), corner(w, h), corner(0.0, h)];
        (0..4).map(|k| Segment::line(c[k], c[(k + 1) % 4])).collect()
    }

    fn width(shape: &Shape) -> f64 {
        shape.narrower_than(f64::INFINITY).unwrap()
    }

    fn polygon(corners: &[(f64, f64)]) -> Shape {
        Shape { points: corners.iter().chain(corners.first()).map(|&c| DVec2::from(c)).collect() }
    }

    /// It was the width of the hull, here 29 mm.
    #[test]
    fn the_width_of_a_bent_hole_is_that_of_the_slot() {
        let bent = [(0.0, 0.0), (40.0, 0.0), (40.0, 1.0), (1.0, 1.0), (1.0, 40.0), (0.0, 40.0)];
        let bent = polygon(&bent);
        // A circle in the corner reaches a little into both legs.
        assert!((1.0..=1.172).contains(&width(&bent)), "{}", width(&bent));
        assert_eq!(bent.narrower_than(0.9), None);
        assert_eq!(bent.narrower_than(3.0), bent.narrower_than(f64::INFINITY));
        // Half a turn of a slot 2 mm wide.
        let end = |r: f64, from: f64, sweep: f64| Segment::Arc(Arc::from_angles(DVec2::ZERO, r, from, sweep));
        let cap =
            |x: f64| Segment::Arc(Arc::from_angles(DVec2::new(x, 0.0), 1.0, 0.0, -std::f64::consts::PI));
        let pi = std::f64::consts::PI;
        let curved =
            shape(&[end(21.0, 0.0, pi), cap(-20.0).reversed(), end(19.0, pi, -pi), cap(20.0).reversed()]);
        assert!((width(&curved) - 2.0).abs() < 0.02, "{}", width(&curved));
        // Sides that are not smooth do not make a hole narrow.
        let rough: Vec<(f64, f64)> = (0..3000)
            .map(|k| {
                let p = math::rotate(DVec2::new(50.0, 0.0), f64::from(k) * std::f64::consts::TAU / 3000.0);
                ((p.x * 100.0).round() / 100.0, (p.y * 100.0).round() / 100.0)
            })
            .collect();
        let rough = polygon(&rough);
        assert!((width(&rough) - 100.0).abs() < 0.1, "{}", width(&rough));
        assert_eq!(rough.narrower_than(95.0), None);
    }

    #[test]
    fn widths_and_moments_of_known_shapes() {
        let circle = shape(&[Segment::Arc(Arc::circle(DVec2::new(7.0, 9.0), 5.0))]);
        assert!((width(&circle) - 10.0).abs() < 2.0 * FINE, "{}", width(&circle));
        for angle in [0.0, 0.3, 2.0] {
            let r = shape(&rectangle(40.0, 10.0, angle));
            assert!((width(&r) - 10.0).abs() < 1e-9, "{}", width(&r));
            let m = r.moments();
            assert!((m.area - 400.0).abs() < 1e-8);
            // b h^3 / 12 and h b^3 / 12.
            assert!((m.principal[0] - 40.0 * 1000.0 / 12.0).abs() < 1e-5, "{:?}", m.principal);
            assert!((m.principal[1] - 10.0 * 64000.0 / 12.0).abs() < 1e-5, "{:?}", m.principal);
        }
        let slot = {
            let (a, b) = (DVec2::new(0.0, 0.0), DVec2::new(20.0, 0.0));
            let end = |from: DVec2, to: DVec2, c: DVec2| Segment::Arc(Arc::new(from, to, c, true));
            let up = DVec2::new(0.0, 3.0);
            Path::new(
                vec![
                    Segment::line(a - up, b - up),
                    end(b - up, b + up, b),
                    Segment::line(b + up, a + up),
                    end(a + up, a - up, a),
                ],
                true,
            )
        };
        assert!((width(&shape(&slot.segments)) - 6.0).abs() < 2.0 * FINE);
    }
}
