//! Cuts and marks that begin moving (`levers.moving_pierce`): what they save, what still begins at rest, and what the checker
//! says of plans that do it wrongly.
#![allow(clippy::unwrap_used, clippy::panic, reason = "tests stop where they cannot go on")]

use crate::testkit::exact::{planned, search_of_exact_cost};
use crate::testkit::sheets::{Builder, circle, line, machine, nested_sheet, p, rectangle};
use kerfway::geometry::Segment;
use kerfway::machine::{
    LeadKind, LeadRule, LeadShape, Leads, Levers, MovingPierce, Process, Profile, SharpCorner, presets,
};
use kerfway::plan::{self, Move, Violation};
use kerfway::sheet::Sheet;

/// A plate with two holes, a mark, and an open cut beside it: 0 plate, 1 and 2 holes, 3 mark, 4 open cut.
fn sheet() -> Sheet {
    let mut b = Builder::new();
    let plate = b.cut(rectangle(p(10.0, 10.0), p(60.0, 40.0)), None);
    b.cut(circle(p(25.0, 25.0), 4.0), Some(plate));
    b.cut(circle(p(50.0, 30.0), 6.0), Some(plate));
    b.mark(line(p(20.0, 40.0), p(40.0, 42.0)), Some(plate));
    b.cut(line(p(80.0, 5.0), p(95.0, 9.0)), None);
    b.sheet
}

fn moving(machine: &Profile, overcut: f64) -> Profile {
    let levers = Levers { moving_pierce: Some(MovingPierce { overcut }), ..Levers::default() };
    Profile { levers, pre_cut_time: None, ..machine.clone() }
}

/// What the checker says after a change to the moves.
fn after(machine: &Profile, checked: &Profile, change: impl FnOnce(&mut Vec<Move>)) -> Vec<Violation> {
    let sheet = sheet();
    let mut plan = planned(&sheet, machine);
    change(&mut plan.moves);
    let parts = plan.summary.parts;
    plan.summary = plan::evaluate(&plan.moves, &sheet, checked);
    plan.summary.parts = parts;
    plan::check(&sheet, checked, &plan).unwrap_err()
}

fn says(found: &[Violation], wanted: &str) -> bool {
    found.iter().any(|v| matches!(v, Violation::Beam { what, .. } if *what == wanted))
}

#[test]
fn closed_cuts_and_marks_begin_moving_and_open_cuts_at_rest_on_every_machine() {
    for preset in presets() {
        for overcut in [0.0, 0.5, 1000.0] {
            let machine = moving(&preset, overcut);
            let plan = planned(&sheet(), &machine);
            assert_eq!(plan::check(&sheet(), &machine, &plan), Ok(()), "{} {overcut}", preset.name);
            assert_eq!((plan.summary.moving_starts, plan.summary.pierces), (4, 1), "{}", preset.name);
            // Cut again is the length that is asked for, and at most half of a contour.
            let length = |c: &kerfway::sheet::Contour| c.path.length();
            let again: f64 =
                [0, 1, 2].map(|id| overcut.min(0.5 * length(&sheet().contours[id]))).iter().sum();
            assert!((plan.summary.lead_length - again).abs() < 1e-9, "{} {overcut}", preset.name);
        }
    }
}

#[test]
fn the_piercing_and_the_delay_before_it_are_saved() {
    for preset in presets().into_iter().filter(|m| m.pre_cut_time.is_none()) {
        let (rest, moving) = (planned(&sheet(), &preset), planned(&sheet(), &moving(&preset, 0.0)));
        let saved = 3.0 * preset.pierce_time + 4.0 * preset.beam_on_delay;
        let less = rest.summary.total_time - moving.summary.total_time;
        assert!((less - saved).abs() < 1e-9, "{}: {less} s, not {saved} s", preset.name);
        assert_eq!(rest.summary.moving_starts, 0);
    }
}

#[test]
fn leads_keep_their_overcut_and_gaps_are_pierced_at_rest() {
    let rule = |overcut| {
        let lead_in = LeadShape { kind: LeadKind::Line, length: 2.0, ..LeadShape::default() };
        let leads =
            Leads { clearance: 0.2, rules: vec![LeadRule { lead_in, overcut, ..LeadRule::default() }] };
        Profile { leads: Some(leads), ..moving(&machine("fibre-3kw-thin"), 0.5) }
    };
    for (overcut, starts) in [(0.2, 4), (0.8, 4), (-0.3, 1)] {
        let machine = rule(overcut);
        let plan = planned(&sheet(), &machine);
        assert_eq!(plan::check(&sheet(), &machine, &plan), Ok(()), "{overcut}");
        assert_eq!(plan.summary.moving_starts, starts, "{overcut}");
    }
}

