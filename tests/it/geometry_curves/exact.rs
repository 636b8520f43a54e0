//! Curves that are lines, arcs and circles come back as these.

use super::distances::{TOLERANCE, v};
use kerfway::geometry::{Affine, Arc, DVec2, Ellipse, Nurbs, Segment, math};
use std::f64::consts::PI;

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
