//! Converts a parametric curve to lines and arcs within a tolerance.
//!
//! 1. The curve is sampled and split where its direction jumps ([`sampler`](super::sampler)).
//! 2. A run between two kinks that is one line, arc or circle within the tolerance becomes that element
//!    ([`recognise`](super::recognise)).
//! 3. In other runs, the stretches that are a line or an arc far below the tolerance become such an element, so a
//!    drawn line or fillet is restored exactly.
//! 4. The rest is covered by the longest possible biarcs ([`cover`](super::cover)).
//! 5. Neighbours on one line or circle are merged.
//!
//! The chain joins bit for bit, the direction is continuous within a run, and the ends are those of the curve.

use super::biarc::{Biarc, TangentArc};
use super::chain::{Chain, EXACT_SHARE};
use super::cover::{SAMPLED_SHARE, cover, lengths, reach};
use super::recognise::single_segment;
use super::sample::Sample;
use super::sampler::{self, Curve};
use super::segment::Segment;

/// An exact stretch becomes one element if it is at least this fraction of the length that one arc covers within the
/// full tolerance. Where the curvature changes steadily, the fraction is the cube root of the ratio of the tolerances,
/// here 0.13, so such a stretch is not taken for a drawn line or arc.
const MIN_EXACT_SHARE: f64 = 0.6;
/// Sine of the largest angle (0.006 degrees) between a drawn line or arc and the curve where it ends; it allows for
/// rounding in the drawing.
const MAX_END_ANGLE: f64 = 1e-4;
/// The smallest tolerance, mm: one nanometre. Below that, the rounding of coordinates around 1 m dominates.
const MIN_TOLERANCE: f64 = 1e-6;

/// The curve as lines and arcs whose distance from the curve is at most `tolerance` mm (at least a nanometre), in both
/// directions. The result is empty for a curve without length or with non-finite numbers.
pub(super) fn fit(curve: &dyn Curve, tolerance: f64) -> Vec<Segment> {
    let mut chain = Chain::new(limited(tolerance));
    add(curve, limited(tolerance), &mut chain);
    chain.segments
}

/// A tolerance that can be met, mm.
pub(super) fn limited(tolerance: f64) -> f64 {
    if tolerance.is_finite() { tolerance.max(MIN_TOLERANCE) } else { MIN_TOLERANCE }
}

/// Adds the lines and arcs of a curve to a chain. The tolerance is limited.
pub(super) fn add(curve: &dyn Curve, tolerance: f64, chain: &mut Chain) {
    if curve.extent().is_finite() {
        for run in sampler::runs(curve, tolerance) {
            chain.start_run();
            match single(&run, tolerance) {
                Some(segment) => chain.push(segment),
                None => elements(&run, tolerance, chain),
            }
        }
    }
}

/// A run as one line, one arc or one circle, if one of them is near enough.
pub(super) fn single(run: &[Sample], tolerance: f64) -> Option<Segment> {
    single_segment(run, tolerance * SAMPLED_SHARE)
}

/// A run as one biarc in the directions of its ends, if it is near enough.
pub(super) fn biarc(run: &[Sample], tolerance: f64) -> Option<[Segment; 2]> {
    let [first, between @ .., last] = run else { return None };
    let biarc = Biarc::along(*first, *last, between)?;
    let segment = |arc: TangentArc| arc.segment(tolerance * EXACT_SHARE);
    biarc.within(between, tolerance * SAMPLED_SHARE).then(|| [biarc.first, biarc.second].map(segment))
}

/// A run as drawn lines and arcs, with biarcs between them.
fn elements(run: &[Sample], tolerance: f64, chain: &mut Chain) {
    // The directions at the ends of exact stretches are replaced by the exact ones, which keeps the joints smooth.
    let mut run = densified(run);
    let mut from = 0;
    for (start, end, arc) in exact_stretches(&run, tolerance) {
        if let (Some(a), Some(b)) = (run.get(start).copied(), run.get(end).copied()) {
            run[start] = Sample { tangent: arc.start_tangent(), ..a };
            run[end] = Sample { tangent: arc.end_tangent(), ..b };
        }
        cover(&run[from..=start], tolerance, chain);
        chain.push(arc.segment(chain.same()));
        from = end;
    }
    cover(&run[from..], tolerance, chain);
}

/// The run with one more sample in every gap, taken from a biarc. An interval of four gaps equals its own biarc to a
/// twentieth of the tolerance, so over one gap the biarc is exact to a thousandth. That is as accurate as the curve,
/// and cheaper.
fn densified(run: &[Sample]) -> Vec<Sample> {
    let mut out = Vec::with_capacity(2 * run.len());
    for w in run.windows(2) {
        out.push(w[0]);
        out.extend(Biarc::new(w[0], w[1]).map(|b| b.joint()));
    }
    out.extend(run.last());
    out
}

/// Stretches that were drawn as a line or an arc: indices of the first and last sample, and the element.
fn exact_stretches(run: &[Sample], tolerance: f64) -> Vec<(usize, usize, TangentArc)> {
    /// A drawn element spans at least one interval of the sampling: four gaps, doubled.
    const MIN_GAPS: usize = 8;
    let mut out: Vec<(usize, usize, TangentArc)> = Vec::new();
    let length = lengths(run);
    let mut i = 0;
    while i + MIN_GAPS < run.len() {
        let exact = |j: usize| tangent_arc(run, i, j, EXACT_SHARE * tolerance, MAX_END_ANGLE);
        let near = |j: usize| tangent_arc(run, i, j, SAMPLED_SHARE * tolerance, 1.0);
        if exact(i + MIN_GAPS).is_some()
            && let Some((j, piece)) = reach(run, i, MIN_GAPS, exact)
        {
            // How far an arc reaches within the full tolerance does not matter, only whether it reaches farther than this: it may be over
            // thousands of samples of a spline with many points.
            let limit = length[i] + (length[j] - length[i]) / MIN_EXACT_SHARE;
            let beyond = length.partition_point(|l| *l <= limit);
            if beyond == run.len() || near(beyond).is_none() {
                out.push((i, j, piece));
                i = j;
            } else {
                i += (j - i) / 2;
            }
        } else {
            i += 1;
        }
    }
    out
}

/// The arc that leaves sample `i` in its direction and ends at sample `j`, if the samples between lie within `within`
/// mm of it and its direction at `j` is right up to an angle of sine `off`.
fn tangent_arc(run: &[Sample], i: usize, j: usize, within: f64, off: f64) -> Option<TangentArc> {
    let (a, b) = (run.get(i)?, run.get(j)?);
    let arc = TangentArc::new(a.point, a.tangent, b.point)?;
    // Test the last samples first, because an arc that leaves in the right direction deviates most there.
    let near = run.get(i + 1..j)?.iter().rev().all(|s| arc.distance(s).is_some_and(|d| d <= within));
    (near && arc.end_tangent().perp_dot(b.tangent).abs() <= off).then_some(arc)
}
