//! Work orders: what crosses from the planner's wasm file to that of the writers loses nothing.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use crate::testkit::{files, fixtures, name, plans};
use kerfway::geometry::{Arc, DVec2, Segment};
use kerfway::job::{Job, LayerChoice, LoadOptions, MachineChoice, OutputKind, PlanOptions};
use kerfway::machine::{JointKind, JointRule, Joints, Profile};
use kerfway::output::{WorkOrder, json_text};
use kerfway::plan::Move;
use kerfway::sheet::Operation;
use std::fs;

/// Every real drawing, planned for machines that use every kind of move.
fn jobs() -> impl Iterator<Item = Job> {
    let quick = Profile { pierce_time: 0.25, kerf_width: 0.2, ..plans::machine() };
    let rule = JointRule { kind: JointKind::Stop, spacing: Some(100.0), ..JointRule::default() };
    let joined = Profile { joints: Some(Joints { rules: vec![rule] }), ..plans::machine() };
    let machines = [
        MachineChoice::Profile(Box::new(quick)),
        MachineChoice::Profile(Box::new(joined)),
        MachineChoice::Preset("length-partial".to_owned()),
        MachineChoice::Preset("fibre-6kw-thick".to_owned()),
    ];
    files(&fixtures().join("dxf-dev"), "dxf").into_iter().zip(machines.into_iter().cycle()).filter_map(
        |(file, machine)| {
            let mut job = Job::load(fs::read(&file).unwrap(), &name(&file), &LoadOptions::default()).ok()?;
            let moves = Some(50);
            job.start(&PlanOptions { machine, moves, allow_off_bed: true, ..PlanOptions::default() }).ok()?;
            job.run_mut().unwrap().step(50);
            Some(job)
        },
    )
}

#[test]
fn a_work_order_read_back_is_the_same_and_writes_the_same() {
    let mut compared = 0;
    for job in jobs() {
        let order = job.work_order(OutputKind::Gcode).unwrap();
        let text = json_text(&order);
        let read = WorkOrder::read(&text).unwrap();
        assert_eq!(read, order);
        assert!(json_text(&read) == text, "{} differs when it is written again", order.name);
        for kind in [OutputKind::Gcode, OutputKind::Svg, OutputKind::Dxf, OutputKind::Lbrn2, OutputKind::Rd] {
            assert!(read.write(kind) == order.write(kind), "{kind:?} of {}", order.name);
        }
        compared += 1;
    }
    assert!(compared >= 16, "{compared} drawings");
}

#[test]
fn every_bit_of_an_element_survives() {
    let at = DVec2::new;
    // The sweep is none that the ends give, the centre is off by the last bit, and zeros have a sign.
    let arc =
        Arc { start: at(-0.0, 1e-300), end: at(0.1 + 0.2, -0.0), center: at(1e300, 0.3), sweep: -1e-17 };
    let path = vec![Segment::line(at(0.1, -0.0), at(1.0 / 3.0, 5e-324)), Segment::Arc(arc)];
    let cut = Move::PreCut { contour: 7, to: at(-0.0, 0.1), ahead: path };
    let back: Move = serde_json::from_str(&json_text(&cut)).unwrap();
    // Debug tells zeros with different signs apart.
    assert_eq!(format!("{back:?}"), format!("{cut:?}"));
}

#[test]
fn a_work_order_that_is_damaged_or_of_another_version_is_refused() {
    let job = planned_plate();
    let text = json_text(&job.work_order(OutputKind::Gcode).unwrap());
    let cut_off = WorkOrder::read(&text[..text.len() / 2]).unwrap_err();
    assert!(
        cut_off.starts_with("The plan did not reach the writer of outputs whole: line 1, column "),
        "{cut_off}"
    );
    let other =
        text.replacen(&format!("\"version\":\"{}\"", env!("CARGO_PKG_VERSION")), "\"version\":\"9.9.9\"", 1);
    assert_eq!(
        WorkOrder::read(&other).unwrap_err(),
        format!(
            "The planner is of version 9.9.9, and the writer of outputs of version {}: use the files of one version.",
            env!("CARGO_PKG_VERSION")
        )
    );
    // A number that is none would be a place that nobody planned.
    let lost = text.replacen("\"length\":", "\"length\":null,\"was\":", 1);
    assert!(WorkOrder::read(&lost).is_err());
}

#[test]
fn settings_of_layers_and_marks_reach_the_writers() {
    let mut options = LoadOptions::default();
    let job = planned_plate();
    let layer = &job.sheet().layers[0];
    let mut choice = LayerChoice::new(&layer.name, Operation::Mark);
    (choice.speed, choice.power) = (Some(12.5), Some(0.25));
    options.layers = vec![choice];
    let job = planned(&options);
    let order = job.work_order(OutputKind::Gcode).unwrap();
    assert!(order.sheet.contours.iter().any(|c| c.mark));
    assert_eq!(order.sheet.layers[0].settings.speed, Some(12.5));
    let written = WorkOrder::read(&json_text(&order)).unwrap().write(OutputKind::Gcode);
    assert_eq!(written, order.write(OutputKind::Gcode));
    assert!(job.output(OutputKind::Gcode).unwrap().contains("F750"));
}

fn planned_plate() -> Job {
    planned(&LoadOptions::default())
}

fn planned(options: &LoadOptions) -> Job {
    let file = fixtures().join("plate/shared-sides.dxf");
    let mut job = Job::load(fs::read(&file).unwrap(), &name(&file), options).unwrap();
    job.start(&PlanOptions { moves: Some(50), allow_off_bed: true, ..PlanOptions::default() }).unwrap();
    job.run_mut().unwrap().step(50);
    job
}
