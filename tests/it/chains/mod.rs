//! Chains (`levers.chains`): what they save, where they may be, and what the checker says of plans that do it wrongly.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests stop where they cannot go on")]

mod checker;
mod edge;
mod every_choice;
mod seconds;

pub(super) use checker::says;
pub(super) use every_choice::{brute, chain_seconds};

use crate::testkit::dialects::read_back;
use crate::testkit::exact::search_of_exact_cost;
use crate::testkit::gcode;
use crate::testkit::leads::{leads, oriented, with_leads};
use crate::testkit::sheets::{Builder, circle, line, machine, p, polygon, rectangle};
use kerfway::geometry::Segment;
use kerfway::machine::dialect::{DialectChoice, dialects};
use kerfway::machine::{Chains, LeadKind, Levers, Process, Profile, Start, cut_time};
use kerfway::output::{self, SheetFacts};
use kerfway::plan::{Move, Plan};
use kerfway::sheet::Sheet;

pub(super) fn chaining(reach: f64, clearance: f64) -> Profile {
    let levers =
        Levers { chains: Some(Chains { reach, clearance, edge_starts: false }), ..Levers::default() };
    Profile { levers, ..machine("fibre-6kw-thick") }
}

/// The same, with cuts through waste that begin on a kerf.
pub(super) fn starting(reach: f64, clearance: f64) -> Profile {
    let levers = Levers { chains: Some(Chains { reach, clearance, edge_starts: true }), ..Levers::default() };
    Profile { levers, ..machine("fibre-6kw-thick") }
}

/// Squares with a side of 20 mm in columns and rows, this far apart.
pub(super) fn squares(columns: u32, rows: u32, gap: f64) -> Builder {
    let mut b = Builder::new();
    for k in 0..columns * rows {
        let at = p(f64::from(k % columns), f64::from(k / columns)) * (20.0 + gap) + p(10.0, 10.0);
        b.cut(rectangle(at, p(20.0, 20.0)), None);
    }
    b
}

pub(super) fn searched(b: Builder, machine: &Profile) -> (Sheet, Plan) {
    let sheet = oriented(b.sheet);
    let (_, _, plan) = search_of_exact_cost(&sheet, machine, 1);
    (sheet, plan)
}

/// The chains of a plan, each with the contours before and after it.
pub(super) fn chains(plan: &Plan) -> Vec<(u32, Segment, u32)> {
    let three = |w: &[Move]| match w {
        [Move::Cut { contour: a, .. }, Move::Chain { path }, Move::Cut { contour: b, .. }] => {
            Some((*a, path[0], *b))
        }
        _ => None,
    };
    plan.moves.windows(3).filter_map(three).collect()
}

/// The sheet with contours that start where the plan enters them.
pub(super) fn starting_where_entered(sheet: &Sheet, plan: &Plan) -> Sheet {
    let mut sheet = sheet.clone();
    for step in &plan.moves {
        if let Move::Cut { contour, path, .. } = step {
            let whole = &mut sheet.contours[*contour as usize].path;
            *whole = whole.starting_at(whole.nearest(path[0].start()).unwrap().0);
        }
    }
    sheet
}

#[track_caller]
pub(super) fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9, "{a} is not {b}");
}

#[test]
fn four_corners_that_face_each_other_are_pierced_once() {
    let machine = chaining(30.0, 1.0);
    let (_, plan) = searched(squares(2, 2, 8.0), &machine);
    let s = &plan.summary;
    assert_eq!((s.chains, s.pierces), (3, 1));
    near(s.chain_length, 24.0);
    near(s.cut_length, 4.0 * 80.0 + 24.0);
    let found = chains(&plan);
    assert_eq!(found.len(), 3);
    // Each takes 8 mm from rest to rest in place of the delays, the move and the piercing.
    let chained: f64 = found.iter().map(|c| cut_time(&machine, &machine.cut, &[c.1])).sum();
    let square = cut_time(&machine, &machine.cut, &rectangle(p(0.0, 0.0), p(20.0, 20.0)).segments);
    near(s.cut_time, 4.0 * square + chained);
    near(s.pierce_time, machine.pierce_time + machine.beam_on_delay + machine.beam_off_delay);
    let (_, without) = searched(squares(2, 2, 8.0), &crate::testkit::sheets::machine("fibre-6kw-thick"));
    assert_eq!((without.summary.chains, without.summary.pierces), (0, 4));
    let saved = without.summary.total_time - s.total_time;
    assert!(saved > 3.0 * (1.1 - 8.0 / 33.0 - 0.02), "{saved} s");
}

#[test]
fn a_contour_is_entered_and_left_at_one_place() {
    // So of a row, every second part is pierced.
    let (_, plan) = searched(squares(4, 1, 8.0), &chaining(30.0, 1.0));
    assert_eq!((plan.summary.chains, plan.summary.pierces), (2, 2));
}

