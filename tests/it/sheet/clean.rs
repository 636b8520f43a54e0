//! Every line and arc once: zero lengths, copies, overlaps.

use super::sketch::*;
use kerfway::finding::Code;
use std::f64::consts::{PI, TAU};

#[test]
fn elements_without_length_are_dropped_and_reported() {
    let s = sheet([line(0.0, 0.0, 10.0, 0.0), line(3.0, 3.0, 3.0, 3.0), circle(5.0, 5.0, 0.0)]);
    assert_eq!(counts(&s), (0, 1));
    let told = findings(&s, Code::ZeroLength);
    assert_eq!(told.len(), 2);
    assert_eq!(told[0].at, Some(p(3.0, 3.0)));
    assert_eq!(told[0].handle.as_deref(), Some("101"));
}

#[test]
fn a_polyline_with_doubled_vertices_stays_one_closed_contour() {
    let s =
        sheet([polyline(&[(0.0, 0.0), (10.0, 0.0), (10.0, 0.0), (10.0, 8.0), (0.0, 8.0), (0.0, 0.0)], true)]);
    assert_eq!(counts(&s), (1, 0));
    close(s.contours[0].area, 80.0);
    assert_eq!(s.contours[0].path.segments.len(), 4);
    let told = findings(&s, Code::ZeroLength);
    assert_eq!((told.len(), told[0].count), (1, 2));
}

#[test]
fn exact_and_reversed_copies_are_removed() {
    let square = rect(0.0, 0.0, 20.0, 10.0);
    let s = sheet([
        square.clone(),
        square.clone(),
        square.reversed(),
        line(30.0, 0.0, 40.0, 0.0),
        line(40.0, 0.0, 30.0, 0.0),
    ]);
    assert_eq!(counts(&s), (1, 1));
    close(total_length(&s), 70.0);
    let told = findings(&s, Code::DuplicateRemoved);
    assert_eq!(told.iter().map(|f| f.handle.as_deref().unwrap()).collect::<Vec<_>>(), ["101", "102", "104"]);
    assert_eq!(told.iter().map(|f| f.count).collect::<Vec<_>>(), [4, 4, 1]);
}

#[test]
fn a_polyline_square_over_four_lines_of_the_same_square_is_one_contour() {
    let square = rect(0.0, 0.0, 20.0, 10.0);
    let mut both_ways = exploded(&square);
    both_ways.push(square.clone());
    for shapes in [both_ways.clone(), both_ways.into_iter().rev().collect()] {
        let s = sheet(shapes);
        assert_eq!(counts(&s), (1, 0));
        close(total_length(&s), 60.0);
        assert_eq!(findings(&s, Code::DuplicateRemoved).len(), 4);
        assert_eq!(s.findings.len(), 4);
    }
}

#[test]
fn collinear_overlaps_leave_the_union() {
    let s = sheet([
        line(0.0, 5.0, 10.0, 5.0),
        line(18.0, 5.0, 8.0, 5.0),
        line(16.0, 5.0, 30.0, 5.0),
        line(2.0, 5.0, 3.0, 5.0),
    ]);
    assert_eq!(counts(&s), (0, 1));
    close(total_length(&s), 30.0);
    let told = findings(&s, Code::OverlapRemoved);
    assert_eq!(told.len(), 2);
    assert!(told[0].message.starts_with("4 mm of this LINE"), "{}", told[0].message);
    assert!(told[1].message.starts_with("This LINE lies wholly along"), "{}", told[1].message);
}

#[test]
fn slanted_overlaps_with_rounded_coordinates_leave_the_union() {
    // On the line y = x / 3, written with six decimals.
    let at = |x: f64| (x, (x / 3.0 * 1e6).round() / 1e6);
    let between = |a: f64, b: f64| polyline(&[at(a), at(b)], false);
    let s = sheet([between(0.0, 100.0), between(250.0, 90.0), between(240.0, 400.0)]);
    assert_eq!(counts(&s), (0, 1));
    close((total_length(&s) - (400.0_f64 * 400.0 / 0.9).sqrt()).abs() * 0.1, 0.0);
}

#[test]
fn a_circle_drawn_twice_with_different_start_is_one() {
    let s = sheet([circle_from(5.0, 5.0, 3.0, 0.0), circle_from(5.0, 5.0, 3.0, 2.1)]);
    assert_eq!(counts(&s), (1, 0));
    close(total_length(&s), 3.0 * TAU);
    assert_eq!(findings(&s, Code::DuplicateRemoved).len(), 1);
}

