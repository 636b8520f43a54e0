//! Rational B-splines, as a SPLINE entity defines them.
//!
//! Evaluation is de Boor's algorithm on homogeneous coordinates (C. de Boor, "On calculating with B-splines", J.
//! Approx. Theory 6 (1972), doi:10.1016/0021-9045(72)90080-9; L. Piegl, W. Tiller, "The NURBS Book", 2nd ed., chapters
//! 3 and 4). These irregularities of real files are accepted: knots that are not clamped, knot vectors without their
//! two redundant outer knots, missing knots, knots that decrease by rounding, and closed splines whose first control
//! points are not repeated at the end.

use super::affine::Affine;
use super::fit;
use super::knots::{CurveError, ascending, complete};
use super::sampler::Curve;
use super::segment::Segment;
use glam::DVec2;

/// Highest degree accepted, which is also the highest that any known program writes.
pub const MAX_DEGREE: usize = 15;

/// A rational B-spline in the plane, valid by construction.
#[derive(Clone, Debug, PartialEq)]
pub struct Nurbs {
    degree: usize,
    /// Control points, mm.
    control: Vec<DVec2>,
    /// One per control point, all above 0.
    weights: Vec<f64>,
    /// `control.len() + degree + 1` ascending values; the curve runs over `knots[degree]..knots[control.len()]`.
    knots: Vec<f64>,
    /// The distinct knots in the range of the curve.
    breaks: Vec<f64>,
    /// For each piece between breaks, the index of the knot it starts at.
    spans: Vec<usize>,
}

impl Nurbs {
    /// A spline of `degree` 1 to 15 from control points (mm), weights (empty when all are 1) and knots.
    ///
    /// There are normally `points + degree + 1` knots. The two outer ones may be missing, and an empty list means
    /// uniform knots with clamped ends.
    ///
    /// # Errors
    /// The counts do not match, a value is not finite, a weight is 0 or less, or the knots do not ascend.
    pub fn new(
        degree: usize,
        control: Vec<DVec2>,
        weights: Vec<f64>,
        knots: Vec<f64>,
    ) -> Result<Self, CurveError> {
        let points = control.len();
        if degree == 0 || degree > MAX_DEGREE {
            return Err(CurveError::Degree(degree));
        }
        if points <= degree {
            return Err(CurveError::TooFewPoints { points, degree });
        }
        let weights = if weights.is_empty() { vec![1.0; points] } else { weights };
        if weights.len() != points {
            return Err(CurveError::WeightCount { weights: weights.len(), points });
        }
        let finite = control.iter().all(|p| p.is_finite());
        if !(finite && weights.iter().chain(&knots).all(|v| v.is_finite())) {
            return Err(CurveError::NotFinite);
        }
        if let Some(w) = weights.iter().find(|w| **w <= 0.0) {
            return Err(CurveError::Weight(*w));
        }
        let knots = ascending(complete(knots, points, degree)?)?;
        let (mut breaks, mut spans) = (Vec::new(), Vec::new());
        for i in degree..points {
            if knots[i] < knots[i + 1] {
                breaks.push(knots[i]);
                spans.push(i);
            }
        }
        breaks.push(knots[points]);
        if spans.is_empty() {
            return Err(CurveError::KnotOrder);
        }
        Ok(Self { degree, control, weights, knots, breaks, spans })
    }

