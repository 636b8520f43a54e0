//! A single outline and its offset line.

use super::made::{KERF, bulged, close, kerfed, machine, points, rounded, started, told};
use crate::testkit::outlines::drawing;
use crate::testkit::plates::rectangle;
use kerfway::finding::Finding;
use kerfway::geometry::{DVec2, Segment};
use std::f64::consts::PI;

#[test]
fn without_a_kerf_the_drawing_is_the_path() {
    let job = started(drawing(&[rectangle([0.0, 0.0, 10.0, 5.0])]), machine(0.0));
    assert_eq!(job.beam_sheet().contours, job.sheet().contours);
    assert!(job.beam_paths().is_none());
}

#[test]
fn squares_grow_and_holes_shrink_by_half_a_kerf() {
    let job = kerfed(&[rectangle([10.0, 20.0, 30.0, 15.0]), rectangle([15.0, 25.0, 8.0, 6.0])]);
    let [outer, hole] = &job.beam_sheet().contours[..] else { panic!() };
    assert_eq!(points(&outer.path), [[9.8, 19.8], [9.8, 35.2], [40.2, 19.8], [40.2, 35.2]]);
    assert_eq!(points(&hole.path), [[15.2, 25.2], [15.2, 30.8], [22.8, 25.2], [22.8, 30.8]]);
    assert!(close(outer.length, 2.0 * (30.4 + 15.4)) && close(hole.length, 2.0 * (7.6 + 5.6)));
    assert!(close(outer.path.area(), 30.4 * 15.4) && close(hole.path.area(), -7.6 * 5.6));
    // The finished part is as drawn.
    assert!(close(outer.area, 450.0) && close(hole.area, 48.0));
    assert_eq!((hole.inside, job.beam_sheet().parts.clone()), (Some(0), job.sheet().parts.clone()));
    let plan = job.plan().unwrap();
    assert!(close(plan.summary.cut_length, 91.6 + 26.4));
    assert_eq!(told(&job), Vec::<&Finding>::new());
}

#[test]
fn circles_stay_circles() {
    let job =
        started(bulged(&[], &[[50.0, 40.0, 10.0], [50.0, 40.0, 4.0], [80.0, 40.0, 0.3]]), machine(KERF));
    let radii: Vec<f64> = job
        .beam_sheet()
        .contours
        .iter()
        .map(|c| match c.path.segments[..] {
            [Segment::Arc(a)] if a.is_circle() => a.radius(),
            _ => panic!("{:?}", c.path),
        })
        .collect();
    assert!(radii.iter().zip([10.2, 3.8, 0.5]).all(|(a, b)| close(*a, b)), "{radii:?}");
    assert!(close(job.beam_sheet().contours[1].length, 2.0 * PI * 3.8));
}

#[test]
fn rounded_rectangles_keep_their_arcs() {
    let (outer, hole) = (rounded([0.0, 0.0, 40.0, 30.0, 5.0]), rounded([10.0, 10.0, 20.0, 8.0, 2.0]));
    let job = started(bulged(&[&outer, &hole], &[]), machine(KERF));
    let length = |w: f64, h: f64, r: f64| 2.0 * (w + h) - 8.0 * r + 2.0 * PI * r;
    let area = |w: f64, h: f64, r: f64| w * h - (4.0 - PI) * r * r;
    for (c, [w, h, r], sign) in [
        (&job.beam_sheet().contours[0], [40.4, 30.4, 5.2], 1.0),
        (&job.beam_sheet().contours[1], [19.6, 7.6, 1.8], -1.0),
    ] {
        assert_eq!(c.path.segments.len(), 8);
        assert!(close(c.length, length(w, h, r)), "{} {}", c.length, length(w, h, r));
        assert!(close(c.path.area(), sign * area(w, h, r)));
        let arcs = c
            .path
            .segments
            .iter()
            .filter_map(|s| if let Segment::Arc(a) = s { Some(a.radius()) } else { None });
        assert!(arcs.into_iter().all(|found| close(found, r)));
    }
}

#[test]
fn an_l_has_a_corner_inside() {
    let l: Vec<DVec2> = [(0.0, 0.0), (30.0, 0.0), (30.0, 10.0), (10.0, 10.0), (10.0, 40.0), (0.0, 40.0)]
        .map(|(x, y)| DVec2::new(x, y))
        .to_vec();
    let c = &kerfed(&[l]).beam_sheet().contours[0].clone();
    let wanted = [[-0.2, -0.2], [-0.2, 40.2], [10.2, 10.2], [10.2, 40.2], [30.2, -0.2], [30.2, 10.2]];
    assert_eq!(points(&c.path), wanted);
    // As long as the box around it.
    assert!(close(c.length, 2.0 * (30.4 + 40.4)));
    assert!(close(c.path.area(), 30.4 * 10.4 + 10.4 * 30.0));
}

#[test]
fn sharp_corners_are_rounded_beyond_the_limit() {
    // Points of 40 and of 20 degrees: 2.92 and 5.76 halves of a kerf.
    for (degrees, rounds) in [(40.0_f64, 0), (20.0, 1)] {
        let half = (degrees / 2.0).to_radians();
        let outline = vec![
            DVec2::new(0.0, 0.0),
            DVec2::new(50.0, -50.0 * half.tan()),
            DVec2::new(50.0, 50.0 * half.tan()),
        ];
        let c = &kerfed(&[outline]).beam_sheet().contours[0].clone();
        let arcs = c.path.segments.iter().filter(|s| matches!(s, Segment::Arc(_))).count();
        assert_eq!(arcs, rounds, "{degrees}");
        let tip = c.bounds.min.x;
        let wanted = if rounds == 0 { -0.2 / half.sin() } else { -0.2 };
        assert!(close(tip, wanted), "{tip} {wanted}");
    }
}
