//! Ends joined, gaps closed, branches, open contours.

use super::sketch::*;
use kerfway::finding::Code;
use kerfway::geometry::{DVec2, Segment, math};
use kerfway::sheet::SheetOptions;

#[test]
fn loose_lines_in_any_order_and_direction_make_one_contour() {
    let l = [
        line(0.0, 0.0, 20.0, 0.0),
        line(0.0, 10.0, 20.0, 10.0),
        line(20.0, 10.0, 20.0, 0.0),
        line(0.0, 0.0, 0.0, 10.0),
    ];
    let s = sheet(l);
    assert_eq!(counts(&s), (1, 0));
    close(s.contours[0].area, 200.0);
    close(s.contours[0].length, 60.0);
    assert!(s.findings.is_empty());
    assert_eq!(s.parts.len(), 1);
}

#[test]
fn a_gap_within_the_tolerance_is_closed_and_reported_with_position_and_size() {
    let s = sheet([
        line(0.0, 0.0, 20.0, 0.0),
        line(20.0, 0.03, 20.0, 10.0),
        line(20.0, 10.0, 0.0, 10.0),
        line(0.0, 10.0, 0.0, 0.0),
    ]);
    assert_eq!(counts(&s), (1, 0));
    assert_eq!(s.contours[0].path.segments.len(), 4, "two lines meet in the middle of the gap");
    assert_eq!(s.contours[0].path.segments[0].end(), p(20.0, 0.015));
    let told = findings(&s, Code::GapClosed);
    assert_eq!((told.len(), told[0].count), (1, 1));
    assert_eq!(told[0].at, Some(p(20.0, 0.015)));
    assert!(told[0].message.contains("0.0300 mm"), "{}", told[0].message);
    assert_eq!(s.findings.len(), 1);
}

#[test]
fn a_line_end_moves_to_an_arc_and_two_arcs_are_joined_by_a_short_line() {
    let s = sheet([arc(0.0, 0.0, 10.0, 0.0, 180.0), line(-10.0, -0.02, 10.0, -0.02)]);
    assert_eq!(counts(&s), (1, 0));
    assert_eq!(findings(&s, Code::GapClosed)[0].count, 2);
    let Segment::Arc(a) = s.contours[0].path.segments[0] else { panic!("the arc comes first") };
    close(a.radius(), 10.0);
    let s = sheet([arc(0.0, 0.0, 10.0, 0.0, 180.0), arc(0.0, -0.04, 10.0, 180.0, 180.0)]);
    assert_eq!(counts(&s), (1, 0));
    assert_eq!(s.contours[0].path.segments.len(), 4);
    close(s.contours[0].length, 20.0 * std::f64::consts::PI + 0.08);
}

#[test]
fn rounding_gaps_are_joined_without_a_finding() {
    let s = sheet([
        line(0.0, 0.0, 20.0, 4e-7),
        line(20.0, 0.0, 20.0, 10.0),
        line(20.0, 10.0, 0.0, 10.0),
        line(3e-7, 10.0, 0.0, 0.0),
    ]);
    assert_eq!(counts(&s), (1, 0));
    assert!(s.findings.is_empty());
}

#[test]
fn the_best_match_comes_first_not_the_first_found() {
    // The end at (10, 0) has a false friend 0.04 away, drawn first, and its true one 0.01 away, drawn last.
    let s = sheet([line(10.0, 0.04, 10.0, 20.0), line(0.0, 0.0, 10.0, 0.0), line(10.01, 0.0, 30.0, 0.0)]);
    assert_eq!(counts(&s), (0, 2));
    close(s.contours[0].length, 19.96);
    close(s.contours[1].length, 30.0);
    assert_eq!(findings(&s, Code::Branch).len(), 1, "the one left over is told");
}

#[test]
fn equal_distances_are_decided_by_layer_then_by_the_straighter_course() {
    let arms = |a: &'static str, b: &'static str| {
        drawing([
            ("A", line(0.0, 0.0, 10.0, 0.0)),
            (a, line(10.0, 0.0, 20.0, 0.0)),
            (b, line(10.0, 0.0, 10.0, 9.0)),
        ])
    };
    let s = arranged(&arms("A", "A"));
    assert_eq!(s.contours.iter().map(|c| c.length).collect::<Vec<_>>(), [20.0, 9.0]);
    let s = arranged(&arms("B", "A"));
    assert_eq!(s.contours.iter().map(|c| c.length).collect::<Vec<_>>(), [19.0, 10.0]);
    assert_eq!(findings(&s, Code::Branch).len(), 1);
    assert_eq!(findings(&s, Code::Branch)[0].at, Some(p(10.0, 0.0)));
}

