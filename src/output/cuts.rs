//! The cuts and marks of a plan in order, as every format needs them.

use super::sheet_facts::SheetFacts;
use crate::geometry::{DVec2, Segment};
use crate::plan::{Leads, Move, Plan};
use std::borrow::Cow;

/// A cut or mark of a plan: a whole contour, or a part of one that is interrupted.
pub(super) struct Cut<'a> {
    /// The contour's id.
    pub(super) contour: u32,
    /// Its entry, mm.
    pub(super) entry: DVec2,
    /// Its elements from the entry on; never empty. Pauses in sharp corners do not divide it, nor do chains, unless contours are
    /// asked for one by one.
    pub(super) path: Cow<'a, [Segment]>,
    /// Whether it is marked instead of cut.
    pub(super) mark: bool,
    /// Whether the head pierces at its entry.
    pub(super) pierced: bool,
    /// Height of the head, mm; 0: as focused.
    pub(super) z: f64,
    /// Which of the elements are leads and overcut.
    pub(super) leads: Leads,
}

/// The cuts and marks of a plan, in order. Contours that are joined by chains are one cut, as the beam stays on.
pub(super) fn cuts(plan: &Plan) -> Vec<Cut<'_>> {
    collect(plan, true)
}

/// The cuts and marks of a plan, in order, those of each contour by themselves, without the chains between them.
pub(super) fn contour_cuts(plan: &Plan) -> Vec<Cut<'_>> {
    collect(plan, false)
}

fn collect(plan: &Plan, joined: bool) -> Vec<Cut<'_>> {
    let mut all: Vec<Cut> = Vec::with_capacity(plan.moves.len());
    let (mut goes_on, mut after_cut, mut pierced, mut height) = (false, false, false, 0.0);
    for (index, step) in plan.moves.iter().enumerate() {
        if let Move::Cut { contour, path, mark, leads, .. } = step
            && let Some(first) = path.first()
        {
            match all.last_mut().filter(|_| goes_on) {
                Some(before) => {
                    before.path.to_mut().extend_from_slice(path);
                    before.leads = before.leads.and(*leads);
                }
                None => {
                    let (contour, mark, leads) = (*contour, *mark, *leads);
                    let (entry, path) = (first.start(), Cow::Borrowed(path.as_slice()));
                    all.push(Cut { contour, entry, path, mark, pierced, z: height, leads });
                }
            }
        }
        if let (Move::Chain { path }, true, Some(first)) = (step, joined, chain_of(step).first()) {
            match all.last_mut().filter(|_| after_cut) {
                Some(before) => before.path.to_mut().extend_from_slice(path),
                // On a kerf the cut of the next contour begins, which is not pierced.
                None => {
                    let Some(Move::Cut { contour, .. }) = plan.moves.get(index + 1) else { continue };
                    let contour = *contour;
                    let (entry, path) = (first.start(), Cow::Borrowed(path.as_slice()));
                    let leads = Leads::default();
                    all.push(Cut { contour, entry, path, mark: false, pierced: false, z: height, leads });
                }
            }
        }
        after_cut = matches!(step, Move::Cut { .. });
        match step {
            Move::Pierce => pierced = true,
            Move::Height { z } => height = *z,
            _ => pierced = false,
        }
        goes_on = matches!(step, Move::Macro { .. }) || joined && matches!(step, Move::Chain { .. });
    }
    all
}

/// The elements of a chain; none of any other move.
fn chain_of(step: &Move) -> &[Segment] {
    if let Move::Chain { path } = step { path } else { &[] }
}

/// Largest difference between the length of a cut and that of its whole contour, mm. It covers rounding of sums in
/// different order; a partial cut differs by more.
const WHOLE: f64 = 1e-6;

/// Whether a cut is closed: it is all of a closed contour, and not a path through a pierce group.
pub(super) fn closes(sheet: &SheetFacts, cut: &Cut) -> bool {
    let length = || cut.path.iter().map(Segment::length).sum::<f64>();
    let comes_back = cut.path.last().is_some_and(|last| last.end() == cut.entry);
    sheet.contour(cut.contour).is_some_and(|c| c.closed && comes_back && length() >= c.length - WHOLE)
}
