//! Assembly: joins chains end to end into contours, best match first.
//!
//! 1. **Points** ([`junctions`]). Ends within rounding of each other are one point. If exactly two ends meet, they are
//!    joined. At a *branch*, where more than two meet, chains that return to the point are closed first. Then chains
//!    that continue are paired before those that lead nowhere, those of one layer before others, the straightest first.
//!    The remaining ends stay open, so all length is still cut.
//! 2. **Gaps** ([`gaps`]). Free ends are joined across gaps up to the tolerance, globally in order of ascending
//!    distance. Ties are decided by the same layer, then by the straighter continuation.
//! 3. **Trace** ([`trace`]). Joined chains become paths whose elements meet bit for bit.
//!
//! An end that touches the middle of another contour is not joined to it. The work is bounded for any drawing: points
//! are united in linear time, a branch of n ends compares O(n log n) pairs, and gaps are closed in rising steps of
//! distance, each of which leaves the free ends too far apart to crowd the next one.

mod close;
mod ends;
mod gaps;
mod junctions;
mod trace;

use super::element::Chains;
use super::source::Source;
use crate::finding::Findings;

use ends::Ends;

pub(super) use trace::Assembled;

/// Joins the chains into contours. `tolerance` is in mm.
pub(super) fn assemble(
    source: Source,
    chains: &Chains,
    tolerance: f64,
    findings: &mut Findings,
) -> Vec<Assembled> {
    let mut ends = Ends::new(chains, tolerance);
    let branches = junctions::join(&mut ends);
    gaps::join(&mut ends, tolerance);
    gaps::report(source, &ends, &branches, tolerance, findings);
    trace::contours(source, chains, &ends, tolerance, findings)
}
