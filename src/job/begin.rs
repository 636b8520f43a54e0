//! The start of a run: the sheet of the beam, and the findings on the machine.

use super::{Job, JobError, Placed, PlanOptions, Run, bridges, shift};
use crate::fields::{Fault, FieldError};
use crate::finding::{Code, Finding, Severity};
use crate::machine::{PLANS_ALL_LEVERS, Process, Profile};
use crate::sheet;

impl Job {
    /// Makes the sheet of the beam, and the first plan on it.
    pub(super) fn begin(&mut self, placed: Placed, options: &PlanOptions) -> Result<Run, JobError> {
        let mut findings = self.compensate(&placed.profile);
        if PLANS_ALL_LEVERS {
            let divided = self.beam_sheet().with_bridge_cuts(&placed.profile);
            self.beam_sheet = divided.or(self.beam_sheet.take());
        }
        let skeleton = self.beam_sheet().with_skeleton(&placed.seen_from_drawing()).map_err(|fault| {
            let message = format!("Skeleton cuts are not possible: {fault}.");
            FieldError::new(Fault::Contradiction, "machine.skeleton", message)
        })?;
        self.beam_sheet = skeleton.or(self.beam_sheet.take());
        self.beam_sheet = self.beam_sheet().sheet_by_sheet(&placed.profile).or(self.beam_sheet.take());
        findings.extend(placed.finding(&self.beam_sheet().bounds));
        findings.extend(self.too_fast(&placed.profile));
        let least = self.sheet.layer_with(&placed.profile, |process| process.min_power.is_some());
        findings.extend(least.map(|layer| {
            Finding::new(Code::LeastPowerLeftOut, Severity::Info, format!(
                "Layer {layer} has a least power, for which G-code has no word: only LightBurn projects and Ruida files carry it."
            ))
        }));
        let mut run = Run::start(self.beam_sheet(), placed, options)?;
        findings.append(&mut run.findings);
        run.findings = findings;
        Ok(run)
    }

    /// Moves parts and connects them by bridges if the machine says so, offsets the cuts by half the kerf, and returns the findings.
    fn compensate(&mut self, machine: &Profile) -> Vec<Finding> {
        let kerf = machine.kerf_width;
        let (moved, mut findings) = shift::shifted(&self.sheet, &self.sheet_options, machine);
        let bridged = bridges::bridged(moved.as_ref().unwrap_or(&self.sheet), machine, &mut findings);
        if kerf <= 0.0 {
            self.beam_sheet = bridged;
            return findings;
        }
        let drawn = bridged.as_ref().or(moved.as_ref()).unwrap_or(&self.sheet);
        let (sheet, found) = sheet::compensated(&self.drawing, drawn, &self.sheet_options, kerf);
        self.beam_sheet = Some(sheet);
        findings.extend(found);
        findings
    }

    /// A layer that is worked faster than the machine moves.
    fn too_fast(&self, machine: &Profile) -> Option<Finding> {
        let most = machine.top_speed();
        let is_too_fast = |process: &Process| process.speed > most;
        let contour = self.sheet.contour_with(machine, is_too_fast)?;
        let message = format!(
            "Layer {} is worked at {} mm/s, but the machine moves with at most {most} mm/s: it takes longer than planned, and is not written as G-code. Lower the speed of the layer, or raise the rapids of the machine.",
            self.sheet.layer_name(contour),
            self.sheet.process_by_id(contour, machine).speed
        );
        Some(Finding::new(Code::LayerTooFast, Severity::Warning, message))
    }
}
