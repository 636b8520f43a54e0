//! Intersections, inside tests, grid and box index, against brute force.

use kerfway::geometry::{
    Aabb, Arc, BoxIndex, DVec2, Path, Segment, filled_area, interior_point, intersect, math, winding,
};
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;
use std::f64::consts::{PI, TAU};

fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

fn rng(seed: u64) -> Xoshiro256PlusPlus {
    Xoshiro256PlusPlus::seed_from_u64(seed)
}

fn point(r: &mut Xoshiro256PlusPlus, size: f64) -> DVec2 {
    v(r.random_range(-size..size), r.random_range(-size..size))
}

fn line(a: (f64, f64), b: (f64, f64)) -> Segment {
    Segment::line(v(a.0, a.1), v(b.0, b.1))
}

fn arc(c: (f64, f64), radius: f64, from: f64, sweep: f64) -> Segment {
    Segment::Arc(Arc::from_angles(v(c.0, c.1), radius, from, sweep))
}

fn random_segment(r: &mut Xoshiro256PlusPlus) -> Segment {
    match r.random_range(0..3) {
        0 => Segment::line(point(r, 10.0), point(r, 10.0)),
        1 => {
            let c = point(r, 5.0);
            Segment::Arc(Arc::from_angles(
                c,
                r.random_range(0.5..8.0),
                r.random_range(-4.0..4.0),
                r.random_range(-6.2..6.2),
            ))
        }
        _ => {
            let c = point(r, 5.0);
            Segment::Arc(Arc::from_angles(c, r.random_range(0.5..8.0), r.random_range(-4.0..4.0), TAU))
        }
    }
}

const TOLERANCE: f64 = 1e-6;

#[test]
fn lines_cross_touch_and_miss() {
    let a = line((0.0, 0.0), (10.0, 0.0));
    let hit = intersect(&a, &line((4.0, -3.0), (4.0, 1.0)), TOLERANCE);
    assert_eq!(hit.points.len(), 1);
    assert!(hit.points[0].crossing);
    assert!((hit.points[0].a - 0.4).abs() < 1e-12 && (hit.points[0].b - 0.75).abs() < 1e-12);
    let touch = intersect(&a, &line((4.0, 0.0), (4.0, 1.0)), TOLERANCE);
    assert_eq!(touch.points.len(), 1);
    assert!(!touch.points[0].crossing);
    let corner = intersect(&a, &line((10.0, 0.0), (12.0, 5.0)), TOLERANCE);
    assert_eq!((corner.points.len(), corner.points[0].a, corner.points[0].b), (1, 1.0, 0.0));
    assert!(intersect(&a, &line((4.0, 0.1), (4.0, 1.0)), TOLERANCE).is_empty());
    assert!(intersect(&a, &line((0.0, 1.0), (10.0, 1.0)), TOLERANCE).is_empty());
}

#[test]
fn an_end_that_falls_short_within_the_tolerance_meets() {
    let a = line((0.0, 0.0), (10.0, 0.0));
    let hit = intersect(&a, &line((4.0, 0.04), (4.0, 1.0)), 0.05);
    assert_eq!(hit.points.len(), 1);
    assert!(hit.points[0].b <= 0.0);
    // Past the end, and beside it.
    assert_eq!(intersect(&a, &line((10.03, 0.03), (12.0, 0.0)), 0.05).points.len(), 1);
    assert!(intersect(&a, &line((10.04, 0.04), (12.0, 0.0)), 0.05).is_empty());
}

#[test]
fn collinear_lines_share_a_stretch() {
    let a = line((0.0, 0.0), (10.0, 0.0));
    let o = intersect(&a, &line((14.0, 0.0), (6.0, 0.0)), TOLERANCE);
    assert!(o.points.is_empty(), "{o:?}");
    assert_eq!(o.overlaps.len(), 1);
    assert!((o.overlaps[0].a[0] - 0.6).abs() < 1e-9 && (o.overlaps[0].a[1] - 1.0).abs() < 1e-9);
    assert!((o.overlaps[0].b[0] - 1.0).abs() < 1e-9 && (o.overlaps[0].b[1] - 0.5).abs() < 1e-9);
    let whole = intersect(&a, &a.reversed(), TOLERANCE);
    assert_eq!((whole.overlaps[0].a, whole.overlaps[0].b), ([0.0, 1.0], [1.0, 0.0]));
    let end_to_end = intersect(&a, &line((10.0, 0.0), (20.0, 0.0)), TOLERANCE);
    assert_eq!((end_to_end.points.len(), end_to_end.overlaps.len()), (1, 0));
}

