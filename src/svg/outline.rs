//! The outline of a shape in user units: what path data and the basic shapes have in common.

use crate::geometry::{DVec2, Ellipse, math};
use std::f64::consts::TAU;

/// A piece of an outline, from where the piece before it ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Piece {
    /// A straight line to a point.
    Line(DVec2),
    /// A quadratic Bézier curve: control point and end.
    Quadratic(DVec2, DVec2),
    /// A cubic Bézier curve: two control points and the end.
    Cubic(DVec2, DVec2, DVec2),
    /// An elliptic arc to a point.
    Arc(Ellipse, DVec2),
}

/// A chain of pieces.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Chain {
    pub(super) start: DVec2,
    pub(super) pieces: Vec<Piece>,
    /// Whether a line leads from its end back to its start.
    pub(super) closed: bool,
}

impl Chain {
    pub(super) fn new(start: DVec2) -> Self {
        Self { start, pieces: Vec::new(), closed: false }
    }
}

/// The arc between two points on an ellipse with radii `rx` and `ry` whose x axis is turned by `rotation` rad; `None`
/// where the specification draws a straight line.
///
/// Source: SVG 2, appendix "Implementation notes", B.2.4 (from end points to centre) and B.2.5 (radii that are too small).
pub(super) fn arc(
    from: DVec2,
    to: DVec2,
    radii: DVec2,
    rotation: f64,
    large: bool,
    sweep: bool,
) -> Option<Ellipse> {
    let radii = radii.abs();
    if from == to || radii.min_element() <= 0.0 {
        return None;
    }
    // In the coordinates of the ellipse, scaled so that it is the unit circle.
    let half = math::rotate((from - to) * 0.5, -rotation) / radii;
    let square = half.length_squared();
    if !square.is_finite() || square <= 0.0 {
        return None;
    }
    let (radii, half) =
        if square > 1.0 { (radii * square.sqrt(), half / square.sqrt()) } else { (radii, half) };
    let height = (1.0 / half.length_squared() - 1.0).max(0.0).sqrt();
    let side = if large == sweep { -1.0 } else { 1.0 };
    let center = DVec2::new(half.y, -half.x) * (side * height);
    let (a, b) = (half - center, -half - center);
    let turn = math::turn(a, b);
    let angle = match sweep {
        true if turn < 0.0 => turn + TAU,
        false if turn > 0.0 => turn - TAU,
        _ => turn,
    };
    let place = |v: DVec2| math::rotate(v * radii, rotation);
    Some(Ellipse {
        center: (from + to) * 0.5 + place(center),
        major: place(a),
        minor: place(a.perp()),
        start: 0.0,
        sweep: angle,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn the_four_arcs_between_two_points() {
        let (from, to) = (DVec2::new(1.0, 0.0), DVec2::new(0.0, 1.0));
        let one = |large, sweep| arc(from, to, DVec2::ONE, 0.0, large, sweep).unwrap();
        for (large, sweep, center, angle) in [
            (false, true, DVec2::ZERO, FRAC_PI_2),
            (true, true, DVec2::ONE, 1.5 * PI),
            (false, false, DVec2::ONE, -FRAC_PI_2),
            (true, false, DVec2::ZERO, -1.5 * PI),
        ] {
            let e = one(large, sweep);
            assert!(
                e.center.distance(center) < 1e-12 && (e.sweep - angle).abs() < 1e-12,
                "{large} {sweep}: {e:?}"
            );
            assert!(e.at(0.0).distance(from) < 1e-12 && e.at(e.sweep).distance(to) < 1e-12);
        }
    }

    #[test]
    fn radii_that_are_too_small_grow_to_half_a_turn() {
        let e = arc(DVec2::ZERO, DVec2::new(10.0, 0.0), DVec2::ONE, 0.3, false, true).unwrap();
        assert!((e.sweep - PI).abs() < 1e-9 && e.center.distance(DVec2::new(5.0, 0.0)) < 1e-12, "{e:?}");
        assert!((e.major.length() - 5.0).abs() < 1e-12);
    }

    #[test]
    fn a_turned_ellipse_passes_through_both_ends() {
        let (from, to) = (DVec2::new(3.0, 4.0), DVec2::new(-2.0, 7.0));
        for (large, sweep) in [(false, false), (false, true), (true, false), (true, true)] {
            let e = arc(from, to, DVec2::new(6.0, 3.0), 0.7, large, sweep).unwrap();
            assert!(e.at(0.0).distance(from) < 1e-9 && e.at(e.sweep).distance(to) < 1e-9);
            assert_eq!(e.sweep > 0.0, sweep);
            assert_eq!(e.sweep.abs() > PI, large);
        }
    }
}
