//! Follows the head through the moves of a plan: each move is joined to the one before it and finite, the beam is on only along
//! contours and after piercing, and the path ends at home.
//!
//! What is cut of each contour is followed elsewhere (`followed.rs`).

use super::followed::Followed;
use super::macros;
use super::tolerance::JOIN;
use super::violation::Violation;
use crate::geometry::{DVec2, Segment};
use crate::machine::Profile;
use crate::plan::model::{Move, Plan};
use crate::sheet::{Operation, Sheet};
use std::mem;

/// What a move means for the one after it.
#[derive(Clone, Copy, Default)]
struct Before {
    /// The contour that it cut.
    cut: Option<u32>,
    /// Whether the head runs on to the next cut.
    runs_on: bool,
    /// Whether the beam is still on after a chain.
    chained: bool,
}

/// A joint that was left and after which the contour was not cut on yet.
#[derive(Clone, Copy)]
struct Joint {
    contour: u32,
    /// Whether it was left without a stop.
    flying: bool,
}

/// The head and its beam between two moves.
struct Head<'c, 's> {
    sheet: &'s Sheet,
    machine: &'c Profile,
    plan: &'c Plan,
    followed: &'c mut Followed<'s>,
    found: &'c mut Vec<Violation>,
    /// Where it is, mm.
    at: DVec2,
    /// Whether it pierced, or begins moving, for a cut that has not begun.
    pierced: bool,
    moving: bool,
    left: Option<Joint>,
    before: Before,
}

/// Follows the head from home through all moves.
pub(super) fn follow<'s>(
    followed: &mut Followed<'s>,
    sheet: &'s Sheet,
    machine: &Profile,
    plan: &Plan,
    found: &mut Vec<Violation>,
) {
    let moves = macros::joined(&plan.moves, machine, &followed.groups, found);
    let mut head = Head {
        sheet,
        machine,
        plan,
        followed,
        found,
        at: machine.home(),
        pierced: false,
        moving: false,
        left: None,
        before: Before::default(),
    };
    for (step, m) in moves {
        head.follow(step, m.as_ref());
    }
    head.finish();
}

impl Head<'_, '_> {
    fn wrong(&mut self, step: usize, what: &'static str) {
        self.found.push(Violation::Beam { step, what });
    }

    /// Follows one move.
    fn follow(&mut self, step: usize, m: &Move) {
        let before = mem::take(&mut self.before);
        self.breaks_off(step, m, before);
        match m {
            Move::Joint { contour, path, flying } => {
                if before.cut != Some(*contour) || !self.followed.visits.joint(*contour, path) {
                    self.wrong(step, "leaves a joint where no contour is being cut");
                }
                self.along(step, path);
                self.left = Some(Joint { contour: *contour, flying: *flying });
            }
            Move::Macro { .. } => {}
            Move::Chain { path } => {
                // On which kerf it begins after an air move or a wait is looked at elsewhere.
                let starts = before.cut.is_some()
                    || step > 0 && matches!(self.plan.moves[step - 1], Move::Air { .. } | Move::Wait { .. });
                if !starts || path.is_empty() {
                    self.wrong(step, "cuts through waste without a cut before it");
                }
                self.along(step, path);
                self.before.chained = true;
            }
            Move::Fly { path } => {
                if before.cut.is_none() {
                    self.wrong(step, "runs on without a cut before it");
                }
                self.along(step, path);
                self.before.runs_on = true;
            }
            Move::Air { to, .. } => {
                if !to.is_finite() {
                    self.found.push(Violation::NotFinite { step });
                }
                if self.pierced || mem::take(&mut self.moving) {
                    self.wrong(step, "moves away from where it pierced");
                }
                self.pierced = false;
                self.at = *to;
            }
            Move::Height { z } => {
                if !z.is_finite() {
                    self.found.push(Violation::NotFinite { step });
                }
                self.wrong_if_begun(step, "is lowered or raised after it pierced");
            }
            Move::Wait { seconds } => {
                if !seconds.is_finite() || *seconds <= 0.0 {
                    self.found.push(Violation::NotFinite { step });
                }
                self.wrong_if_begun(step, "waits after it pierced");
            }
            Move::Pierce => {
                self.wrong_if_begun(step, "pierces twice");
                self.pierced = true;
            }
            Move::MovingStart => {
                self.wrong_if_begun(step, "pierces twice");
                self.moving = true;
            }
            Move::PreCut { contour, to, ahead } if self.followed.groups.holds(*contour) => {
                self.pre_cut_of_group(step, *contour, *to, ahead, before);
            }
            Move::PreCut { contour, to, ahead } => self.pre_cut(step, *contour, *to, ahead, before),
            Move::Cut { contour, with, path, mark, leads, .. } => {
                let begun = self.begin(step, *contour, *mark, before);
                let operation = if *mark { Operation::Mark } else { Operation::Cut };
                if self.sheet.contours.get(*contour as usize).is_some_and(|c| c.operation != operation) {
                    self.found.push(Violation::Operation { step, contour: *contour });
                }
                self.along_cut(step, path);
                self.followed.cut(step, (*contour, with), (path, leads), begun, self.found);
                self.before.cut = Some(*contour);
                if path.is_empty() {
                    self.wrong(step, "cuts nothing");
                }
            }
        }
    }

