//! What dialects refuse: programs that were changed, and what a controller cannot do.

use super::{machine, with};
use crate::testkit::plans;
use kerfway::machine::dialect::{Dialect, DialectChoice, dialects};
use kerfway::machine::{Profile, Start};
use kerfway::output;
use kerfway::plan::{self, Plan};

/// A program of the small plan, with the piercing that most mutants change.
fn program(dialect: &str) -> (Profile, Plan, String) {
    // Without a wait after cuts, every rapid has its own S0.
    let machine = Profile { beam_off_delay: 0.0, ..machine() };
    let profile = with(&machine, DialectChoice::named(dialect));
    let (sheet, mut plan) = plans::small();
    plan.summary = plan::evaluate(&plan.moves, &sheet, &profile);
    let text =
        output::gcode(&plan, &output::SheetFacts::of(&sheet), &profile, "test.dxf", Start::Absolute).unwrap();
    (profile, plan, text)
}

/// Whether the check refuses a changed program, both alone and against the plan, and accepts the original.
fn assert_refused(dialect: &str, mutant: &str, change: impl Fn(&str) -> String, codes: &[&str]) {
    let (profile, _, text) = program(dialect);
    let changed = change(&text);
    assert_ne!(changed, text, "{mutant} changes nothing in {dialect}");
    let check = output::check(&changed, &profile).unwrap();
    assert!(!check.passed, "{mutant} passes in {dialect}:\n{changed}");
    let found: Vec<String> = check.problems.iter().map(|p| output::json_text(&p.code)).collect();
    assert!(
        codes.iter().all(|c| found.contains(&format!("\"{c}\""))),
        "{mutant} in {dialect}: {codes:?} not in {found:?}"
    );
}

/// Multiplies the number of every word with this letter in lines that match.
fn scaled(text: &str, letter: char, factor: f64, lines: impl Fn(&str) -> bool) -> String {
    let word = |w: &str| match w.strip_prefix(letter).and_then(|n| n.parse::<f64>().ok()) {
        Some(n) => format!("{letter}{}", n * factor),
        None => w.to_owned(),
    };
    let line = |l: &str| {
        if l.starts_with(';') || l.starts_with('(') || !lines(l) {
            return l.to_owned();
        }
        l.split(' ').map(word).collect::<Vec<_>>().join(" ")
    };
    text.lines().map(|l| line(l) + "\n").collect()
}

#[test]
fn a_wait_in_milliseconds_was_reported_with_the_rounding_of_a_division() {
    let (profile, _, text) = program("marlin-fan");
    let wait = text.lines().find(|l| l.starts_with("G4 ")).unwrap();
    let check = output::check(&text.replacen(wait, "G4 P0.105", 1), &profile).unwrap();
    let told = "waits 0.000105 s; this machine";
    assert!(check.problems.iter().any(|p| p.message.contains(told)), "{:?}", check.problems);
}

#[test]
fn every_mutant_fails_the_preflight() {
    let is_wait = |l: &str| l.starts_with("G4 ");
    for dialect in ["grbl-m4", "grbl-m3", "fluidnc", "grblhal", "linuxcnc-m67", "linuxcnc-spindle"] {
        assert_refused(
            dialect,
            "milliseconds for seconds",
            |t| scaled(t, 'P', 1000.0, is_wait),
            &["wait-out-of-range"],
        );
    }
    for dialect in ["marlin-inline", "marlin-fan"] {
        assert_refused(
            dialect,
            "seconds for milliseconds",
            |t| scaled(t, 'P', 0.001, is_wait),
            &["wait-out-of-range"],
        );
    }
    for (dialect, letter) in [
        ("grbl-m4", 'S'),
        ("fluidnc", 'S'),
        ("marlin-inline", 'S'),
        ("smoothie", 'S'),
        ("linuxcnc-m67", 'Q'),
        ("mach4-m67", 'Q'),
    ] {
        let is_power = |l: &str| !l.starts_with("G4 ") && !l.starts_with("G64");
        assert_refused(
            dialect,
            "power times 255",
            |t| scaled(t, letter, 255.0, is_power),
            &["power-out-of-range"],
        );
    }
    assert_refused("linuxcnc-m67", "M67 for M68", |t| t.replace("M68", "M67"), &["dark-pierce"]);
    let without_s0 = |t: &str| {
        let line = |l: &str| if l.starts_with("G0") { l.replace(" S0", "") } else { l.to_owned() };
        t.lines().map(|l| line(l) + "\n").collect::<String>()
    };
    for dialect in ["grbl-m4", "grbl-m3", "grblhal", "smoothie", "marlin-inline"] {
        assert_refused(dialect, "a dropped S0", without_s0, &["power-on-rapid"]);
    }
    assert_refused("fluidnc", "a dropped S0", without_s0, &["beam-on-rapid"]);
    for dialect in dialects() {
        let shift = |t: &str| {
            let moved = |w: &str| match w.strip_prefix('X').and_then(|n| n.parse::<f64>().ok()) {
                Some(n) => format!("X{}", n + 3.0),
                None => w.to_owned(),
            };
            t.lines().map(|l| if l.starts_with('G') { l.split(' ').map(moved).collect::<Vec<_>>().join(" ") } else { l.to_owned() } + "\n").collect::<String>()
        };
        assert_refused(&dialect.name, "a shifted origin", shift, &["differs"]);
        let doubled = |t: &str| {
            let lines: Vec<&str> = t.lines().collect();
            let starts: Vec<usize> = (0..lines.len()).filter(|&k| lines[k].contains(" contour ")).collect();
            let contour = lines[starts[1]..starts[2]].join("\n") + "\n";
            let at = lines[..starts[2]].join("\n").len() + 1;
            // Back to where the contour begins, then the contour again.
            let back = lines[starts[1] - 1..starts[1]].join("\n") + "\n";
            let text = lines.join("\n") + "\n";
            format!("{}{back}{contour}{}", &text[..at], &text[at..])
        };
        assert_refused(&dialect.name, "a doubled contour", doubled, &["cut-twice"]);
        let truncated =
            |t: &str| t.lines().take(t.lines().count() - 4).map(|l| l.to_owned() + "\n").collect();
        assert_refused(&dialect.name, "half a program", truncated, &["incomplete"]);
    }
    for (dialect, off) in [
        ("grbl-m4", "M5 S0"),
        ("grbl-m3", "M5 S0"),
        ("fluidnc", "M5 S0"),
        ("grblhal", "M5 S0"),
        ("linuxcnc-spindle", "M5"),
        ("linuxcnc-m67", "M68 E0 Q0"),
        ("marlin-fan", "M107 P0"),
        ("template", "M98 P9002"),
    ] {
        let missing = |t: &str| {
            let last_cut = t.rfind("\nG1").or(t.rfind("\nG3")).unwrap();
            let (work, end) = t.split_at(last_cut);
            format!(
                "{work}{}",
                end.lines()
                    .filter(|l| *l != off && !l.starts_with("M67"))
                    .map(|l| l.to_owned() + "\n")
                    .collect::<String>()
            )
        };
        assert_refused(dialect, "a missing M5", missing, &["beam-on-at-end"]);
    }
}

