//! Sharp corners of thick plate: a pause in each that is cut through, saved where a cut begins or ends; pre-cuts with a
//! length.
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    clippy::float_cmp,
    dead_code,
    reason = "a test fails by panicking"
)]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::disallowed_methods,
    reason = "sheets of a few contours"
)]

use crate::testkit::outlines::{covers, drawing};
use kerfway::geometry::DVec2;
use kerfway::job::{BestPath, Job, LoadOptions, MachineChoice, OutputKind, PlanOptions, SliceEnd};
use kerfway::machine::{Profile, SharpCorner, preset};
use kerfway::plan::{self, Move, Plan, Violation};
use std::f64::consts::{PI, TAU};

/// Regular, turned by an angle.
fn regular(corners: u32, center: (f64, f64), radius: f64, turned: f64) -> Vec<DVec2> {
    (0..corners)
        .map(|k| {
            let a = turned + TAU * f64::from(k) / f64::from(corners);
            DVec2::from(center) + radius * DVec2::new(a.cos(), a.sin())
        })
        .collect()
}

/// Triangles beside squares, a triangle in a large square, all turned by an angle.
fn forms(turned: f64) -> Vec<Vec<DVec2>> {
    let place = |x: f64, y: f64| {
        let (sin, cos) = turned.sin_cos();
        (400.0 + x * cos - y * sin, 400.0 + x * sin + y * cos)
    };
    vec![
        regular(3, place(0.0, 0.0), 20.0, turned),
        regular(4, place(60.0, 10.0), 20.0, turned),
        regular(3, place(120.0, -20.0), 15.0, 0.7 + turned),
        regular(4, place(60.0, 120.0), 60.0, PI / 4.0 + turned),
        regular(3, place(50.0, 110.0), 20.0, 0.3 + turned),
        regular(6, place(160.0, 90.0), 18.0, turned),
    ]
}

/// Thick plate: corners below 70 degrees wait for 2 s.
fn thick() -> Profile {
    Profile {
        pierce_time: 1.0,
        pre_cut_time: None,
        sharp_corner: Some(SharpCorner { angle: 70.0_f64.to_radians(), time: 2.0 }),
        home: [400.0, 400.0],
        ..preset("fibre-6kw-thick").unwrap()
    }
}

