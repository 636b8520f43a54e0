//! G-code, read back by an interpreter of our own and compared with the plan it came from.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::float_cmp,
    clippy::print_stdout,
    clippy::disallowed_methods,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "tests stop where they cannot go on, compare what must be equal, and share no arithmetic with the product"
)]

use crate::testkit::gcode::{Event, Motion, Program};
use crate::testkit::paths::{Element, assert_same_path};
use glam::DVec2;
use kerfway::geometry::{Arc, Path, Segment};
use kerfway::machine::Profile;
use kerfway::output;
use kerfway::plan::{Move, Plan};
use kerfway::sheet::{Operation, Sheet};
use sha2::Digest;
use std::f64::consts::{PI, TAU};

/// Largest distance between a motion and the element it stands for, mm.
const DEVIATION: f64 = 0.002;

fn program(sheet: &Sheet, plan: &Plan, profile: &Profile) -> Program {
    let text = output::gcode(
        plan,
        &output::SheetFacts::of(sheet),
        profile,
        "test.dxf",
        kerfway::machine::Start::Absolute,
    )
    .unwrap();
    crate::testkit::gcode::run(&text).unwrap_or_else(|e| panic!("{e}"))
}

/// The motions with the beam on of each contour, in order: what follows the comment that announces it.
fn worked(program: &Program) -> Vec<Vec<Motion>> {
    let mut contours = Vec::new();
    for event in &program.events {
        match event {
            Event::Comment(text) if text.contains(" contour ") => contours.push(Vec::new()),
            Event::Motion(m) if !m.rapid => contours.last_mut().unwrap().push(m.clone()),
            _ => {}
        }
    }
    contours
}

fn elements(motions: &[Motion]) -> Vec<Element> {
    motions.iter().map(|m| m.path).collect()
}

/// Whether the program does what the plan says: order, geometry both ways, lengths, feed, power, darkness, way home.
fn assert_same(sheet: &Sheet, plan: &Plan, profile: &Profile) {
    let program = program(sheet, plan, profile);
    assert!(program.ended);
    for m in program.motions() {
        if m.rapid {
            assert_eq!((m.beam, m.commanded), (0.0, 0.0), "beam on a rapid: {m:?}");
        } else {
            assert!(m.beam > 0.0, "dark at work: {m:?}");
        }
    }

    let cuts: Vec<(&[Segment], bool)> = plan
        .moves
        .iter()
        .filter_map(|m| match m {
            Move::Cut { path, mark, .. } => Some((path.as_slice(), *mark)),
            _ => None,
        })
        .collect();
    let worked = worked(&program);
    assert_eq!(worked.len(), cuts.len());
    for (motions, (path, mark)) in worked.iter().zip(&cuts) {
        let process = if *mark { &profile.mark } else { &profile.cut };
        for m in motions {
            assert_eq!(m.feed, process.speed * 60.0);
            assert_eq!(m.beam, process.power * profile.max_s);
        }
        assert_same_path(&elements(motions), path, DEVIATION);
    }

    let air: f64 = program.motions().filter(|m| m.rapid).map(|m| m.path.length()).sum();
    let rounding = DEVIATION * plan.moves.len() as f64;
    assert!((air - plan.summary.air_length).abs() <= rounding, "{air} {}", plan.summary.air_length);
    if profile.return_home {
        let last = program.motions().last().unwrap();
        // A contour through home may end there, a hair away or not at all.
        assert_eq!(last.path.to, profile.home());
    }
}

#[test]
fn a_small_plan_comes_back_as_planned() {
    let (sheet, plan) = crate::testkit::plans::small();
    assert_same(&sheet, &plan, &crate::testkit::plans::machine());
}

