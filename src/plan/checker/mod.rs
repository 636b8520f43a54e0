//! Checks from the moves and the geometry alone that a plan does what the sheet requires.
//!
//! The checker shares no code with the solvers or with the conversion of solutions to plans. It determines itself which
//! contour lies inside which (`nesting.rs`), follows every cut along its contour (`coverage.rs`), checks that parts come
//! out as drawn (`kerf.rs`), and adds up lengths and times with its own formula for trapezoidal motion (`sums.rs`). It does
//! share the geometry (points and lengths of elements) and the look-ahead along a contour, which has its own oracle.

mod bridge_cuts;
mod bridges;
mod chains;
mod corners;
mod coverage;
mod cut_apart;
mod fly;
mod fractions;
mod group_work;
mod groups;
mod heat;
mod joint_room;
mod joints;
mod joints_left;
mod kerf;
mod kerfs;
mod lead_room;
mod lead_rules;
mod leads;
mod macros;
mod moving;
mod nesting;
mod order;
mod passes;
mod rapids;
mod skeleton;
mod skeleton_starts;
mod sums;
mod tip_sizes;
mod tips;
mod tolerance;
mod violation;
mod visits;
mod waste;

pub use violation::Violation;

use super::model::{Move, Plan};
use crate::geometry::{DVec2, Segment};
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::sheet::{Operation, Sheet};
use fly::Flown;
use groups::Groups;
use skeleton_starts::SkeletonStarts;
use tolerance::{JOIN, SAME};
use visits::Visits;

/// Checks that every contour is cut or marked completely and exactly once, in one go or as the machine allows; that inner
/// contours are finished before outer ones, and ranks are kept; that moves are joined from home (and back, if the machine
/// returns); that piercings and pre-cuts are where they belong; and that the sums are right.
///
/// # Errors
/// All violations; those of moves are in the order of the moves.
pub fn check(sheet: &Sheet, machine: &Profile, plan: &Plan) -> Result<(), Vec<Violation>> {
    let mut found = Vec::new();
    let as_planned = plan;
    let plan = &*corners::cut_through(plan);
    let mut visits = Visits::new(sheet, machine);
    let mut groups = Groups::new(sheet, machine, plan);
    let mut flown = Flown::new(sheet, plan);
    let starts = SkeletonStarts::new(sheet, machine, plan);
    let through = if PLANS_ALL_LEVERS { bridge_cuts::on_kerfs(sheet, plan) } else { Vec::new() };
    follow(&mut visits, &mut groups, (&mut flown, &starts, &through), sheet, machine, plan, &mut found);
    pre_cuts(machine, plan, &mut found);
    visits.finish(|c| groups.holds(c) || flown.holds(c) || starts.hold(c), &mut found);
    if PLANS_ALL_LEVERS {
        starts.finish(sheet, plan, &mut found);
    }
    flown.finish(sheet, machine, plan, &mut found);
    groups.finish(|c| visits.ends(c), &mut found);
    order::check(sheet, machine, &visits, &groups, &mut found);
    passes::check(sheet, machine, plan, &visits, &mut found);
    sums::check(sheet, machine, &groups, as_planned, &mut found);
    kerf::check(sheet, machine, plan, &mut found);
    leads::check(sheet, machine, plan, |c| flown.holds(c), &mut found);
    corners::check(sheet, machine, as_planned, |c| flown.holds(c), &mut found);
    chains::check(sheet, machine, plan, &mut found);
    bridges::check(sheet, machine, plan, &mut found);
    bridge_cuts::check(sheet, machine, &visits, &mut found);
    moving::check(sheet, machine, plan, &flown, &mut found);
    joints::check(sheet, machine, plan, &mut found);
    skeleton::check(sheet, machine, plan, &mut found);
    tips::check(sheet, machine, plan, &mut found);
    heat::check(sheet, machine, as_planned, &mut found);
    if found.is_empty() { Ok(()) } else { Err(found) }
}