    /// Reports what the moves before this one began and it does not go on with.
    fn breaks_off(&mut self, step: usize, m: &Move, before: Before) {
        if before.runs_on && !matches!(m, Move::Cut { .. }) {
            self.wrong(step, "runs on without a cut after it");
        }
        if before.chained && !matches!(m, Move::Cut { mark: false, .. }) {
            self.wrong(step, "cuts through waste without a cut after it");
        }
        if !matches!(m, Move::Cut { .. } | Move::Pierce) && self.left.take().is_some() {
            self.wrong(step, "does not cut on after a joint");
        }
    }

    /// Reports what the head does after the beam was made ready for a cut.
    fn wrong_if_begun(&mut self, step: usize, what: &'static str) {
        if self.pierced || self.moving {
            self.wrong(step, what);
        }
    }

    /// Follows a path that begins where the head is.
    fn along(&mut self, step: usize, path: &[Segment]) {
        for s in path {
            let gap = s.start().distance(self.at);
            if !gap.is_finite() || gap > JOIN {
                self.found.push(Violation::NotJoined { step, gap });
            }
            self.at = s.end();
        }
    }

    /// Follows the path of a cut.
    fn along_cut(&mut self, step: usize, path: &[Segment]) {
        for s in path {
            let gap = s.start().distance(self.at);
            if !gap.is_finite() || !s.length().is_finite() {
                self.found.push(Violation::NotFinite { step });
            } else if gap > JOIN {
                self.found.push(Violation::NotJoined { step, gap });
            }
            self.at = s.end();
        }
    }

    /// Follows a pre-cut at a node of a pierce group, after which the cut before it may go on.
    fn pre_cut_of_group(&mut self, step: usize, contour: u32, to: DVec2, ahead: &[Segment], before: Before) {
        self.before.cut = before.cut;
        let groups = &mut self.followed.groups;
        let there = self.pierced || before.cut.is_some_and(|b| groups.same(b, contour));
        if !groups.pre_cut(contour, to, ahead) || !there || to.distance(self.at) > JOIN {
            self.wrong(step, "makes a pre-cut where there is nothing to make it for");
        }
    }

    /// Follows a pre-cut into a contour that is left unfinished.
    fn pre_cut(&mut self, step: usize, contour: u32, to: DVec2, ahead: &[Segment], before: Before) {
        if !self.followed.visits.pre_cut(contour, ahead) || before.cut != Some(contour) {
            self.wrong(step, "makes a pre-cut where it leaves nothing unfinished");
        }
        // The head returns; the time this takes is part of the pre-cut's charge.
        let gap = to.distance(self.at);
        let joined = gap <= JOIN;
        if !joined {
            self.found.push(Violation::NotJoined { step, gap });
        }
        self.at = to;
    }

    /// Checks that the beam is on where a cut begins, and for a good reason. Returns whether the cut of a pierce group may begin here.
    fn begin(&mut self, step: usize, contour: u32, mark: bool, before: Before) -> bool {
        // A mark is not pierced, but may begin moving.
        let moving = mem::take(&mut self.moving) && !mark;
        let pierced = mem::take(&mut self.pierced) || moving;
        let joint = self.left.take();
        if joint.is_some_and(|joint| joint.contour != contour || joint.flying == pierced) {
            self.wrong(step, "does not cut on as a joint asks for");
        }
        let Followed { visits, groups, .. } = &*self.followed;
        let grouped = groups.holds(contour);
        let goes_on = before.cut.is_some_and(|b| groups.same(b, contour));
        let resumed = joint.is_none() && self.followed.is_unfinished(contour);
        let on = pierced || joint.is_some_and(|joint| joint.flying) || before.runs_on || before.chained;
        let on_kerf = self.followed.begins_on_kerf(step);
        let ready = mark || on || on_kerf || resumed && visits.is_ready(contour);
        if mark && pierced {
            self.wrong(step, "pierces for a mark");
        }
        if resumed && pierced {
            self.wrong(step, "pierces where it goes on with a cut");
        }
        if !grouped && !ready {
            self.wrong(step, "cuts without piercing");
        }
        pierced || goes_on
    }

    /// After the last move: nothing that was begun is left, and the head is at home.
    fn finish(self) {
        let Before { runs_on, chained, .. } = self.before;
        if self.pierced || self.moving || runs_on || chained {
            let step = self.plan.moves.len();
            self.found.push(Violation::Beam { step, what: "ends before a cut that it began" });
        }
        let left = self.at.distance(self.machine.home());
        if self.machine.return_home && left > JOIN {
            self.found.push(Violation::NotHome { left });
        }
    }
}