#[test]
fn a_small_plan_reads_as_expected() {
    let (sheet, plan) = crate::testkit::plans::small();
    let text = output::gcode(
        &plan,
        &output::SheetFacts::of(&sheet),
        &crate::testkit::plans::machine(),
        "plate (v2)! \u{df}?.dxf",
        kerfway::machine::Start::Absolute,
    )
    .unwrap();
    let version = env!("CARGO_PKG_VERSION");
    let expected = format!(
        "; Kerfway {version}, plate v2_ __.dxf
; machine test
; Test 100 W
; 3 contours, 2 pierces
; cut 195.7 mm, air 70.7 mm
; time: about 12.5 s
; unit: mm
; x 10 to 50, y 10 to 40
; GRBL 1.1, laser mode on, setting 32 at 1
M5 S0
G21 G90 G91.1 G17 G94
M4 S0
G0 X0 Y0
G0 X12 Y11
; 1 of 3: mark contour 0, layer Gravur ___
G1 X38 Y11 F6000 S200
G0 X25 Y25 S0
; 2 of 3: cut contour 1, layer Cut 3mm
G1 M3 S800 F1500
G4 P0.5
M4
G2 X35 Y25 I5 J0
G2 X25 Y25 I-5 J0
G0 X10 Y10 S0
; 3 of 3: cut contour 2, layer Cut 3mm
G1 M3 S800 F1500
G4 P0.5
M4
G1 X50 Y10
G1 X50 Y36
G3 X46 Y40 I-4 J0
G1 X10 Y40
G1 X10 Y10
M5 S0
G0 X0 Y0
; checksum 0000000000000000
M2
"
    );
    let sum: String = sha2::Sha256::digest(&expected).iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(text, expected.replace("0000000000000000", &sum[..16]));
}

#[test]
fn no_fact_of_the_header_is_cut_off() {
    let (sheet, mut plan) = crate::testkit::plans::small();
    let s = &mut plan.summary;
    (s.contours, s.pierces) = (u32::MAX, u32::MAX);
    (s.cut_length, s.air_length, s.total_time) = (123_456_789_012.3, 98_765_432_109.8, 1_234_567_890.1);
    s.bounds = [-131_071.9, -131_071.9, 131_071.9, 131_071.9];
    let profile = Profile {
        name: "workshop-".repeat(20),
        title: "The laser beside the window ".repeat(9),
        ..crate::testkit::plans::machine()
    };
    let name = format!("{} order 4711 of December.dxf", "very long name ".repeat(30));
    let text = output::gcode(
        &plan,
        &output::SheetFacts::of(&sheet),
        &profile,
        &name,
        kerfway::machine::Start::Absolute,
    )
    .unwrap();
    let version = env!("CARGO_PKG_VERSION");
    for line in [
        "; 4294967295 contours, 4294967295 pierces",
        "; cut 123456789012.3 mm, air 98765432109.8 mm",
        "; time: about 1234567890.1 s",
        "; unit: mm",
        "; x -131071.9 to 131071.9, y -131071.9 to 131071.9",
    ] {
        assert!(text.lines().any(|l| l == line), "{line} is missing in {text}");
    }
    let first = text.lines().next().unwrap();
    assert!(first.starts_with(&format!("; Kerfway {version}, very long name")), "{first}");
    assert!(first.ends_with("4711 of December.dxf") && first.contains("..."), "{first}");
    // The interpreter refuses lines that are too long.
    crate::testkit::gcode::run(&text).unwrap();
}

#[test]
fn plans_come_back_as_planned() {
    crate::testkit::random_plans::each(400, assert_same);
}

#[test]
fn a_pierce_burns_at_the_entry_for_its_time_and_marks_do_not_pierce() {
    let (sheet, plan) = crate::testkit::plans::small();
    let profile = Profile { beam_on_delay: 0.1, beam_off_delay: 0.05, ..crate::testkit::plans::machine() };
    let program = program(&sheet, &plan, &profile);
    let dwells: Vec<(f64, f64)> = program
        .events
        .iter()
        .filter_map(|e| match e {
            Event::Dwell { seconds, beam } => Some((*seconds, *beam)),
            _ => None,
        })
        .collect();
    // Settling before and after the mark; piercing with settling, and settling after, for each cut.
    assert_eq!(dwells, [(0.1, 200.0), (0.05, 0.0), (0.6, 800.0), (0.05, 0.0), (0.6, 800.0), (0.05, 0.0)]);
    assert_same(&sheet, &plan, &profile);
}