#[test]
fn arcs_on_one_circle_share_their_stretches() {
    let a = arc((1.0, 2.0), 5.0, 0.0, PI);
    let o = intersect(&a, &arc((1.0, 2.0), 5.0, 1.5 * PI, -PI), TOLERANCE);
    assert_eq!((o.points.len(), o.overlaps.len()), (0, 1), "{o:?}");
    assert!((o.overlaps[0].a[0] - 0.5).abs() < 1e-9 && (o.overlaps[0].a[1] - 1.0).abs() < 1e-9);
    assert!((o.overlaps[0].b[0] - 1.0).abs() < 1e-9 && (o.overlaps[0].b[1] - 0.5).abs() < 1e-9);
    // Two that meet at both ends.
    let o = intersect(&a, &arc((1.0, 2.0), 5.0, -0.1 * PI, -0.8 * PI), TOLERANCE);
    assert!(o.is_empty());
    let o = intersect(&a, &arc((1.0, 2.0), 5.0, -PI, 1.2 * PI), TOLERANCE);
    assert_eq!((o.points.len(), o.overlaps.len()), (1, 1), "{o:?}");
    assert!((o.points[0].a - 1.0).abs() < 1e-9 && (o.overlaps[0].a[1] - 0.2).abs() < 1e-9);
}

#[test]
fn a_circle_and_its_copy_share_everything_wherever_they_start() {
    let a = arc((0.0, 0.0), 5.0, 0.0, TAU);
    for (from, sweep) in [(0.0, TAU), (1.0, TAU), (2.0, -TAU), (-3.0, -TAU)] {
        let o = intersect(&a, &arc((0.0, 0.0), 5.0, from, sweep), TOLERANCE);
        assert!(o.points.is_empty(), "{o:?}");
        let on_a: f64 = o.overlaps.iter().map(|s| s.a[1] - s.a[0]).sum();
        let on_b: f64 = o.overlaps.iter().map(|s| (s.b[1] - s.b[0]).abs()).sum();
        assert!((on_a - 1.0).abs() < 1e-9 && (on_b - 1.0).abs() < 1e-9, "{o:?}");
        assert!(o.overlaps.iter().all(|s| (s.b[1] > s.b[0]) == (sweep > 0.0)), "{o:?}");
    }
    let o = intersect(&a, &arc((0.0, 0.0), 5.0, -1.0, 2.0), TOLERANCE);
    let on_b: f64 = o.overlaps.iter().map(|s| s.b[1] - s.b[0]).sum();
    assert!(o.points.is_empty() && (on_b - 1.0).abs() < 1e-9, "{o:?}");
}

#[test]
fn circles_cross_twice_and_touch_once() {
    let a = arc((0.0, 0.0), 5.0, 0.0, TAU);
    let o = intersect(&a, &arc((6.0, 0.0), 5.0, 0.0, TAU), TOLERANCE);
    assert_eq!(o.points.len(), 2);
    assert!(
        o.points
            .iter()
            .all(|m| m.crossing && (m.point.x - 3.0).abs() < 1e-9 && (m.point.y.abs() - 4.0).abs() < 1e-9)
    );
    for (x, r) in [(8.0, 3.0), (3.0, 2.0), (-3.0, 2.0), (-8.0, 3.0), (-3.0, 8.0)] {
        let o = intersect(&a, &arc((x, 0.0), r, 0.3, TAU), TOLERANCE);
        assert_eq!(o.points.len(), 1, "{x} {r} {o:?}");
        assert!(!o.points[0].crossing && (o.points[0].point.x.abs() - 5.0).abs() < 1e-6);
    }
    assert!(intersect(&a, &arc((0.0, 0.0), 4.0, 0.0, TAU), TOLERANCE).is_empty());
    let tangent = intersect(&line((-9.0, 5.0), (9.0, 5.0)), &a, TOLERANCE);
    assert_eq!((tangent.points.len(), tangent.points[0].crossing), (1, false));
    // The seam of a circle is no end: a line through it crosses.
    let through = intersect(&line((0.0, 0.0), (9.0, 0.0)), &a, TOLERANCE);
    assert_eq!((through.points.len(), through.points[0].crossing), (1, true));
}