/// Checks that pre-cuts start where the head is and have the length of the machine's pre-cuts.
fn pre_cuts(machine: &Profile, plan: &Plan, found: &mut Vec<Violation>) {
    for (step, m) in plan.moves.iter().enumerate() {
        let Move::PreCut { to, ahead, .. } = m else { continue };
        let length = ahead.iter().map(Segment::length).sum::<f64>();
        let joined = ahead.iter().try_fold(*to, |at, s| (s.start().distance(at) <= JOIN).then(|| s.end()));
        let short =
            length <= machine.pre_cut_length + SAME && (length > 0.0) == (machine.pre_cut_length > 0.0);
        if !short || joined.is_none() {
            found.push(Violation::Beam { step, what: "makes a pre-cut of a wrong length" });
        }
    }
}

/// Follows the head along a path that begins where it is. Returns where it ends.
fn along(path: &[Segment], step: usize, head: DVec2, found: &mut Vec<Violation>) -> DVec2 {
    path.iter().fold(head, |head, s| {
        let gap = s.start().distance(head);
        if !gap.is_finite() || gap > JOIN {
            found.push(Violation::NotJoined { step, gap });
        }
        s.end()
    })
}

/// Follows the head: moves are joined and finite, the beam is on only along contours and after piercing, and the path ends
/// at home.
fn follow(
    visits: &mut Visits,
    groups: &mut Groups,
    (flown, starts, through): (&mut Flown, &SkeletonStarts, &[usize]),
    sheet: &Sheet,
    machine: &Profile,
    plan: &Plan,
    found: &mut Vec<Violation>,
) {
    let mut head = machine.home();
    let (mut pierced, mut moving) = (false, false);
    // The contour of the previous move, if that was a cut.
    let mut just_cut = None;
    // The contour of a joint that was left, and whether without a stop, until the contour is cut on.
    let mut left = None;
    // Whether the head runs on to the next cut.
    let mut flies = false;
    // Whether the beam is still on after a chain.
    let mut chains = false;
    for (step, m) in macros::joined(&plan.moves, machine, groups, found) {
        let before = just_cut.take();
        let runs_on = std::mem::take(&mut flies);
        if runs_on && !matches!(m.as_ref(), Move::Cut { .. }) {
            found.push(Violation::Beam { step, what: "runs on without a cut after it" });
        }
        let chained = std::mem::take(&mut chains);
        if chained && !matches!(m.as_ref(), Move::Cut { mark: false, .. }) {
            found.push(Violation::Beam { step, what: "cuts through waste without a cut after it" });
        }
        if !matches!(m.as_ref(), Move::Cut { .. } | Move::Pierce) && left.take().is_some() {
            found.push(Violation::Beam { step, what: "does not cut on after a joint" });
        }
        match m.as_ref() {
            Move::Joint { contour, path, flying } => {
                if before != Some(*contour) || !visits.joint(*contour, path) {
                    found
                        .push(Violation::Beam { step, what: "leaves a joint where no contour is being cut" });
                }
                head = along(path, step, head, found);
                left = Some((*contour, *flying));
            }
            Move::Macro { .. } => {}
            Move::Chain { path } => {
                // On which kerf it begins after an air move or a wait is looked at elsewhere.
                let starts = before.is_some()
                    || step > 0 && matches!(plan.moves[step - 1], Move::Air { .. } | Move::Wait { .. });
                if !starts || path.is_empty() {
                    found.push(Violation::Beam { step, what: "cuts through waste without a cut before it" });
                }
                head = along(path, step, head, found);
                chains = true;
            }
            Move::Fly { path } => {
                if before.is_none() {
                    found.push(Violation::Beam { step, what: "runs on without a cut before it" });
                }
                head = along(path, step, head, found);
                flies = true;
            }
            Move::Air { to, .. } => {
                if !to.is_finite() {
                    found.push(Violation::NotFinite { step });
                }
                if pierced || std::mem::take(&mut moving) {
                    found.push(Violation::Beam { step, what: "moves away from where it pierced" });
                }
                pierced = false;
                head = *to;
            }
            Move::Height { z } => {
                if !z.is_finite() {
                    found.push(Violation::NotFinite { step });
                }
                if pierced || moving {
                    found.push(Violation::Beam { step, what: "is lowered or raised after it pierced" });
                }
            }
            Move::Wait { seconds } => {
                if !seconds.is_finite() || *seconds <= 0.0 {
                    found.push(Violation::NotFinite { step });
                }
                if pierced || moving {
                    found.push(Violation::Beam { step, what: "waits after it pierced" });
                }
            }
            Move::Pierce => {
                if pierced || moving {
                    found.push(Violation::Beam { step, what: "pierces twice" });
                }
                pierced = true;
            }
            Move::MovingStart => {
                if pierced || moving {
                    found.push(Violation::Beam { step, what: "pierces twice" });
                }
                moving = true;
            }
            Move::PreCut { contour, to, ahead } if groups.holds(*contour) => {
                just_cut = before;
                let there = pierced || before.is_some_and(|b| groups.same(b, *contour));
                if !groups.pre_cut(*contour, *to, ahead) || !there || to.distance(head) > JOIN {
                    found.push(Violation::Beam {
                        step,
                        what: "makes a pre-cut where there is nothing to make it for",
                    });
                }
            }
            Move::PreCut { contour, to, ahead } => {
                if !visits.pre_cut(*contour, ahead) || before != Some(*contour) {
                    found.push(Violation::Beam {
                        step,
                        what: "makes a pre-cut where it leaves nothing unfinished",
                    });
                }
                // The head returns; the time this takes is part of the pre-cut's charge.
                let gap = to.distance(head);
                let joined = gap <= JOIN;
                if !joined {
                    found.push(Violation::NotJoined { step, gap });
                }
                head = *to;
            }
            Move::Cut { contour, with, path, mark, leads, .. } => {
                // A mark is not pierced, but may begin moving.
                pierced |= std::mem::take(&mut moving) && !*mark;
                let grouped = groups.holds(*contour);
                let after_joint = left.take();
                if let Some((of, flying)) = after_joint
                    && (of != *contour || flying == pierced)
                {
                    found.push(Violation::Beam { step, what: "does not cut on as a joint asks for" });
                }
                let resumed = !grouped
                    && !flown.holds(*contour)
                    && !starts.hold(*contour)
                    && after_joint.is_none()
                    && visits.is_unfinished(*contour);
                if *mark && pierced {
                    found.push(Violation::Beam { step, what: "pierces for a mark" });
                }
                if resumed && pierced {
                    found.push(Violation::Beam { step, what: "pierces where it goes on with a cut" });
                }
                let over_joint = after_joint.is_some_and(|(_, flying)| flying);
                let on = pierced || over_joint || runs_on || chained;
                let on_kerf = starts.allow(step) || PLANS_ALL_LEVERS && through.binary_search(&step).is_ok();
                let ready = *mark || on || on_kerf || (resumed && visits.is_ready(*contour));
                let goes_on = before.is_some_and(|b| groups.same(b, *contour));
                let begun = pierced || goes_on;
                if !grouped && !ready {
                    found.push(Violation::Beam { step, what: "cuts without piercing" });
                }
                pierced = false;
                let operation = if *mark { Operation::Mark } else { Operation::Cut };
                if sheet.contours.get(*contour as usize).is_some_and(|c| c.operation != operation) {
                    found.push(Violation::Operation { step, contour: *contour });
                }
                for s in path {
                    let gap = s.start().distance(head);
                    if !gap.is_finite() || !s.length().is_finite() {
                        found.push(Violation::NotFinite { step });
                    } else if gap > JOIN {
                        found.push(Violation::NotJoined { step, gap });
                    }
                    head = s.end();
                }
                if flown.holds(*contour) {
                    flown.cut(step, *contour, path, leads);
                    visits.note(step, *contour);
                } else if starts.hold(*contour) {
                    visits.note(step, *contour);
                } else if grouped {
                    let contours: Vec<u32> = std::iter::once(*contour).chain(with.iter().copied()).collect();
                    groups.cut(step, &contours, leads.divide(path)[1], begun, found);
                    contours.iter().for_each(|&c| visits.note(step, c));
                } else {
                    visits.cut(step, *contour, leads.divide(path)[1], found);
                }
                just_cut = Some(*contour);
                if path.is_empty() {
                    found.push(Violation::Beam { step, what: "cuts nothing" });
                }
            }
        }
    }
    if pierced || moving || flies || chains {
        found.push(Violation::Beam { step: plan.moves.len(), what: "ends before a cut that it began" });
    }
    let left = head.distance(machine.home());
    if machine.return_home && left > JOIN {
        found.push(Violation::NotHome { left });
    }
}
