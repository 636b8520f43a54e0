//! A fit stays within its tolerance, with few pieces, however the curve lies.

use super::distances::{
    TOLERANCE, assert_chain, dense, largest_turn, measure, random_points, rng, smallest_radius, two_sided,
    unit, unit_ellipse, v,
};
use kerfway::geometry::{Affine, DVec2, Ellipse, Nurbs, Segment, math};
use rand::RngExt;
use std::f64::consts::TAU;

#[test]
fn random_splines_stay_within_the_tolerance_both_ways() {
    let mut r = rng(1);
    let mut smooth = 0;
    for round in 0..60 {
        let degree = 1 + round % 5;
        let n = degree + 1 + r.random_range(0..8);
        let weights =
            if round % 2 == 0 { vec![] } else { (0..n).map(|_| r.random_range(0.2..4.0)).collect() };
        let curve = Nurbs::new(degree, random_points(&mut r, n, 60.0), weights, vec![]).unwrap();
        let segments = curve.to_segments(TOLERANCE);
        let what = format!("round {round}, degree {degree}");
        assert_chain(&segments, &what);
        assert_eq!(segments[0].start(), curve.start(), "{what}");
        assert_eq!(segments[segments.len() - 1].end(), curve.end(), "{what}");
        let off = two_sided(&unit(&curve), &segments);
        assert!(off <= TOLERANCE, "{what}: {off} mm off, {} segments", segments.len());
        if degree > 1 && smallest_radius(&unit(&curve)) > TOLERANCE {
            smooth += 1;
            assert!(largest_turn(&segments) < 1e-2, "{what}: turns {}", largest_turn(&segments));
        }
    }
    assert!(smooth > 30, "only {smooth} without a turn sharper than the tolerance");
}

#[test]
fn ellipses_stay_within_the_tolerance_both_ways() {
    let mut r = rng(2);
    for round in 0..40 {
        let e = Ellipse {
            center: v(r.random_range(-500.0..500.0), r.random_range(-500.0..500.0)),
            major: v(r.random_range(-80.0..80.0), r.random_range(-80.0..80.0)),
            minor: v(r.random_range(-30.0..30.0), r.random_range(-30.0..30.0)),
            start: r.random_range(-TAU..TAU),
            sweep: if round % 3 == 0 { TAU } else { r.random_range(-TAU..TAU) },
        };
        let segments = e.to_segments(TOLERANCE);
        assert_chain(&segments, "ellipse");
        let off = two_sided(&unit_ellipse(e), &segments);
        assert!(off <= TOLERANCE, "round {round}: {off} mm off, {} segments, {e:?}", segments.len());
        if e.is_full() {
            assert_eq!(segments[0].start(), segments[segments.len() - 1].end());
        }
    }
}

/// Integral of the cube root of the rate of curvature over a curve: pieces a fit needs are in proportion to it.
fn bend(points: &[DVec2]) -> f64 {
    let curvature = |i: usize| {
        let (a, b) = (points[i] - points[i - 1], points[i + 1] - points[i]);
        2.0 * math::turn(a, b) / (a.length() + b.length())
    };
    (1..points.len() - 2)
        .map(|i| {
            let ds = points[i].distance(points[i + 1]);
            math::pow(((curvature(i + 1) - curvature(i)) / ds).abs(), 1.0 / 3.0) * ds
        })
        .sum()
}