/// These programs add up, and passed when they were checked without their plan.
#[test]
fn a_program_that_was_changed_is_refused_by_its_checksum() {
    for dialect in dialects() {
        let name = &dialect.name;
        let (profile, _, text) = program(name);
        let untouched =
            [text.clone(), text.replace('\n', "\r\n"), text.replace("\r\n", "\n"), text.replace('\n', " \n")];
        for same in untouched {
            assert_eq!(output::check(&same, &profile).unwrap().problems, [], "{name}");
        }
        let words = |from: &'static str, to: &'static str| move |t: &str| t.replacen(from, to, 1);
        if text.contains("\nG2 ") {
            assert_refused(name, "an arc the other way", words("\nG2 ", "\nG3 "), &["changed"]);
        }
        assert_refused(name, "another tool", words("\nG21", "\nM6\nG21"), &["changed"]);
        let lines = |t: &str| t.lines().map(|l| l.to_owned() + "\n").collect::<Vec<_>>();
        let swapped = |t: &str| {
            let lines = lines(t);
            let starts: Vec<usize> = (0..lines.len()).filter(|&k| lines[k].contains(" contour ")).collect();
            // The rapid to each contour is the line before it.
            let [a, b, c] = [starts[0] - 1, starts[1] - 1, starts[2] - 1];
            [&lines[..a], &lines[b..c], &lines[a..b], &lines[c..]].concat().concat()
        };
        assert_refused(name, "another order", swapped, &["changed"]);
        // Without the checksum it is checked like any other program.
        let plain: String = lines(&text).into_iter().filter(|l| !l.contains("checksum")).collect();
        assert_eq!(output::check(&plain, &profile).unwrap().problems, [], "{name}");
        assert!(plain.len() < text.replace("\r\n", "\n").len(), "{name}");
    }
}

#[test]
fn what_a_dialect_cannot_do_is_refused_in_a_sentence_that_names_it() {
    let (sheet, plan) = plans::small();
    let mut smoothie = dialects().into_iter().find(|d| d.name == "smoothie").unwrap();
    smoothie.pierce = None;
    let profile = with(&machine(), DialectChoice::Document(Box::new(smoothie)));
    let error = output::gcode(&plan, &output::SheetFacts::of(&sheet), &profile, "x", Start::Absolute)
        .unwrap_err()
        .to_string();
    assert_eq!(
        error,
        "Smoothieware (dialect \"smoothie\") cannot pierce at rest: set the machine's piercing time and beam-on delay to 0, \
         or choose a dialect that pierces."
    );
}

#[test]
fn a_dialect_that_contradicts_itself_is_refused() {
    let of = |change: fn(&mut Dialect)| {
        let mut dialect = dialects().into_iter().find(|d| d.name == "smoothie").unwrap();
        change(&mut dialect);
        let profile = with(&machine(), DialectChoice::Document(Box::new(dialect)));
        profile.validate().unwrap_err().to_string()
    };
    use kerfway::machine::dialect::PierceBy;
    let error = of(|d| d.pierce.as_mut().unwrap().by = PierceBy::DwellM3);
    assert!(
        error.contains("pierces by \"dwell-m3\", which does not work with power by \"motion\""),
        "{error}"
    );
    let error = of(|d| d.header.push("G21 {secnds}".into()));
    assert!(error.contains("no placeholder named \"secnds\". Did you mean \"seconds\"?"), "{error}");
    let error = of(|d| d.footer.push("M5 ß".into()));
    assert!(error.contains("'ß'"), "{error}");
    let error = of(|d| d.pierce.as_mut().unwrap().length = None);
    assert!(error.contains("give \"pierce.length\""), "{error}");
}
