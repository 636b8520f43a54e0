//! Samples of a parametric curve, dense enough to measure a fit against them.
//!
//! A curve is divided into intervals until each differs from the biarc between its own two ends by at most a twentieth
//! of the tolerance and turns by at most 45 degrees. A fitted piece spans three or four such intervals, and each
//! interval has three more samples inside. The largest of these 12 or more distances underestimates the true maximum by
//! a few percent, which the margin of the fit covers. The samples are split into runs where the direction jumps (a
//! kink); within a run the direction is continuous.

use super::biarc::Biarc;
use super::sample::Sample;
use glam::DVec2;

/// A parametric curve, in mm.
pub(super) trait Curve {
    /// Parameters between which the curve is smooth, in ascending order; at least two.
    fn breaks(&self) -> &[f64];
    /// Point and derivative at `t` on the piece between `breaks[piece]` and `breaks[piece + 1]`.
    fn at(&self, piece: usize, t: f64) -> (DVec2, DVec2);
    /// Number of intervals each piece is divided into at first: enough to see every bend it can have.
    fn intervals(&self) -> usize;
    /// Approximate size of the whole curve, mm. Lengths are compared with it to decide whether they are zero.
    fn extent(&self) -> f64;
}

/// Largest distance between an interval and its own biarc, as a fraction of the tolerance.
const RESOLUTION: f64 = 0.05;
/// An interval shorter than this fraction of the tolerance is not divided further; a sharp turn inside it is a kink.
const POINT_SIZE: f64 = 0.02;
/// Largest sum of sines of the turns inside one interval: 45 degrees.
const MAX_TURN: f64 = 0.75;
/// Directions that differ by more than this sine (0.3 degrees) at a break are a kink. Rounding of drawn
/// coordinates to 6 digits stays well below, a visible corner well above.
pub(super) const KINK: f64 = 0.005;
/// Largest number of times one interval is halved. 2^-24 of a knot span of 1 km is below a tenth of a micrometre.
const MAX_HALVINGS: u32 = 24;
/// Number of halvings allowed for a curve, plus [`HALVINGS_PER_PIECE`] for each of its pieces. It bounds time and memory
/// for hostile input; a piece that spans a kilometre takes a few dozen at the default tolerance.
const HALVINGS_PER_CURVE: usize = 50_000;
const HALVINGS_PER_PIECE: usize = 100;
/// Where an interval is sampled inside. The positions are symmetric, so that a reversed curve gives the same samples.
const INNER_SAMPLES: [f64; 3] = [0.23, 0.5, 0.77];
/// Where the derivative times the interval is below this fraction of the extent, the direction is undefined.
const STANDSTILL: f64 = 1e-9;
/// How far inside the interval the direction is taken in that case, as a fraction of the interval.
const STEP_IN: f64 = 1e-6;

/// The samples of a curve in runs without kinks. Consecutive runs share their end point bit for bit. Every run has at
/// least two samples; a curve without length has no run.
pub(super) fn runs(curve: &dyn Curve, tolerance: f64) -> Vec<Vec<Sample>> {
    let breaks = curve.breaks();
    let budget = HALVINGS_PER_CURVE + HALVINGS_PER_PIECE * breaks.len();
    let zero = STANDSTILL * curve.extent();
    let mut sampler = Sampler { curve, tolerance, zero, budget, runs: Vec::new(), run: Vec::new() };
    let first = curve.intervals().max(1);
    for (piece, ends) in breaks.windows(2).enumerate() {
        let (from, to) = (ends[0], ends[1]);
        if to > from {
            for i in 0..first {
                let cut =
                    |i: usize| if i == first { to } else { from + (to - from) * (i as f64 / first as f64) };
                sampler.interval(piece, cut(i), cut(i + 1));
            }
        }
    }
    sampler.finish();
    sampler.runs
}

struct Sampler<'c> {
    curve: &'c dyn Curve,
    tolerance: f64,
    /// A length below this is zero, mm.
    zero: f64,
    budget: usize,
    runs: Vec<Vec<Sample>>,
    run: Vec<Sample>,
}

