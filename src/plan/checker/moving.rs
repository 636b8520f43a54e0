//! Checks moving starts: only where the machine has them, and only of marks and of closed cuts in one pass, without joints, that
//! are cut again over the length at which the beam was not through.

use super::fly::Flown;
use super::groups::Groups;
use super::joints;
use super::macros::joined;
use super::violation::Violation;
use crate::geometry::Segment;
use crate::machine::Profile;
use crate::plan::model::{Move, Plan};
use crate::sheet::{Operation, Sheet};

/// Largest error of the length that is cut again, mm.
const LENGTH: f64 = 1e-3;

pub(super) fn check(
    sheet: &Sheet,
    machine: &Profile,
    plan: &Plan,
    flown: &Flown,
    found: &mut Vec<Violation>,
) {
    if !plan.moves.contains(&Move::MovingStart) {
        return;
    }
    let groups = Groups::new(sheet, machine, plan);
    let grouped = sheet.may_be_cut_as_one(machine.cuts_as_one());
    // A cut may pause in sharp corners. Faults of these pauses are reported elsewhere.
    let moves = joined(&plan.moves, machine, &groups, &mut Vec::new());
    let begins = |m: &Move| *m == Move::MovingStart;
    for pair in moves.windows(2).filter(|pair| begins(&pair[0].1)) {
        let (step, next) = (pair[0].0, pair[1].1.as_ref());
        let mut fault = |what| found.push(Violation::Beam { step, what });
        // Those of cuts on the run are checked with them.
        if matches!(next, Move::Cut { contour, .. } if flown.holds(*contour)) {
            continue;
        }
        let Some(lever) = machine.levers.moving_pierce else {
            fault("begins moving, which the machine does not");
            continue;
        };
        let Move::Cut { contour, path, leads, .. } = next else {
            fault("begins moving without a cut");
            continue;
        };
        let Some(known) = sheet.contours.get(*contour as usize) else { continue };
        if sheet.process_of(known, machine).passes > 1 {
            fault("begins one of several passes moving");
        }
        if known.operation == Operation::Mark {
            continue;
        }
        let asks = joints::asked(sheet, machine, *contour).is_some();
        let has_joints = asks && grouped.get(*contour as usize) != Some(&true);
        let at_rest = groups.holds(*contour) || has_joints;
        if !known.path.closed || at_rest {
            fault("begins a cut moving that has to be pierced at rest");
        }
        let again: f64 = leads.divide(path)[2].iter().map(Segment::length).sum();
        if again < lever.overcut.min(0.5 * known.path.length()) - LENGTH {
            fault("begins moving and does not cut the beginning again");
        }
    }
}
