//! Contours that share no cut.
#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp, reason = "a test fails by panicking")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::disallowed_methods,
    reason = "sheets of a few contours"
)]

use super::corners::{forms, macros, planned, sound, thick};
use crate::testkit::outlines::covers;
use kerfway::geometry::DVec2;
use kerfway::job::{BestPath, OutputKind};
use kerfway::machine::{Profile, SharpCorner};
use kerfway::plan::{self, Leads, Move, Plan, Violation};
use std::f64::consts::PI;

#[test]
fn triangles_pause_in_two_corners_because_they_are_entered_in_the_third() {
    let job = planned(&forms(0.0), thick());
    let plan = sound(&job);
    assert_eq!(macros(&plan), 6);
    assert!((plan.summary.macro_time - 12.0).abs() < 1e-12);
    let without = sound(&planned(&forms(0.0), Profile { sharp_corner: None, ..thick() }));
    assert_eq!(macros(&without), 0);
    assert!((without.summary.cut_length - plan.summary.cut_length).abs() < 1e-6);
    assert_eq!(without.summary.contours, plan.summary.contours);
    // Times of stops: one pair each, pauses among them.
    let (path, _) = BestPath::of(job.run().unwrap(), job.sheet());
    assert_eq!(path.times.len(), 2 * path.contours.len());
    let through: f64 = path.times.chunks(2).map(|t| t[1] - t[0]).sum();
    let s = &plan.summary;
    let delays = 6.0 * (thick().beam_on_delay + thick().beam_off_delay);
    assert!((through - s.cut_time - s.macro_time - delays).abs() < 1e-9, "{through}");
}

/// The limit itself is not sharp, also where rounding makes it a hair less.
#[test]
fn right_angles_are_not_below_a_limit_of_a_right_angle() {
    let at = |angle: f64| Profile { sharp_corner: Some(SharpCorner { angle, time: 2.0 }), ..thick() };
    for turned in [0.0, 0.1, 1.0, 2.2] {
        assert_eq!(macros(&sound(&planned(&forms(turned), at(PI / 2.0)))), 6, "{turned}");
        assert_eq!(macros(&sound(&planned(&forms(turned), at(PI / 2.0 + 1e-3)))), 6 + 6, "{turned}");
        assert_eq!(macros(&sound(&planned(&forms(turned), at(0.0)))), 0, "{turned}");
    }
}

#[test]
fn a_rotated_drawing_takes_the_same_time() {
    let machine = Profile { travel: kerfway::machine::Travel::Vector, ..thick() };
    let straight = sound(&planned(&forms(0.0), machine.clone())).summary.total_time;
    for turned in [0.4, 1.7, 3.0] {
        let total = sound(&planned(&forms(turned), machine.clone())).summary.total_time;
        assert!((total - straight).abs() < 1e-6 * total, "{turned}: {total}, not {straight}");
    }
}

#[test]
fn a_machine_without_acceleration_pauses_too() {
    let mut machine = thick();
    machine.cut.accel = None;
    assert_eq!(macros(&sound(&planned(&forms(0.3), machine))), 6);
}

/// Where leaving costs less than a wait, and where it costs more.
#[test]
fn contours_interrupted_in_a_corner_save_its_pause() {
    // Of the six corners two are those where a contour is left. A pre-cut that takes no time is no move.
    for (pre_cut, pauses, left) in [(0.0, 4, 0), (0.5, 4, 2), (5.0, 6, 0)] {
        let machine = Profile { pre_cut_time: Some(pre_cut), ..thick() };
        let job = planned(&forms(0.0), machine);
        let plan = sound(&job);
        assert_eq!((macros(&plan), plan.summary.pre_cuts), (pauses, left), "{pre_cut}");
        assert!(job.run().unwrap().bound() <= plan.summary.total_time + 1e-9);
    }
}

