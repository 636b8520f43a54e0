//! Assembly: joins chains end to end into contours, best match first.
//!
//! 1. **Points** ([`junctions`]). Ends within rounding of each other are one point. If exactly two ends meet, they are
//!    joined. At a *branch*, where more than two meet, chains that return to the point are closed first. Then chains
//!    that continue are paired before those that lead nowhere, those of one layer before others, the straightest first.
//!    The remaining ends stay open, so all length is still cut.
//! 2. **Gaps** ([`gaps`]). Free ends are joined across gaps up to the tolerance, globally in order of ascending
//!    distance. Ties are decided by the same layer, then by the straighter continuation.
//! 3. **Faces** ([`network`]). Where lines serve two parts (branches, ends that meet the middle of another line), the
//!    areas that they enclose together become contours.
//! 4. **Trace** ([`trace`]). Joined chains become paths whose elements meet bit for bit.
//! 5. **Fragments** ([`fragments`]). Elements that no program can show are removed.
//!
//! The work is bounded for any drawing: points
//! are united in linear time, a branch of n ends compares O(n log n) pairs, and gaps are closed in rising steps of
//! distance, each of which leaves the free ends too far apart to crowd the next one.

mod close;
mod ends;
mod fragments;
mod gaps;
mod junctions;
mod network;
mod roles;
mod trace;

use super::element::Chains;
use super::source::Source;
use crate::finding::{Code, Finding, Findings, Severity};
use ends::Ends;
use junctions::Branch;
use network::{Outcome, TooMany};

pub(super) use trace::Assembled;

/// What the assembly came to.
pub(super) struct Assembly {
    /// The contours in drawing order.
    pub(super) contours: Vec<Assembled>,
    /// Whether areas that lines enclose together were searched for everywhere. If not, what is open may free a part.
    pub(super) searched: bool,
}

/// Joins the chains into contours. `tolerance` is in mm. With `faces`, lines that enclose an area together become
/// contours.
pub(super) fn assemble(
    source: Source,
    chains: &Chains,
    tolerance: f64,
    faces: bool,
    findings: &mut Findings,
) -> Assembly {
    let (ends, branches) = joined(chains, tolerance);
    let outcome =
        if faces { network::resolve(&roles::of(chains, &ends, tolerance)) } else { Outcome::Unchanged };
    let searched = !matches!(outcome, Outcome::TooMany(_));
    let resolved = match outcome {
        Outcome::Faces(resolved) => Some(resolved),
        Outcome::Unchanged => None,
        Outcome::TooMany(TooMany { limit, at }) => {
            let message = format!(
                "More than {limit} pairs of lines lie over each other, around here and elsewhere: the areas they enclose \
                 together were not searched for, and what is open is cut open, as drawn. Draw the parts as \
                 closed outlines, or divide the drawing."
            );
            findings.push(Finding::new(Code::NotAllChecked, Severity::Warning, message).at(at));
            None
        }
    };
    let (chains, ends, branches) = match &resolved {
        Some(resolved) => {
            let (ends, branches) = joined(resolved, tolerance);
            (resolved, ends, branches)
        }
        None => (chains, ends, branches),
    };
    gaps::report(source, &ends, &branches, tolerance, findings);
    let mut contours = trace::contours(source, chains, &ends, tolerance, findings);
    for contour in &mut contours {
        contour.path = fragments::without_fragments(std::mem::take(&mut contour.path));
    }
    Assembly { contours, searched }
}

/// Joins the ends of chains; returns them with the branches.
fn joined(chains: &Chains, tolerance: f64) -> (Ends, Vec<Branch>) {
    let mut ends = Ends::new(chains, tolerance);
    let branches = junctions::join(&mut ends);
    gaps::join(&mut ends, tolerance);
    (ends, branches)
}