    /// A closed spline. Control points that already return to the start are used unchanged, and so are clamped knots
    /// (an open curve although its flag says closed). Otherwise the first `degree` control points are repeated and the
    /// knots continued periodically, as drawing programs do when they read the closed flag.
    ///
    /// # Errors
    /// As [`Nurbs::new`].
    pub fn closed(
        degree: usize,
        control: Vec<DVec2>,
        weights: Vec<f64>,
        knots: Vec<f64>,
    ) -> Result<Self, CurveError> {
        let points = control.len();
        let periodic = knots.is_empty() || (points >= 2 && knots.len() == points + 1);
        if !periodic {
            let open = Self::new(degree, control, weights, knots)?;
            let clamped = open.clamped_start() && open.clamped_end();
            let (a, b) = (open.start(), open.end());
            if clamped || a.distance(b) <= 1e-6 * open.extent() {
                return Ok(open);
            }
            let Self { control, weights, knots, .. } = open;
            let period = knots.get(degree..=points).map(<[f64]>::to_vec).unwrap_or_default();
            // Only `points - degree` spans are known but the wrapped curve has `points`; the rest continues uniformly.
            return Self::wrapped(degree, &control, &weights, &period);
        }
        Self::wrapped(degree, &control, &weights, &knots)
    }

    /// A periodic spline; `period` holds the knots of one turn and is continued uniformly when it is too short.
    fn wrapped(
        degree: usize,
        control: &[DVec2],
        weights: &[f64],
        period: &[f64],
    ) -> Result<Self, CurveError> {
        let points = control.len();
        if degree == 0 || degree > MAX_DEGREE {
            return Err(CurveError::Degree(degree));
        }
        if points < 2 || points < degree {
            return Err(CurveError::TooFewPoints { points, degree });
        }
        let period = ascending(period.to_vec()).unwrap_or_default();
        let (first, last) = (period.first().copied().unwrap_or(0.0), period.last().copied().unwrap_or(0.0));
        let step = if period.len() > 1 { (last - first) / (period.len() - 1) as f64 } else { 1.0 };
        let mut steps: Vec<f64> = period.windows(2).map(|w| w[1] - w[0]).collect();
        steps.resize(points, step);
        // There are degree + points + degree periodic steps, so that the curve runs over exactly one period.
        let mut knots = Vec::with_capacity(points + 2 * degree + 1);
        let mut at = first - (0..degree).map(|i| steps[(points * degree + i - degree) % points]).sum::<f64>();
        knots.push(at);
        for i in 0..points + 2 * degree {
            at += steps[(points * degree + i - degree) % points];
            knots.push(at);
        }
        let wrap = |i: usize| i % points;
        let wrapped_control = (0..points + degree).filter_map(|i| control.get(wrap(i)).copied()).collect();
        let wrapped_weights = if weights.is_empty() {
            Vec::new()
        } else {
            (0..points + degree).filter_map(|i| weights.get(wrap(i)).copied()).collect()
        };
        Self::new(degree, wrapped_control, wrapped_weights, knots)
    }

    /// Degree, 1 to 15.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Control points, mm.
    pub fn control(&self) -> &[DVec2] {
        &self.control
    }

    /// The range of the parameter.
    pub fn domain(&self) -> (f64, f64) {
        (self.breaks[0], self.breaks[self.breaks.len() - 1])
    }

    /// First point, mm.
    pub fn start(&self) -> DVec2 {
        if self.clamped_start() { self.control[0] } else { self.homogeneous(0, self.breaks[0]).0 }
    }

    /// Last point, mm.
    pub fn end(&self) -> DVec2 {
        let last = self.control.len() - 1;
        let piece = self.spans.len() - 1;
        if self.clamped_end() {
            self.control[last]
        } else {
            self.homogeneous(piece, self.breaks[piece + 1]).0
        }
    }

    /// The point at parameter `t`, which is clamped to the domain.
    pub fn point(&self, t: f64) -> DVec2 {
        self.at(self.piece(t), t).0
    }

    /// The derivative with respect to the parameter at `t`; at a kink, that of the later side.
    pub fn derivative(&self, t: f64) -> DVec2 {
        self.at(self.piece(t), t).1
    }

    /// The image under an affine map. It is exact, because mapping the control points maps the curve.
    pub fn transformed(&self, map: &Affine) -> Self {
        Self { control: self.control.iter().map(|p| map.point(*p)).collect(), ..self.clone() }
    }

