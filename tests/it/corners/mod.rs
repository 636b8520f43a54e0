//! Corners in which a cut does not stop (`levers.corners`): loops through waste and rounded corners, what they save, where they may
//! be, and what the checker says of plans that have them wrongly.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests stop where they cannot go on")]

mod checker;
mod every_choice;

use crate::testkit::dialects::read_back;
use crate::testkit::exact::search_of_exact_cost;
use crate::testkit::leads::{leads, oriented, with_leads};
use crate::testkit::sheets::{Builder, machine, p, polygon, rectangle};
use kerfway::geometry::{DVec2, math};
use kerfway::machine::{CornerKind, Corners, LeadKind, Levers, Profile};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{self, Move, Plan, Turn};
use kerfway::sheet::{ContourChoice, Sheet};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

pub(super) const LOOPS: Corners = Corners {
    outer: CornerKind::Loop,
    hole: CornerKind::Loop,
    loop_radius: 1.0,
    clearance: 1.0,
    round_radius: 1.0,
    deviation: 0.1,
};
pub(super) const ROUND: Corners = Corners { outer: CornerKind::Round, hole: CornerKind::Round, ..LOOPS };

/// Thick plate, where corners of less than 75 degrees cool for a second; nothing is left unfinished.
pub(super) fn plate(corners: Corners) -> Profile {
    let levers = Levers { corners: Some(corners), ..Levers::default() };
    Profile { pre_cut_time: None, pre_cut_length: 0.0, levers, ..machine("fibre-6kw-plate") }
}

/// Thin sheet, cut fast: corners only slow the head down.
pub(super) fn thin(corners: Corners) -> Profile {
    let levers = Levers { corners: Some(corners), ..Levers::default() };
    Profile { levers, ..machine("fibre-3kw-thin") }
}

pub(super) fn without(machine: &Profile) -> Profile {
    Profile { levers: Levers { corners: None, ..machine.levers }, ..machine.clone() }
}

/// An isosceles triangle on its base, with this angle at its tip.
pub(super) fn wedge(at: DVec2, base: f64, tip: f64) -> kerfway::geometry::Path {
    let height = 0.5 * base / math::tan(0.5 * tip);
    polygon(&[at, at + p(base, 0.0), at + p(0.5 * base, height)])
}

pub(super) fn wedges(count: u32, gap: f64) -> Builder {
    let mut b = Builder::new();
    for k in 0..count {
        b.cut(wedge(p(f64::from(k) * (30.0 + gap) + 20.0, 20.0), 30.0, PI / 3.0), None);
    }
    b
}

pub(super) fn searched(b: Builder, machine: &Profile) -> (Sheet, Plan) {
    let sheet = oriented(b.sheet);
    let plan = search_of_exact_cost(&sheet, machine, 1).2;
    (sheet, plan)
}

pub(super) fn turns(plan: &Plan) -> Vec<(u32, Turn)> {
    let of = |m: &Move| match m {
        Move::Cut { contour, turns, .. } => turns.iter().map(|t| (*contour, *t)).collect(),
        _ => Vec::new(),
    };
    plan.moves.iter().flat_map(of).collect()
}

#[track_caller]
pub(super) fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9, "{a} is not {b}");
}

#[test]
fn loops_replace_the_pauses_of_sharp_corners() {
    let machine = plate(LOOPS);
    let (_, plan) = searched(wedges(1, 0.0), &machine);
    let (_, before) = searched(wedges(1, 0.0), &without(&machine));
    let s = &plan.summary;
    // It begins in one corner; the other two have loops of two lines and two thirds of a circle.
    assert_eq!((s.loops, s.rounded_corners), (2, 0));
    let each = 2.0 * math::tan(PI / 3.0) + (TAU - 2.0 * PI / 3.0);
    near(s.loop_length, 2.0 * each);
    near(s.cut_length, 90.0 + 2.0 * each);
    near(s.macro_time, 0.0);
    near(before.summary.macro_time, 2.0);
    // The cut runs through both corners at its speed: of three runs from rest to rest, one remains.
    let (v, a) = (machine.cut.speed, machine.cut.accel.unwrap());
    near(s.cut_time, s.cut_length / v + v / a);
    let saved = 2.0 * (1.0 + machine.beam_on_delay + machine.beam_off_delay + v / a - each / v);
    near(before.summary.total_time - s.total_time, saved);
    assert!(saved > 1.0, "{saved}");
}

#[test]
fn a_loop_that_takes_longer_than_the_corner_is_not_cut() {
    let wide = Corners { loop_radius: 8.0, ..LOOPS };
    assert_eq!(searched(wedges(1, 0.0), &plate(wide)).1.summary.loops, 0);
    // In thin sheet, a right angle slows the head down for milliseconds only: a loop of 1 mm is quicker still, one of 8 mm is not.
    let mut b = Builder::new();
    b.cut(rectangle(p(20.0, 20.0), p(30.0, 20.0)), None);
    let rect = |corners| searched(Builder { sheet: b.sheet.clone() }, &thin(corners)).1.summary.loops;
    assert_eq!((rect(wide), rect(LOOPS)), (0, 3));
}

