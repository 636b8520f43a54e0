//! Cuts on the run (`levers.fly`): what they save, how rows and grids are cut, and what the checker says of plans that do it wrongly.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests stop where they cannot go on")]
#![allow(clippy::print_stdout, reason = "the figures of docs/levers.md")]

mod checker;
mod every_choice;
mod motion;

use crate::testkit::exact::planned;
use crate::testkit::gcode;
use crate::testkit::sheets::{Builder, circle, line, machine, p, polygon, rectangle, slot};
use kerfway::geometry::{DVec2, Path, Segment, math};
use kerfway::machine::dialect::{DialectChoice, dialects};
use kerfway::machine::{
    Fly, JointRule, Joints, LeadKind, LeadRule, LeadShape, Leads, Levers, Process, Profile, Start, cut_time,
};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{self, Move, Plan};
use kerfway::sheet::Sheet;
use std::f64::consts::PI;

pub(super) fn flying(reach: f64, overcut: f64) -> Profile {
    let levers = Levers { fly: Some(Fly { reach, overcut }), ..Levers::default() };
    Profile { levers, ..machine("fibre-3kw-thin") }
}

/// A plate with holes at the places of a grid, the first at 20, 20. `turn` turns all of it, rad.
pub(super) fn plate(
    columns: u32,
    rows: u32,
    pitch: f64,
    turn: f64,
    hole: impl Fn(DVec2, f64) -> Path,
) -> Sheet {
    let mut b = Builder::new();
    let u = math::unit(turn);
    let size = p(40.0 + pitch * f64::from(columns), 40.0 + pitch * f64::from(rows));
    let corners = [p(0.0, 0.0), p(size.x, 0.0), size, p(0.0, size.y)].map(|c| u.rotate(c));
    let outer = b.cut(polygon(&corners), None);
    for row in 0..rows {
        for column in 0..columns {
            let at = p(20.0 + pitch * f64::from(column), 20.0 + pitch * f64::from(row));
            b.cut(hole(u.rotate(at), turn), Some(outer));
        }
    }
    b.sheet
}

pub(super) fn round(at: DVec2, _: f64) -> Path {
    circle(at, 1.5)
}

pub(super) fn square(at: DVec2, turn: f64) -> Path {
    let u = math::unit(turn);
    polygon(&[p(0.0, 0.0), p(10.0, 0.0), p(10.0, 10.0), p(0.0, 10.0)].map(|c| at + u.rotate(c)))
}

pub(super) fn checked(sheet: &Sheet, machine: &Profile) -> Plan {
    let plan = planned(sheet, machine);
    assert_eq!(plan::check(sheet, machine, &plan), Ok(()));
    plan
}

#[track_caller]
fn near(a: f64, b: f64, tolerance: f64) {
    assert!((a - b).abs() <= tolerance, "{a} is not {b}");
}

#[test]
fn a_row_of_round_holes_is_one_motion_along_its_tangent() {
    let machine = flying(20.0, 0.0);
    let plan = checked(&plate(4, 1, 6.0, 0.0, round), &machine);
    let s = &plan.summary;
    assert_eq!((s.fly_cuts, s.moving_starts, s.pierces), (3, 1, 1));
    let first = plan.moves.iter().position(|m| *m == Move::MovingStart).unwrap();
    let row = &plan.moves[first + 1..first + 8];
    let mut motion: Vec<Segment> = Vec::new();
    for (k, m) in row.iter().enumerate() {
        match m {
            Move::Cut { path, .. } if k % 2 == 0 => {
                assert!((path.iter().map(Segment::length).sum::<f64>() - 3.0 * PI).abs() < 1e-9);
                motion.extend(path);
            }
            Move::Fly { path } if k % 2 == 1 => {
                assert_eq!(path.len(), 1);
                near(path[0].length(), 6.0, 1e-9);
                // On the line that touches the holes, above or below them.
                near((path[0].start().y - 20.0).abs(), 1.5, 1e-9);
                motion.extend(path);
            }
            other => panic!("{k}: {other:?}"),
        }
    }
    // Straight on at every join, so only the ends slow the head down.
    for pair in motion.windows(2) {
        assert!(pair[0].tangent(1.0).dot(pair[1].tangent(0.0)) > 1.0 - 1e-9);
    }
    let outline = plan.moves.iter().find_map(|m| match m {
        Move::Cut { contour: 0, path, .. } => Some(cut_time(&machine, &machine.cut, path)),
        _ => None,
    });
    near(s.cut_time, cut_time(&machine, &machine.cut, &motion) + outline.unwrap(), 1e-9);
    near(s.pierce_time, machine.pierce_time + machine.beam_on_delay + 2.0 * machine.beam_off_delay, 1e-12);
}

