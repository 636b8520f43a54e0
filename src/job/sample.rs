//! A small program for trying a machine or a dialect: a square with a round hole.

use super::{Job, JobError, LoadOptions, MachineChoice, OutputKind, PlanOptions};
use crate::output::WorkOrder;

/// A square with a side of 40 mm and a hole with a diameter of 10 mm, in mm.
const DRAWING: &str = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n\
    0\nLWPOLYLINE\n8\nCUT\n90\n4\n70\n1\n10\n10\n20\n10\n10\n50\n20\n10\n10\n50\n20\n50\n10\n10\n20\n50\n\
    0\nCIRCLE\n8\nCUT\n10\n30\n20\n30\n40\n5\n0\nENDSEC\n0\nEOF\n";

/// The work order of the sample on a machine: its G-code shows what the dialect looks like.
pub fn sample_order(machine: MachineChoice) -> Result<WorkOrder, JobError> {
    let mut job = Job::load(DRAWING.into(), "sample.dxf", &LoadOptions::default())?;
    job.start(&PlanOptions { machine, moves: Some(100), seed: 1, ..PlanOptions::default() })?;
    job.run_mut()?.step(100);
    job.work_order(OutputKind::Gcode)
}
