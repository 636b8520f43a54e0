//! Samples of a parametric curve, dense enough to measure a fit against them.
//!
//! A curve is cut into short intervals until each is, to a twentieth of the tolerance, the biarc of its own two ends
//! and turns by at most 45 degrees. A fitted piece spans about three or four such intervals, each of which carries
//! three more samples inside: the largest of 12 or more measured distances misses the true one by a few percent,
//! which the margin of the fit covers. Where the direction jumps (a kink) the samples are split into runs; within a
//! run the direction is continuous.

use super::biarc::Biarc;
use super::sample::Sample;
use glam::DVec2;

/// A curve with a parameter, in mm.
pub(super) trait Curve {
    /// Parameters between which the curve is smooth, ascending; at least two.
    fn breaks(&self) -> &[f64];
    /// Point and derivative at `t` of the piece between `breaks[piece]` and `breaks[piece + 1]`.
    fn at(&self, piece: usize, t: f64) -> (DVec2, DVec2);
    /// How many intervals to cut every piece into before looking: enough to see each bend it can have.
    fn intervals(&self) -> usize;
    /// Rough size of the whole curve, mm, against which a length is zero.
    fn extent(&self) -> f64;
}

/// Share of the tolerance to which an interval must equal its own biarc.
const RESOLUTION: f64 = 0.05;
/// An interval shorter than this share of the tolerance is not cut further: a sharp turn inside it is a kink.
const POINT: f64 = 0.02;
/// Largest sum of sines of the turns inside one interval: 45 degrees.
const TURN: f64 = 0.75;
/// Directions that differ by more than this sine (0.3 degrees) at a break are a kink. Rounding of drawn
/// coordinates to 6 digits stays well below, a visible corner well above.
pub(super) const KINK: f64 = 0.005;
/// Halvings of one interval; 2^-24 of a knot span of 1 km is below a tenth of a micrometre.
const DEPTH: u32 = 24;
/// Halvings a curve may take, and more for each of its pieces: bounds time and memory on hostile input. A piece that
/// spans a kilometre takes a few dozen at the default tolerance.
const BUDGET: usize = 50_000;
const BUDGET_PER_PIECE: usize = 100;
/// Where an interval is measured inside; symmetric, so that a reversed curve is cut alike.
const INSIDE: [f64; 3] = [0.23, 0.5, 0.77];
/// A derivative whose step over the interval is below this share of the extent has no direction.
const STANDSTILL: f64 = 1e-9;
/// How far inside to look for the direction then, as a share of the interval.
const STEP_IN: f64 = 1e-6;

/// The samples of a curve in runs without kinks. Consecutive runs share their end point bit for bit; every run has
/// at least two samples; a curve without length has no run.
pub(super) fn runs(curve: &dyn Curve, tolerance: f64) -> Vec<Vec<Sample>> {
    let breaks = curve.breaks();
    let budget = BUDGET + BUDGET_PER_PIECE * breaks.len();
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
    /// Below this a length is none, mm.
    zero: f64,
    budget: usize,
    runs: Vec<Vec<Sample>>,
    run: Vec<Sample>,
}

impl Sampler<'_> {
    /// Samples one interval, in order, halving it as needed.
    fn interval(&mut self, piece: usize, from: f64, to: f64) {
        // A stack, not recursion: the depth is bounded either way, the wasm stack is small.
        let mut open = vec![(from, to, 0)];
        while let Some((a, b, depth)) = open.pop() {
            let samples = self.five(piece, a, b);
            let exhausted = depth >= DEPTH || self.budget == 0;
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

    /// The ends of an interval and three samples inside.
    fn five(&self, piece: usize, a: f64, b: f64) -> [Sample; 5] {
        let sample = |f: f64| {
            let t = if f >= 1.0 { b } else { a + (b - a) * f };
            let (point, mut d) = self.curve.at(piece, t);
            if d.length() * (b - a) <= self.zero {
                d = self.curve.at(piece, t + (a + (b - a) * 0.5 - t) * STEP_IN).1;
            }
            Sample { point, tangent: d.normalize_or_zero() }
        };
        let mut out = [sample(0.0), sample(INSIDE[0]), sample(INSIDE[1]), sample(INSIDE[2]), sample(1.0)];
        let chord = (out[4].point - out[0].point).normalize_or_zero();
        for s in &mut out {
            if s.tangent == DVec2::ZERO {
                s.tangent = chord;
            }
        }
        out
    }

    /// Takes an interval that turns little.
    fn smooth(&mut self, samples: &[Sample; 5]) {
        self.join(samples[0]);
        self.run.extend_from_slice(&samples[1..]);
    }

    /// Takes an interval too short to matter that turns much: a kink. One without any length is left out.
    fn point(&mut self, samples: &[Sample; 5]) {
        if samples[4].tangent != DVec2::ZERO {
            self.join(samples[0]);
            self.join(Sample { point: samples[0].point, tangent: samples[4].tangent });
        }
    }

    /// Takes an interval as its chord: what is left to do when the budget is spent.
    fn chord(&mut self, samples: &[Sample; 5]) {
        let tangent = (samples[4].point - samples[0].point).normalize_or_zero();
        self.join(Sample { point: samples[0].point, tangent });
        if tangent != DVec2::ZERO {
            self.run.push(Sample { point: samples[4].point, tangent });
        }
    }

    /// Continues the run at the start of an interval, or starts a new one behind a kink or a jump.
    fn join(&mut self, next: Sample) {
        let Some(last) = self.run.last_mut() else {
            // Behind a point-like interval the run may be empty while the chain is not.
            let point = self.runs.last().and_then(|r| r.last()).map_or(next.point, |s| s.point);
            return self.run.push(Sample { point, tangent: next.tangent });
        };
        let gap = next.point - last.point;
        if gap.length() > self.zero.max(POINT * self.tolerance) {
            // A knot of multiplicity above the degree: the two sides are joined by a line.
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

    /// Ends the run.
    fn finish(&mut self) {
        let run = std::mem::take(&mut self.run);
        if run.len() > 1 {
            self.runs.push(run);
        }
    }
}

/// Same direction but for rounding.
fn aligned(a: DVec2, b: DVec2) -> bool {
    a.dot(b) > 0.0 && a.perp_dot(b).abs() <= KINK
}

enum Shape {
    Smooth,
    Point,
    Open,
}

/// Whether an interval may be taken as it is.
fn judge(samples: &[Sample; 5], tolerance: f64) -> Shape {
    let mut length = 0.0;
    let mut turn = 0.0;
    let mut forward = true;
    for w in samples.windows(2) {
        length += w[0].point.distance(w[1].point);
        turn += w[0].tangent.perp_dot(w[1].tangent).abs();
        forward &= w[0].tangent.dot(w[1].tangent) > 0.0;
    }
    let short = length <= POINT * tolerance;
    if !forward || turn > TURN {
        return if short { Shape::Point } else { Shape::Open };
    }
    let fits = short
        || Biarc::new(samples[0], samples[4])
            .is_some_and(|b| b.within(&samples[1..4], RESOLUTION * tolerance));
    if fits { Shape::Smooth } else { Shape::Open }
}
