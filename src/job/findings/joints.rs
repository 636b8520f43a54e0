//! Findings on the micro-joints of a run.

use crate::finding::Finding;
use crate::joint::{self, Planner};
use crate::machine::Profile;
use crate::problem::Problem;
use crate::sheet::Sheet;

/// What became of the joints of every contour, and which contours have none.
pub(super) fn findings(sheet: &Sheet, machine: &Profile, problem: &Problem) -> Vec<Finding> {
    let Some(planner) = Planner::new(sheet, machine) else { return Vec::new() };
    let outcomes = (0..).zip(&problem.items).filter_map(|(id, i)| Some((id, &i.joints.as_ref()?.outcome)));
    joint::findings(sheet, &planner, outcomes)
}