impl Sampler<'_> {
    /// Samples one interval, in order, halving it as needed.
    fn interval(&mut self, piece: usize, from: f64, to: f64) {
        // A stack instead of recursion, because the wasm stack is small.
        let mut open = vec![(from, to, 0)];
        while let Some((a, b, depth)) = open.pop() {
            let samples = self.five(piece, a, b);
            let exhausted = depth >= MAX_HALVINGS || self.budget == 0;
            match judge(&samples, self.tolerance) {
                Shape::Smooth => self.smooth(&samples),
                Shape::Point => self.point(&samples),
                Shape::Open if exhausted => self.chord(&samples),
                Shape::Open => {
                    self.budget -= 1;
                    let middle = a + (b - a) * 0.5;
                    open.push((middle, b, depth + 1));
                    open.push((a, middle, depth + 1));
                }
            }
        }
    }

    /// The ends of an interval and three samples inside it.
    fn five(&self, piece: usize, a: f64, b: f64) -> [Sample; 5] {
        let sample = |f: f64| {
            let t = if f >= 1.0 { b } else { a + (b - a) * f };
            let (point, mut d) = self.curve.at(piece, t);
            if d.length() * (b - a) <= self.zero {
                d = self.curve.at(piece, t + (a + (b - a) * 0.5 - t) * STEP_IN).1;
            }
            Sample { point, tangent: d.normalize_or_zero() }
        };
        let mut out = [
            sample(0.0),
            sample(INNER_SAMPLES[0]),
            sample(INNER_SAMPLES[1]),
            sample(INNER_SAMPLES[2]),
            sample(1.0),
        ];
        let chord = (out[4].point - out[0].point).normalize_or_zero();
        for s in &mut out {
            if s.tangent == DVec2::ZERO {
                s.tangent = chord;
            }
        }
        out
    }

    /// Adds an interval without a kink.
    fn smooth(&mut self, samples: &[Sample; 5]) {
        self.join(samples[0]);
        self.run.extend_from_slice(&samples[1..]);
    }

    /// Adds an interval with a sharp turn that is too short to be divided further: a kink. It is skipped if it has no
    /// length.
    fn point(&mut self, samples: &[Sample; 5]) {
        if samples[4].tangent != DVec2::ZERO {
            self.join(samples[0]);
            self.join(Sample { point: samples[0].point, tangent: samples[4].tangent });
        }
    }

    /// Adds an interval as its chord, once the budget of halvings is spent.
    fn chord(&mut self, samples: &[Sample; 5]) {
        let tangent = (samples[4].point - samples[0].point).normalize_or_zero();
        self.join(Sample { point: samples[0].point, tangent });
        if tangent != DVec2::ZERO {
            self.run.push(Sample { point: samples[4].point, tangent });
        }
    }

    /// Continues the run at the start of an interval, or starts a new run after a kink or a jump.
    fn join(&mut self, next: Sample) {
        let Some(last) = self.run.last_mut() else {
            // After a point-like interval the current run may be empty although earlier runs exist.
            let point = self.runs.last().and_then(|r| r.last()).map_or(next.point, |s| s.point);
            return self.run.push(Sample { point, tangent: next.tangent });
        };
        let gap = next.point - last.point;
        if gap.length() > self.zero.max(POINT_SIZE * self.tolerance) {
            // At a knot of multiplicity above the degree the curve jumps; a line joins the two sides.
            let (from, tangent) = (last.point, gap.normalize_or_zero());
            self.finish();
            self.runs.push(vec![Sample { point: from, tangent }, Sample { point: next.point, tangent }]);
            self.run.push(next);
        } else if aligned(last.tangent, next.tangent) {
            last.tangent = (last.tangent + next.tangent).normalize_or_zero();
        } else {
            let point = last.point;
            self.finish();
            self.run.push(Sample { point, tangent: next.tangent });
        }
    }

    /// Ends the current run.
    fn finish(&mut self) {
        let run = std::mem::take(&mut self.run);
        if run.len() > 1 {
            self.runs.push(run);
        }
    }
}

/// Whether two directions are the same up to the angle of a kink.
fn aligned(a: DVec2, b: DVec2) -> bool {
    a.dot(b) > 0.0 && a.perp_dot(b).abs() <= KINK
}

enum Shape {
    Smooth,
    Point,
    Open,
}

/// Decides whether an interval is smooth, must be halved, or is a point.
fn judge(samples: &[Sample; 5], tolerance: f64) -> Shape {
    let mut length = 0.0;
    let mut turn = 0.0;
    let mut forward = true;
    for w in samples.windows(2) {
        length += w[0].point.distance(w[1].point);
        turn += w[0].tangent.perp_dot(w[1].tangent).abs();
        forward &= w[0].tangent.dot(w[1].tangent) > 0.0;
    }
    let short = length <= POINT_SIZE * tolerance;
    if !forward || turn > MAX_TURN {
        return if short { Shape::Point } else { Shape::Open };
    }
    let fits = short
        || Biarc::new(samples[0], samples[4])
            .is_some_and(|b| b.within(&samples[1..4], RESOLUTION * tolerance));
    if fits { Shape::Smooth } else { Shape::Open }
}
