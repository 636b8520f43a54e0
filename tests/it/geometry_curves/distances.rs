//! How far a fit is from its curve, which is evaluated densely; random curves.

use kerfway::geometry::{Aabb, BoxIndex, DVec2, Ellipse, Nurbs, Segment, math};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

pub(super) const TOLERANCE: f64 = 0.005;

pub(super) fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// Chain joined bit for bit, and no segment without length.
pub(super) fn assert_chain(segments: &[Segment], what: &str) {
    for w in segments.windows(2) {
        assert_eq!(w[0].end(), w[1].start(), "{what}: chain is torn");
    }
    for s in segments {
        assert!(s.length() > 0.0, "{what}: {s:?} has no length");
        if let Segment::Arc(a) = s {
            let (r0, r1) = (a.radius(), a.end.distance(a.center));
            assert!((r0 - r1).abs() <= 1e-6, "{what}: radii {r0} and {r1}");
        }
    }
}

/// How many equal steps the parameter takes: knots of 1 to 8 uniform spans are hit exactly.
pub(super) const STEPS: u32 = 840;

/// Longest chord of the curve as measured against, mm; over a radius of 0.1 mm it rises by half a micrometre.
pub(super) const CHORD: f64 = 0.02;

/// The curve as points no farther apart than [`CHORD`], however fast its parameter runs.
pub(super) fn polyline(curve: &dyn Fn(f64) -> DVec2) -> Vec<DVec2> {
    let mut out = vec![curve(0.0)];
    for i in 0..STEPS {
        let (a, b) = (f64::from(i) / f64::from(STEPS), f64::from(i + 1) / f64::from(STEPS));
        let rough: f64 = (0..8)
            .map(|k| [k, k + 1].map(|k| curve(a + (b - a) * f64::from(k) / 8.0)))
            .map(|[p, q]| p.distance(q))
            .fold(0.0, f64::max);
        let n = (1..1000).find(|n| 8.0 * rough / f64::from(*n) <= CHORD).unwrap_or(1000);
        out.extend(
            (1..=n).map(|k| if k == n { curve(b) } else { curve(a + (b - a) * f64::from(k) / f64::from(n)) }),
        );
    }
    out
}

/// Two-sided distance between a curve over [0, 1] and segments, by brute force.
pub(super) fn two_sided(curve: &dyn Fn(f64) -> DVec2, segments: &[Segment]) -> f64 {
    let points = polyline(curve);
    let to_fit = |p: &DVec2| segments.iter().map(|s| s.nearest(*p).1).fold(f64::INFINITY, f64::min).sqrt();
    let there = points.iter().map(to_fit).fold(0.0, f64::max);
    let chords: Vec<Segment> = points.windows(2).map(|w| Segment::line(w[0], w[1])).collect();
    let index = BoxIndex::new(chords.iter().map(Segment::bounds));
    let to_curve = |p: DVec2| {
        let mut reach = CHORD;
        loop {
            let near = index.query(Aabb::of(p).grown(reach)).into_iter();
            let least = near.map(|i| chords[i].nearest(p).1.sqrt()).fold(f64::INFINITY, f64::min);
            if least <= reach || reach > 1e9 {
                return least;
            }
            reach *= 2.0;
        }
    };
    let places = segments.iter().flat_map(|s| (0..=12).map(move |k| s.at(f64::from(k) / 12.0)));
    let back = places.map(to_curve).fold(0.0, f64::max);
    there.max(back)
}

/// A spline over [0, 1].
pub(super) fn unit(curve: &Nurbs) -> impl Fn(f64) -> DVec2 + '_ {
    let (a, b) = curve.domain();
    move |t| curve.point(a + (b - a) * t)
}

/// A piece of an ellipse over [0, 1].
pub(super) fn unit_ellipse(e: Ellipse) -> impl Fn(f64) -> DVec2 {
    move |t| e.at(e.start + e.sweep * t)
}

pub(super) fn dense(curve: &dyn Fn(f64) -> DVec2, n: u32) -> Vec<DVec2> {
    (0..=n).map(|i| curve(f64::from(i) / f64::from(n))).collect()
}

/// Smallest radius of curvature at dense points, mm: below the tolerance the curve has what looks like a corner.
pub(super) fn smallest_radius(curve: &dyn Fn(f64) -> DVec2) -> f64 {
    let radius = |w: &[DVec2]| {
        let (a, b) = (w[1] - w[0], w[2] - w[1]);
        a.length().min(b.length()) / a.angle_between_abs(b).max(1e-12)
    };
    polyline(curve).windows(3).map(radius).fold(f64::INFINITY, f64::min)
}

/// Largest turn at a joint, rad.
pub(super) fn largest_turn(segments: &[Segment]) -> f64 {
    segments.windows(2).map(|w| w[0].tangent(1.0).angle_between_abs(w[1].tangent(0.0))).fold(0.0, f64::max)
}

pub(super) trait AngleBetween {
    fn angle_between_abs(self, o: DVec2) -> f64;
}

impl AngleBetween for DVec2 {
    fn angle_between_abs(self, o: DVec2) -> f64 {
        math::turn(self, o).abs()
    }
}

pub(super) fn rng(seed: u64) -> Xoshiro256PlusPlus {
    Xoshiro256PlusPlus::seed_from_u64(seed)
}

pub(super) fn random_points(r: &mut Xoshiro256PlusPlus, n: usize, size: f64) -> Vec<DVec2> {
    (0..n).map(|_| v(r.random_range(0.0..size), r.random_range(0.0..size))).collect()
}

/// Shape as a number: what must not change under a move, turn or mirror.
pub(super) fn measure(segments: &[Segment]) -> (f64, usize) {
    (segments.iter().map(Segment::length).sum(), segments.len())
}
