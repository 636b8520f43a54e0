//! Covering a smooth stretch with as few biarcs as possible.
//!
//! Greedy: each biarc reaches as far as the tolerance lets it. For pieces that interpolate the curve and its direction
//! at the samples this is optimal in number (R. L. S. Drysdale, G. Rote, A. Sturm, "Approximation of an open polygonal
//! curve with a minimum number of circular arcs and biarcs", Comput. Geom. 41 (2008),
//! doi:10.1016/j.comgeo.2007.10.009). We go below that number by leaving and arriving at a small angle to the curve
//! ([`best_tilt`]).

use super::biarc::{Biarc, bend};
use super::chain::Chain;
use super::sample::Sample;
use super::segment::Segment;

/// Share of the tolerance a fit may use as measured at the samples. The rest covers the samples' own resolution (a
/// twentieth) and what lies between them.
pub(super) const MEASURED: f64 = 0.85;
/// Largest sum of sines of the turns inside one biarc: about half a circle, so that its arcs stay below that.
const TURN: f64 = 3.0;

/// Covers a stretch with the longest biarcs, one after the other, as part of a chain.
pub(super) fn cover(run: &[Sample], tolerance: f64, chain: &mut Chain) {
    let stretch = Stretch::new(run, tolerance);
    let (mut i, mut tilt) = (0, 0.0);
    // Neighbours reach about as far as each other: half the last reach is a good first try.
    let mut step = 1;
    while i + 1 < run.len() {
        let found = reach(run, i, step, |j| stretch.biarc(i, tilt, j));
        let found = found.map(|(j, b)| stretch.shared(i, tilt, j).unwrap_or((j, b)));
        match found {
            Some((j, (biarc, at_end))) => {
                chain.push(biarc.first.segment(chain.same()));
                chain.push(biarc.second.segment(chain.same()));
                step = ((j - i) / 2).max(1);
                (i, tilt) = (j, at_end);
            }
            None => {
                // Two samples no biarc joins: nearer than the resolution, a line is as good.
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
        let (mut turned, mut length) = (vec![0.0; run.len()], vec![0.0; run.len()]);
        for i in 1..run.len() {
            turned[i] = turned[i - 1] + run[i - 1].tangent.perp_dot(run[i].tangent).abs();
            length[i] = length[i - 1] + run[i - 1].point.distance(run[i].point);
        }
        Self { run, tolerance, turned, length }
    }

    /// The biarc from sample `i`, starting `tilt` rad off its direction, to sample `j`, and how far it ends off the
    /// direction there; `None` when it is not near enough.
    fn biarc(&self, i: usize, tilt: f64, j: usize) -> Option<(Biarc, f64)> {
        if self.turned[j] - self.turned[i] > TURN {
            return None;
        }
        let (from, to, between) = (tilted(self.run[i], tilt), self.run[j], &self.run[i + 1..j]);
        // The ends of the stretch keep their directions.
        let best = match self.run.get(j + 1) {
            // Off by this angle, a piece over the next gap alone misses the curve by 0.15 tolerances at most.
            Some(next) => {
                let most = self.tolerance / next.point.distance(to.point);
                best_tilt(bend(from, to)?, tilt).clamp(-most, most)
            }
            None => 0.0,
        };
        let biarc = Biarc::along(from, tilted(to, best), between)?;
        biarc.within(between, MEASURED * self.tolerance).then_some((biarc, best))
    }

    /// When a piece that reaches from `i` to `j` leaves but a sliver to the end: one to the middle of both instead.
    fn shared(&self, i: usize, tilt: f64, j: usize) -> Option<(usize, (Biarc, f64))> {
        /// What is left, as a part of the piece: below it two halves of the sum are well within reach.
        const SLIVER: f64 = 0.3;
        let (start, end) = (self.length[i], *self.length.last()?);
        let rest = end - self.length[j];
        if rest <= 0.0 || rest > SLIVER * (self.length[j] - start) {
            return None;
        }
        let middle = self.length.partition_point(|l| *l < 0.5 * (start + end)).clamp(i + 1, j);
        Some((middle, self.biarc(i, tilt, middle)?))
    }
}

/// A sample with its direction turned by a small angle, rad.
fn tilted(s: Sample, angle: f64) -> Sample {
    Sample { tangent: (s.tangent + s.tangent.perp() * angle).normalize_or_zero(), ..s }
}

/// The angle (rad) between fit and curve at a joint that lets the pieces be longest, given the [`bend`] of the
/// biarc that ends in the direction of the curve and starts `tilt` off it.
///
/// Where the curvature changes at rate k, arcs of length h with all joints on the curve stay nearest to it when they
/// leave and arrive at an angle of -k h^2 / 12: their distance is then the even wave of amplitude k h^3 / 125, a third
/// of what biarcs in the curve's own directions reach. That biarc changes its curvature by
/// 4/3 k h + 2 tilt / h, hence k.
fn best_tilt((change, h): (f64, f64), tilt: f64) -> f64 {
    /// Beyond 6 degrees the small-angle reckoning is void.
    const MOST: f64 = 0.1;
    /// 1/16 follows from the above; a quarter less gave the fewest pieces on ellipses and random splines, since the
    /// rate k changes along a piece.
    const DAMPED: f64 = 0.75 / 16.0;
    (-(change * h - 2.0 * tilt) * DAMPED).clamp(-MOST, MOST)
}

/// The farthest sample that `piece` reaches from `i`, and its piece: a first try `step` samples away, then steps
/// double while it fits and halve when it does not.
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
