//! Chains of cubic Bézier curves, as SVG paths have them.

use super::chain::Chain;
use super::fit;
use super::sample::Sample;
use super::sampler::{Curve, KINK};
use super::segment::Segment;
use glam::DVec2;

/// Samples inside a curve that is fitted alone.
const SAMPLES: usize = 15;

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
            return Self::new(reversed).fitted(tolerance).iter().rev().map(Segment::reversed).collect();
        }
        self.fitted(tolerance)
    }

    /// A simple curve between two kinks is tried as a few elements first, which takes a sixth of the time of a general run. All
    /// others are fitted together with their neighbours.
    fn fitted(&self, tolerance: f64) -> Vec<Segment> {
        let tolerance = fit::limited(tolerance);
        let mut chain = Chain::new(tolerance);
        let rest = |from: usize, to: usize, chain: &mut Chain| {
            if let Some(curves) = self.curves.get(from..to).filter(|c| !c.is_empty()) {
                fit::add(&Self::new(curves.to_vec()), tolerance, chain);
            }
        };
        let mut from = 0;
        let mut kink = true;
        for (i, curve) in self.curves.iter().enumerate() {
            let next = self.curves.get(i + 1);
            let ends_at_kink = next.is_none_or(|next| is_kink(curve, next));
            if kink && ends_at_kink && is_simple(curve) {
                rest(from, i, &mut chain);
                from = i;
                if add_simple(curve, tolerance, &mut chain) {
                    from = i + 1;
                }
            }
            kink = ends_at_kink;
        }
        rest(from, self.curves.len(), &mut chain);
        chain.segments
    }
}

/// Whether a curve bends to one side only and turns by less than a right angle.
///
/// Such a curve and an arc between its ends run in the same direction, so fifteen samples inside are enough to measure their
/// distance: a general run has twelve for each fitted piece.
fn is_simple([p, q, r, s]: &[DVec2; 4]) -> bool {
    let (a, b, c) = (q - p, r - q, s - r);
    // False where a number is NaN.
    a.dot(b) > 0.0 && b.dot(c) > 0.0 && a.dot(c) > 0.0 && a.perp_dot(b) * b.perp_dot(c) >= 0.0
}

/// Adds a simple curve as one line, arc or biarc, or as a biarc for each of its halves; `false` if they are not near enough.
fn add_simple(curve: &[DVec2; 4], tolerance: f64, chain: &mut Chain) -> bool {
    chain.start_run();
    let run = samples(curve);
    if let Some(segment) = fit::single(&run, tolerance) {
        chain.push(segment);
        return true;
    }
    let biarc = |run: &[Sample]| fit::biarc(run, tolerance);
    if let Some(two) = biarc(&run) {
        two.into_iter().for_each(|s| chain.push(s));
        return true;
    }
    // Only biarcs keep the direction where the halves meet.
    let [first, second] = halves(curve).map(|half| biarc(&samples(&half)));
    let both = first.zip(second);
    both.into_iter().flat_map(|(a, b)| a.into_iter().chain(b)).for_each(|s| chain.push(s));
    both.is_some()
}

fn samples(curve: &[DVec2; 4]) -> [Sample; SAMPLES + 2] {
    std::array::from_fn(|k| {
        let (point, derivative) = at(curve, k as f64 / (SAMPLES + 1) as f64);
        Sample { point, tangent: derivative.normalize_or_zero() }
    })
}

/// A curve as two, by de Casteljau's construction.
fn halves([a, b, c, d]: &[DVec2; 4]) -> [[DVec2; 4]; 2] {
    let (ab, bc, cd) = ((a + b) * 0.5, (b + c) * 0.5, (c + d) * 0.5);
    let (abc, bcd) = ((ab + bc) * 0.5, (bc + cd) * 0.5);
    let middle = (abc + bcd) * 0.5;
    [[*a, ab, abc, middle], [middle, bcd, cd, *d]]
}

/// Whether the direction jumps from one curve to the next, or is unknown there.
fn is_kink(curve: &[DVec2; 4], next: &[DVec2; 4]) -> bool {
    let (leaves, enters) = (curve[3] - curve[2], next[1] - next[0]);
    let lengths = (leaves.length_squared() * enters.length_squared()).sqrt();
    // Written so that an unknown direction is no kink.
    leaves.dot(enters) < 0.0 || leaves.perp_dot(enters).abs() > KINK * lengths
}

/// Point and derivative of a curve at `t` from 0 to 1.
fn at([a, b, c, d]: &[DVec2; 4], t: f64) -> (DVec2, DVec2) {
    let s = 1.0 - t;
    // The ends are exact, whatever the rounding of the sum.
    let point = if t <= 0.0 {
        *a
    } else if t >= 1.0 {
        *d
    } else {
        *a * (s * s * s) + *b * (3.0 * s * s * t) + *c * (3.0 * s * t * t) + *d * (t * t * t)
    };
    (point, ((b - a) * (s * s) + (c - b) * (2.0 * s * t) + (d - c) * (t * t)) * 3.0)
}

impl Curve for Beziers {
    fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    fn at(&self, piece: usize, t: f64) -> (DVec2, DVec2) {
        self.curves.get(piece).map_or((DVec2::ZERO, DVec2::ZERO), |curve| at(curve, t - piece as f64))
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
    use crate::geometry::math;

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

    /// Curves of one bend, of all sizes: those that are fitted alone, and the same joined to a line by a kink.
    #[test]
    fn simple_curves_stay_within_the_tolerance_in_both_directions() {
        let tolerance = 0.005;
        let mut state = 7_u64;
        let mut random = || {
            state = state.wrapping_mul(0x5851_F42D_4C95_7F2D).wrapping_add(0x1405_7B7E_F767_814F);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        let (mut simple, mut alone) = (0, 0);
        for _ in 0..400 {
            let size = math::pow(10.0, -1.5 + 3.0 * random());
            let mut point = |x: f64| DVec2::new(x + 0.3 * random(), 0.4 * random()) * size;
            let curve = [DVec2::ZERO, point(0.2), point(0.5), DVec2::new(size, 0.0)];
            simple += u32::from(is_simple(&curve));
            let mut chain = Chain::new(tolerance);
            alone += u32::from(is_simple(&curve) && add_simple(&curve, tolerance, &mut chain));
            let segments = Beziers::new(vec![curve]).to_segments(tolerance);
            assert_eq!(segments[0].start(), curve[0]);
            assert_eq!(segments[segments.len() - 1].end(), curve[3]);
            assert!(segments.windows(2).all(|w| w[0].end() == w[1].start()));
            // A flat arc becomes a line that misses its direction by up to a thousandth.
            assert!(segments.windows(2).all(|w| w[0].tangent(1.0).distance(w[1].tangent(0.0)) < 2.1e-3));
            let places: Vec<DVec2> = (0..=600).map(|k| at(&curve, f64::from(k) / 600.0).0).collect();
            let chords: Vec<Segment> = places.windows(2).map(|w| Segment::line(w[0], w[1])).collect();
            let off = |p: DVec2, from: &[Segment]| {
                from.iter().map(|s| s.nearest(p).1.sqrt()).fold(f64::INFINITY, f64::min)
            };
            for p in places.iter().step_by(7) {
                assert!(off(*p, &segments) <= tolerance, "{curve:?}");
            }
            for s in &segments {
                for k in 0..=10 {
                    assert!(off(s.at(f64::from(k) / 10.0), &chords) <= tolerance * 1.001, "{curve:?}");
                }
            }
        }
        assert!(simple > 100 && alone > 50 && alone < simple, "{alone} of {simple}");
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