#[test]
fn meetings_agree_with_dense_sampling_and_with_both_orders() {
    let mut r = rng(5);
    let (mut met, mut missed) = (0, 0);
    for round in 0..3000 {
        let (a, b) = (random_segment(&mut r), random_segment(&mut r));
        let o = intersect(&a, &b, TOLERANCE);
        let back = intersect(&b, &a, TOLERANCE);
        assert_eq!(o.points.len(), back.points.len(), "round {round}: {a:?} {b:?} {o:?} {back:?}");
        let turned = intersect(&a.reversed(), &b, TOLERANCE);
        assert_eq!(o.points.len(), turned.points.len(), "round {round}: {a:?} {b:?} {o:?} {turned:?}");
        for m in &o.points {
            assert!(a.at(m.a).distance(b.at(m.b)) <= 2.0 * TOLERANCE);
            assert!(m.point.distance(a.at(m.a)) <= 1e-9);
        }
        let nearest =
            (0..=400).map(|k| b.nearest(a.at(f64::from(k) / 400.0)).1).fold(f64::INFINITY, f64::min).sqrt();
        if o.is_empty() {
            missed += 1;
            assert!(nearest > 1e-5, "round {round}: missed a meeting {nearest} {a:?} {b:?}");
        } else {
            met += 1;
            assert!(nearest < a.length() / 400.0, "round {round}");
        }
    }
    assert!(met > 500 && missed > 500, "{met} {missed}");
}

/// A closed path of lines and arcs through random points around the origin, not crossing itself for small bulges.
fn blob(r: &mut Xoshiro256PlusPlus, center: DVec2, bulge: f64) -> Path {
    let n = r.random_range(3..9);
    let points: Vec<DVec2> = (0..n)
        .map(|i| center + math::unit(TAU * f64::from(i) / f64::from(n)) * r.random_range(3.0..10.0))
        .collect();
    let segments = (0..points.len())
        .map(|i| {
            let (a, b) = (points[i], points[(i + 1) % points.len()]);
            Arc::from_bulge(a, b, r.random_range(-bulge..bulge)).map_or(Segment::line(a, b), Segment::Arc)
        })
        .collect();
    Path::new(segments, true)
}

/// Winding number by summing angles over a dense polygon.
fn angle_sum(path: &Path, p: DVec2) -> i32 {
    let n = 2000;
    let mut sum = 0.0;
    for s in &path.segments {
        for k in 0..n {
            let (a, b) = (s.at(f64::from(k) / f64::from(n)), s.at(f64::from(k + 1) / f64::from(n)));
            sum += math::turn(a - p, b - p);
        }
    }
    #[allow(clippy::cast_possible_truncation, reason = "a few turns")]
    let turns = (sum / TAU).round() as i32;
    turns
}

#[test]
fn winding_agrees_with_the_sum_of_angles() {
    let mut r = rng(6);
    let mut inside = 0;
    for _ in 0..120 {
        let path = blob(&mut r, DVec2::ZERO, 1.5);
        for _ in 0..12 {
            let p = point(&mut r, 12.0);
            let near = path.segments.iter().map(|s| s.nearest(p).1).fold(f64::INFINITY, f64::min).sqrt();
            if near < 0.01 {
                continue;
            }
            let w = winding(&path, p);
            assert_eq!(w.number, angle_sum(&path, p), "{p} {path:?}");
            assert!(!w.on_edge);
            assert_eq!(winding(&path.reversed(), p).number, -w.number);
            inside += usize::from(w.is_inside());
        }
    }
    assert!(inside > 200, "{inside}");
}