#[test]
fn a_row_is_found_from_either_side() {
    // Discs of four sizes that hang from one line, and two outlines of ten sides that lean towards each other.
    let hung = |turned: bool| {
        let mut b = Builder::new();
        for (k, r) in [2.0, 3.0, 1.5, 2.5].into_iter().enumerate() {
            b.cut(circle(p(10.0 * k as f64, if turned { r } else { -r }), r), None);
        }
        b.sheet
    };
    let lean = |turned: bool| {
        let points = [
            p(-3.0, 0.0),
            p(3.0, 0.0),
            p(5.5, 5.0),
            p(8.0, 10.0),
            p(10.0, 15.0),
            p(11.0, 20.0),
            p(5.0, 20.0),
            p(3.0, 15.0),
            p(1.0, 10.0),
            p(-1.5, 5.0),
        ];
        let mut b = Builder::new();
        let shape = |mirrored: bool| {
            let mut all: Vec<DVec2> =
                points.iter().map(|q| if mirrored { p(30.0 - q.x, q.y) } else { *q }).collect();
            all.iter_mut().filter(|_| turned).for_each(|q| *q = -*q);
            if mirrored {
                all.reverse();
            }
            polygon(&all)
        };
        b.cut(shape(false), None);
        b.cut(shape(true), None);
        b.sheet
    };
    for turned in [false, true] {
        let machine = flying(20.0, 0.0);
        let found = [hung(turned), lean(turned)].map(|sheet| checked(&sheet, &machine).summary);
        assert_eq!(
            found.each_ref().map(|s| (s.moving_starts, s.fly_cuts)),
            [(1, 3), (1, 1)],
            "turned: {turned}"
        );
    }
}

#[test]
fn an_overcut_is_cut_on_the_run() {
    let machine = flying(20.0, 0.4);
    let plan = checked(&plate(5, 2, 6.0, 0.0, round), &machine);
    assert_eq!(plan.summary.fly_cuts, 8);
    near(plan.summary.lead_length, 10.0 * 0.4, 1e-9);
}

#[test]
fn a_grid_of_squares_is_cut_line_by_line() {
    let sheet = plate(6, 5, 20.0, 0.0, square);
    let machine = flying(15.0, 0.0);
    let plan = checked(&sheet, &machine);
    // 10 lines with 6 sides along x, and 12 with 5 along y: each line is one start.
    assert_eq!((plan.summary.moving_starts, plan.summary.fly_cuts), (22, 10 * 5 + 12 * 4));
    let sides = plan.moves.iter().filter(|m| matches!(m, Move::Cut { path, .. } if path.len() == 1)).count();
    assert_eq!(sides, 4 * 30);
    near(plan.summary.cut_length, 30.0 * 40.0 + sheet.contours[0].length, 1e-6);
    let one_by_one = planned(&sheet, &crate::testkit::sheets::machine("fibre-3kw-thin")).summary.total_time;
    assert!(plan.summary.total_time < 0.6 * one_by_one, "{} of {one_by_one}", plan.summary.total_time);
    // Nearer than the gaps, nothing is flown.
    assert_eq!(checked(&sheet, &flying(9.0, 0.0)).summary.fly_cuts, 0);
}

