//! Lines, arcs, paths, boxes, maps and angles: values at the edges of what they take.

use kerfway::geometry::{Aabb, Affine, Arc, DVec2, Path, Segment, math};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

fn near(a: DVec2, b: DVec2) -> bool {
    a.distance(b) < 1e-9
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

fn rng(seed: u64) -> Xoshiro256PlusPlus {
    Xoshiro256PlusPlus::seed_from_u64(seed)
}

fn random_arc(r: &mut Xoshiro256PlusPlus) -> Arc {
    let center = v(r.random_range(-100.0..100.0), r.random_range(-100.0..100.0));
    let sweep = match r.random_range(0..6) {
        0 => TAU,
        1 => -TAU,
        2 => TAU - 1e-7,
        3 => 1e-7,
        _ => r.random_range(-TAU..TAU),
    };
    Arc::from_angles(center, r.random_range(0.01..500.0), r.random_range(-7.0..7.0), sweep)
}

#[test]
fn an_arc_keeps_its_ends_and_direction() {
    let mut r = rng(1);
    for _ in 0..2000 {
        let a = random_arc(&mut r);
        let s = Segment::Arc(a);
        assert_eq!((s.at(0.0), s.at(1.0)), (a.start, a.end));
        assert!(close(s.length(), a.radius() * a.sweep.abs()));
        let back = s.reversed();
        assert!(close(back.length(), s.length()));
        for f in [0.0, 0.1, 0.5, 0.99, 1.0] {
            assert!(s.at(f).distance(back.at(1.0 - f)) < 1e-9 * (1.0 + a.radius()), "{a:?} {f}");
            assert!(s.tangent(f).distance(-back.tangent(1.0 - f)) < 1e-6, "{a:?} {f}");
            // The direction is that of a small step.
            let step = s.at((f + 1e-6).min(1.0)) - s.at((f - 1e-6).max(0.0));
            if a.sweep.abs() > 0.1 {
                assert!(step.normalize().dot(s.tangent(f)) > 0.999_99, "{a:?} {f}");
            }
        }
        let rebuilt = Arc::new(a.start, a.end, a.center, a.ccw());
        assert!((rebuilt.sweep - a.sweep).abs() < 1e-6, "{a:?} {rebuilt:?}");
    }
}

#[test]
fn fractions_at_the_ends_are_exact() {
    let mut r = rng(2);
    for _ in 0..2000 {
        let a = random_arc(&mut r);
        let start = a.fraction_of(a.start - a.center).unwrap();
        let end = a.fraction_of(a.end - a.center).unwrap();
        assert!(start * a.sweep.abs() < 1e-9 || a.is_circle(), "{a:?} {start}");
        assert!((1.0 - end) * a.sweep.abs() < 1e-9 || a.is_circle(), "{a:?} {end}");
        let f = r.random_range(0.0..1.0);
        let met = a.fraction_of(Segment::Arc(a).at(f) - a.center).unwrap();
        assert!((met - f).abs() * a.sweep.abs() < 1e-9, "{a:?} {f} {met}");
        if a.sweep.abs() < TAU - 0.1 {
            let outside = a.start_angle() - 0.05 * a.sweep.signum();
            assert_eq!(a.fraction_of(math::unit(outside)), None, "{a:?}");
        }
    }
}

#[test]
fn bulges_are_arcs_and_no_bulge_is_none() {
    let half = Arc::from_bulge(v(0.0, 0.0), v(2.0, 0.0), 1.0).unwrap();
    assert!(near(half.center, v(1.0, 0.0)) && close(half.sweep, PI));
    // Counter-clockwise from left to right: below the chord.
    assert!(near(Segment::Arc(half).at(0.5), v(1.0, -1.0)));
    let quarter = Arc::from_bulge(v(1.0, 0.0), v(0.0, 1.0), math::tan(PI / 8.0)).unwrap();
    assert!(near(quarter.center, v(0.0, 0.0)) && close(quarter.sweep, FRAC_PI_2));
    let clockwise = Arc::from_bulge(v(0.0, 1.0), v(1.0, 0.0), -math::tan(PI / 8.0)).unwrap();
    assert!(near(clockwise.center, v(0.0, 0.0)) && close(clockwise.sweep, -FRAC_PI_2));
    for b in [0.0, 1e-12, f64::NAN, f64::INFINITY] {
        assert_eq!(Arc::from_bulge(v(0.0, 0.0), v(1.0, 0.0), b), None);
    }
    assert_eq!(Arc::from_bulge(v(1.0, 1.0), v(1.0, 1.0), 1.0), None);
    let nearly_full = Arc::from_bulge(v(0.0, 0.0), v(1e-3, 0.0), 1e6).unwrap();
    assert!(nearly_full.center.is_finite() && (nearly_full.radius() - 250.0).abs() < 1e-6);
    assert!(Arc::from_bulge(v(0.0, 0.0), v(1.0, 0.0), 1e200).unwrap().center.is_finite());
}

#[test]
fn boxes_hold_arcs_exactly() {
    let mut r = rng(3);
    for _ in 0..1000 {
        let s = Segment::Arc(random_arc(&mut r));
        let b = s.bounds();
        let dense = (0..=4000).fold(Aabb::EMPTY, |b, k| b.with(s.at(f64::from(k) / 4000.0)));
        assert!(b.grown(1e-9).contains_box(&dense), "{s:?}");
        // Not larger than the shape, except for the steps of the sampling.
        let step = s.length() / 4000.0;
        assert!(dense.grown(step).contains_box(&b), "{s:?} {b:?} {dense:?}");
    }
    assert_eq!(
        Segment::Arc(Arc::circle(v(1.0, 2.0), 3.0)).bounds(),
        Aabb { min: v(-2.0, -1.0), max: v(4.0, 5.0) }
    );
}

#[test]
fn the_nearest_place_is_the_nearest_of_many() {
    let mut r = rng(4);
    for _ in 0..400 {
        let s = if r.random_bool(0.3) {
            Segment::line(v(r.random_range(-9.0..9.0), 1.0), v(2.0, r.random_range(-9.0..9.0)))
        } else {
            Segment::Arc(random_arc(&mut r))
        };
        let p = v(r.random_range(-200.0..200.0), r.random_range(-200.0..200.0));
        let (f, d2) = s.nearest(p);
        assert!((0.0..=1.0).contains(&f) && (s.at(f).distance_squared(p) - d2).abs() <= 1e-9 * (1.0 + d2));
        let dense = (0..=3000).map(|k| s.at(f64::from(k) / 3000.0).distance(p)).fold(f64::INFINITY, f64::min);
        assert!(d2.sqrt() <= dense + 1e-9 && d2.sqrt() >= dense - s.length() / 3000.0, "{s:?} {p}");
    }
    let circle = Segment::Arc(Arc::circle(v(0.0, 0.0), 5.0));
    assert!(close(circle.nearest(v(0.0, 0.0)).1, 25.0));
    let point = Segment::line(v(1.0, 1.0), v(1.0, 1.0));
    assert_eq!(point.nearest(v(4.0, 5.0)), (0.0, 25.0));
}

#[test]
fn pieces_add_up_to_the_whole() {
    let mut r = rng(5);
    for _ in 0..500 {
        let s = Segment::Arc(random_arc(&mut r));
        let (a, b) = (r.random_range(0.0..0.5), r.random_range(0.5..1.0));
        let pieces = [s.piece(0.0, a), s.piece(a, b), s.piece(b, 1.0)];
        assert_eq!((pieces[0].start(), pieces[2].end()), (s.start(), s.end()));
        assert!(pieces.windows(2).all(|w| w[0].end() == w[1].start()));
        let length: f64 = pieces.iter().map(Segment::length).sum();
        assert!((length - s.length()).abs() < 1e-9 * (1.0 + s.length()));
        assert!(pieces[1].at(0.5).distance(s.at(0.5 * (a + b))) < 1e-9 * (1.0 + s.length()));
        assert_eq!(s.piece(-1.0, 2.0), s);
    }
}

/// A slot of 10 mm between centres, 2 mm radius, lower left of its straight edge at (0, -2), counter-clockwise.
fn slot() -> Path {
    Path::new(
        vec![
            Segment::line(v(0.0, -2.0), v(10.0, -2.0)),
            Segment::Arc(Arc::new(v(10.0, -2.0), v(10.0, 2.0), v(10.0, 0.0), true)),
            Segment::line(v(10.0, 2.0), v(0.0, 2.0)),
            Segment::Arc(Arc::new(v(0.0, 2.0), v(0.0, -2.0), v(0.0, 0.0), true)),
        ],
        true,
    )
}

#[test]
fn areas_and_lengths_are_exact() {
    let slot = slot();
    assert!(close(slot.area(), 40.0 + 4.0 * PI) && close(slot.length(), 20.0 + 4.0 * PI));
    assert!(close(slot.reversed().area(), -slot.area()));
    assert!(close(slot.largest_gap(), 0.0));
    let circle = Path::new(vec![Segment::Arc(Arc::circle(v(500.0, -300.0), 7.0))], true);
    assert!(close(circle.area(), 49.0 * PI) && close(circle.reversed().area(), -49.0 * PI));
    let torn = Path::new(
        vec![Segment::line(v(0.0, 0.0), v(1.0, 0.0)), Segment::line(v(1.0, 0.5), v(0.0, 0.0))],
        true,
    );
    assert!(close(torn.largest_gap(), 0.5));
    let nothing = Path::default();
    assert_eq!((nothing.start(), nothing.at(1.0), nothing.locate(0.0)), (None, None, None));
    assert!(nothing.bounds().is_empty() && close(nothing.length(), 0.0));
}

#[test]
fn a_closed_path_can_start_anywhere() {
    let slot = slot();
    let length = slot.length();
    for k in 0..200 {
        let s = length * f64::from(k) / 200.0;
        let cut = slot.starting_at(s);
        assert!(near(cut.start().unwrap(), slot.at(s).unwrap()));
        assert!(
            close(cut.length(), length) && close(cut.area(), slot.area()) && close(cut.largest_gap(), 0.0)
        );
        assert!(near(cut.at(1.0).unwrap(), slot.at((s + 1.0) % length).unwrap()));
        assert!(cut.segments.iter().all(|s| s.length() > 1e-9) && cut.segments.len() <= 5);
    }
    // At a joint, or next to it by rounding: no new element.
    for s in [0.0, 10.0, 10.0 + 1e-12, 10.0 - 1e-12, length, length - 1e-13, 20.0 + 2.0 * PI, -3.0, f64::NAN]
    {
        assert_eq!(slot.starting_at(s).segments.len(), 4, "{s}");
    }
    let circle = Path::new(vec![Segment::Arc(Arc::circle(v(0.0, 0.0), 1.0)).reversed()], true);
    let cut = circle.starting_at(FRAC_PI_2);
    assert_eq!(cut.segments.len(), 1);
    assert!(near(cut.start().unwrap(), v(0.0, -1.0)) && close(cut.area(), -PI));
    let open = Path::new(vec![Segment::line(v(0.0, 0.0), v(1.0, 0.0))], false);
    assert_eq!(open.starting_at(0.5), open);
}

#[test]
fn maps_compose_and_keep_their_properties() {
    let map =
        Affine::scale(v(2.0, 3.0)).then(&Affine::rotation(FRAC_PI_2)).then(&Affine::translation(v(1.0, 1.0)));
    assert_eq!(map.point(v(1.0, 1.0)), v(-2.0, 3.0));
    assert!(close(map.determinant(), 6.0) && !map.is_similarity());
    assert!(Affine::rotation(0.3).then(&Affine::scale(v(-4.0, 4.0))).is_similarity());
    assert!(!Affine::scale(v(0.0, 0.0)).is_similarity() && !Affine::scale(v(1.0, 1.000_001)).is_similarity());
    assert!(!Affine::translation(v(f64::NAN, 0.0)).is_finite());
    let quarters = [v(3.0, 0.0), v(0.0, 3.0), v(-3.0, 0.0), v(0.0, -3.0)];
    for (quarter, wanted) in (0..).zip(quarters) {
        assert_eq!(Affine::rotation(f64::from(quarter) * FRAC_PI_2).point(v(3.0, 0.0)), wanted);
    }
    let image = map.path(&slot(), 0.005);
    assert!(image.largest_gap() <= 0.0);
    assert!((image.area() - 6.0 * slot().area()).abs() < 0.02, "{}", image.area());
    let mirrored = Affine::scale(v(-1.0, 1.0)).path(&slot(), 0.005);
    assert_eq!(mirrored.segments.len(), 4);
    assert!(close(mirrored.area(), -slot().area()));
}

#[test]
fn angles_wrap_into_their_ranges() {
    for k in -9..=9 {
        for d in [0.0, 1e-17, -1e-17, 1.0, -1.0] {
            let a = f64::from(k) * PI + d;
            let (t, p) = (math::wrap_tau(a), math::wrap_pi(a));
            assert!((0.0..TAU).contains(&t), "{a} {t}");
            assert!(p > -PI && p <= PI, "{a} {p}");
            assert!(near(math::unit(t), math::unit(a)) && near(math::unit(p), math::unit(a)));
        }
    }
    assert!(close(math::acos(1.0 + 1e-15), 0.0) && close(math::asin(-2.0), -FRAC_PI_2));
    assert!(close(math::turn(v(1.0, 0.0), v(0.0, 2.0)), FRAC_PI_2));
}

#[test]
fn an_empty_box_holds_nothing_and_changes_nothing() {
    let b = Aabb::of(v(1.0, 2.0)).with(v(3.0, 1.0));
    assert_eq!(Aabb::EMPTY.union(b), b);
    assert_eq!(b.union(Aabb::EMPTY), b);
    assert!(!Aabb::EMPTY.overlaps(&b) && !b.contains_box(&Aabb::EMPTY) && Aabb::EMPTY.grown(5.0).is_empty());
    assert_eq!((Aabb::EMPTY.size(), b.size(), b.center()), (DVec2::ZERO, v(2.0, 1.0), v(2.0, 1.5)));
    assert!(b.overlaps(&Aabb::of(v(3.0, 2.0))) && !b.overlaps(&Aabb::of(v(3.1, 2.0))));
}