#[test]
fn nothing_is_joined_that_is_too_far_away_or_has_no_room() {
    let joined = |b: Builder, machine: &Profile| searched(b, machine).1.summary.chains;
    let two = || squares(2, 1, 8.0);
    assert_eq!(joined(two(), &chaining(30.0, 1.0)), 1);
    assert_eq!(joined(two(), &chaining(8.0, 1.0)), 1);
    assert_eq!(joined(two(), &chaining(7.9, 1.0)), 0);
    // Where piercing takes no time, a chain is slower than a move.
    let quick = Profile { pierce_time: 0.0, beam_on_delay: 0.0, beam_off_delay: 0.0, ..chaining(30.0, 1.0) };
    assert_eq!(joined(two(), &quick), 0);
    // A wall of a thin part, and of an open cut, between the two.
    let mut b = two();
    b.cut(rectangle(p(33.0, -20.0), p(1.0, 80.0)), None);
    let (_, plan) = searched(b, &chaining(100.0, 1.0));
    assert!(chains(&plan).iter().all(|&(a, _, b)| a == 2 || b == 2), "{:?}", chains(&plan));
    let mut b = two();
    b.cut(line(p(34.0, -20.0), p(34.0, 60.0)), None);
    assert_eq!(joined(b, &chaining(100.0, 1.0)), 0);
    // A mark is no obstacle.
    let mut b = two();
    b.mark(line(p(34.0, -20.0), p(34.0, 60.0)), None);
    assert_eq!(joined(b, &chaining(30.0, 1.0)), 1);
    // 8 mm are too narrow for a clearance of 9 mm from a third part, but not the 20 mm to the side of it.
    let mut b = two();
    b.cut(rectangle(p(10.0, 38.0), p(48.0, 10.0)), None);
    let (_, plan) = searched(b, &chaining(8.5, 9.0));
    assert!(plan.summary.chains > 0);
    for (a, chain, b) in chains(&plan) {
        assert!((a, b) == (2, 0) || a + b > 1 || chain.start().y <= 29.0, "{a} {b} {chain:?}");
    }
}

#[test]
fn chains_stay_in_their_piece_of_waste() {
    // A frame with a large hole, two parts within it, and a part beside the frame.
    let mut b = Builder::new();
    let frame = b.cut(rectangle(p(0.0, 0.0), p(100.0, 60.0)), None);
    let hole = b.cut(rectangle(p(10.0, 10.0), p(80.0, 40.0)), Some(frame));
    b.cut(rectangle(p(15.0, 15.0), p(20.0, 20.0)), Some(hole));
    b.cut(circle(p(50.0, 30.0), 9.0), Some(hole));
    b.cut(rectangle(p(105.0, 0.0), p(20.0, 20.0)), None);
    let (_, plan) = searched(b, &chaining(40.0, 1.0));
    let found = chains(&plan);
    let joined = |a, b| found.iter().any(|c| (c.0, c.2) == (a, b) || (c.0, c.2) == (b, a));
    assert!(found.len() >= 2, "{found:?}");
    // Parts in the hole with each other and with the hole, which comes after them; what is beside the frame with the frame.
    for &(a, _, b) in &found {
        let within = |c: u32| (1..=3).contains(&c);
        assert_eq!(within(a), within(b), "{a} {b}");
        assert_ne!(a, hole, "the hole is the last to be cut in it");
    }
    assert!(joined(0, 4));
    // Holes of one part are never joined, whatever the reach.
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(0.0, 0.0), p(100.0, 60.0)), None);
    for k in 0..4 {
        b.cut(circle(p(20.0 + 20.0 * f64::from(k), 30.0), 6.0), Some(plate));
    }
    assert_eq!(searched(b, &chaining(1000.0, 0.5)).1.summary.chains, 0);
}

#[test]
fn leads_are_joined_from_tip_to_tip() {
    let machine = with_leads(chaining(30.0, 1.0), leads(LeadKind::Line, 1.0, 0.0));
    let (_, plan) = searched(squares(2, 2, 12.0), &machine);
    assert!(plan.summary.chains >= 2, "{:?}", plan.summary);
    assert!(plan.summary.lead_length > 0.0);
}

