//! How programs begin and end: dark at the end, whatever the last motion was, and with lines of the dialect's own.

use super::{machine, with};
use crate::testkit::plans;
use kerfway::geometry::{Arc, DVec2, Path, Segment};
use kerfway::machine::dialect::{Dialect, DialectChoice, dialects};
use kerfway::machine::{Process, Profile, Start};
use kerfway::output::{self, SheetFacts};
use kerfway::plan;
use kerfway::sheet::Operation;
use std::f64::consts::{PI, TAU};

fn dialect(name: &str) -> Dialect {
    dialects().into_iter().find(|d| d.name == name).unwrap()
}

/// The program of one line, or of a circle, on a machine, checked.
fn program(path: Path, profile: &Profile, start: Start) -> String {
    let stop = plans::Stop { layer: 0, operation: Operation::Cut, path };
    let (sheet, mut plan) = plans::plan_of(vec![stop], &[("0", 7)], profile);
    plan.summary = plan::evaluate(&plan.moves, &sheet, profile);
    let text = output::gcode(&plan, &SheetFacts::of(&sheet), profile, "x", start).unwrap();
    assert_eq!(output::check_against(&text, profile, &plan).unwrap().problems, [], "{text}");
    text
}

fn line() -> Path {
    Path::new(vec![Segment::line(DVec2::new(40.0, 10.0), DVec2::new(20.0, 10.0))], false)
}

/// The lines after the last one that cuts, without comments and waits.
fn tail(text: &str) -> Vec<&str> {
    let lines: Vec<&str> =
        text.lines().filter(|l| !l.starts_with(['(', ';', '%']) && !l.starts_with("G4")).collect();
    let last =
        lines.iter().rposition(|l| ["G1 ", "G2 ", "G3 "].iter().any(|cut| l.starts_with(cut))).unwrap();
    lines[last + 1..].to_vec()
}

#[test]
fn a_program_that_ends_at_its_last_cut_takes_the_power_back() {
    for dialect in dialects() {
        let stays = Profile { return_home: false, ..with(&machine(), DialectChoice::named(&dialect.name)) };
        let text = program(line(), &stays, Start::Absolute);
        let end = tail(&text);
        match dialect.name.as_str() {
            // S stays in force, and the next motion would have it.
            "smoothie" => assert!(end.contains(&"G0 X20 Y10 S0"), "{end:?}"),
            // The beam goes off with the next motion: back by half of the line, and forth again.
            "mach4-m67" => assert_eq!(end[..3], ["M67 E0 Q0", "G0 X30 Y10", "G0 X20 Y10"], "{end:?}"),
            _ => {}
        }
    }
}

/// A part that is entered where the machine's home is leaves no way home, though the machine returns.
#[test]
fn a_circle_that_is_cut_from_home_ends_dark_too() {
    let home = Profile { home: [20.0, 10.0], ..machine() };
    let circle = Arc::from_angles(DVec2::new(30.0, 10.0), 10.0, PI, TAU);
    let ring = Path::new(vec![Segment::Arc(circle)], true);
    for dialect in dialects() {
        let profile = with(&home, DialectChoice::named(&dialect.name));
        let text = program(ring.clone(), &profile, Start::Absolute);
        if dialect.name == "mach4-m67" {
            assert_eq!(tail(&text)[..3], ["M67 E0 Q0", "G0 X40 Y10", "G0 X20 Y10"], "{text}");
        }
    }
}

#[test]
fn commands_of_the_dialect_that_call_programs_are_its_own() {
    let air = Profile { cut: Process { air: true, ..machine().cut }, ..machine() };
    let text = program(line(), &with(&air, DialectChoice::named("template")), Start::Absolute);
    assert!(
        dialect("template").air.is_some_and(|air| text.contains(&air.on) && text.contains(&air.off)),
        "{text}"
    );
}

#[test]
fn a_header_without_blanks_is_made_relative() {
    let mut glued = dialect("grbl-m4");
    glued.header.iter_mut().for_each(|line| *line = line.replace(' ', ""));
    let profile = with(&machine(), DialectChoice::Document(Box::new(glued)));
    assert!(program(line(), &profile, Start::Current).contains("G21G91G91.1G17G94"));
    assert!(program(line(), &profile, Start::Absolute).contains("G21G90G91.1G17G94"));
}
