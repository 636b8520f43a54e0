//! Chains of cubic Bézier curves, as SVG paths have them.

use super::fit;
use super::sampler::Curve;
use super::segment::Segment;
use glam::DVec2;

/// Cubic Bézier curves joined end to end: four control points each, in mm. The last point of one is the first of the next.
///
/// They are fitted together, so that a circle drawn as four curves becomes one circle again.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Beziers {
    curves: Vec<[DVec2; 4]>,
    breaks: Vec<f64>,
}

impl Beziers {
    /// A chain of curves.
    pub fn new(curves: Vec<[DVec2; 4]>) -> Self {
        let breaks = (0..=curves.len()).map(|i| i as f64).collect();
        Self { curves, breaks }
    }

    /// The cubic curve that is the same as a quadratic one.
    pub fn of_quadratic(start: DVec2, control: DVec2, end: DVec2) -> [DVec2; 4] {
        [start, start + (control - start) * (2.0 / 3.0), end + (control - end) * (2.0 / 3.0), end]
    }

    /// Lines and arcs within `tolerance` mm of the curves. Kinks are kept; between them the direction is continuous. The
    /// ends are exact. The result is empty when the curves have no length. The same curves in the other direction give the
    /// same elements reversed, so a copy drawn backwards is recognised as a copy.
    pub fn to_segments(&self, tolerance: f64) -> Vec<Segment> {
        let points = || self.curves.iter().flatten();
        let differ = points().zip(points().rev()).find(|(a, b)| a != b);
        if differ.is_some_and(|(a, b)| (a.x, a.y) > (b.x, b.y)) {
            let reversed = self.curves.iter().rev().map(|c| [c[3], c[2], c[1], c[0]]).collect();
            return fit::fit(&Self::new(reversed), tolerance).iter().rev().map(Segment::reversed).collect();
        }
        fit::fit(self, tolerance)
    }
}

impl Curve for Beziers {
    fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    fn at(&self, piece: usize, t: f64) -> (DVec2, DVec2) {
        let Some(&[a, b, c, d]) = self.curves.get(piece) else { return (DVec2::ZERO, DVec2::ZERO) };
        let t = t - piece as f64;
        let s = 1.0 - t;
        // The ends are exact, whatever the rounding of the sum.
        let point = if t <= 0.0 {
            a
        } else if t >= 1.0 {
            d
        } else {
            a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t)
        };
        let derivative = ((b - a) * (s * s) + (c - b) * (2.0 * s * t) + (d - c) * (t * t)) * 3.0;
        (point, derivative)
    }

    fn intervals(&self) -> usize {
        // A cubic bends at most twice, and every interval carries five samples.
        2
    }

    fn extent(&self) -> f64 {
        let (low, high) = self
            .curves
            .iter()
            .flatten()
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(*p), high.max(*p)));
        (high - low).length()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Distance of the end of the control lines that makes four cubic curves a circle within 0.03 %.
    const CIRCLE: f64 = 0.552_284_749_8;

    fn circle(radius: f64) -> Vec<[DVec2; 4]> {
        let quarter = |x: DVec2| {
            let y = x.perp();
            [x, x + y * CIRCLE, y + x * CIRCLE, y].map(|p| p * radius)
        };
        [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y].map(quarter).to_vec()
    }

    #[test]
    fn four_curves_of_a_circle_are_one_circle() {
        let segments = Beziers::new(circle(10.0)).to_segments(0.005);
        assert!(
            matches!(segments.as_slice(), [Segment::Arc(a)] if a.is_circle() && (a.radius() - 10.0).abs() < 0.005),
            "{segments:?}"
        );
    }

    #[test]
    fn a_corner_stays_a_corner_and_ends_are_exact() {
        let line = |a: DVec2, b: DVec2| [a, a.lerp(b, 0.3), a.lerp(b, 0.6), b];
        let (a, b, c) = (DVec2::ZERO, DVec2::new(10.0, 0.0), DVec2::new(10.0, 5.0));
        let segments = Beziers::new(vec![line(a, b), line(b, c)]).to_segments(0.005);
        assert_eq!(segments, [Segment::line(a, b), Segment::line(b, c)]);
    }

    #[test]
    fn a_curve_and_its_reverse_give_the_same_elements() {
        let curve = [DVec2::ZERO, DVec2::new(1.0, 20.0), DVec2::new(30.0, -5.0), DVec2::new(40.0, 10.0)];
        let reversed = [curve[3], curve[2], curve[1], curve[0]];
        let there = Beziers::new(vec![curve]).to_segments(0.005);
        let back: Vec<_> =
            Beziers::new(vec![reversed]).to_segments(0.005).iter().rev().map(Segment::reversed).collect();
        assert_eq!(there, back);
        assert!(there.len() < 30, "{}", there.len());
    }

    #[test]
    fn a_quadratic_curve_as_a_cubic_one() {
        let cubic = Beziers::new(vec![Beziers::of_quadratic(
            DVec2::ZERO,
            DVec2::new(10.0, 20.0),
            DVec2::new(20.0, 0.0),
        )]);
        assert!(cubic.at(0, 0.5).0.distance(DVec2::new(10.0, 10.0)) < 1e-12);
        assert!(Beziers::new(vec![[DVec2::ONE; 4]]).to_segments(0.005).is_empty());
    }
}
