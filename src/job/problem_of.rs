//! Builds the problem that a search works on from a sheet and a machine.

use crate::machine::Profile;
use crate::problem::{self, Problem};
use crate::sheet::Sheet;
use crate::solve::pierce_group;

/// The problem of cutting a sheet on a machine, including the paths through its pierce groups.
pub fn problem_of(sheet: &Sheet, machine: &Profile) -> Problem {
    let paths = pierce_group::paths(&problem::group_problems(sheet, machine));
    problem::from_sheet(sheet, machine, &paths)
}