/// Arcs of length h with one direction at their joints cannot be nearer than k h^3 / 125 to a curve of curvature rate
/// k (both the wave form of the error and its amplitude follow from integrating a sawtooth twice): the least number
/// for small tolerances. Biarcs in the curve's own directions reach k (2 h)^3 / 324, 1.46 times as many.
#[test]
fn few_pieces_compared_with_the_optimum() {
    let optimum = |points: &[DVec2]| bend(points) * math::pow(124.7 * TOLERANCE, -1.0 / 3.0);
    let mut r = rng(3);
    let (mut pieces, mut least) = (0, 0.0);
    for _ in 0..40 {
        let n = 4 + r.random_range(0..20);
        let curve = Nurbs::new(3, random_points(&mut r, n, 100.0), vec![], vec![]).unwrap();
        pieces += curve.to_segments(TOLERANCE).len();
        least += optimum(&dense(&unit(&curve), 20_000));
    }
    let ratio = f64::from(u32::try_from(pieces).unwrap()) / least;
    assert!(ratio < 1.7, "{ratio} times the optimum on random splines");
    for (a, b, most) in
        [(40.0, 20.0, 36), (5.0, 4.0, 16), (200.0, 50.0, 62), (1000.0, 999.0, 16), (10.0, 9.9999, 1)]
    {
        let e = Ellipse { center: v(3.0, 4.0), major: v(a, 0.0), minor: v(0.0, b), start: 0.3, sweep: TAU };
        let n = e.to_segments(TOLERANCE).len();
        let least = optimum(&dense(&unit_ellipse(e), 4000));
        assert!(n <= most, "ellipse {a} x {b}: {n} pieces, optimum {least}");
    }
}

#[test]
fn moved_turned_mirrored_and_reversed_curves_give_the_same_fit() {
    let mut r = rng(4);
    for round in 0..12 {
        let n = 5 + r.random_range(0..6);
        let points = random_points(&mut r, n, 80.0);
        let curve = Nurbs::new(3, points.clone(), vec![], vec![]).unwrap();
        let fit = curve.to_segments(TOLERANCE);
        let (length, count) = measure(&fit);
        for map in [
            Affine::translation(v(1234.5, -987.25)),
            Affine::rotation(0.7),
            Affine::scale(v(-1.0, 1.0)),
            Affine::rotation(2.1).then(&Affine::scale(v(1.0, -1.0))).then(&Affine::translation(v(5.0, 6.0))),
        ] {
            let image = curve.transformed(&map).to_segments(TOLERANCE);
            let (l, c) = measure(&image);
            // A turn or mirror may change from which end the pieces are laid.
            assert!((l - length).abs() < 1e-4 * length, "round {round}: {l} {length}");
            assert!(c.abs_diff(count) <= 2 + count / 10, "round {round}: {c} {count}");
            let mapped = |t: f64| map.point(unit(&curve)(t));
            assert!(two_sided(&mapped, &image) <= TOLERANCE + 1e-3 * TOLERANCE);
        }
        let reversed = Nurbs::new(3, points.into_iter().rev().collect(), vec![], vec![]).unwrap();
        let back: Vec<Segment> =
            reversed.to_segments(TOLERANCE).iter().rev().map(Segment::reversed).collect();
        assert_eq!(back, fit, "round {round}");
    }
    let e =
        Ellipse { center: v(1.0, 2.0), major: v(30.0, 5.0), minor: v(-3.0, 12.0), start: 0.4, sweep: 5.0 };
    let reversed = Ellipse { start: e.start + e.sweep, sweep: -e.sweep, ..e };
    let back: Vec<Segment> = reversed.to_segments(TOLERANCE).iter().rev().map(Segment::reversed).collect();
    assert_eq!(back.len(), e.to_segments(TOLERANCE).len());
    for (a, b) in back.iter().zip(e.to_segments(TOLERANCE)) {
        assert!(a.start().distance(b.start()) < 1e-9 && a.end().distance(b.end()) < 1e-9);
    }
}

#[test]
fn a_finer_tolerance_gives_a_nearer_fit() {
    let mut r = rng(11);
    let curve = Nurbs::new(3, random_points(&mut r, 8, 60.0), vec![], vec![]).unwrap();
    let points = dense(&unit(&curve), 20_000);
    let mut last = 0;
    for tolerance in [0.5, 0.05, 0.005, 0.0005] {
        let segments = curve.to_segments(tolerance);
        let off = points
            .iter()
            .map(|p| segments.iter().map(|s| s.nearest(*p).1).fold(f64::INFINITY, f64::min).sqrt())
            .fold(0.0, f64::max);
        assert!(off <= tolerance && off > 0.2 * tolerance, "{tolerance}: {off}");
        assert!(segments.len() > last);
        last = segments.len();
    }
}
