//! The preflight: reads a program back by the rules of its dialect and says what the machine would do with it.
//!
//! Every program that Kerfway writes passes it before it leaves the core, and files of other programs can be checked too.
//! It follows the head and the beam line by line (`reader.rs`, `beam.rs`, `macros.rs`), puts together what is cut (`contours.rs`), and
//! compares that with the machine, with the plan or with what the file's own header says (`expected.rs`, `rules.rs`).
//!
//! A program **fails** if it has a problem of severity error. For programs of others some rules are warnings, because a
//! file alone cannot show the settings of its controller: whether GRBL's laser mode is on, for example.

mod beam;
mod contours;
mod expected;
mod macros;
mod problem;
mod program;
mod reader;
mod report;
mod rules;
mod totals;
mod words;

pub use problem::{Code as CheckCode, Problem as CheckProblem};
pub use report::Check;

use super::checksum::is_changed;
use crate::machine::Profile;
use crate::machine::dialect::Dialect;
use crate::plan::Plan;
use expected::Expected;
use problem::Problems;

const CHANGED: &str = "The program is not as Kerfway wrote it: lines were changed, added or removed since. Write it again; if that was \
    on purpose, delete the first line and the line with the checksum, and check the program once more.";

/// Checks a program against the machine that is to run it, and against its own header if Kerfway wrote it.
///
/// # Errors
/// The machine's dialect cannot be used.
pub fn check(program: &str, profile: &Profile) -> Result<Check, String> {
    let dialect = profile.dialect.document()?;
    Ok(run(program, profile, &dialect, None))
}

/// Checks a program against the plan it was written from. Whether that may leave the bed has been decided before, with the options of
/// its placement, so here it is no problem.
///
/// # Errors
/// The machine's dialect cannot be used.
pub fn check_against(program: &str, profile: &Profile, plan: &Plan) -> Result<Check, String> {
    let dialect = profile.dialect.document()?;
    Ok(run(program, profile, &dialect, Some(plan)))
}

fn run(text: &str, profile: &Profile, dialect: &Dialect, plan: Option<&Plan>) -> Check {
    let mut problems = Problems::default();
    let program = reader::follow(text, dialect, &mut problems);
    let expected = plan.map_or_else(|| Expected::of_comments(&program.comments), Expected::of_plan);
    let cuts = contours::cuts(&program.events);
    rules::beam(&program, dialect, profile, &expected, &mut problems);
    let figures = report::figures(&program, &cuts, profile);
    totals::compare(&figures, &expected, dialect, profile, &mut problems);
    if expected.by_kerfway && is_changed(text) {
        problems.error(CheckCode::Changed, None, || CHANGED.into());
    }
    report::report(figures, problems, profile, dialect)
}
