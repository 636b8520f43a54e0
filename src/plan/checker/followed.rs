//! Hands what is cut of each contour to the one that follows it: `visits.rs` for contours that are cut by themselves, `groups.rs`,
//! `fly.rs` or `skeleton_starts.rs`.

use super::bridge_cuts;
use super::fly::Flown;
use super::groups::Groups;
use super::skeleton_starts::SkeletonStarts;
use super::violation::Violation;
use super::visits::Visits;
use crate::geometry::Segment;
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::plan::model::{Leads, Plan};
use crate::sheet::Sheet;

/// What was cut so far of all contours. Each contour is followed by one of these; the visits also know the order of all cuts.
pub(super) struct Followed<'s> {
    /// Contours that are cut by themselves.
    pub(super) visits: Visits<'s>,
    /// Pierce groups.
    pub(super) groups: Groups<'s>,
    /// Contours that are cut on the run.
    pub(super) flown: Flown,
    /// Skeleton cuts that are not pierced.
    starts: SkeletonStarts,
    /// The moves that may cut through a bridge without piercing, in order.
    through_bridges: Vec<usize>,
}

impl<'s> Followed<'s> {
    pub(super) fn new(sheet: &'s Sheet, machine: &Profile, plan: &Plan) -> Self {
        Self {
            visits: Visits::new(sheet, machine),
            groups: Groups::new(sheet, machine, plan),
            flown: Flown::new(sheet, plan),
            starts: SkeletonStarts::new(sheet, machine, plan),
            through_bridges: if PLANS_ALL_LEVERS { bridge_cuts::on_kerfs(sheet, plan) } else { Vec::new() },
        }
    }

    /// Whether a contour was begun, is not finished, and is cut by itself.
    pub(super) fn is_unfinished(&self, contour: u32) -> bool {
        !self.is_elsewhere(contour) && self.visits.is_unfinished(contour)
    }

    /// Whether the cut of a move may begin without piercing, on a kerf or at the edge of the sheet.
    pub(super) fn begins_on_kerf(&self, step: usize) -> bool {
        self.starts.allow(step) || PLANS_ALL_LEVERS && self.through_bridges.binary_search(&step).is_ok()
    }

    /// Follows a cut of a contour, and of those `with` it. `begun`: it was pierced, or continues where the beam just was.
    pub(super) fn cut(
        &mut self,
        step: usize,
        (contour, with): (u32, &[u32]),
        (path, leads): (&[Segment], &Leads),
        begun: bool,
        found: &mut Vec<Violation>,
    ) {
        if self.flown.holds(contour) {
            self.flown.cut(step, contour, path, leads);
            self.visits.note(step, contour);
        } else if self.starts.hold(contour) {
            self.visits.note(step, contour);
        } else if self.groups.holds(contour) {
            let contours: Vec<u32> = std::iter::once(contour).chain(with.iter().copied()).collect();
            self.groups.cut(step, &contours, leads.divide(path)[1], begun, found);
            contours.iter().for_each(|&c| self.visits.note(step, c));
        } else {
            self.visits.cut(step, contour, leads.divide(path)[1], found);
        }
    }

    /// After the last move: all contours are cut completely.
    pub(super) fn finish(&self, sheet: &Sheet, machine: &Profile, plan: &Plan, found: &mut Vec<Violation>) {
        self.visits.finish(|c| self.is_elsewhere(c), found);
        if PLANS_ALL_LEVERS {
            self.starts.finish(sheet, plan, found);
        }
        self.flown.finish(sheet, machine, plan, found);
        self.groups.finish(|c| self.visits.ends(c), found);
    }

    /// Whether a contour is not followed by the visits.
    fn is_elsewhere(&self, contour: u32) -> bool {
        self.groups.holds(contour) || self.flown.holds(contour) || self.starts.hold(contour)
    }
}
