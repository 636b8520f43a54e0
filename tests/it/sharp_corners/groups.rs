//! Groups of parts, pre-cuts, and a published method.
#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp, reason = "a test fails by panicking")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::disallowed_methods,
    reason = "sheets of a few contours"
)]

use super::corners::{forms, macros, planned, sound, thick};
use crate::testkit::outlines::{covers, drawing};
use kerfway::geometry::DVec2;
use kerfway::job::{Job, LoadOptions, MachineChoice, OutputKind, PlanOptions, SliceEnd};
use kerfway::machine::{Profile, SharpCorner};
use kerfway::plan::{self, Move, Plan};

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
            let mut summary = plan::evaluate(&moves, job.beam_sheet(), &machine);
            summary.parts = good.summary.parts;
            let found = plan::check(job.sheet(), &machine, &Plan { moves, summary, bridges: Vec::new() });
            assert!(found.is_err(), "{change}");
        }
    }
    assert!(made > 0);
}

/// Pauses count in the objective of the partition-tree and of its construction, in contours that are left in a corner too.
#[test]
fn the_partition_tree_counts_pauses() {
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
