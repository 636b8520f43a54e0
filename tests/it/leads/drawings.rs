//! Leads on every real drawing and on the sheets: plans pass the check, and programs are written and read back.

use crate::testkit::jobs::each_planned;
use crate::testkit::leads::{leads, with_leads};
use crate::testkit::{files, fixtures};
use kerfway::job::OutputKind;
use kerfway::machine::{LeadKind, preset};

#[test]
fn every_drawing_is_planned_with_leads() {
    let mut all = files(&fixtures().join("dxf-dev"), "dxf");
    all.extend(files(&fixtures().join("sheets"), "dxf"));
    let machine = |k: usize| {
        let kind = [LeadKind::Arc, LeadKind::Line, LeadKind::LineArc][k % 3];
        let mut machine =
            with_leads(preset("fibre-3kw-thin").unwrap(), leads(kind, 0.5, [0.0, 0.4, -0.2][k / 3 % 3]));
        machine.kerf_width = [0.0, 0.2][k % 2];
        machine
    };
    let mut with = 0;
    each_planned(&all, machine, |name, job, plan| {
        with += usize::from(plan.summary.lead_length > 0.0);
        if let Err(e) = job.output(OutputKind::Gcode) {
            panic!("{name}: {e}");
        }
    });
    assert!(with > 20, "{with}");
}