#[test]
fn slots_in_a_line_and_outlines_in_a_row_are_flown() {
    let slots = plate(8, 3, 20.0, 0.0, |at, _| slot(at, 10.0, 2.0));
    assert_eq!(checked(&slots, &flying(25.0, 0.0)).summary.fly_cuts, 3 * 7);
    let mut b = Builder::new();
    for k in 0..5 {
        b.cut(slot(p(50.0, 20.0 * f64::from(k)), 10.0, 2.0), None);
    }
    // Beside each other, slots are flown by their round ends.
    assert_eq!(checked(&b.sheet, &flying(25.0, 0.0)).summary.fly_cuts, 4);
}

#[test]
fn a_turned_sheet_is_flown_as_one_that_is_not() {
    for (hole, reach) in [(round as fn(DVec2, f64) -> Path, 10.0), (square, 15.0)] {
        let pitch = if reach < 12.0 { 6.0 } else { 20.0 };
        let straight = checked(&plate(5, 4, pitch, 0.0, hole), &flying(reach, 0.0)).summary;
        for turn in [0.3, 1.0, 2.5] {
            let turned = checked(&plate(5, 4, pitch, turn, hole), &flying(reach, 0.0)).summary;
            assert_eq!(
                (turned.fly_cuts, turned.moving_starts),
                (straight.fly_cuts, straight.moving_starts),
                "{turn}"
            );
            near(turned.cut_time, straight.cut_time, 0.02 * straight.cut_time);
        }
    }
}

#[test]
fn what_cannot_be_flown_is_cut_one_by_one() {
    let sheet = plate(4, 1, 6.0, 0.0, round);
    let flies = |machine: &Profile, sheet: &Sheet| checked(sheet, machine).summary.fly_cuts;
    let machine = flying(20.0, 0.0);
    assert_eq!(flies(&machine, &sheet), 3);
    let lead_in = LeadShape { kind: LeadKind::Line, length: 0.5, ..LeadShape::default() };
    let leads = Leads { clearance: 0.1, rules: vec![LeadRule { lead_in, ..LeadRule::default() }] };
    assert_eq!(flies(&Profile { leads: Some(leads), ..machine.clone() }, &sheet), 0);
    let joints = Joints { rules: vec![JointRule { count: 1, ..JointRule::default() }] };
    assert_eq!(flies(&Profile { joints: Some(joints), ..machine.clone() }, &sheet), 0);
    assert_eq!(flies(&Profile { cut: Process { passes: 2, ..machine.cut }, ..machine.clone() }, &sheet), 0);
    // Holes around something else, of another size, or with another contour around them.
    let mut b = Builder::new();
    let outer = b.cut(rectangle(p(0.0, 0.0), p(200.0, 50.0)), None);
    let holes: Vec<u32> =
        (0..4).map(|k| b.cut(circle(p(20.0 + 20.0 * f64::from(k), 20.0), 5.0), Some(outer))).collect();
    b.cut(circle(p(20.0, 20.0), 2.0), Some(holes[0]));
    b.mark(line(p(39.0, 20.0), p(41.0, 20.0)), Some(holes[1]));
    assert_eq!(flies(&machine, &b.sheet), 1);
}

#[test]
fn machines_with_pre_cuts_are_refused() {
    let plate = machine("fibre-6kw-plate");
    let both = Profile { levers: flying(20.0, 0.0).levers, ..plate };
    let message = both.validate().unwrap_err().to_string();
    assert!(message.contains("levers.fly and pre_cut_time"), "{message}");
    let message = flying(0.0, 0.0).validate().unwrap_err().to_string();
    assert!(message.contains("\"levers.fly.reach\" is 0"), "{message}");
    let message = flying(10.0, -1.0).validate().unwrap_err().to_string();
    assert!(message.contains("\"levers.fly.overcut\" is -1"), "{message}");
}

