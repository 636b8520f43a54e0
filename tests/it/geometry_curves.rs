//! Splines and ellipses become lines and arcs: measured against a dense evaluation of the curve itself.

use kerfway::geometry::{Aabb, Affine, Arc, BoxIndex, CurveError, DVec2, Ellipse, Nurbs, Segment, math};
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

/// How many equal steps the parameter takes: knots of 1 to 8 uniform spans are hit exactly.
const STEPS: u32 = 840;
/// Longest chord of the curve as measured against, mm; over a radius of 0.1 mm it rises by half a micrometre.
const CHORD: f64 = 0.02;

/// The curve as points no farther apart than [`CHORD`], however fast its parameter runs.
fn polyline(curve: &dyn Fn(f64) -> DVec2) -> Vec<DVec2> {
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
fn two_sided(curve: &dyn Fn(f64) -> DVec2, segments: &[Segment]) -> f64 {
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
fn unit(curve: &Nurbs) -> impl Fn(f64) -> DVec2 + '_ {
    let (a, b) = curve.domain();
    move |t| curve.point(a + (b - a) * t)
}

/// A piece of an ellipse over [0, 1].
fn unit_ellipse(e: Ellipse) -> impl Fn(f64) -> DVec2 {
    move |t| e.at(e.start + e.sweep * t)
}

fn dense(curve: &dyn Fn(f64) -> DVec2, n: u32) -> Vec<DVec2> {
    (0..=n).map(|i| curve(f64::from(i) / f64::from(n))).collect()
}

/// Smallest radius of curvature at dense points, mm: below the tolerance the curve has what looks like a corner.
fn smallest_radius(curve: &dyn Fn(f64) -> DVec2) -> f64 {
    let radius = |w: &[DVec2]| {
        let (a, b) = (w[1] - w[0], w[2] - w[1]);
        a.length().min(b.length()) / a.angle_between_abs(b).max(1e-12)
    };
    polyline(curve).windows(3).map(radius).fold(f64::INFINITY, f64::min)
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

/// Shape as a number: what must not change under a move, turn or mirror.
fn measure(segments: &[Segment]) -> (f64, usize) {
    (segments.iter().map(Segment::length).sum(), segments.len())
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

#[test]
fn a_flattened_ellipse_is_a_line_there_and_back() {
    let arc = Arc::circle(v(0.0, 0.0), 10.0);
    let flat = Ellipse::of_arc(&arc, &Affine::scale(v(2.0, 0.0)));
    let segments = flat.to_segments(TOLERANCE);
    assert_eq!(segments.len(), 2, "{segments:?}");
    let length: f64 = segments.iter().map(Segment::length).sum();
    assert!((length - 80.0).abs() < 1e-9);
    assert!(Ellipse::of_arc(&arc, &Affine::scale(v(0.0, 0.0))).to_segments(TOLERANCE).is_empty());
}

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