#[test]
fn rays_through_vertices_and_along_tangents_are_counted_once() {
    // A square on its corner: the ray through the middle runs through two corners.
    let corners = [v(1.0, 0.0), v(0.0, 1.0), v(-1.0, 0.0), v(0.0, -1.0)];
    let square = Path::new((0..4).map(|i| Segment::line(corners[i], corners[(i + 1) % 4])).collect(), true);
    assert_eq!(winding(&square, v(0.0, 0.0)).number, 1);
    assert_eq!(winding(&square, v(-2.0, 0.0)).number, 0);
    assert_eq!(winding(&square, v(-2.0, 1.0)).number, 0);
    assert_eq!(winding(&square, v(-2.0, -1.0)).number, 0);
    // A circle's top and bottom, however it is cut.
    for start in [0.0, 0.5 * PI, PI, -0.5 * PI, 1.0] {
        for sweep in [TAU, -TAU] {
            let circle = Path::new(vec![arc((3.0, 4.0), 2.0, start, sweep)], true);
            let sign = if sweep > 0.0 { 1 } else { -1 };
            assert_eq!(winding(&circle, v(3.0, 4.0)).number, sign);
            for y in [2.0, 6.0, 4.0, 1.9, 6.1] {
                assert_eq!(winding(&circle, v(0.0, y)).number, 0, "start {start} y {y}");
                assert_eq!(winding(&circle, v(6.0, y)).number, 0);
            }
            assert!(winding(&circle, v(3.0, 6.0)).on_edge && winding(&circle, v(5.0, 4.0)).on_edge);
        }
    }
    // A slot: lines tangent to half circles, rays along both lines.
    let slot = Path::new(
        vec![
            line((0.0, -1.0), (4.0, -1.0)),
            arc((4.0, 0.0), 1.0, -PI / 2.0, PI),
            line((4.0, 1.0), (0.0, 1.0)),
            arc((0.0, 0.0), 1.0, PI / 2.0, PI),
        ],
        true,
    );
    for y in [-1.0, 1.0] {
        assert_eq!(winding(&slot, v(-3.0, y)).number, 0);
        assert!(winding(&slot, v(2.0, y)).on_edge);
    }
    assert_eq!(winding(&slot, v(-0.9, 0.0)).number, 1);
    assert_eq!(winding(&slot, v(4.9, 0.0)).number, 1);
    assert_eq!(winding(&slot, v(4.9, 0.9)).number, 0);
}

#[test]
fn an_interior_point_is_inside() {
    let mut r = rng(7);
    for _ in 0..300 {
        let c = point(&mut r, 100.0);
        let path = blob(&mut r, c, 0.3);
        let p = interior_point(&path).unwrap();
        assert!(winding(&path, p).is_inside());
    }
    assert_eq!(interior_point(&Path::new(vec![], true)), None);
    let flat = Path::new(vec![line((0.0, 0.0), (1.0, 0.0)), line((1.0, 0.0), (0.0, 0.0))], true);
    assert_eq!(interior_point(&flat), None);
}

#[test]
fn box_index_finds_what_brute_force_finds() {
    let mut r = rng(9);
    for n in [0, 1, 5, 300] {
        let mut boxes: Vec<Aabb> = (0..n)
            .map(|_| {
                let p = point(&mut r, 50.0);
                Aabb::of(p).with(p + v(r.random_range(0.0..5.0), r.random_range(0.0..5.0)))
            })
            .collect();
        if n > 2 {
            boxes[1] = Aabb::EMPTY;
            boxes[2] = Aabb { min: v(f64::NAN, 0.0), max: v(1.0, 1.0) };
        }
        let index = BoxIndex::new(boxes.iter().copied());
        for _ in 0..50 {
            let p = point(&mut r, 50.0);
            let area = Aabb::of(p).with(p + v(r.random_range(0.0..30.0), r.random_range(0.0..30.0)));
            let brute: Vec<usize> =
                (0..n).filter(|i| boxes[*i].min.is_finite() && boxes[*i].overlaps(&area)).collect();
            assert_eq!(index.query(area), brute);
            let mut first = None;
            index.visit(area, |i| {
                first = Some(i);
                false
            });
            assert_eq!(first.is_some(), !brute.is_empty());
        }
    }
}

/// A disc, a bow tie, whose lobes are run around in different directions, and a pentagram, whose middle is run around twice.
#[test]
fn the_filled_area_counts_every_lobe_once() {
    let through = |corners: &[DVec2]| {
        let next = corners.iter().cycle().skip(1);
        Path::new(corners.iter().zip(next).map(|(a, b)| Segment::line(*a, *b)).collect(), true)
    };
    let disc = Path::new(vec![Segment::Arc(Arc::circle(DVec2::ZERO, 10.0))], true);
    let bow_tie = through(&[v(0.0, 0.0), v(10.0, 10.0), v(10.0, 0.0), v(0.0, 10.0)]);
    let tip = |k: u32| math::unit(PI / 2.0 + 4.0 * PI / 5.0 * f64::from(k)) * 10.0;
    let star = through(&[0, 1, 2, 3, 4].map(tip));
    // Ten triangles from the middle to a tip and to the inner corner beside it.
    let inner = 10.0 * math::sin(PI / 10.0) / math::sin(7.0 * PI / 10.0);
    let area = 10.0 * 0.5 * 10.0 * inner * math::sin(PI / 5.0);
    for (path, wanted) in [(disc, 100.0 * PI), (bow_tie, 50.0), (star, area)] {
        let is = filled_area(&path);
        assert!((is / wanted - 1.0).abs() < 1e-4, "{is} instead of {wanted}");
    }
}