#[test]
fn every_dialect_writes_cuts_on_the_run_or_refuses_them() {
    let machine = Profile { beam_off_delay: 0.0, ..flying(20.0, 0.2) };
    let mut refused = Vec::new();
    for sheet in [plate(5, 3, 6.0, 0.0, round), plate(5, 3, 20.0, 0.0, square)] {
        let plan = checked(&sheet, &machine);
        let dark: f64 = plan
            .moves
            .iter()
            .map(|m| if let Move::Fly { path } = m { path.iter().map(Segment::length).sum() } else { 0.0 })
            .sum();
        assert!(dark > 10.0);
        for dialect in dialects() {
            let profile = Profile { dialect: DialectChoice::named(&dialect.name), ..machine.clone() };
            let profile = Profile { pierce_time: 0.0, beam_on_delay: 0.0, ..profile };
            let plan = checked(&sheet, &profile);
            match output::gcode(&plan, &SheetFacts::of(&sheet), &profile, "plate.dxf", Start::Absolute) {
                Ok(text) => {
                    let check = output::check_against(&text, &profile, &plan).unwrap();
                    assert!(check.passed, "{}: {:?}", dialect.name, check.problems);
                    let alone = output::check(&text, &profile).unwrap();
                    assert!(alone.passed, "{}, alone: {:?}", dialect.name, alone.problems);
                }
                Err(e) => {
                    assert!(e.to_string().contains("or cut on the run"), "{}: {e}", dialect.name);
                    refused.push(dialect.name.clone());
                }
            }
        }
        // In GRBL's program, every way between cuts is a dark G1 with the length of the plan.
        let text =
            output::gcode(&plan, &SheetFacts::of(&sheet), &machine, "plate.dxf", Start::Absolute).unwrap();
        let program = gcode::run(&text).unwrap();
        let ways = program.motions().filter(|m| !m.rapid && m.beam == 0.0);
        near(ways.map(|m| m.path.length()).sum(), dark, 0.1);
    }
    refused.sort();
    refused.dedup();
    assert_eq!(refused, ["linuxcnc-spindle", "marlin-fan", "template"]);
}

/// Outlines of nine sides, two of them along x, each `lean` mm farther along x on the far side; every second one leans the other way.
fn leaning(count: u32, pitch: f64, lean: f64, turn: f64) -> Sheet {
    let mut b = Builder::new();
    let u = math::unit(turn);
    for k in 0..count {
        let lean = if k % 2 == 0 { -lean } else { lean };
        let corners = [(-2.0, 0.0), (2.0, 0.0), (3.0, 2.0), (3.5, 4.0), (lean + 2.0, 8.0), (lean - 2.0, 8.0)];
        let more = [(-3.6, 5.0), (-3.5, 4.0), (-3.0, 2.0)];
        let at = p(50.0 + pitch * f64::from(k), 50.0);
        let corners: Vec<DVec2> =
            corners.iter().chain(&more).map(|&(x, y)| p(400.0, 400.0) + u.rotate(at + p(x, y))).collect();
        b.cut(polygon(&corners), None);
    }
    b.sheet
}

#[test]
fn rows_whose_far_sides_are_farther_apart_than_the_reach_are_not_run_there() {
    let machine = flying(20.0, 0.3);
    for (lean, longest) in [(0.5, 19.0 + 1.0), (1.2, 19.0)] {
        for turn in [0.0, 0.5 * PI, PI, 1.5 * PI] {
            let plan = checked(&leaning(4, 19.0, lean, turn), &machine);
            assert!(plan.summary.fly_cuts > 0, "{lean} {turn}");
            let ways =
                plan.moves.iter().filter_map(|m| if let Move::Fly { path } = m { Some(path) } else { None });
            let way = ways.map(|path| path.iter().map(Segment::length).sum::<f64>()).fold(0.0, f64::max);
            assert!(way <= longest, "{way} mm");
        }
    }
}
