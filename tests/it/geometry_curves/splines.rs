//! Splines of all kinds are read, or refused with their reason.

use super::distances::{
    AngleBetween, TOLERANCE, assert_chain, measure, random_points, rng, two_sided, unit, v,
};
use kerfway::geometry::{CurveError, DVec2, Nurbs, Segment, math};
use std::f64::consts::TAU;

#[test]
fn unclamped_periodic_and_short_knot_vectors_are_read() {
    // A closed uniform cubic with its first three points repeated at the end: smooth, closed, about a circle.
    let ring: Vec<DVec2> = (0..8).map(|i| math::unit(TAU * f64::from(i) / 8.0) * 20.0).collect();
    let wrapped: Vec<DVec2> = ring.iter().chain(&ring[..3]).copied().collect();
    let knots: Vec<f64> = (0..15).map(f64::from).collect();
    let given = Nurbs::new(3, wrapped.clone(), vec![], knots.clone()).unwrap();
    assert_eq!(given.domain(), (3.0, 11.0));
    let segments = given.to_segments(TOLERANCE);
    assert_eq!(segments[0].start(), segments[segments.len() - 1].end());
    assert!(two_sided(&unit(&given), &segments) <= TOLERANCE);
    let seam = segments[segments.len() - 1].tangent(1.0).angle_between_abs(segments[0].tangent(0.0));
    assert!(seam < 1e-2, "{seam}");
    // The same with the flag only, by periodic knots, by no knots, and already wrapped: all the same curve.
    for (control, knots) in [
        (ring.clone(), (0..9).map(f64::from).collect::<Vec<_>>()),
        (ring.clone(), vec![]),
        (ring, (0..12).map(f64::from).collect()),
        (wrapped, knots),
    ] {
        let closed = Nurbs::closed(3, control, vec![], knots).unwrap();
        let (a, b) = (measure(&closed.to_segments(TOLERANCE)), measure(&segments));
        assert!((a.0 - b.0).abs() < 1e-3, "{a:?} {b:?}");
        assert!(closed.start().distance(closed.end()) < 1e-9);
    }
    // Without the two outer knots, and with rounding that steps back.
    let points = vec![v(0.0, 0.0), v(10.0, 0.0), v(10.0, 10.0), v(20.0, 10.0), v(20.0, 0.0)];
    let full = Nurbs::new(3, points.clone(), vec![], vec![0., 0., 0., 0., 1., 2., 2., 2., 2.]).unwrap();
    let short = Nurbs::new(3, points.clone(), vec![], vec![0., 0., 0., 1., 2., 2., 2.]).unwrap();
    assert_eq!(full, short);
    let rounded =
        Nurbs::new(3, points.clone(), vec![], vec![0., 0., 0., 0., 1., 2., 1.999_999_9, 2., 2.]).unwrap();
    assert!(rounded.point(1.5).distance(full.point(1.5)) < 1e-6);
    // A closed flag on clamped knots whose ends differ: taken as drawn, open.
    let open = Nurbs::closed(3, points, vec![], vec![0., 0., 0., 0., 1., 2., 2., 2., 2.]).unwrap();
    assert_eq!((open.start(), open.end()), (v(0.0, 0.0), v(20.0, 0.0)));
}

#[test]
fn a_spline_through_points_goes_through_them_smoothly() {
    let points = [v(0.0, 0.0), v(10.0, 5.0), v(20.0, 0.0), v(30.0, 12.0), v(30.0, 12.0), v(45.0, 3.0)];
    let free = Nurbs::interpolate(&points, None, None, false).unwrap();
    let length = [0, 1, 2, 3].map(|i| points[i].distance(points[(i + 1).min(3)]));
    let mut t = 0.0;
    for i in 0..4 {
        assert!(free.point(t).distance(points[i]) < 1e-9, "{i}");
        t += length[i];
    }
    // Natural ends: no curvature there; curvature is continuous at inner points.
    let (a, b) = free.domain();
    let curvature = |u: f64, h: f64| (free.derivative(u + h) - free.derivative(u)).length() / h.abs();
    assert!(curvature(a, 1e-5) < 1e-3 && curvature(b, -1e-5) < 1e-3);
    let inner = length[0];
    let jump =
        (free.derivative(inner + 1e-5) + free.derivative(inner - 1e-5) - free.derivative(inner) * 2.0) / 1e-5;
    assert!(jump.length() < 1e-3, "{jump}");
    let given = Nurbs::interpolate(&points, Some(v(0.0, 3.0)), Some(v(0.0, -0.1)), false).unwrap();
    assert!(given.derivative(0.0).distance(v(0.0, 1.0)) < 1e-9);
    assert!(given.derivative(given.domain().1).distance(v(0.0, -1.0)) < 1e-9);
    // Closed: the seam is as smooth as any other point.
    let ring: Vec<DVec2> = (0..6).map(|i| math::unit(f64::from(i) * TAU / 6.0) * 10.0).collect();
    let closed = Nurbs::interpolate(&ring, None, None, true).unwrap();
    let (a, b) = closed.domain();
    assert!(closed.point(a).distance(closed.point(b)) < 1e-12);
    assert!(closed.derivative(a).distance(closed.derivative(b)) < 1e-9);
    // By symmetry every gap bulges alike, near the circle.
    for i in 0..6 {
        let middle = closed.point(a + (b - a) * (f64::from(i) + 0.5) / 6.0).length();
        assert!((middle - 9.9).abs() < 0.2, "{middle}");
    }
    let line = Nurbs::interpolate(&points[..2], None, None, false).unwrap().to_segments(TOLERANCE);
    assert_eq!(line, vec![Segment::line(points[0], points[1])]);
}

