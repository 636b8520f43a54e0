//! Follows skeleton cuts that begin without piercing: each beginning lies on the edge of the sheet or on a skeleton cut that was made before, and
//! the cut is made from end to end, in one go or from one place to either end.

use super::chains::edge_of;
use super::kerfs::Kerfs;
use super::tolerance::SAME;
use super::violation::Violation;
use crate::geometry::{DVec2, Segment};
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::plan::model::{Move, Plan};
use crate::sheet::Sheet;

/// The skeleton cuts of a plan that are not pierced.
#[derive(Default)]
pub(super) struct SkeletonStarts {
    /// The moves that may cut without piercing, in order.
    allowed: Vec<usize>,
    /// The contours that are followed here, each with the moves that cut it.
    followed: Vec<(u32, Vec<usize>)>,
    /// For each contour, whether it is followed here.
    held: Vec<bool>,
}

impl SkeletonStarts {
    pub(super) fn new(sheet: &Sheet, machine: &Profile, plan: &Plan) -> Self {
        let mut all = Self::default();
        if !PLANS_ALL_LEVERS || !machine.levers.chains.is_some_and(|l| l.edge_starts) {
            return all;
        }
        let is_skeleton = |c: u32| sheet.contours.get(c as usize).is_some_and(|c| c.skeleton);
        let kerfs = Kerfs::new(plan, is_skeleton);
        let edge = edge_of(sheet).unwrap_or_default();
        let mut cuts: Vec<(u32, Vec<usize>)> = Vec::new();
        let mut place = vec![None; sheet.contours.len()];
        for (step, m) in plan.moves.iter().enumerate() {
            let Move::Cut { contour, path, .. } = m else { continue };
            if !is_skeleton(*contour) || !sheet.is_cut_once(*contour, machine) {
                continue;
            }
            let known = *place[*contour as usize].get_or_insert(cuts.len());
            match cuts.get_mut(known) {
                Some(cut) => cut.1.push(step),
                None => cuts.push((*contour, vec![step])),
            }
            let Some(at) = path.first().map(Segment::start) else { continue };
            let on_edge = edge.iter().any(|s| s.nearest(at).1.sqrt() <= SAME);
            if on_edge || kerfs.at(at).iter().any(|k| k.0 < step) {
                all.allowed.push(step);
            }
        }
        let pierced = |step: usize| step > 0 && matches!(plan.moves.get(step - 1), Some(Move::Pierce));
        cuts.retain(|(_, steps)| steps.iter().any(|&step| !pierced(step)));
        all.held = vec![false; sheet.contours.len()];
        cuts.iter().for_each(|c| all.held[c.0 as usize] = true);
        all.followed = cuts;
        all
    }

    /// Whether a move may cut without piercing.
    pub(super) fn allow(&self, step: usize) -> bool {
        PLANS_ALL_LEVERS && self.allowed.binary_search(&step).is_ok()
    }

    /// Whether a contour is followed here.
    pub(super) fn hold(&self, contour: u32) -> bool {
        PLANS_ALL_LEVERS && self.held.get(contour as usize) == Some(&true)
    }

    /// Each is cut from end to end.
    pub(super) fn finish(&self, sheet: &Sheet, plan: &Plan, found: &mut Vec<Violation>) {
        for (contour, steps) in &self.followed {
            let Some(path) = sheet.contours.get(*contour as usize).map(|c| &c.path) else { continue };
            let (Some(start), Some(end)) = (path.start(), path.end()) else { continue };
            let stretches: Vec<[DVec2; 2]> = steps
                .iter()
                .filter_map(|&step| match plan.moves.get(step) {
                    Some(Move::Cut { path, .. }) => Some([path.first()?.start(), path.last()?.end()]),
                    _ => None,
                })
                .collect();
            let same = |a: DVec2, b: DVec2| a.distance(b) <= SAME;
            let ends = |a: DVec2, b: DVec2| same(a, start) && same(b, end) || same(a, end) && same(b, start);
            let is_whole = match stretches.as_slice() {
                [[from, to]] => ends(*from, *to),
                [[from, to], [again, other]] => {
                    let between = from.distance(start) + from.distance(end) - start.distance(end);
                    same(*from, *again) && ends(*to, *other) && between <= SAME
                }
                _ => false,
            };
            if !is_whole {
                let step = steps.first().copied().unwrap_or_default();
                found.push(Violation::Beam { step, what: "does not cut a skeleton cut from end to end" });
            }
        }
    }
}
