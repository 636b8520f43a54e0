//! Joints on every real drawing and on the sheets: plans pass the check, and programs are written and read back.

use crate::testkit::jobs::each_planned;
use crate::testkit::joints::{rule, with_joints};
use crate::testkit::leads::{leads, with_leads};
use crate::testkit::{files, fixtures};
use kerfway::job::OutputKind;
use kerfway::machine::{JointKind, JointRule, LeadKind, preset};

#[test]
fn every_drawing_is_planned_with_joints() {
    let mut all = files(&fixtures().join("dxf-dev"), "dxf");
    all.push(fixtures().join("sheets/sheet_100.dxf"));
    let machine = |k: usize| {
        let kind = [JointKind::Stop, JointKind::Flying][k / 2 % 2];
        let rule = JointRule { spacing: [Some(150.0), None][k % 2], ..rule([1, 2, 3, 4][k % 4], kind) };
        let mut machine = with_joints(preset(["co2-100w", "fibre-3kw-thin"][k % 2]).unwrap(), vec![rule]);
        if k.is_multiple_of(3) {
            machine = with_leads(machine, leads(LeadKind::Arc, 0.5, 0.2));
        }
        machine.kerf_width = [0.0, 0.2, 0.0][k % 3];
        machine
    };
    let mut with = 0;
    each_planned(&all, machine, |name, job, plan| {
        with += usize::from(plan.summary.joints > 0);
        for kind in [OutputKind::Gcode, OutputKind::Svg, OutputKind::Dxf, OutputKind::Json, OutputKind::Lbrn2]
        {
            if let Err(e) = job.output(kind) {
                panic!("{name} {kind:?}: {e}");
            }
        }
    });
    assert!(with > 15, "{with}");
}