#[test]
fn bad_splines_are_refused_and_hostile_ones_terminate() {
    let points = vec![v(0.0, 0.0), v(1.0, 0.0), v(1.0, 1.0), v(0.0, 1.0)];
    let new = |degree, weights: Vec<f64>, knots: Vec<f64>| Nurbs::new(degree, points.clone(), weights, knots);
    assert!(matches!(new(0, vec![], vec![]), Err(CurveError::Degree(0))));
    assert!(matches!(new(16, vec![], vec![]), Err(CurveError::Degree(16))));
    assert!(matches!(new(4, vec![], vec![]), Err(CurveError::TooFewPoints { points: 4, degree: 4 })));
    assert!(matches!(new(3, vec![1.0; 3], vec![]), Err(CurveError::WeightCount { .. })));
    assert!(matches!(new(3, vec![1.0, 0.0, 1.0, 1.0], vec![]), Err(CurveError::Weight(_))));
    assert!(matches!(new(3, vec![f64::NAN; 4], vec![]), Err(CurveError::NotFinite)));
    assert!(matches!(new(3, vec![], vec![0.0; 5]), Err(CurveError::KnotCount { .. })));
    assert!(matches!(new(3, vec![], vec![0.0; 8]), Err(CurveError::KnotOrder)));
    assert!(matches!(new(3, vec![], vec![0., 0., 0., 0., 1., 0.5, 1., 1.]), Err(CurveError::KnotOrder)));
    assert!(matches!(
        new(3, vec![], vec![0., 0., 0., 0., 1., 1., 1., f64::INFINITY]),
        Err(CurveError::NotFinite)
    ));
    assert!(matches!(Nurbs::new(1, vec![v(0.0, f64::NAN); 2], vec![], vec![]), Err(CurveError::NotFinite)));
    assert!(matches!(
        Nurbs::interpolate(&[v(1.0, 1.0); 3], None, None, false),
        Err(CurveError::TooFewFitPoints)
    ));
    assert!(matches!(Nurbs::interpolate(&[], None, None, true), Err(CurveError::TooFewFitPoints)));
    // All points the same: nothing to cut. Some the same: the rest.
    assert!(Nurbs::new(3, vec![v(2.0, 2.0); 9], vec![], vec![]).unwrap().to_segments(TOLERANCE).is_empty());
    let stuck =
        vec![v(0.0, 0.0), v(0.0, 0.0), v(0.0, 0.0), v(10.0, 5.0), v(10.0, 5.0), v(20.0, 0.0), v(20.0, 0.0)];
    let curve = Nurbs::new(3, stuck, vec![], vec![]).unwrap();
    let segments = curve.to_segments(TOLERANCE);
    assert_chain(&segments, "repeated points");
    assert!(two_sided(&unit(&curve), &segments) <= TOLERANCE);
    // Huge, tiny, far away, wild weights, many points, a tolerance that cannot be met: all end, all joined.
    let mut r = rng(12);
    for (size, weights) in [(1e6, 0.0), (1e-6, 0.0), (100.0, 1e9), (1e12, 0.0), (1e150, 0.0)] {
        for degree in [1, 3, 15] {
            let control = random_points(&mut r, 200, size);
            let w = if weights > 0.0 {
                (0..200).map(|i| if i % 7 == 0 { weights } else { 1.0 }).collect()
            } else {
                vec![]
            };
            let segments = Nurbs::new(degree, control, w, vec![]).unwrap().to_segments(TOLERANCE);
            for s in segments.windows(2) {
                assert_eq!(s[0].end(), s[1].start());
            }
            assert!(segments.len() < 500_000, "{} pieces", segments.len());
            assert!(segments.iter().all(|s| s.start().is_finite() && s.end().is_finite()));
        }
    }
    let ends = Nurbs::new(3, random_points(&mut r, 50, 100.0), vec![], vec![]).unwrap().to_segments(f64::NAN);
    assert!(ends.len() < 500_000);
}
