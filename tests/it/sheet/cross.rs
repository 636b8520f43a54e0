//! Contours that cross themselves and each other, and those that only touch.

use super::sketch::*;
use kerfway::finding::Code;

#[test]
fn a_figure_of_eight_crosses_itself_once() {
    let s = sheet([polyline(&[(0.0, 0.0), (20.0, 10.0), (20.0, 0.0), (0.0, 10.0)], true)]);
    assert!(s.contours[0].self_crossing);
    let told = findings(&s, Code::SelfCrossing);
    assert_eq!((told.len(), told[0].count), (1, 1));
    assert!(told[0].at.unwrap().distance(p(10.0, 5.0)) < 1e-9);
    assert_eq!(s.findings.len(), 1);
}

#[test]
fn a_crossing_through_corners_is_one_crossing() {
    let corners = [(0.0, 0.0), (10.0, 5.0), (20.0, 10.0), (20.0, 0.0), (10.0, 5.0), (0.0, 10.0)];
    let s = sheet([polyline(&corners, true)]);
    assert_eq!(findings(&s, Code::SelfCrossing)[0].count, 1);
    let s = sheet([
        polyline(&[(0.0, 0.0), (10.0, 5.0), (20.0, 0.0)], false),
        polyline(&[(10.0, -5.0), (10.0, 5.0), (10.0, 15.0)], false),
    ]);
    assert_eq!(findings(&s, Code::Crossing).len(), 1);
}

#[test]
fn contours_that_cross_are_reported_with_their_position() {
    let s = sheet([rect(0.0, 0.0, 20.0, 10.0), circle(20.0, 5.0, 3.0), line(5.0, 5.0, 5.0, 30.0)]);
    let told = findings(&s, Code::Crossing);
    assert_eq!(told.iter().map(|f| f.count).collect::<Vec<_>>(), [2, 1]);
    assert_eq!(told[1].at, Some(p(5.0, 10.0)));
    assert!(!s.contours.iter().any(|c| c.self_crossing));
}

#[test]
fn touching_is_no_crossing() {
    let s = sheet([
        rect(0.0, 0.0, 20.0, 10.0),
        circle(10.0, 5.0, 5.0),                                    // tangent from inside
        line(20.0, 5.0, 22.0, 5.0),                                // an end on a side
        line(5.0, 10.005, 5.0, 30.0),                              // nearly
        polyline(&[(-5.0, -5.0), (0.0, 0.0), (-5.0, 5.0)], false), // corner to corner
        polyline(&[(8.0, -6.0), (10.0, 0.0), (12.0, -6.0)], true), // corner to side
        polyline(&[(25.0, 0.0), (20.0, 10.0), (30.0, 10.0), (27.0, 3.0)], true), // corner to corner
    ]);
    assert_eq!(s.contours.len(), 7);
    assert!(findings(&s, Code::Crossing).is_empty() && findings(&s, Code::SelfCrossing).is_empty());
}

#[test]
fn an_outline_that_touches_itself_does_not_cross_itself() {
    let s = sheet([polyline(
        &[(0.0, 0.0), (10.0, 10.0), (20.0, 0.0), (20.0, 20.0), (10.0, 10.0), (0.0, 20.0)],
        true,
    )]);
    assert!(!s.contours[0].self_crossing);
}

#[test]
fn arcs_cross_where_their_chords_do_not() {
    let s = sheet([arc(0.0, 0.0, 10.0, 0.0, 180.0), line(-8.0, 4.0, 8.0, 9.0)]);
    assert_eq!(findings(&s, Code::Crossing)[0].count, 1);
    let s = sheet([arc(0.0, 0.0, 10.0, 0.0, 180.0), line(-8.0, 1.0, 8.0, 5.0)]);
    assert!(findings(&s, Code::Crossing).is_empty());
}

#[test]
fn hostile_everything_crosses_everything() {
    let across = (0..2_000).map(|i| line(0.0, f64::from(i), 2_000.0, f64::from(i) + 0.5));
    let up = (0..2_000).map(|i| line(f64::from(i), -5.0, f64::from(i) + 0.5, 2_005.0));
    let s = sheet(across.chain(up));
    assert_eq!(s.contours.len(), 4_000);
    assert_eq!(findings(&s, Code::NotAllChecked).len(), 2, "of enclosed areas and of crossings");
    assert!(findings(&s, Code::Crossing).len() == 200 && !findings(&s, Code::More).is_empty());
}