#[test]
fn two_half_circles_over_a_circle_are_one_circle() {
    let halves = [arc(5.0, 5.0, 3.0, 30.0, 180.0), arc(5.0, 5.0, 3.0, 210.0, 180.0)];
    for order in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        let all = [halves[0].clone(), halves[1].clone(), circle(5.0, 5.0, 3.0)];
        let s = sheet(order.map(|i: usize| all[i].clone()));
        assert_eq!(counts(&s), (1, 0));
        assert_eq!(s.contours[0].path.segments.len(), 1, "the circle stays whole");
        close(total_length(&s), 3.0 * TAU);
        assert_eq!(findings(&s, Code::OverlapRemoved).len(), 2);
    }
}

#[test]
fn co_circular_overlaps_leave_the_union() {
    let s = sheet([arc(0.0, 0.0, 10.0, 300.0, 100.0), arc(0.0, 0.0, 10.0, 120.0, -100.0)]);
    assert_eq!(counts(&s), (0, 1));
    close(total_length(&s), 10.0 * 180.0_f64.to_radians());
    assert_eq!(findings(&s, Code::OverlapRemoved).len(), 1);
    let s = sheet([arc(0.0, 0.0, 10.0, 10.0, 200.0), arc(0.0, 0.0, 10.0, 190.0, 220.0)]);
    assert_eq!(counts(&s), (1, 0), "two arcs that together come round");
    close(total_length(&s), 10.0 * TAU);
}

#[test]
fn sides_of_a_closed_shape_outrank_a_longer_line_along_them() {
    let long = line(-50.0, 0.0, 80.0, 0.0);
    let square = rect(0.0, 0.0, 20.0, 10.0);
    for shapes in [vec![long.clone(), square.clone()], vec![square.clone(), long.clone()]] {
        let s = sheet(shapes);
        assert_eq!(counts(&s), (1, 2));
        close(total_length(&s), 60.0 + 110.0);
    }
    let loose = exploded(&square).into_iter().chain([long]);
    let s = sheet(loose);
    assert_eq!(counts(&s), (1, 2), "so do sides drawn as lines");
    close(s.contours[0].area, 200.0);
    close(total_length(&s), 60.0 + 110.0);
}

#[test]
fn neighbours_that_share_a_side_lose_it_once() {
    let s = sheet([rect(0.0, 0.0, 20.0, 10.0), rect(20.0, 0.0, 30.0, 10.0)]);
    assert_eq!(counts(&s), (1, 1));
    close(total_length(&s), 60.0 + 70.0);
    close(s.contours[1].length, 70.0);
    assert_eq!(s.contours[1].path.start(), Some(p(20.0, 0.0)));
    assert_eq!(s.contours[1].path.end(), Some(p(20.0, 10.0)));
}

#[test]
fn near_copies_are_removed_whatever_they_are_made_of() {
    let s = sheet([rect(0.0, 0.0, 20.0, 10.0), rect(0.004, -0.003, 20.002, 10.004)]);
    assert_eq!(counts(&s), (1, 0));
    close(total_length(&s), 60.0);
    assert_eq!(findings(&s, Code::DuplicateRemoved).len(), 1);
    let s = sheet([circle(5.0, 5.0, 3.0), circle_from(5.006, 5.0, 3.001, 1.0), circle(5.0, 5.0, 3.05)]);
    assert_eq!(counts(&s), (2, 0));
    close(total_length(&s), 6.05 * TAU);
    // An arc of 1 m radius is 0.005 mm off its chord of 6.3 mm.
    let flat = arc(0.0, 0.0, 1000.0, 80.0, 0.362);
    let (a, b) = (flat.start().unwrap(), flat.end().unwrap());
    let s = sheet([flat.clone(), line(b.x, b.y, a.x, a.y)]);
    assert_eq!(counts(&s), (0, 1));
    close(total_length(&s), flat.length());
    // Lines over each other at a ten-thousandth of a radian.
    let s = sheet([line(0.0, 0.0, 60.0, 0.0), line(30.0, 0.002, 90.0, 0.008)]);
    assert_eq!(counts(&s), (0, 1));
    assert!((total_length(&s) - 90.0).abs() < 0.02, "{}", total_length(&s));
    assert_eq!(findings(&s, Code::OverlapRemoved).len(), 1);
}

#[test]
fn legs_of_a_sharp_corner_and_short_elements_are_no_copies() {
    let s = sheet([polyline(&[(0.0, 0.0), (50.0, 1.0), (0.0, 2.0)], true)]);
    assert_eq!((counts(&s), s.findings.len()), ((1, 0), 0));
    let zigzag: Vec<(f64, f64)> =
        (0..400).map(|i| (f64::from(i) * 0.004, f64::from(i % 2) * 0.003)).collect();
    let path = polyline(&zigzag, false);
    let s = sheet([path.clone()]);
    assert_eq!(counts(&s), (0, 1));
    close(total_length(&s), path.length());
}

