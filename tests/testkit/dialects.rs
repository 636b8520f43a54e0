//! Plans written in every dialect and read back.

use kerfway::machine::Profile;
use kerfway::machine::Start;
use kerfway::machine::dialect::{DialectChoice, dialects};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::Plan;
use kerfway::sheet::Sheet;

/// Plans for the machine in each dialect, writes the program, and checks it by itself and against the plan, which cuts so many
/// `parts`. Only a dialect that cannot dwell may refuse a plan. `also` gets the name of the dialect, each plan and its program.
pub fn read_back(
    machine: &Profile,
    planned: impl Fn(&Profile) -> (Sheet, Plan),
    parts: u32,
    also: impl Fn(&str, &Plan, Option<&str>),
) {
    for dialect in dialects() {
        let profile = Profile { dialect: DialectChoice::named(&dialect.name), ..machine.clone() };
        let profile = if dialect.pierce.is_none() {
            Profile { pierce_time: 0.0, beam_on_delay: 0.0, beam_off_delay: 2.0, ..profile }
        } else {
            profile
        };
        let (sheet, plan) = planned(&profile);
        let text = match output::gcode(&plan, &SheetFacts::of(&sheet), &profile, "plan.dxf", Start::Absolute)
        {
            Ok(text) => text,
            Err(e) => {
                assert!(dialect.dwell.is_none(), "{}: {e}", dialect.name);
                also(&dialect.name, &plan, None);
                continue;
            }
        };
        for check in [output::check_against(&text, &profile, &plan), output::check(&text, &profile)] {
            let check = check.unwrap();
            assert!(check.passed, "{}: {:?}", dialect.name, check.problems);
            assert_eq!(check.parts, parts, "{}", dialect.name);
        }
        also(&dialect.name, &plan, Some(&text));
    }
}