#[test]
fn every_dialect_keeps_the_beam_on() {
    let machine = Profile { beam_off_delay: 0.0, ..chaining(30.0, 1.0) };
    let (sheet, plan) = searched(squares(2, 2, 8.0), &machine);
    let planned = |machine: &Profile| searched(squares(2, 2, 8.0), machine);
    read_back(&machine, planned, 4, |dialect, plan, text| {
        assert_eq!(plan.summary.chains, 3, "{dialect}");
        let chains = |text: &str| text.matches("through waste for 8.000 mm to contour").count();
        assert!(text.is_none_or(|text| chains(text) == 3), "{dialect}");
    });
    // Starts on kerfs wait for the beam, and do not pierce.
    for dialect in dialects().iter().filter(|d| d.pierce.is_some() && d.dwell.is_some()) {
        let profile = Profile { dialect: DialectChoice::named(&dialect.name), ..starting(30.0, 1.0) };
        let (sheet, plan) = searched(squares(4, 1, 8.0), &profile);
        let facts = SheetFacts::of(&sheet);
        let Ok(text) = output::gcode(&plan, &facts, &profile, "squares.dxf", Start::Absolute) else {
            continue;
        };
        let check = output::check_against(&text, &profile, &plan).unwrap();
        assert!(check.passed, "{}: {:?}", dialect.name, check.problems);
        assert_eq!(text.matches("from a kerf or an edge through waste for ").count(), 2, "{}", dialect.name);
    }
    // In GRBL's program the beam is on from the first cut to the last.
    let text =
        output::gcode(&plan, &SheetFacts::of(&sheet), &machine, "squares.dxf", Start::Absolute).unwrap();
    let program = gcode::run(&text).unwrap();
    let lit: f64 = program.motions().filter(|m| m.beam > 0.0).map(|m| m.path.length()).sum();
    assert!((lit - 344.0).abs() < 0.01, "{lit}");
    let runs: Vec<bool> = program.motions().map(|m| m.beam > 0.0).collect();
    assert_eq!(runs.windows(2).filter(|w| w[0] && !w[1]).count(), 1);
}

/// A chain is charged from rest to rest. Where corners do not slow the head down, the program runs through its ends.
#[test]
fn programs_without_stops_at_chains_pass_their_check() {
    let quick = chaining(30.0, 1.0);
    let cut = Process { speed: 400.0, accel: Some(2000.0), ..quick.cut };
    let machine = Profile { cut, junction_deviation: None, ..quick };
    let planned = |machine: &Profile| searched(squares(2, 2, 8.0), machine);
    read_back(&machine, planned, 4, |dialect, plan, _| assert_eq!(plan.summary.chains, 3, "{dialect}"));
}

#[test]
fn drawings_have_chains_as_one_path_with_their_contours() {
    let machine = chaining(30.0, 1.0);
    let (sheet, plan) = searched(squares(2, 2, 8.0), &machine);
    let facts = SheetFacts::of(&sheet);
    let dxf = output::dxf(&plan, &facts);
    assert_eq!(dxf.matches("LWPOLYLINE").count(), 1, "one path with three chains");
    let project = output::lbrn2(&plan, &facts, &machine).unwrap();
    assert_eq!(project.matches("<Shape").count(), 1);
    let svg = output::svg(&plan, &facts, &machine);
    assert_eq!(svg.matches("class=\"cut\"").count(), 4);
    assert_eq!(svg.matches("Cuts through waste").count(), 1);
    // A start on a kerf begins another path.
    let (sheet, plan) = searched(squares(4, 1, 8.0), &starting(30.0, 1.0));
    assert_eq!(output::dxf(&plan, &SheetFacts::of(&sheet)).matches("LWPOLYLINE").count(), 3);
}

#[test]
fn machines_that_cannot_are_refused() {
    let with = |change: &dyn Fn(&mut Profile)| {
        let mut profile = chaining(30.0, 1.0);
        change(&mut profile);
        profile.validate().unwrap_err().to_string()
    };
    assert!(
        with(&|p| p.pre_cut_time = Some(1.0)).starts_with("The machine has levers.chains and pre_cut_time.")
    );
    let corner = Some(kerfway::machine::SharpCorner { angle: 1.0, time: 1.0 });
    assert!(with(&|p| p.sharp_corner = corner).contains("levers.chains and sharp_corner"));
    assert!(
        with(&|p| p.levers.chains = Some(Chains { reach: 0.0, clearance: 1.0, edge_starts: false }))
            .contains("levers.chains.reach")
    );
}

#[test]
fn a_turned_sheet_has_the_same_chains() {
    let machine = Profile { rapid: chaining(1.0, 1.0).rapid, ..chaining(30.0, 1.0) };
    let total = |turn: f64| {
        let u = kerfway::geometry::math::unit(turn);
        let mut b = Builder::new();
        for k in 0..4 {
            let at = p(f64::from(k % 2), f64::from(k / 2)) * 28.0 + p(100.0, 10.0);
            let corners = [p(0.0, 0.0), p(20.0, 0.0), p(20.0, 20.0), p(0.0, 20.0)];
            b.cut(polygon(&corners.map(|c| u.rotate(at + c))), None);
        }
        let plan = searched(b, &machine).1;
        (plan.summary.chains, plan.summary.chain_length)
    };
    for turn in [0.3, 1.2, -0.8] {
        let (chains, length) = total(turn);
        assert_eq!(chains, 3);
        assert!((length - 24.0).abs() < 1e-6, "{length}");
    }
}