#[test]
fn a_circle_is_two_halves_from_its_entry() {
    for sweep in [TAU, -TAU] {
        let circle = Arc::from_angles(DVec2::new(20.0, 30.0), 7.0, 1.0, sweep);
        let stop = crate::testkit::plans::Stop {
            layer: 0,
            operation: Operation::Cut,
            path: Path::new(vec![Segment::Arc(circle)], true),
        };
        let (sheet, plan) =
            crate::testkit::plans::plan_of(vec![stop], &[("0", 7)], &crate::testkit::plans::machine());
        let worked = worked(&program(&sheet, &plan, &crate::testkit::plans::machine()));
        assert_eq!(worked[0].len(), 2);
        for m in &worked[0] {
            let (center, half) = m.path.arc.unwrap();
            assert!(center.distance(circle.center) < 0.002);
            assert!((half - sweep / 2.0).abs() < 1e-3 && half.abs() < PI + 1e-3);
        }
        assert_eq!(worked[0][0].path.from, worked[0][1].path.to);
    }
}

#[test]
fn arcs_too_short_for_the_grid_never_become_circles() {
    // 0.4 micrometres of a circle of 100 m, and a hair less than a turn of 0.3 micrometres: both next to nothing.
    for (radius, sweep) in [(1e5, 4e-9), (1e5, -4e-7), (3e-4, TAU - 1e-3), (50.0, 1e-9)] {
        let arc = Arc::from_angles(DVec2::new(3.3, 4.4), radius, 0.7, sweep);
        let lead = Segment::line(arc.start - DVec2::X, arc.start);
        let path = Path::new(vec![lead, Segment::Arc(arc)], false);
        let stop = crate::testkit::plans::Stop { layer: 0, operation: Operation::Cut, path };
        let (sheet, plan) =
            crate::testkit::plans::plan_of(vec![stop], &[("0", 7)], &crate::testkit::plans::machine());
        let worked = worked(&program(&sheet, &plan, &crate::testkit::plans::machine()));
        let length: f64 = elements(&worked[0]).iter().map(Element::length).sum();
        assert!(length < 1.05, "{length} mm for an arc of {} mm", radius * sweep.abs());
    }
}

#[test]
fn arcs_whose_ends_were_moved_by_joining_are_still_accepted() {
    for (radius, sweep) in [(1.0, 1.0), (40.0, 0.02), (3.0, -3.0), (0.5, 6.0), (2000.0, 0.001)] {
        let mut arc = Arc::from_angles(DVec2::new(3.3, 4.4), radius, 0.7, sweep);
        // Half the default joining tolerance, across the arc.
        arc.end += (arc.end - arc.center).normalize() * 0.025;
        let path = Path::new(vec![Segment::Arc(arc)], false);
        let stop = crate::testkit::plans::Stop { layer: 0, operation: Operation::Cut, path };
        let (sheet, plan) =
            crate::testkit::plans::plan_of(vec![stop], &[("0", 7)], &crate::testkit::plans::machine());
        let motions = &worked(&program(&sheet, &plan, &crate::testkit::plans::machine()))[0];
        assert!(motions.last().unwrap().path.to.distance(arc.end) <= DEVIATION);
        for i in 0..=24 {
            let p = Segment::Arc(arc).at(f64::from(i) / 24.0);
            let off = motions.iter().map(|m| m.path.distance(p)).fold(f64::INFINITY, f64::min);
            assert!(off <= 0.025 + DEVIATION, "{off} mm off, {arc:?}");
        }
    }
}

#[test]
fn tiny_steps_do_not_add_up_to_an_error() {
    // 10,000 steps of 0.4 micrometres, each below the grid, along a slope.
    let step = DVec2::new(0.0004, 0.0003);
    let at = |i: i32| f64::from(i) * step;
    let path = Path::new((0..10_000).map(|i| Segment::line(at(i), at(i + 1))).collect(), false);
    let stop = crate::testkit::plans::Stop { layer: 0, operation: Operation::Cut, path };
    let (sheet, plan) =
        crate::testkit::plans::plan_of(vec![stop], &[("0", 7)], &crate::testkit::plans::machine());
    let worked = worked(&program(&sheet, &plan, &crate::testkit::plans::machine()));
    let end = worked[0].last().unwrap().path.to;
    assert!(end.distance(at(10_000)) <= 0.001, "{end}");
}

