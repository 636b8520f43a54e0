//! From a parametric curve to lines and arcs within a tolerance.
//!
//! 1. The curve is sampled and split where its direction jumps ([`sampler`](super::sampler)).
//! 2. A run between two kinks that is one line, one arc or one circle within the tolerance becomes just that
//!    ([`single`](super::single)).
//! 3. Otherwise the stretches of a run that *are* a line or an arc, far below the tolerance, are taken as such: a
//!    drawn line or fillet comes back exact.
//! 4. What is left is covered by the longest possible biarcs ([`cover`](super::cover)).
//! 5. Neighbours that lie on one line or circle are merged.
//!
//! Chains join bit for bit; within a run the direction is continuous; the ends are those of the curve.

use super::biarc::{Biarc, Bow};
use super::chain::{Chain, EXACT};
use super::cover::{MEASURED, cover, reach};
use super::sample::Sample;
use super::sampler::{self, Curve};
use super::segment::Segment;
use super::single::single;

/// A stretch that is exact is taken as one piece when it reaches at least this share of what the full tolerance
/// reaches with one arc. On a curve of steadily changing curvature the shares are as the cube roots of the
/// tolerances, 0.13 here: such a stretch is no drawn line or arc.
const DRAWN: f64 = 0.6;
/// A drawn line or arc arrives in its own direction, but for rounding of the drawing: sine of 0.006 degrees.
const ARRIVES: f64 = 1e-4;
/// The finest tolerance, mm: a nanometre. Below, rounding of coordinates of 1 m decides.
const FINEST: f64 = 1e-6;

/// The curve as lines and arcs, each nowhere farther than `tolerance` mm (at least a nanometre) from it, and the
/// curve from them. Empty for a curve without length or with numbers that are not
/// finite.
pub(super) fn fit(curve: &dyn Curve, tolerance: f64) -> Vec<Segment> {
    let tolerance = if tolerance.is_finite() { tolerance.max(FINEST) } else { FINEST };
    let mut chain = Chain::new(tolerance);
    if curve.extent().is_finite() {
        for run in sampler::runs(curve, tolerance) {
            chain.start_run();
            match single(&run, tolerance * MEASURED) {
                Some(segment) => chain.push(segment),
                None => pieces(&run, tolerance, &mut chain),
            }
        }
    }
    chain.segments
}

/// A run as drawn lines and arcs with biarcs between them.
fn pieces(run: &[Sample], tolerance: f64, chain: &mut Chain) {
    // Directions at the ends of exact stretches are replaced by the exact ones: keeps the joints smooth.
    let mut run = doubled(run);
    let mut from = 0;
    for (start, end, bow) in drawn(&run, tolerance) {
        if let (Some(a), Some(b)) = (run.get(start).copied(), run.get(end).copied()) {
            run[start] = Sample { tangent: bow.start_tangent(), ..a };
            run[end] = Sample { tangent: bow.end_tangent(), ..b };
        }
        cover(&run[from..=start], tolerance, chain);
        chain.push(bow.segment(chain.same()));
        from = end;
    }
    cover(&run[from..], tolerance, chain);
}

/// The run with a sample between any two. An interval of four samples is its own biarc to a twentieth of the tolerance,
/// so over one gap the biarc is exact to a thousandth: as good as the curve, and cheaper.
fn doubled(run: &[Sample]) -> Vec<Sample> {
    let mut out = Vec::with_capacity(2 * run.len());
    for w in run.windows(2) {
        out.push(w[0]);
        out.extend(Biarc::new(w[0], w[1]).map(|b| b.joint()));
    }
    out.extend(run.last());
    out
}

/// Stretches that are a line or an arc as drawn: index of first and last sample, and the piece.
fn drawn(run: &[Sample], tolerance: f64) -> Vec<(usize, usize, Bow)> {
    /// A drawn piece takes at least one interval of the sampling, of four gaps, doubled.
    const LEAST: usize = 8;
    let mut out: Vec<(usize, usize, Bow)> = Vec::new();
    let mut i = 0;
    while i + LEAST < run.len() {
        let exact = |j: usize| bow(run, i, j, EXACT * tolerance, ARRIVES);
        let near = |j: usize| bow(run, i, j, MEASURED * tolerance, 1.0);
        let far = |j: usize| run[i].point.distance(run[j].point);
        if exact(i + LEAST).is_some()
            && let Some((j, piece)) = reach(run, i, LEAST, exact)
            && let Some((full, _)) = reach(run, i, LEAST, near)
        {
            if far(j) >= DRAWN * far(full) {
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

/// The arc from sample `i` in its direction to sample `j`, when the samples between lie within `within` mm of it
/// and it arrives in the direction of `j`, but for an angle of sine `off`.
fn bow(run: &[Sample], i: usize, j: usize, within: f64, off: f64) -> Option<Bow> {
    let (a, b) = (run.get(i)?, run.get(j)?);
    let bow = Bow::new(a.point, a.tangent, b.point)?;
    // Farthest first: a bow that leaves in the right direction strays there.
    let near = run.get(i + 1..j)?.iter().rev().all(|s| bow.distance(s).is_some_and(|d| d <= within));
    (near && bow.end_tangent().perp_dot(b.tangent).abs() <= off).then_some(bow)
}