    /// The curve as lines and arcs within `tolerance` mm of it, unless that takes more than some ten thousand elements,
    /// as hostile input does. Kinks are kept; between them the direction is continuous. The ends are exact, and a curve
    /// that ends where it started closes bit for bit. The result is empty when the curve has no length. A reversed
    /// curve gives the same elements reversed, so a copy drawn in the other direction is recognised as a copy.
    pub fn to_segments(&self, tolerance: f64) -> Vec<Segment> {
        if self.starts_at_its_later_end()
            && let Ok(other) = self.reversed()
        {
            return fit::fit(&other, tolerance).iter().rev().map(Segment::reversed).collect();
        }
        fit::fit(self, tolerance)
    }

    /// The same curve in the opposite direction.
    fn reversed(&self) -> Result<Self, CurveError> {
        let sum = self.knots[0] + self.knots[self.knots.len() - 1];
        let control = self.control.iter().rev().copied().collect();
        let weights = self.weights.iter().rev().copied().collect();
        Self::new(self.degree, control, weights, self.knots.iter().rev().map(|k| sum - k).collect())
    }

    /// Whether fits are made from the other end. A curve is fitted in the direction whose control points come first
    /// when compared by x, then by y, so that both directions give the same elements.
    fn starts_at_its_later_end(&self) -> bool {
        let differ = self.control.iter().zip(self.control.iter().rev()).find(|(a, b)| a != b);
        differ.is_some_and(|(a, b)| (a.x, a.y) > (b.x, b.y))
    }

    fn clamped_start(&self) -> bool {
        self.knots[0] >= self.knots[self.degree]
    }

    fn clamped_end(&self) -> bool {
        self.knots[self.knots.len() - 1] <= self.knots[self.control.len()]
    }

    /// Index of the piece between breaks that contains `t`.
    fn piece(&self, t: f64) -> usize {
        self.breaks.partition_point(|b| *b <= t).clamp(1, self.spans.len()) - 1
    }

    /// Point and derivative by de Boor's algorithm.
    fn homogeneous(&self, piece: usize, t: f64) -> (DVec2, DVec2) {
        let (p, k) = (self.degree, self.spans[piece]);
        let mut d = [(DVec2::ZERO, 0.0); MAX_DEGREE + 1];
        for (j, slot) in d.iter_mut().enumerate().take(p + 1) {
            let i = k - p + j;
            *slot = (self.control[i] * self.weights[i], self.weights[i]);
        }
        let mut before = (d[0], d[0]);
        for r in 1..=p {
            if r == p {
                before = (d[p - 1], d[p]);
            }
            for j in (r..=p).rev() {
                let (low, high) = (self.knots[j + k - p], self.knots[j + 1 + k - r]);
                let a = (t - low) / (high - low);
                d[j] = (d[j - 1].0 * (1.0 - a) + d[j].0 * a, d[j - 1].1 * (1.0 - a) + d[j].1 * a);
            }
        }
        let (point, weight) = d[p];
        let rate = p as f64 / (self.knots[k + 1] - self.knots[k]);
        let (dp, dw) = ((before.1.0 - before.0.0) * rate, (before.1.1 - before.0.1) * rate);
        let at = point / weight;
        (at, (dp - at * dw) / weight)
    }
}

impl Curve for Nurbs {
    fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    fn at(&self, piece: usize, t: f64) -> (DVec2, DVec2) {
        let (from, to) = self.domain();
        let t = t.clamp(from, to);
        let (mut point, derivative) = self.homogeneous(piece, t);
        if t <= from {
            point = self.start();
        } else if t >= to {
            let (start, end) = (self.start(), self.end());
            // A curve whose ends differ only by rounding is closed.
            point = if start.distance(end) <= 1e-9 * self.extent() { start } else { end };
        }
        (point, derivative)
    }

    fn intervals(&self) -> usize {
        // A piece of degree p bends at most p - 1 times, and every interval carries five samples.
        self.degree.div_ceil(2)
    }

    fn extent(&self) -> f64 {
        let (low, high) = self
            .control
            .iter()
            .fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(*p), high.max(*p)));
        (high - low).length()
    }
}
