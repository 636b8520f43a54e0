//! Containment, parts, orientation.

use super::sketch::*;
use kerfway::finding::Code;
use kerfway::geometry::{Path, Segment, math};
use kerfway::sheet::Sheet;
use rand::{RngExt, SeedableRng};
use rand_xoshiro::Xoshiro256PlusPlus;

fn inside(s: &Sheet) -> Vec<Option<u32>> {
    s.contours.iter().map(|c| c.inside).collect()
}

#[test]
fn parts_in_holes_are_parts_of_their_own() {
    let s = sheet([
        circle(50.0, 50.0, 5.0),
        rect(40.0, 40.0, 20.0, 20.0),
        rect(0.0, 0.0, 100.0, 100.0),
        rect(20.0, 20.0, 60.0, 60.0),
        circle(10.0, 10.0, 4.0),
        rect(200.0, 0.0, 10.0, 10.0),
    ]);
    assert_eq!(inside(&s), [Some(1), Some(3), None, Some(2), Some(2), None]);
    assert_eq!(s.contours.iter().map(|c| c.depth).collect::<Vec<_>>(), [3, 2, 0, 1, 1, 0]);
    let parts: Vec<_> = s.parts.iter().map(|p| (p.outer, p.holes.clone(), p.inside)).collect();
    assert_eq!(parts, [(1, vec![0], Some(1)), (2, vec![3, 4], None), (5, vec![], None)]);
}

#[test]
fn contours_that_touch_nest_by_their_inside() {
    let s = sheet([
        rect(0.0, 0.0, 100.0, 100.0),
        circle(50.0, 50.0, 50.0), // touches all four sides
        polyline(&[(100.0, 50.0), (50.0, 100.0), (0.0, 50.0), (50.0, 0.0)], true),
    ]);
    let inner: Vec<_> = s.contours.iter().filter(|c| c.path.closed).map(|c| c.inside).collect();
    assert_eq!(inner, [None, Some(0), Some(1)]);
    let s = sheet([rect(0.0, 0.0, 10.0, 10.0), rect(10.0, 10.0, 10.0, 10.0), circle(-3.0, 5.0, 3.0)]);
    assert_eq!(inside(&s), [None, None, None]);
}

#[test]
fn a_contour_in_a_notch_is_not_inside() {
    let c = polyline(
        &[
            (0.0, 0.0),
            (50.0, 0.0),
            (50.0, 10.0),
            (10.0, 10.0),
            (10.0, 40.0),
            (50.0, 40.0),
            (50.0, 50.0),
            (0.0, 50.0),
        ],
        true,
    );
    let s = sheet([c, circle(30.0, 25.0, 10.0), circle(5.0, 25.0, 3.0)]);
    assert_eq!(inside(&s), [None, None, Some(0)]);
}

#[test]
fn arcs_are_exact_where_their_chords_would_lie() {
    // A hole between the chord and the arc of a D, and one beyond the arc.
    let d = [arc(0.0, 0.0, 50.0, -90.0, 180.0), line(0.0, 50.0, 0.0, -50.0)];
    let s = sheet(d.into_iter().chain([
        circle(49.0, 0.0, 0.9),
        circle(36.0, 36.0, 0.5),
        circle(35.0, 34.0, 0.5),
    ]));
    assert_eq!(inside(&s), [None, Some(0), None, Some(0)]);
}

#[test]
fn open_contours_have_the_contour_around_them() {
    let s = sheet([
        rect(0.0, 0.0, 100.0, 100.0),
        line(20.0, 20.0, 80.0, 80.0),
        line(0.0, 50.0, 30.0, 40.0),
        line(0.0, 60.0, -30.0, 40.0),
    ]);
    assert_eq!(inside(&s), [None, Some(0), Some(0), None]);
    assert_eq!(s.parts[0].holes, [1, 2]);
}

#[test]
fn a_hole_that_breaks_through_an_edge_is_cut_before_the_edge() {
    let s = sheet([rect(0.0, 0.0, 100.0, 100.0), circle(100.0, 50.0, 5.0), rect(120.0, 0.0, 50.0, 50.0)]);
    assert_eq!(inside(&s), [None, None, None], "half of it lies beyond the box");
    let notched = polyline(&[(0.0, 0.0), (100.0, 0.0), (100.0, 100.0), (50.0, 60.0), (0.0, 100.0)], true);
    let s = sheet([notched, circle(50.0, 63.0, 4.0)]);
    assert_eq!(inside(&s), [None, Some(0)]);
}

#[test]
fn a_contour_inside_two_crossing_contours_has_both_as_ancestors() {
    let s = sheet([rect(0.0, 0.0, 100.0, 50.0), rect(60.0, -40.0, 30.0, 120.0), circle(75.0, 25.0, 5.0)]);
    assert_eq!(inside(&s), [None, Some(0), Some(1)]);
}

