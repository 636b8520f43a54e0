//! What ellipses, splines and helices become: places, lengths and findings, one test an item.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use super::dxf_entities::v;
use crate::testkit::drawings::{close, entities, found, one};
use kerfway::finding::Code;
use std::f64::consts::FRAC_PI_2;

#[test]
fn ellipse_is_complete_or_an_arc() {
    let whole = one("0 ELLIPSE 8 0 10 0 20 0 11 20 21 0 40 0.5 41 0 42 6.283185307179586");
    assert!(whole.closed);
    // Circumference of half axes 20 and 10: 4 a E(e), e^2 = 3/4.
    assert!((whole.length() - 96.884_482_205_5).abs() < 0.01, "{}", whole.length());
    let quarter = one("0 ELLIPSE 8 0 10 0 20 0 11 20 21 0 40 0.5 41 0 42 1.5707963267948966");
    close(quarter.start().unwrap().distance(v(20.0, 0.0)), 0.0);
    close(quarter.end().unwrap().distance(v(0.0, 10.0)), 0.0);
}

#[test]
fn ellipse_below_turns_the_other_way() {
    let quarter =
        one("0 ELLIPSE 8 0 10 0 20 0 11 20 21 0 40 0.5 41 0 42 1.5707963267948966 210 0 220 0 230 -1");
    close(quarter.end().unwrap().distance(v(0.0, -10.0)), 0.0);
}

#[test]
fn rational_spline_is_its_circle() {
    let w = 0.5f64.sqrt();
    let path = one(&format!(
        "0 SPLINE 8 0 70 4 71 2 72 6 73 3 74 0 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 {w} 41 1 \
         10 10 20 0 30 0 10 10 20 10 30 0 10 0 20 10 30 0"
    ));
    assert!((path.length() - FRAC_PI_2 * 10.0).abs() < 0.01, "{}", path.length());
    assert_eq!(path.end(), Some(v(0.0, 10.0)));
}

#[test]
fn spline_of_fit_points_only_goes_through_them() {
    let path = one("0 SPLINE 8 0 70 8 71 3 72 0 73 0 74 3 11 0 21 0 31 0 11 10 21 5 31 0 11 20 21 0 31 0");
    let nearest =
        path.segments.iter().map(|s| s.nearest(v(10.0, 5.0)).1.sqrt()).fold(f64::INFINITY, f64::min);
    assert!(nearest < 0.005, "{nearest}");
    assert_eq!((path.start(), path.end()), (Some(v(0.0, 0.0)), Some(v(20.0, 0.0))));
}

#[test]
fn spline_of_degree_one_keeps_its_kinks() {
    let path =
        one("0 SPLINE 8 0 70 0 71 1 72 5 73 3 40 0 40 0 40 1 40 2 40 2 10 0 20 0 10 10 20 0 10 10 20 10");
    close(path.length(), 20.0);
    assert_eq!(path.segments.len(), 2);
}

#[test]
fn closed_spline_whose_points_are_not_repeated_closes() {
    // A square of control points, periodic: comes back to its start.
    let path = one("0 SPLINE 8 0 70 11 71 3 72 0 73 4 10 0 20 0 10 10 20 0 10 10 20 10 10 0 20 10");
    assert!(path.closed);
    assert!(path.area() > 30.0 && path.area() < 100.0, "{}", path.area());
}

#[test]
fn spline_with_the_wrong_number_of_knots_is_a_finding() {
    let drawing = entities(
        "0 SPLINE 5 B7 8 0 70 8 71 3 40 0 40 1 10 0 20 0 10 1 20 0 10 2 20 0 10 3 20 0 0 LINE 8 0 10 0 20 0 11 1 21 0",
    );
    assert_eq!(drawing.shapes.len(), 1);
    let finding = found(&drawing, Code::InvalidGeometry);
    assert_eq!(finding.handle.as_deref(), Some("B7"));
    assert!(finding.message.contains("knots"), "{}", finding.message);
}

#[test]
fn helix_is_read_as_its_spline() {
    let path = one(
        "0 HELIX 8 0 100 AcDbSpline 70 8 71 1 72 4 73 2 40 0 40 0 40 1 40 1 10 0 20 0 30 0 10 6 20 8 30 0 \
         100 AcDbHelix 90 29 10 500 20 500 30 0 11 700 21 0 31 0 40 99 41 3",
    );
    close(path.length(), 10.0);
}

#[test]
fn tilted_circle_is_an_ellipse_and_reported() {
    // Tilted by 60 degrees: half as high as wide.
    let drawing = entities("0 CIRCLE 8 0 10 0 20 0 40 10 210 0 220 -0.8660254037844386 230 0.5");
    let size = drawing.shapes[0].path.bounds().size();
    assert!((size.x - 20.0).abs() < 0.01 && (size.y - 10.0).abs() < 0.01, "{size}");
    assert_eq!(found(&drawing, Code::Projected).count, 1);
}
