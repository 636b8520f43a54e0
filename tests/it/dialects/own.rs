//! Dialects of a person's own: what they may say is followed, and what they may not say is refused in a sentence.

use super::{machine, with};
use crate::testkit::plans;
use kerfway::machine::dialect::{Dialect, DialectChoice, DwellUnit, dialects};
use kerfway::machine::{Profile, Start};
use kerfway::output::{self, Check};
use kerfway::plan;

/// A shipped dialect after a change.
fn own(name: &str, change: impl FnOnce(&mut Dialect)) -> Profile {
    let mut dialect = dialects().into_iter().find(|d| d.name == name).unwrap();
    change(&mut dialect);
    with(&machine(), DialectChoice::Document(Box::new(dialect)))
}

/// The program of the small plan, with what the check says of it against the plan.
fn written(profile: &Profile) -> (String, Check) {
    let (sheet, mut plan) = plans::small();
    plan.summary = plan::evaluate(&plan.moves, &sheet, profile);
    let text =
        output::gcode(&plan, &output::SheetFacts::of(&sheet), profile, "test.dxf", Start::Absolute).unwrap();
    let check = output::check_against(&text, profile, &plan).unwrap();
    (text, check)
}

/// What the check says of a program that it should pass.
fn passes(profile: &Profile) -> String {
    let (text, check) = written(profile);
    assert!(check.problems.is_empty(), "{:?}\n{text}", check.problems);
    text
}

fn refusal(profile: &Profile) -> String {
    profile.validate().unwrap_err().to_string()
}

#[test]
fn a_footer_with_comments_and_blank_lines_is_found_at_the_end() {
    let lines =
        ["", "(the end)", "; after {time}", "M98 P9002 (beam off)", "T{contours}", "M400 ; wait", "M30", ""];
    let profile = own("template", |d| d.footer = lines.map(str::to_owned).to_vec());
    let text = passes(&profile);
    // Without one of its commands it is not complete.
    for command in ["M98 P9002 (beam off)\r\n", "M400 ; wait\r\n", "M30\r\n"] {
        let cut = text.replacen(command, "", 1);
        assert_ne!(cut, text, "{command}");
        let check = output::check(&cut, &profile).unwrap();
        assert!(check.problems.iter().any(|p| p.message.starts_with("The end of the program is missing")));
    }
}

#[test]
fn a_long_footer_is_found_at_the_end() {
    passes(&own("template", |d| d.footer.splice(0..0, (0..40).map(|k| format!("T{k}"))).for_each(drop)));
}

#[test]
fn macros_that_set_variables_are_followed() {
    let lines = |list: &[&str]| list.iter().map(|l| (*l).to_owned()).collect::<Vec<_>>();
    let profile = own("template", |d| {
        d.power.on = lines(&["#500={power}", "M98 P9001"]);
        d.power.off = lines(&["#500=0"]);
        d.pierce.as_mut().unwrap().lines = lines(&["#500={power}", "#501={seconds}", "M98 P9003"]);
        d.header.retain(|l| l != "M98 P9002");
        d.footer = lines(&["M30"]);
    });
    let text = passes(&profile);
    assert!(text.contains("#500=80\r\n#501=0.254\r\nM98 P9003\r\n"), "{text}");
    let problems = |text: String| output::check(&text, &profile).unwrap().problems;
    let of = |changed: String| problems(changed).into_iter().map(|p| p.message).collect::<Vec<_>>();
    let stronger = of(text.replace("#500=80", "#500=800"));
    assert!(stronger.iter().any(|m| m.contains("sets the power 800; it goes from 0 to 100")), "{stronger:?}");
    let longer = of(text.replace("#501=0.254", "#501=254"));
    assert!(longer.iter().any(|m| m.contains("waits 254 s")), "{longer:?}");
    let lit = of(text.replace("#500=0\r\n", ""));
    assert!(
        lit.iter().any(|m| m.contains("is a rapid") && m.contains("with the beam on, at power 20")),
        "{lit:?}"
    );
}

#[test]
fn a_macro_that_pierces_by_a_dwell_keeps_the_power() {
    let profile = own("template", |d| {
        d.pierce.as_mut().unwrap().lines = vec!["M98 P9001 S{power}".into(), "G4 X{seconds}".into()];
    });
    let text = passes(&profile);
    // Without the lines that switch the beam off at the beginning and after the first cut.
    let lit = text.replacen("M98 P9002\r\n", "", 2);
    assert_ne!(lit, text);
    let problems = output::check(&lit, &profile).unwrap().problems;
    assert!(problems.iter().any(|p| p.message.contains("with the beam on, at power 20")), "{problems:?}");
}

#[test]
fn placeholders_that_a_macro_has_no_value_for_are_refused() {
    let feed = own("template", |d| d.pierce.as_mut().unwrap().lines.push("G1 F{feed}".into()));
    assert_eq!(
        refusal(&feed),
        "In \"pierce.lines\" of the dialect \"template\": There is no placeholder named \"feed\". Choose one of: power, seconds."
    );
    let seconds = own("template", |d| d.power.on = vec!["M98 P9001 S{power} Q{seconds}".into()]);
    assert_eq!(
        refusal(&seconds),
        "In \"power.on\" of the dialect \"template\": There is no placeholder named \"seconds\". Choose one of: power."
    );
    let air = own("template", |d| d.air.as_mut().unwrap().off = "M9 {power}".into());
    assert_eq!(
        refusal(&air),
        "The dialect \"template\" has a line in \"air.off\" with the placeholder \"power\", but it is written as it is: M9 {power}"
    );
}

/// Siemens controls wait with `G4 F2`, which leaves the feed as it is.
#[test]
fn a_dwell_in_the_word_f_is_no_feed() {
    for (word, unit) in [("F", DwellUnit::S), ("X", DwellUnit::Ms)] {
        let profile = own("grbl-m4", |d| {
            let dwell = d.dwell.as_mut().unwrap();
            (dwell.word, dwell.unit) = (word.into(), unit);
        });
        let text = passes(&profile);
        let wait = if unit == DwellUnit::S { "G4 F0.254\n" } else { "G4 X254\n" };
        assert!(text.contains(wait), "{text}");
    }
}

#[test]
fn a_power_word_that_the_commands_do_not_take_is_refused() {
    let word = |name: &str, word: &str| refusal(&own(name, |d| d.power.word = word.into()));
    assert_eq!(
        word("linuxcnc-m67", "S"),
        "The dialect \"linuxcnc-m67\" sets the power by \"output-m67\" with the word S, which these commands do not take: set \"power.word\" to \"Q\"."
    );
    for (name, by) in [
        ("grbl-m4", "laser-m4"),
        ("grbl-m3", "laser-m3"),
        ("linuxcnc-spindle", "spindle-m3"),
        ("marlin-inline", "inline-m3"),
        ("marlin-fan", "fan-m106"),
        ("smoothie", "motion"),
    ] {
        assert_eq!(
            word(name, "Q"),
            format!(
                "The dialect \"{name}\" sets the power by \"{by}\" with the word Q, which these commands do not take: set \"power.word\" to \"S\"."
            )
        );
    }
    // Macros hold the power where their lines say so.
    passes(&own("template", |d| d.power.word = "Q".into()));
}