#[test]
fn a_near_miss_is_left_open_and_reported() {
    let s = sheet([
        line(0.0, 0.0, 20.0, 0.0),
        line(20.0, 0.2, 20.0, 10.0),
        line(20.0, 10.0, 0.0, 10.0),
        line(0.0, 10.0, 0.0, 0.0),
    ]);
    assert_eq!(counts(&s), (0, 1));
    let told = findings(&s, Code::GapLeft);
    assert_eq!(told.len(), 1);
    assert_eq!(told[0].at, Some(p(20.0, 0.1)));
    assert!(told[0].message.contains(" 0.2 mm"));
    assert_eq!(findings(&s, Code::OpenContour).len(), 1);
    let wider = SheetOptions { join_tolerance: 0.25, ..SheetOptions::default() };
    let s = sheet_with(
        [
            line(0.0, 0.0, 20.0, 0.0),
            line(20.0, 0.2, 20.0, 10.0),
            line(20.0, 10.0, 0.0, 10.0),
            line(0.0, 10.0, 0.0, 0.0),
        ],
        &wider,
    );
    assert_eq!(counts(&s), (1, 0));
}

#[test]
fn an_end_on_the_middle_of_another_contour_is_no_join() {
    let s = sheet([rect(0.0, 0.0, 20.0, 10.0), line(5.0, 10.0, 5.0, 30.0)]);
    assert_eq!(counts(&s), (1, 1));
    assert!(findings(&s, Code::Branch).is_empty());
}

#[test]
fn at_a_branch_loops_close_first_and_all_length_is_cut() {
    // A square of lines with a tail in line with one of its sides.
    let mut lines = exploded(&rect(0.0, 0.0, 20.0, 10.0));
    lines.insert(0, line(50.0, 0.0, 20.0, 0.0));
    let s = sheet(lines);
    assert_eq!(counts(&s), (1, 1));
    close(total_length(&s), 90.0);
    close(s.contours[1].area, 200.0);
    // Only the square can be meant, so there is nothing to check at the branch.
    assert!(findings(&s, Code::Branch).is_empty());
    assert_eq!(findings(&s, Code::OpenContour).len(), 1);
}

#[test]
fn four_ends_in_a_point_continue_straight() {
    let s = sheet([
        line(0.0, 0.0, 10.0, 10.0),
        line(20.0, 0.0, 10.0, 10.0),
        line(10.0, 10.0, 20.0, 20.0),
        line(10.0, 10.0, 0.0, 20.0),
    ]);
    assert_eq!(counts(&s), (0, 2));
    for c in &s.contours {
        close(c.length, 800.0_f64.sqrt());
        assert!(c.path.segments[0].tangent(1.0).dot(c.path.segments[1].tangent(0.0)) > 0.999);
    }
}

#[test]
fn an_arc_that_comes_nearly_round_closes_on_itself_and_a_short_line_does_not() {
    let s = sheet([arc(0.0, 0.0, 10.0, 0.0, 359.9), line(50.0, 0.0, 50.03, 0.0)]);
    assert_eq!(counts(&s), (1, 1));
    assert_eq!(s.contours[0].path.segments.len(), 2);
    close(s.contours[1].length, 0.03);
}

#[test]
fn one_contour_over_several_layers_goes_to_the_one_with_most_of_it() {
    let mut sides = exploded(&rect(0.0, 0.0, 20.0, 10.0));
    let last = sides.pop().unwrap();
    let large = sides.into_iter().map(|p| ("LARGE", p));
    let s = arranged(&drawing([("SMALL", last)].into_iter().chain(large)));
    assert_eq!(counts(&s), (1, 0));
    assert_eq!(s.layers[s.contours[0].layer as usize].name, "LARGE");
    let told = findings(&s, Code::SeveralLayers);
    assert_eq!(told.len(), 1);
    assert!(told[0].message.contains("SMALL, LARGE"), "{}", told[0].message);
    assert_eq!(s.layers.iter().map(|l| l.contours).collect::<Vec<_>>(), [0, 1]);
}

/// The direction of the spoke `i` of `n`.
fn spoke(i: i32, n: i32) -> DVec2 {
    math::unit(std::f64::consts::TAU * f64::from(i) / f64::from(n))
}

#[test]
fn hostile_all_ends_in_one_point() {
    let n = 20_000;
    let s = sheet((0..n).map(|i| {
        let out = spoke(i, n);
        line(0.0, 0.0, 1000.0 * out.x, 1000.0 * out.y)
    }));
    assert_eq!(s.contours.len(), 10_000);
    close(total_length(&s) / f64::from(n), 1000.0);
    assert_eq!(findings(&s, Code::Branch)[0].message.split(' ').next(), Some("20000"));
    let straight = |c: &kerfway::sheet::Contour| {
        c.path.segments[0].tangent(1.0).dot(c.path.segments[1].tangent(0.0)) > 0.999_999
    };
    assert!(s.contours.iter().all(straight));
}

#[test]
fn hostile_all_ends_within_the_tolerance() {
    let n = 20_000;
    let s = sheet((0..n).map(|i| {
        let out = spoke(i, n);
        let r = 0.01 + 0.000_000_3 * f64::from(i);
        line(r * out.x, r * out.y, 1000.0 * out.x, 1000.0 * out.y)
    }));
    assert_eq!(s.contours.len(), 10_000);
}