#[test]
fn several_passes_begin_at_rest() {
    let preset = machine("co2-100w");
    let machine = moving(&Profile { cut: Process { passes: 2, ..preset.cut }, ..preset }, 0.5);
    let plan = planned(&sheet(), &machine);
    assert_eq!(plan::check(&sheet(), &machine, &plan), Ok(()));
    // The mark alone begins moving.
    assert_eq!((plan.summary.moving_starts, plan.summary.pierces), (1, 8));
}

#[test]
fn machines_that_leave_cuts_unfinished_pierce_at_rest() {
    let plate = machine("fibre-6kw-plate");
    let both = Profile { pre_cut_time: plate.pre_cut_time, ..moving(&plate, 0.5) };
    let message = both.validate().unwrap_err().to_string();
    assert!(message.contains("levers.moving_pierce and pre_cut_time"), "{message}");
    moving(&plate, 0.5).validate().unwrap();
    let message = moving(&plate, 1e3).validate().unwrap_err().to_string();
    assert!(message.contains("\"levers.moving_pierce.overcut\" is 1000"), "{message}");
}

#[test]
fn the_checker_finds_wrong_moving_starts() {
    let with = moving(&machine("fibre-3kw-thin"), 0.5);
    let without = Profile { levers: Levers::default(), ..with.clone() };
    let found = after(&with, &without, |_| ());
    assert!(says(&found, "begins moving, which the machine does not"), "{found:?}");
    let found = after(&with, &with, |moves| {
        let at = moves.iter().position(|m| *m == Move::Pierce).unwrap();
        moves[at] = Move::MovingStart;
    });
    assert!(says(&found, "begins a cut moving that has to be pierced at rest"), "{found:?}");
    let found = after(&with, &with, |moves| {
        for m in moves.iter_mut() {
            if let Move::Cut { contour: 1, path, leads, .. } = m {
                path.truncate(path.len() - std::mem::take(&mut leads.overcut));
            }
        }
    });
    assert!(says(&found, "begins moving and does not cut the beginning again"), "{found:?}");
    let found = after(&with, &with, |moves| {
        let at = moves.iter().position(|m| *m == Move::MovingStart).unwrap();
        moves.insert(at, Move::Pierce);
    });
    assert!(says(&found, "pierces twice"), "{found:?}");
    let found = after(&with, &with, |moves| {
        let at = moves.iter().position(|m| matches!(m, Move::Cut { contour: 1, .. })).unwrap();
        moves.remove(at - 1);
    });
    assert!(says(&found, "cuts without piercing"), "{found:?}");
}

#[test]
fn the_search_is_as_good_as_every_order_and_entry_of_six_contours() {
    for seed in 0..10 {
        let sheet = nested_sheet(6, seed);
        let machine = moving(&machine("fibre-3kw-thin"), 0.5);
        let (_, _, plan) = search_of_exact_cost(&sheet, &machine, seed);
        let lengths = |m: &Move| {
            if let Move::Cut { path, .. } = m { path.iter().map(Segment::length).sum() } else { 0.0 }
        };
        let sum: f64 = plan.moves.iter().map(lengths).sum();
        assert!((plan.summary.cut_length - sum).abs() < 1e-9);
    }
}

/// The checker looked for the overcut in the first run of such a cut alone, and refused the plan.
#[test]
fn cuts_that_begin_moving_and_pause_in_sharp_corners_cut_their_beginning_again() {
    let sharp_corner = Some(SharpCorner { angle: 1.6, time: 0.2 });
    let machine = Profile { sharp_corner, ..moving(&machine("co2-100w"), 3.0) };
    let plan = planned(&sheet(), &machine);
    assert_eq!(plan::check(&sheet(), &machine, &plan), Ok(()));
    let pauses = plan.moves.iter().filter(|m| matches!(m, Move::Macro { contour: 0, .. })).count();
    assert_eq!((plan.summary.moving_starts, pauses), (4, 4));
    let found = after(&machine, &machine, |moves| {
        let last = moves.iter().rposition(|m| matches!(m, Move::Cut { contour: 0, .. })).unwrap();
        let Move::Cut { path, leads, .. } = &mut moves[last] else { panic!() };
        path.truncate(path.len() - std::mem::take(&mut leads.overcut));
    });
    assert!(says(&found, "begins moving and does not cut the beginning again"), "{found:?}");
}
