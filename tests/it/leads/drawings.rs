//! Leads on every real drawing and on the sheets: plans pass the check, and programs are written and read back.

use crate::testkit::leads::{leads, with_leads};
use crate::testkit::{files, fixtures, name};
use kerfway::job::{Job, LoadOptions, MachineChoice, OutputKind, PlanOptions};
use kerfway::machine::{LeadKind, preset};

#[test]
fn every_drawing_is_planned_with_leads() {
    let mut all = files(&fixtures().join("dxf-dev"), "dxf");
    all.extend(files(&fixtures().join("sheets"), "dxf"));
    let mut with = 0;
    for (k, path) in all.iter().enumerate() {
        let Ok(mut job) = Job::load(std::fs::read(path).unwrap(), &name(path), &LoadOptions::default())
        else {
            continue;
        };
        let kind = [LeadKind::Arc, LeadKind::Line, LeadKind::LineArc][k % 3];
        let mut machine =
            with_leads(preset("fibre-3kw-thin").unwrap(), leads(kind, 0.5, [0.0, 0.4, -0.2][k / 3 % 3]));
        machine.kerf_width = [0.0, 0.2][k % 2];
        let options = PlanOptions {
            machine: MachineChoice::Profile(Box::new(machine)),
            moves: Some(2_000),
            allow_off_bed: true,
            ..PlanOptions::default()
        };
        if job.start(&options).is_err() {
            continue;
        }
        job.run_mut().unwrap().step(2_000);
        let plan = job.plan().unwrap_or_else(|e| panic!("{}: {e}", name(path)));
        with += usize::from(plan.summary.lead_length > 0.0);
        let program = job.output(OutputKind::Gcode);
        if let Err(e) = program {
            panic!("{}: {e}", name(path));
        }
    }
    assert!(with > 20, "{with}");
}