#[test]
fn the_checker_finds_a_missing_or_extra_macro() {
    let job = planned(&forms(0.2), thick());
    let good = sound(&job);
    let machine = thick();
    let faults = |change: &dyn Fn(&mut Vec<Move>)| {
        let mut moves = good.moves.clone();
        change(&mut moves);
        let mut summary = plan::evaluate(&moves, job.beam_sheet(), &machine);
        summary.parts = good.summary.parts;
        plan::check(job.sheet(), &machine, &Plan { moves, summary, bridges: Vec::new() }).unwrap_err()
    };
    let at = good.moves.iter().position(|m| matches!(m, Move::Macro { .. })).unwrap();
    let missing = |found: &[Violation]| found.iter().any(|v| matches!(v, Violation::NoMacro { .. }));
    // Without the pause; as one cut; with the pause elsewhere; twice; of a machine that needs none.
    assert!(missing(&faults(&|m| drop(m.remove(at)))));
    assert!(missing(&faults(&|m| {
        let Move::Cut { path: rest, .. } = m.remove(at + 1) else { panic!() };
        m.remove(at);
        let Move::Cut { path, .. } = &mut m[at - 1] else { panic!() };
        path.extend(rest);
    })));
    let astray = |found: &[Violation]| {
        let says = "pauses where no sharp corner is cut through";
        found.iter().any(|v| matches!(v, Violation::Beam { what, .. } if *what == says))
    };
    assert!(astray(&faults(&|m| {
        let Move::Macro { at: place, .. } = &mut m[at] else { panic!() };
        *place += DVec2::X;
    })));
    assert!(astray(&faults(&|m| m.insert(at, m[at].clone()))));
    assert!(astray(&faults(&|m| m.push(m[at].clone()))));
    let none = Profile { sharp_corner: None, ..machine.clone() };
    let mut summary = plan::evaluate(&good.moves, job.beam_sheet(), &none);
    summary.parts = good.summary.parts;
    let found =
        plan::check(job.sheet(), &none, &Plan { moves: good.moves.clone(), summary, bridges: Vec::new() })
            .unwrap_err();
    assert!(astray(&found), "{found:?}");
    // A time that leaves pauses out.
    let mut plan = good.clone();
    plan.summary.total_time -= plan.summary.macro_time;
    plan.summary.macro_time = 0.0;
    assert!(plan::check(job.sheet(), &machine, &plan).is_err());
}

#[test]
fn a_pause_where_a_side_continues_is_a_fault() {
    let job = planned(&forms(0.2), thick());
    let good = sound(&job);
    let mut moves = good.moves.clone();
    // A square's corner is not sharp.
    let at = moves.iter().position(|m| matches!(m, Move::Cut { path, .. } if path.len() == 4)).unwrap();
    let Move::Cut { contour, path, .. } = &mut moves[at] else { panic!() };
    let (contour, rest) = (*contour, path.split_off(2));
    let cut = Move::Cut {
        contour,
        with: vec![],
        mark: false,
        path: rest.clone(),
        leads: Leads::default(),
        turns: vec![],
    };
    moves.splice(at + 1..at + 1, [Move::Macro { contour, at: rest[0].start() }, cut]);
    let mut summary = plan::evaluate(&moves, job.beam_sheet(), &thick());
    summary.parts = good.summary.parts;
    let found =
        plan::check(job.sheet(), &thick(), &Plan { moves, summary, bridges: Vec::new() }).unwrap_err();
    assert!(found.iter().any(|v| matches!(v, Violation::Beam { .. })), "{found:?}");
}

#[test]
fn g_code_pauses_in_the_corners_with_the_beam_off() {
    let mut machine = thick();
    machine.sharp_corner = Some(SharpCorner { angle: 70.0_f64.to_radians(), time: 2.125 });
    let text = planned(&forms(0.1), machine).output(OutputKind::Gcode).unwrap();
    assert_eq!(text.lines().filter(|l| *l == "G4 P2.125").count(), 6);
    let lines: Vec<&str> = text.lines().collect();
    for k in (0..lines.len()).filter(|&k| lines[k] == "G4 P2.125") {
        assert_eq!(lines[k - 1], "S0");
    }
    // One comment for each contour.
    assert_eq!(text.lines().filter(|l| l.contains(": cut contour")).count(), 6);
    covers(&forms(0.1), &text);
}

/// Ruida files were written without the pauses and without a word.
#[test]
fn ruida_files_refuse_plans_that_pause_in_corners() {
    let refused = planned(&forms(0.0), thick()).output(OutputKind::Rd).unwrap_err().to_string();
    assert!(refused.starts_with("Ruida files of Kerfway have no pauses in sharp corners: "), "{refused}");
}