#[test]
fn without_return_the_head_stays_at_the_end_with_the_beam_off() {
    let profile = Profile { return_home: false, ..crate::testkit::plans::machine() };
    let stops = vec![crate::testkit::plans::Stop {
        layer: 0,
        operation: Operation::Cut,
        path: Path::new(vec![Segment::line(DVec2::new(1.0, 2.0), DVec2::new(5.0, 2.0))], false),
    }];
    let (sheet, plan) = crate::testkit::plans::plan_of(stops, &[("0", 7)], &profile);
    let program = program(&sheet, &plan, &profile);
    let last = program.motions().last().unwrap();
    assert_eq!((last.rapid, last.path.to), (false, DVec2::new(5.0, 2.0)));
    let text = output::gcode(
        &plan,
        &output::SheetFacts::of(&sheet),
        &profile,
        "x",
        kerfway::machine::Start::Absolute,
    )
    .unwrap();
    let [.., off, checksum, "M2"] = text.lines().collect::<Vec<_>>()[..] else { panic!("{text}") };
    assert!(off == "M5 S0" && checksum.starts_with("; checksum "), "{text}");
}

/// The interpreter itself: it must refuse what GRBL refuses, or the tests above prove nothing.
#[test]
fn the_interpreter_is_strict() {
    let refuses = |text: &str, why: &str| {
        let error = crate::testkit::gcode::run(text).unwrap_err();
        assert!(error.contains(why), "{error}");
    };
    refuses("G1 X1 Y1", "motion without feed");
    refuses("G0 G1 X1 F100", "modal group");
    refuses("G2 X1 Y0 F100", "arc without centre");
    refuses("G2 X10 Y0 I5.01 J0 F100", "radii");
    refuses("G0 X1e3", "plain number");
    refuses("G5 X1", "unknown word");
    refuses("; what?", "acts upon");
    refuses("M2\nG0 X1", "after the end");
    let circle = crate::testkit::gcode::run("G3 X0 Y0 I5 F100 M4 S10").unwrap();
    let circle = circle.motions().next().unwrap();
    assert!((circle.path.length() - 10.0 * PI).abs() < 1e-12 && circle.beam == 10.0);
    let inches = crate::testkit::gcode::run("G20 G91\nG0 X1 Y1\nG0 X1").unwrap();
    assert_eq!(inches.motions().last().unwrap().path.to, DVec2::new(50.8, 25.4));
    let under_m4 = crate::testkit::gcode::run("G1 M4 S10 F1\nG4 P1").unwrap();
    assert_eq!(under_m4.events, [Event::Dwell { seconds: 1.0, beam: 0.0 }]);
    let after_rapid = crate::testkit::gcode::run("G0 X1\nM3 S10\nG4 P1").unwrap();
    assert_eq!(after_rapid.events[1], Event::Dwell { seconds: 1.0, beam: 0.0 });
}

#[test]
fn file_names_do_not_reach_comments_unescaped() {
    let (sheet, plan) = crate::testkit::plans::small();
    let profile = crate::testkit::plans::machine();
    for name in ["a\nG0 X0\n.dxf", "a)G1 X9(.svg", "~!?\u{18}.dxf", "\u{202e}fxd.a", "ä;M3\r\n"] {
        let text = output::gcode(
            &plan,
            &output::SheetFacts::of(&sheet),
            &profile,
            name,
            kerfway::machine::Start::Absolute,
        )
        .unwrap();
        let plain = output::gcode(
            &plan,
            &output::SheetFacts::of(&sheet),
            &profile,
            "a.dxf",
            kerfway::machine::Start::Absolute,
        )
        .unwrap();
        // Besides the checksum only the first line differs, and it is a comment of printable ASCII.
        let (head, rest) = text.split_once('\n').unwrap();
        let lines = |rest: &str| {
            rest.lines().filter(|l| !l.contains("checksum")).map(str::to_owned).collect::<Vec<_>>()
        };
        assert_eq!(lines(rest), lines(plain.split_once('\n').unwrap().1), "{name:?}");
        assert!(head.starts_with("; ") && head.bytes().all(|b| (0x20..0x7f).contains(&b)), "{head:?}");
        assert!(!head[2..].contains(['(', ')', ';', '!', '?', '~']), "{head:?}");
    }
}
