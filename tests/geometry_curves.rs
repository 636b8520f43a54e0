//! Splines and ellipses become lines and arcs: measured against a dense evaluation of the curve itself.

use kerfway::geometry::{Affine, Arc, DVec2, Ellipse, Nurbs, Segment, math};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;
use std::f64::consts::{PI, TAU};

const TOLERANCE: f64 = 0.005;

fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

/// Chain joined bit for bit, and no segment without length.
fn assert_chain(segments: &[Segment], what: &str) {
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

/// Two-sided distance between a curve (as dense points) and segments, by brute force.
fn two_sided(curve: &[DVec2], segments: &[Segment]) -> f64 {
    let to_fit = |p: DVec2| segments.iter().map(|s| s.nearest(p).1).fold(f64::INFINITY, f64::min).sqrt();
    let there = curve.iter().map(|p| to_fit(*p)).fold(0.0, f64::max);
    let chords: Vec<Segment> = curve.windows(2).map(|w| Segment::line(w[0], w[1])).collect();
    let to_curve = |p: DVec2| chords.iter().map(|s| s.nearest(p).1).fold(f64::INFINITY, f64::min).sqrt();
    let back = segments
        .iter()
        .flat_map(|s| (0..=24).map(move |k| s.at(f64::from(k) / 24.0)))
        .map(to_curve)
        .fold(0.0, f64::max);
    there.max(back)
}

/// Uniform knots are hit exactly when `n` is a multiple of the spans: 6720 is one of 1 to 8.
fn dense(curve: &Nurbs, n: usize) -> Vec<DVec2> {
    let (a, b) = curve.domain();
    (0..=n).map(|i| curve.point(a + (b - a) * i as f64 / n as f64)).collect()
}

/// Smallest radius of curvature at dense points, mm: below the tolerance the curve has what looks like a corner.
fn smallest_radius(curve: &Nurbs, n: usize) -> f64 {
    let (a, b) = curve.domain();
    let at = |i: usize| a + (b - a) * i as f64 / n as f64;
    let radius = |i: usize| {
        let turn = curve.derivative(at(i)).angle_between_abs(curve.derivative(at(i + 1)));
        curve.point(at(i)).distance(curve.point(at(i + 1))) / turn.max(1e-12)
    };
    (0..n).map(radius).fold(f64::INFINITY, f64::min)
}

fn dense_ellipse(e: &Ellipse, n: usize) -> Vec<DVec2> {
    (0..=n).map(|i| e.at(e.start + e.sweep * i as f64 / n as f64)).collect()
}

/// Largest turn at a joint, rad.
fn largest_turn(segments: &[Segment]) -> f64 {
    segments.windows(2).map(|w| w[0].tangent(1.0).angle_between_abs(w[1].tangent(0.0))).fold(0.0, f64::max)
}

trait AngleBetween {
    fn angle_between_abs(self, o: DVec2) -> f64;
}
impl AngleBetween for DVec2 {
    fn angle_between_abs(self, o: DVec2) -> f64 {
        math::turn(self, o).abs()
    }
}

fn rng(seed: u64) -> Xoshiro256PlusPlus {
    Xoshiro256PlusPlus::seed_from_u64(seed)
}

fn random_points(r: &mut Xoshiro256PlusPlus, n: usize, size: f64) -> Vec<DVec2> {
    (0..n).map(|_| v(r.random_range(0.0..size), r.random_range(0.0..size))).collect()
}

#[test]
fn random_splines_stay_within_the_tolerance_both_ways() {
    let mut r = rng(1);
    let mut smooth = 0;
    for round in 0..120 {
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
        let off = two_sided(&dense(&curve, 6720), &segments);
        assert!(off <= TOLERANCE, "{what}: {off} mm off, {} segments", segments.len());
        if degree > 1 && smallest_radius(&curve, 6720) > 0.1 * TOLERANCE {
            smooth += 1;
            assert!(largest_turn(&segments) < 1e-2, "{what}: turns {}", largest_turn(&segments));
        }
    }
    assert!(smooth > 60, "only {smooth} without a turn sharper than the tolerance");
}

#[test]
fn ellipses_stay_within_the_tolerance_both_ways() {
    let mut r = rng(2);
    for round in 0..80 {
        let e = Ellipse {
            center: v(r.random_range(-500.0..500.0), r.random_range(-500.0..500.0)),
            major: v(r.random_range(-80.0..80.0), r.random_range(-80.0..80.0)),
            minor: v(r.random_range(-30.0..30.0), r.random_range(-30.0..30.0)),
            start: r.random_range(-TAU..TAU),
            sweep: if round % 3 == 0 { TAU } else { r.random_range(-TAU..TAU) },
        };
        let segments = e.to_segments(TOLERANCE);
        assert_chain(&segments, "ellipse");
        let off = two_sided(&dense_ellipse(&e, 6000), &segments);
        assert!(off <= TOLERANCE, "round {round}: {off} mm off, {} segments, {e:?}", segments.len());
        if e.is_full() {
            assert_eq!(segments[0].start(), segments[segments.len() - 1].end());
        }
    }
}

#[test]
fn an_arc_under_a_similarity_stays_one_arc() {
    let map =
        Affine::rotation(1.1).then(&Affine::scale(v(-2.5, 2.5))).then(&Affine::translation(v(7.0, -3.0)));
    let arc = Arc::from_angles(v(1.0, 2.0), 5.0, 0.3, 2.0);
    let Some(Segment::Arc(image)) = map.segment(&Segment::Arc(arc)) else { panic!("an arc is expected") };
    assert!((image.sweep + 2.0).abs() < 1e-12);
    assert!((image.radius() - 12.5).abs() < 1e-12);
    for k in 0..=10 {
        let f = f64::from(k) / 10.0;
        let (a, b) = (map.point(Segment::Arc(arc).at(f)), Segment::Arc(image).at(f));
        assert!(a.distance(b) < 1e-12, "{a} {b}");
    }
}

#[test]
fn a_circle_as_four_cubics_comes_back_as_one_circle() {
    let k = 0.552_284_749_830_793_4;
    let r = 10.0;
    let q = [v(1., 0.), v(1., k), v(k, 1.), v(0., 1.), v(-k, 1.), v(-1., k), v(-1., 0.)];
    let lower = [v(-1., -k), v(-k, -1.), v(0., -1.), v(k, -1.), v(1., -k), v(1., 0.)];
    let control: Vec<DVec2> = q.iter().chain(&lower).map(|p| *p * r + v(100.0, 50.0)).collect();
    let knots =
        [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 3.0, 3.0, 3.0, 4.0, 4.0, 4.0, 4.0].to_vec();
    let curve = Nurbs::new(3, control, vec![], knots).unwrap();
    let segments = curve.to_segments(TOLERANCE);
    assert_eq!(segments.len(), 1, "{segments:?}");
    let Segment::Arc(a) = segments[0] else { panic!() };
    assert!(a.is_circle() && a.ccw());
    assert!((a.radius() - r).abs() < TOLERANCE && a.center.distance(v(100.0, 50.0)) < TOLERANCE);
}

#[test]
fn lines_and_fillets_drawn_as_one_spline_come_back_exact() {
    // 50 mm straight, a quarter turn of 5 mm radius, 30 mm straight: rational, with exact pieces.
    let w = math::cos(PI / 4.0);
    let control = vec![v(0., 0.), v(25., 0.), v(50., 0.), v(55., 0.), v(55., 5.), v(55., 20.), v(55., 35.)];
    let knots = [0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 3.0].to_vec();
    let curve = Nurbs::new(2, control, vec![1.0, 1.0, 1.0, w, 1.0, 1.0, 1.0], knots).unwrap();
    let segments = curve.to_segments(TOLERANCE);
    assert_eq!(segments.len(), 3, "{segments:#?}");
    let Segment::Arc(a) = segments[1] else { panic!("{segments:?}") };
    assert!((a.radius() - 5.0).abs() < 1e-6 && (a.sweep - PI / 2.0).abs() < 1e-6, "{a:?}");
    assert!(a.start.distance(v(50.0, 0.0)) < 1e-6);
}
