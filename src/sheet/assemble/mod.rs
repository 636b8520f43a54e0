//! Assembly: chains joined end to end into contours, best match first.
//!
//! 1. **Points** ([`node`]). Ends within rounding of each other are one point. Two ends that meet alone are joined.
//!    Where more than two meet, a *branch*, chains that come back to the point are closed first; then chains that
//!    lead on are paired before those that lead nowhere, those of one layer before others, the straightest first.
//!    What is left over stays open, so all length is still cut.
//! 2. **Gaps** ([`gaps`]). Ends still free are joined over gaps up to the tolerance, globally by ascending distance,
//!    never first come first served; equal distances by same layer, then by the straighter continuation.
//! 3. **Trace** ([`trace`]). Joined chains are walked into paths whose elements meet bit for bit.
//!
//! An end that touches the middle of another contour is no join. Work is bounded whatever the drawing: points are
//! united in linear time, at a branch of n ends O(n log n) pairs are looked at, and gaps are closed in rising steps
//! of distance, each of which leaves free ends too far apart to crowd the next one.

mod close;
mod ends;
mod gaps;
mod node;
mod trace;

use super::element::Chains;
use super::source::Source;
use crate::finding::Findings;

use ends::Ends;

pub(super) use trace::Assembled;

/// Joins the chains. `tolerance` in mm.
pub(super) fn assemble(
    source: Source,
    chains: &Chains,
    tolerance: f64,
    findings: &mut Findings,
) -> Vec<Assembled> {
    let mut ends = Ends::new(chains, tolerance);
    let branches = node::join(&mut ends);
    gaps::join(&mut ends, tolerance);
    gaps::report(source, &ends, &branches, tolerance, findings);
    trace::contours(source, chains, &ends, tolerance, findings)
}