fn planned(outlines: &[Vec<DVec2>], machine: Profile) -> Job {
    let mut job = Job::load(drawing(outlines), "corners.dxf", &LoadOptions::default()).unwrap();
    let machine = MachineChoice::Profile(Box::new(machine));
    job.start(&PlanOptions { machine, allow_off_bed: true, seed: 1, ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(60_000);
    job
}

/// The plan, checked; what the search counts and what each contour takes anyhow are the whole job.
fn sound(job: &Job) -> Plan {
    let plan = job.plan().unwrap();
    let run = job.run().unwrap();
    let fixed: f64 = run.problem().items.iter().map(|i| i.fixed).sum();
    let (sum, total) = (fixed + run.best().cost, plan.summary.total_time);
    assert!((sum - total).abs() < 1e-9 * total, "{sum}, not {total}");
    plan
}

fn macros(plan: &Plan) -> usize {
    plan.moves.iter().filter(|m| matches!(m, Move::Macro { .. })).count()
}

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
    for pre_cut in [0.0, 0.5, 5.0] {
        let machine = Profile { pre_cut_time: Some(pre_cut), ..thick() };
        let job = planned(&forms(0.0), machine);
        let plan = sound(&job);
        let left = plan.summary.pre_cuts as usize;
        assert!(macros(&plan) + left >= 6 || pre_cut == 0.0, "{pre_cut}");
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
        let mut summary = plan::evaluate(&moves, &machine);
        summary.parts = good.summary.parts;
        plan::check(job.sheet(), &machine, &Plan { moves, summary }).unwrap_err()
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
    let mut summary = plan::evaluate(&good.moves, &none);
    summary.parts = good.summary.parts;
    let found = plan::check(job.sheet(), &none, &Plan { moves: good.moves.clone(), summary }).unwrap_err();
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
    let cut = Move::Cut { contour, with: vec![], mark: false, path: rest.clone() };
    moves.splice(at + 1..at + 1, [Move::Macro { contour, at: rest[0].start() }, cut]);
    let mut summary = plan::evaluate(&moves, &thick());
    summary.parts = good.summary.parts;
    let found = plan::check(job.sheet(), &thick(), &Plan { moves, summary }).unwrap_err();
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

/// m by n squares with shared sides.
fn grid(m: usize, n: usize) -> Vec<Vec<DVec2>> {
    let corner = |k: usize| DVec2::new(300.0 + 20.0 * (k % m) as f64, 300.0 + 20.0 * (k / m) as f64);
    let square = |k: usize| {
        [(0.0, 0.0), (20.0, 0.0), (20.0, 20.0), (0.0, 20.0)].map(|d| corner(k) + DVec2::from(d)).to_vec()
    };
    (0..m * n).map(square).collect()
}

/// Every right angle that a run through the group turns at is a pause, or is not turned at.
#[test]
fn groups_pause_in_corners_and_avoid_some() {
    let machine = Profile {
        pre_cut_time: Some(0.3),
        sharp_corner: Some(SharpCorner { angle: 100.0_f64.to_radians(), time: 2.0 }),
        ..thick()
    };
    for (m, n) in [(2, 1), (2, 2), (3, 2)] {
        let plan = sound(&planned(&grid(m, n), machine.clone()));
        assert!(macros(&plan) > 0, "{m} x {n}");
        // Waits are looked at while the order is chosen.
        let blind = sound(&planned(&grid(m, n), Profile { sharp_corner: None, ..machine.clone() }));
        let waits = |plan: &Plan| {
            let runs = plan.moves.iter().filter_map(|m| match m {
                Move::Cut { path, .. } => Some(machine.runs(path).count() - 1),
                _ => None,
            });
            runs.sum::<usize>() + macros(plan)
        };
        assert!(waits(&plan) <= waits(&blind), "{m} x {n}");
    }
}

#[test]
fn pre_cuts_have_a_length_and_are_cut_ahead() {
    let machine = Profile {
        pre_cut_time: Some(0.01),
        pre_cut_length: 3.0,
        pierce_time: 5.0,
        sharp_corner: None,
        ..thick()
    };
    let mut made = 0;
    for outlines in [grid(3, 2), forms(0.0)] {
        let job = planned(&outlines, machine.clone());
        let good = sound(&job);
        covers(&outlines, &job.output(OutputKind::Gcode).unwrap());
        let ahead = |m: &Move| if let Move::PreCut { ahead, .. } = m { Some(ahead.clone()) } else { None };
        let lengths: Vec<f64> =
            good.moves.iter().filter_map(ahead).map(|a| a.iter().map(|s| s.length()).sum()).collect();
        made += lengths.len();
        assert!(lengths.iter().all(|l| (l - 3.0).abs() < 1e-9), "{lengths:?}");
        let Some(at) = good.moves.iter().position(|m| matches!(m, Move::PreCut { .. })) else { continue };
        assert!(job.output(OutputKind::Gcode).unwrap().contains("; pre-cut into contour"));
        // Of another length, elsewhere, and none at all.
        for change in 0..3 {
            let mut moves = good.moves.clone();
            let Move::PreCut { ahead, .. } = &mut moves[at] else { panic!() };
            match change {
                0 => *ahead = vec![ahead[0].piece(0.0, 1.0), ahead[0].piece(0.0, 1.0)],
                1 => {
                    *ahead = vec![kerfway::geometry::Segment::line(
                        ahead[0].start(),
                        ahead[0].start() + DVec2::new(1.7, 1.9),
                    )]
                }
                _ => ahead.clear(),
            }
            let mut summary = plan::evaluate(&moves, &machine);
            summary.parts = good.summary.parts;
            let found = plan::check(job.sheet(), &machine, &Plan { moves, summary });
            assert!(found.is_err(), "{change}");
        }
    }
    assert!(made > 0);
}

/// Pauses are in the objective of the partition-tree and of its construction, in contours that are left in a corner too.
#[test]
fn the_partition_tree_minimises_pauses_too() {
    for (pre_cut, name) in [0.0, 0.5, 5.0].into_iter().flat_map(|p| ["pfr", "partition-tree"].map(|n| (p, n)))
    {
        let machine = Profile { pre_cut_time: Some(pre_cut), ..thick() };
        let mut job = Job::load(drawing(&forms(0.0)), "corners.dxf", &LoadOptions::default()).unwrap();
        let machine = MachineChoice::Profile(Box::new(machine));
        let method = Some(name.to_owned());
        job.start(&PlanOptions { machine, method, seed: 1, ..PlanOptions::default() }).unwrap();
        while job.run_mut().unwrap().step(100_000).end != SliceEnd::Exhausted {}
        // What the best path counts is the whole time of its plan, pauses among it.
        let plan = sound(&job);
        assert!(plan.summary.macro_time > 0.0 || pre_cut == 0.0, "{pre_cut} {name}");
        // The construction ends with its only path: what the tree counts is the same.
        let insight = job.run().unwrap().insight().unwrap();
        let curve = insight.curves.iter().find(|c| c.name == "time now, s").unwrap();
        let best = job.run().unwrap().best().cost;
        assert!(
            name != "pfr" || (curve.value - best).abs() < 1e-9,
            "{pre_cut}: {} is not {best}",
            curve.value
        );
    }
}
