//! Checks from the moves and the geometry alone that a plan does what the sheet requires.
//!
//! The checker shares no code with the solvers or with the conversion of solutions to plans. It determines itself which
//! contour lies inside which (`nesting.rs`), follows the head from move to move (`head.rs`) and every cut along its contour (`coverage.rs`), checks that parts come
//! out as drawn (`kerf.rs`), and adds up lengths and times (`sums.rs`) with its own formula for trapezoidal motion (`textbook.rs`). It does
//! share the geometry (points and lengths of elements) and the look-ahead along a contour, which has its own oracle.

mod bridge_cuts;
mod bridges;
mod chains;
mod corners;
mod coverage;
mod cut_apart;
mod fly;
mod followed;
mod fractions;
mod group_work;
mod groups;
mod head;
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
mod over;
mod passes;
mod rapids;
mod skeleton;
mod skeleton_starts;
mod sums;
mod textbook;
mod tip_sizes;
mod tips;
mod tolerance;
mod violation;
mod visits;
mod waste;

pub use violation::Violation;

use super::model::{Move, Plan};
use crate::geometry::Segment;
use crate::machine::Profile;
use crate::sheet::Sheet;
use followed::Followed;
use tolerance::{JOIN, SAME};

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
    let mut followed = Followed::new(sheet, machine, plan);
    head::follow(&mut followed, sheet, machine, plan, &mut found);
    pre_cuts(machine, plan, &mut found);
    followed.finish(sheet, machine, plan, &mut found);
    let Followed { visits, groups, flown, .. } = &followed;
    order::check(sheet, machine, visits, groups, &mut found);
    passes::check(sheet, machine, plan, visits, &mut found);
    sums::check(sheet, machine, groups, as_planned, &mut found);
    kerf::check(sheet, machine, plan, &mut found);
    leads::check(sheet, machine, plan, |c| flown.holds(c), &mut found);
    corners::check(sheet, machine, as_planned, |c| flown.holds(c), &mut found);
    chains::check(sheet, machine, plan, &mut found);
    bridges::check(sheet, machine, plan, &mut found);
    bridge_cuts::check(sheet, machine, visits, &mut found);
    moving::check(sheet, machine, plan, flown, &mut found);
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