#[test]
fn rounded_corners_stay_within_their_deviation_and_save_time() {
    let rect = || {
        let mut b = Builder::new();
        b.cut(rectangle(p(20.0, 20.0), p(30.0, 20.0)), None);
        b
    };
    let machine = thin(ROUND);
    let (_, plan) = searched(rect(), &machine);
    let s = &plan.summary;
    assert_eq!(s.rounded_corners, 3);
    // The radius that goes with 0.1 mm at a right angle is r (sqrt 2 - 1) = 0.1.
    let radius = 0.1 / (2.0_f64.sqrt() - 1.0);
    near(s.corner_deviation, 0.1);
    near(s.cut_length, 100.0 - 3.0 * (2.0 - FRAC_PI_2) * radius);
    let before = searched(rect(), &without(&machine)).1.summary.total_time;
    assert!(before - s.total_time > 0.01, "{before} {}", s.total_time);
    // The greatest radius counts where the deviation allows more.
    let (_, plan) = searched(rect(), &thin(Corners { round_radius: 0.1, deviation: 1.0, ..ROUND }));
    near(plan.summary.corner_deviation, 0.1 * (2.0_f64.sqrt() - 1.0));
}

#[test]
fn loops_are_outside_parts_and_inside_holes_and_nowhere_else() {
    // A star-like hole: its corners that point inwards have waste beyond them, its tips have the part.
    let (mut b, middle) = (Builder::new(), p(70.0, 70.0));
    let part = b.cut(rectangle(p(20.0, 20.0), p(100.0, 100.0)), None);
    let star: Vec<DVec2> = (0..8)
        .map(|k| middle + math::unit(f64::from(k) * PI / 4.0) * if k % 2 == 0 { 40.0 } else { 12.0 })
        .collect();
    let hole = b.cut(polygon(&star), Some(part));
    let machine = plate(Corners { loop_radius: 0.5, ..LOOPS });
    // Every corner below 75 degrees pauses; those that point inwards are 270 degrees wide and more.
    let wide = Profile {
        sharp_corner: Some(kerfway::machine::SharpCorner { angle: 2.6, time: 1.0 }),
        ..machine.clone()
    };
    let (sheet, plan) = searched(b, &wide);
    assert_eq!((plan.summary.loops, plan.summary.macro_time), (3 + 4, 3.0));
    for (contour, turn) in turns(&plan) {
        let from = turn.at.distance(middle);
        assert!(contour == part || from < 20.0, "contour {hole} has a loop at its tip {}", turn.at);
    }
    assert_eq!(plan::check(&sheet, &wide, &plan), Ok(()));
}

#[test]
fn what_has_no_room_stops_and_is_told() {
    // Two wedges 2 mm apart: base corners that face each other have no room for loops of 1 mm with 1 mm of clearance.
    let machine = plate(LOOPS);
    let sheet = oriented(wedges(2, 2.0).sheet);
    let (problem, _, plan) = search_of_exact_cost(&sheet, &machine, 1);
    let blocked: Vec<_> = problem
        .items
        .iter()
        .filter_map(|i| i.leads.as_ref())
        .flat_map(|l| l.corners.without_room.clone())
        .collect();
    assert_eq!(blocked, [(CornerKind::Loop, p(50.0, 20.0)), (CornerKind::Loop, p(52.0, 20.0))]);
    // Each begins where it would have to pause.
    assert_eq!((plan.summary.loops, plan.summary.macro_time), (4, 0.0));
    let (_, apart) = searched(wedges(2, 20.0), &machine);
    assert_eq!(apart.summary.loops, 4);
}

#[test]
fn a_person_chooses_by_contour() {
    let stop = Corners { outer: CornerKind::Stop, hole: CornerKind::Stop, ..LOOPS };
    let mut sheet = oriented(wedges(3, 20.0).sheet);
    let choice = |contour, kind| ContourChoice { contour, joints: None, lead: None, corners: Some(kind) };
    sheet.choices = vec![choice(0, CornerKind::Loop), choice(2, CornerKind::Round)];
    let plan = search_of_exact_cost(&sheet, &plate(stop), 1).2;
    assert_eq!((plan.summary.loops, plan.summary.rounded_corners), (2, 2));
    assert!(turns(&plan).iter().all(|(c, t)| (*c == 0) == (t.kind == CornerKind::Loop) && *c != 1));
    sheet.choices = vec![choice(1, CornerKind::Stop)];
    let plan = search_of_exact_cost(&sheet, &plate(LOOPS), 1).2;
    assert!(plan.summary.loops == 4 && turns(&plan).iter().all(|(c, _)| *c != 1));
}

#[test]
fn leads_and_joints_go_with_loops() {
    let machine = with_leads(plate(LOOPS), leads(LeadKind::Line, 1.0, 2.0));
    let (_, plan) = searched(wedges(2, 20.0), &machine);
    assert!(plan.summary.loops >= 4 && plan.summary.lead_length > 0.0, "{:?}", plan.summary);
    let rule = kerfway::machine::JointRule { count: 2, ..kerfway::machine::JointRule::default() };
    let joints = Some(kerfway::machine::Joints { rules: vec![rule] });
    let (_, plan) = searched(wedges(2, 20.0), &Profile { joints, ..plate(LOOPS) });
    assert!(plan.summary.loops >= 4 && plan.summary.joints == 4, "{:?}", plan.summary);
}

#[test]
fn every_dialect_and_drawing_has_loops_and_arcs() {
    for corners in [LOOPS, ROUND] {
        let planned = |machine: &Profile| searched(wedges(2, 20.0), machine);
        read_back(&plate(corners), planned, 2, |dialect, plan, _| {
            assert!(plan.summary.loops + plan.summary.rounded_corners >= 4, "{dialect}");
        });
        let (sheet, plan) = searched(wedges(2, 20.0), &plate(corners));
        let facts = SheetFacts::of(&sheet);
        assert_eq!(output::dxf(&plan, &facts).matches("LWPOLYLINE").count(), 2);
        let svg = output::svg(&plan, &facts, &plate(corners));
        assert_eq!(svg.matches("Loops at corners").count(), usize::from(corners == LOOPS));
        assert_eq!(output::lbrn2(&plan, &facts, &plate(corners)).unwrap().matches("<Shape").count(), 2);
    }
}
