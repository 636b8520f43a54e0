//! What a run says about the settings of its machine: a file for each kind.
//!
//! What is known from the problem is said when the run begins (`of_problem`), and the rest of each finished plan (`of_plan`).

mod common_cuts;
mod corners;
mod heat;
mod joints;
mod leads;
mod tips;

use crate::finding::Finding;
use crate::machine::Profile;
use crate::plan::Plan;
use crate::problem::Problem;
use crate::sheet::Sheet;

/// The findings on common cuts, leads, joints and corners.
pub(super) fn of_problem(sheet: &Sheet, machine: &Profile, problem: &Problem) -> Vec<Finding> {
    let mut all = common_cuts::findings(sheet, problem);
    all.extend(leads::findings(sheet, machine, problem));
    all.extend(joints::findings(sheet, machine, problem));
    all.extend(corners::findings(machine, problem));
    all
}

/// The findings on pieces that may have tipped, and on cuts that heat each other.
pub(super) fn of_plan(plan: &Plan, machine: &Profile) -> impl Iterator<Item = Finding> {
    tips::finding(plan, machine.home()).into_iter().chain(heat::finding(plan, machine))
}
