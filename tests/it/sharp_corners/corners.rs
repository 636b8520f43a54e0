//! Outlines with corners of many angles, planned on a machine that pauses in sharp ones.
#![allow(clippy::unwrap_used, clippy::panic, clippy::float_cmp, reason = "a test fails by panicking")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    clippy::disallowed_methods,
    reason = "sheets of a few contours"
)]

use crate::testkit::outlines::drawing;
use kerfway::geometry::DVec2;
use kerfway::job::{Job, LoadOptions, MachineChoice, PlanOptions};
use kerfway::machine::{Profile, SharpCorner, preset};
use kerfway::plan::{Move, Plan};
use std::f64::consts::{PI, TAU};

/// Regular, turned by an angle.
pub(super) fn regular(corners: u32, center: (f64, f64), radius: f64, turned: f64) -> Vec<DVec2> {
    (0..corners)
        .map(|k| {
            let a = turned + TAU * f64::from(k) / f64::from(corners);
            DVec2::from(center) + radius * DVec2::new(a.cos(), a.sin())
        })
        .collect()
}

/// Triangles beside squares, a triangle in a large square, all turned by an angle.
pub(super) fn forms(turned: f64) -> Vec<Vec<DVec2>> {
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
pub(super) fn thick() -> Profile {
    Profile {
        pierce_time: 1.0,
        pre_cut_time: None,
        sharp_corner: Some(SharpCorner { angle: 70.0_f64.to_radians(), time: 2.0 }),
        home: [400.0, 400.0],
        ..preset("fibre-6kw-thick").unwrap()
    }
}

pub(super) fn planned(outlines: &[Vec<DVec2>], machine: Profile) -> Job {
    let mut job = Job::load(drawing(outlines), "corners.dxf", &LoadOptions::default()).unwrap();
    let machine = MachineChoice::Profile(Box::new(machine));
    job.start(&PlanOptions { machine, allow_off_bed: true, seed: 1, ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(60_000);
    job
}

/// The plan, checked; what the search counts and what each contour takes anyhow are the whole job.
pub(super) fn sound(job: &Job) -> Plan {
    let plan = job.plan().unwrap();
    let run = job.run().unwrap();
    let fixed: f64 = run.problem().items.iter().map(|i| i.fixed).sum();
    let (sum, total) = (fixed + run.best().cost, plan.summary.total_time);
    assert!((sum - total).abs() < 1e-9 * total, "{sum}, not {total}");
    plan
}

pub(super) fn macros(plan: &Plan) -> usize {
    plan.moves.iter().filter(|m| matches!(m, Move::Macro { .. })).count()
}