/// Nested circles and rectangles at random: each free place is filled again.
fn nested(rng: &mut Xoshiro256PlusPlus, x: f64, y: f64, size: f64, depth: u32, out: &mut Vec<Path>) {
    let shape = if rng.random_bool(0.5) {
        circle_from(x, y, size * 0.5, rng.random_range(0.0..6.0))
    } else {
        rect(x - size * 0.35, y - size * 0.35, size * 0.7, size * 0.7)
    };
    out.push(shape);
    if depth == 0 {
        return;
    }
    let quarter = size * 0.16;
    for (dx, dy) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
        if rng.random_bool(0.7) {
            let smaller = size * 0.3 * rng.random_range(0.5..1.0);
            nested(rng, x + dx * quarter, y + dy * quarter, smaller, depth - 1, out);
        }
    }
}

fn shuffle<T>(rng: &mut Xoshiro256PlusPlus, v: &mut [T]) {
    for i in (1..v.len()).rev() {
        v.swap(i, rng.random_range(0..=i));
    }
}

#[test]
fn nesting_equals_brute_force_on_random_drawings() {
    for seed in 0..30 {
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(seed);
        let mut paths = Vec::new();
        for i in 0..4 {
            nested(&mut rng, f64::from(i) * 120.0, 0.0, 100.0, 4, &mut paths);
        }
        shuffle(&mut rng, &mut paths);
        let s = sheet(paths.clone());
        assert_eq!(s.contours.len(), paths.len());
        for (i, c) in s.contours.iter().enumerate() {
            // Brute force: the smallest of all contours that contain a point of this one.
            let around = s
                .contours
                .iter()
                .enumerate()
                .filter(|&(j, o)| j != i && o.area > c.area && holds(&o.path, c.path.start().unwrap()));
            let expected =
                around.min_by(|a, b| a.1.area.total_cmp(&b.1.area)).map(|(j, _)| u32::try_from(j).unwrap());
            assert_eq!(c.inside, expected, "seed {seed} contour {i}");
        }
    }
}

/// Whether the circle or upright rectangle contains `q`, by definition.
fn holds(path: &Path, q: kerfway::geometry::DVec2) -> bool {
    match path.segments[..] {
        [Segment::Arc(a)] => q.distance(a.center) < a.radius(),
        _ => path.bounds().contains(q),
    }
}

#[test]
fn ten_thousand_circles_around_each_other() {
    let n = 10_000_u32;
    let s = sheet((1..=n).map(|i| circle(0.0, 0.0, f64::from(i))));
    for (i, c) in (1..).zip(&s.contours) {
        assert_eq!(c.inside, (i < n).then_some(i));
        assert_eq!(c.depth, n - i);
    }
    assert_eq!(s.parts.len(), 5_000);
}

/// A C of width 1 that opens to the right, around everything within `r` of the origin.
fn c_shape(r: f64) -> Path {
    let (o, w) = (r + 1.0, 3_000.0);
    polyline(&[(-o, -o), (w, -o), (w, -r), (-r, -r), (-r, r), (w, r), (w, o), (-o, o)], true)
}

#[test]
fn hostile_contours_that_interlock_are_given_up_and_reported() {
    let within =
        |n: i32| sheet((0..n).map(|i| c_shape(10.0 + 2.0 * f64::from(i))).chain([circle(0.0, 0.0, 5.0)]));
    let few = within(200);
    assert!(few.findings.is_empty() && few.contours.iter().all(|c| c.inside.is_none()));
    let many = within(500);
    assert_eq!(findings(&many, Code::NotAllChecked).len(), 1);
    assert!(many.contours.iter().all(|c| c.inside.is_none()));
}

#[test]
fn ten_thousand_holes_in_a_contour_of_ten_thousand_elements() {
    let n = 10_000;
    let rim: Vec<(f64, f64)> = (0..n)
        .map(|i| {
            let r = 1000.0 + if i % 2 == 0 { 20.0 } else { 0.0 };
            let rim = r * math::unit(std::f64::consts::TAU * f64::from(i) / f64::from(n));
            (rim.x, rim.y)
        })
        .collect();
    let holes = (0..100).flat_map(|i| {
        (0..100).map(move |j| circle(f64::from(i) * 13.0 - 640.0, f64::from(j) * 13.0 - 640.0, 4.0))
    });
    let s = sheet([polyline(&rim, true)].into_iter().chain(holes));
    assert_eq!(s.contours.len(), 10_001);
    assert!(s.contours[1..].iter().all(|c| c.inside == Some(0)));
    assert_eq!(s.parts[0].holes.len(), 10_000);
}