#[test]
fn lines_farther_apart_than_the_tolerance_both_stay() {
    let s = sheet([line(0.0, 0.0, 50.0, 0.0), line(0.0, 0.02, 50.0, 0.02)]);
    close(total_length(&s), 100.0);
    assert!(findings(&s, Code::DuplicateRemoved).is_empty());
}

#[test]
fn a_spike_out_and_back_leaves_its_outline_closed() {
    let outline =
        [(0.0, 0.0), (10.0, 0.0), (10.0, -7.0), (10.0, 0.0), (20.0, 0.0), (20.0, 10.0), (0.0, 10.0)];
    for start in 0..outline.len() {
        let turned: Vec<_> = (0..outline.len()).map(|i| outline[(i + start) % outline.len()]).collect();
        let s = sheet([polyline(&turned, true)]);
        assert_eq!(counts(&s), (1, 1), "start {start}");
        let closed = s.contours.iter().find(|c| c.path.closed).unwrap();
        close(closed.area, 200.0);
        close(total_length(&s), 67.0);
    }
}

#[test]
fn a_part_that_shares_a_side_is_still_a_part_with_its_holes() {
    let s = sheet([
        rect(0.0, 0.0, 20.0, 10.0),
        circle(10.0, 5.0, 2.0),
        rect(20.0, -5.0, 30.0, 20.0),
        circle(35.0, 5.0, 2.0),
        rect(0.0, 10.0, 20.0, 10.0),
    ]);
    assert_eq!(counts(&s), (3, 2));
    close(total_length(&s), 60.0 + 90.0 + 35.0 + 8.0 * PI);
    assert_eq!(
        s.parts.iter().map(|p| (p.outer, p.holes.clone())).collect::<Vec<_>>(),
        [(0, vec![1]), (2, vec![3]), (4, vec![])]
    );
    close(s.contours[2].area, 600.0);
    assert!(findings(&s, Code::OpenContour).is_empty() && findings(&s, Code::Branch).is_empty());
    assert_eq!(findings(&s, Code::OverlapRemoved).len() + findings(&s, Code::DuplicateRemoved).len(), 2);
}

#[test]
fn hostile_a_hundred_thousand_lines_on_top_of_each_other() {
    let s = sheet((0..100_000).map(|i| line(f64::from(i) * 0.01, 7.0, f64::from(i) * 0.01 + 3.0, 7.0)));
    assert_eq!(counts(&s), (0, 1));
    // Steps as small as the tolerance: the ends may be off by one.
    assert!((total_length(&s) - 1002.99).abs() < 0.05, "{}", total_length(&s));
}

#[test]
fn hostile_fifty_thousand_copies() {
    let s = sheet((0..50_000).map(|i| circle_from(4.0, 4.0, 2.0, f64::from(i % 7))));
    assert_eq!(counts(&s), (1, 0));
    close(total_length(&s), 2.0 * TAU);
    let told: u32 = s.findings.iter().map(|f| f.count).sum();
    assert_eq!(told, 49_999, "each copy is told, one by one or summed up");
    let s = sheet((0..50_000).map(|_| arc(4.0, 4.0, 2.0, 10.0, 90.0)));
    close(total_length(&s), PI);
}

#[test]
fn hostile_a_hatch_of_slanted_lines_is_checked_in_part() {
    let s = sheet((0..20_000).map(|i| {
        let x = f64::from(i) * 0.5;
        line(x, 0.0, x + 10_000.0, 10_000.0)
    }));
    assert_eq!(counts(&s), (0, 20_000));
    let told = findings(&s, Code::NotAllChecked);
    let of = ["near copies", "enclose together", "crossings"];
    assert_eq!(told.len(), of.len());
    assert!(told.iter().zip(of).all(|(f, of)| f.message.contains(of)), "{told:?}");
}

/// As in DRAAK, where 0.013 mm of a line stuck out beyond a shared border and were cut by themselves.
#[test]
fn pieces_shorter_than_the_joining_tolerance_are_dropped_and_reported() {
    let beside = |over: f64| {
        let mut shapes = exploded(&rect(0.0, 0.0, 50.0, 20.0));
        shapes.extend([line(30.0, 0.0, 50.0 + over, 0.0), line(0.0, 40.0, 0.04, 40.0)]);
        sheet(shapes)
    };
    let s = beside(0.013);
    // An element that was drawn as short as this stays.
    assert_eq!(counts(&s), (1, 1));
    close(total_length(&s), 140.04);
    let scrap = findings(&s, Code::OverlapRemoved)
        .into_iter()
        .find(|f| f.message.contains("1 piece no longer than the joining tolerance"));
    assert_eq!(scrap.unwrap().at.map(|at| at.distance(p(50.0, 0.0)) < 0.02), Some(true));
    // What sticks out farther stays.
    let s = beside(0.2);
    assert_eq!(counts(&s), (1, 2));
    close(total_length(&s), 140.24);
}
