//! Covers a smooth stretch with as few biarcs as possible.
//!
//! The method is greedy: each biarc reaches as far as the tolerance allows. For pieces that interpolate the curve and
//! its direction at the samples, this minimises their number (R. L. S. Drysdale, G. Rote, A. Sturm, "Approximation of
//! an open polygonal curve with a minimum number of circular arcs and biarcs", Comput. Geom. 41 (2008),
//! doi:10.1016/j.comgeo.2007.10.009). Kerfway needs fewer still, because its pieces leave and arrive at a small angle
//! to the curve ([`best_tilt`]).

use super::biarc::{Biarc, bend};
use super::chain::Chain;
use super::sample::Sample;
use super::segment::Segment;

/// Fraction of the tolerance that a fit may use at the samples. The rest covers the error of the samples (a twentieth)
/// and the places between them.
pub(super) const SAMPLED_SHARE: f64 = 0.85;
/// Largest sum of the sines of the turns inside one biarc, about half a circle, so that each of its arcs stays below
/// half a circle.
const MAX_TURN: f64 = 3.0;

/// Covers a stretch with the longest biarcs, one after the other, and adds them to a chain.
pub(super) fn cover(run: &[Sample], tolerance: f64, chain: &mut Chain) {
    let stretch = Stretch::new(run, tolerance);
    let (mut i, mut tilt) = (0, 0.0);
    // Neighbouring pieces are of similar length, so half the last length is a good first attempt.
    let mut step = 1;
    while i + 1 < run.len() {
        let found = reach(run, i, step, |j| stretch.biarc(i, tilt, j));
        let found = found.map(|(j, b)| stretch.halved(i, tilt, j).unwrap_or((j, b)));
        match found {
            Some((j, (biarc, at_end))) => {
                chain.push(biarc.first.segment(chain.same()));
                chain.push(biarc.second.segment(chain.same()));
                step = ((j - i) / 2).max(1);
                (i, tilt) = (j, at_end);
            }
            None => {
                // No biarc joins these two samples. They are nearer than the resolution, so a line serves as well.
                chain.push(Segment::line(run[i].point, run[i + 1].point));
                (i, tilt) = (i + 1, 0.0);
            }
        }
    }
}

/// Samples to be covered by biarcs.
struct Stretch<'r> {
    run: &'r [Sample],
    tolerance: f64,
    /// Sum of sines of the turns up to each sample.
    turned: Vec<f64>,
    /// Length up to each sample, mm.
    length: Vec<f64>,
}

impl<'r> Stretch<'r> {
    fn new(run: &'r [Sample], tolerance: f64) -> Self {
        let mut turned = vec![0.0; run.len()];
        for i in 1..run.len() {
            turned[i] = turned[i - 1] + run[i - 1].tangent.perp_dot(run[i].tangent).abs();
        }
        Self { run, tolerance, turned, length: lengths(run) }
    }

    /// The biarc from sample `i`, starting `tilt` rad off its direction, to sample `j`, with the angle by which it ends
    /// off the direction there; `None` when it is too far from the curve.
    fn biarc(&self, i: usize, tilt: f64, j: usize) -> Option<(Biarc, f64)> {
        if self.turned[j] - self.turned[i] > MAX_TURN {
            return None;
        }
        let (from, to, between) = (tilted(self.run[i], tilt), self.run[j], &self.run[i + 1..j]);
        // The ends of the stretch keep their directions.
        let best = match self.run.get(j + 1) {
            // With at most this angle, a piece over the next gap alone misses the curve by 0.15 tolerances at most.
            Some(next) => {
                let most = self.tolerance / next.point.distance(to.point);
                best_tilt(bend(from, to)?, tilt).clamp(-most, most)
            }
            None => 0.0,
        };
        let biarc = Biarc::along(from, tilted(to, best), between)?;
        biarc.within(between, SAMPLED_SHARE * self.tolerance).then_some((biarc, best))
    }

    /// If a piece from `i` to `j` leaves only a short rest to the end, a piece to the middle of both instead.
    fn halved(&self, i: usize, tilt: f64, j: usize) -> Option<(usize, (Biarc, f64))> {
        /// The rest as a fraction of the piece, below which two halves of the sum are certainly within reach.
        const SHORT_REST: f64 = 0.3;
        let (start, end) = (self.length[i], *self.length.last()?);
        let rest = end - self.length[j];
        if rest <= 0.0 || rest > SHORT_REST * (self.length[j] - start) {
            return None;
        }
        let middle = self.length.partition_point(|l| *l < 0.5 * (start + end)).clamp(i + 1, j);
        Some((middle, self.biarc(i, tilt, middle)?))
    }
}

/// Length from the first sample up to each, mm.
pub(super) fn lengths(run: &[Sample]) -> Vec<f64> {
    let gaps = run.windows(2).map(|w| w[0].point.distance(w[1].point));
    let sums = gaps.scan(0.0, |sum, gap| {
        *sum += gap;
        Some(*sum)
    });
    [0.0].into_iter().chain(sums).collect()
}

/// A sample with its direction turned by a small angle, rad.
fn tilted(s: Sample, angle: f64) -> Sample {
    Sample { tangent: (s.tangent + s.tangent.perp() * angle).normalize_or_zero(), ..s }
}

/// The angle (rad) between fit and curve at a joint that allows the longest pieces. It is computed from the [`bend`] of
/// the biarc that starts `tilt` off the curve and ends in the curve's direction.
///
/// Where the curvature changes at rate k, arcs of length h with all joints on the curve are nearest to it when they
/// leave and arrive at an angle of -k h^2 / 12. Their distance is then an even wave of amplitude k h^3 / 125, a third
/// of what biarcs in the curve's own directions reach. The biarc changes its curvature by 4/3 k h + 2 tilt / h, which
/// gives k.
fn best_tilt((change, h): (f64, f64), tilt: f64) -> f64 {
    /// Beyond 6 degrees the small-angle approximation no longer holds.
    const MAX_TILT: f64 = 0.1;
    /// The derivation above gives 1/16. A quarter less gave the fewest pieces on ellipses and random splines, because
    /// the rate k changes along a piece.
    const DAMPING: f64 = 0.75 / 16.0;
    (-(change * h - 2.0 * tilt) * DAMPING).clamp(-MAX_TILT, MAX_TILT)
}

/// The farthest sample that `piece` reaches from `i`, and that piece. The first attempt is `step` samples away; the
/// step doubles while a piece fits and halves when it does not.
pub(super) fn reach<T>(
    run: &[Sample],
    i: usize,
    mut step: usize,
    piece: impl Fn(usize) -> Option<T>,
) -> Option<(usize, T)> {
    let last = run.len() - 1;
    let mut best: Option<(usize, T)> = None;
    let mut beyond = last + 1;
    loop {
        let from = best.as_ref().map_or(i, |(j, _)| *j);
        let j = (from + step).min(beyond - 1);
        if j <= from {
            return best;
        }
        match piece(j) {
            Some(p) => {
                best = Some((j, p));
                step *= 2;
            }
            None => {
                beyond = j;
                step = ((j - from) / 2).max(1);
            }
        }
    }
}
