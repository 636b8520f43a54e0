//! What cannot be asked for together, and what this build of Kerfway cannot plan.

use super::JobError;
use crate::fields::{Fault, FieldError};
use crate::machine::{CornerKind, PLANS_ALL_LEVERS, Profile};
use crate::sheet::{CommonCuts, Sheet};

/// Refuses what a machine cannot do for a sheet, or this build of Kerfway cannot plan.
pub(super) fn check(sheet: &Sheet, machine: &Profile) -> Result<(), JobError> {
    if let Some(layer) = sheet.lowers_head(machine).filter(|_| machine.z_speed.is_none()) {
        let message = format!(
            "The passes on layer {layer} lower the head, but the machine {} has no \"z_speed\". Set it, or set the z step to 0.",
            machine.name
        );
        return Err(FieldError::new(Fault::Missing, "machine.z_speed", message).into());
    }
    if let Some((lever, does)) = machine.levers.not_in_this_build() {
        let message = format!(
            "The machine {} {does}, which this build of Kerfway does not plan. Leave out \"levers.{lever}\", or load the whole package.",
            machine.name
        );
        return Err(FieldError::new(Fault::Contradiction, "machine.levers", message).into());
    }
    if !PLANS_ALL_LEVERS && sheet.common_cuts == CommonCuts::Insertion {
        let sentence = "This build of Kerfway has no insertion heuristic. Leave out \"commonCuts\", or load the whole package.";
        return Err(JobError::Conflict { field: "commonCuts", sentence });
    }
    corners(sheet, machine)?;
    bridges(sheet, machine)
}

/// Refuses levers that the published methods do not know.
pub(super) fn published_method(machine: &Profile) -> Result<(), JobError> {
    let sentence = if machine.levers.chains.is_some() {
        "Methods of papers do not join contours through waste. Leave out \"levers.chains\", or choose the method tour-tree."
    } else if machine.levers.common_cuts.is_some() {
        "Methods of papers do not begin again on kerfs. Leave out \"levers.common_cuts\", or choose the method tour-tree."
    } else {
        return Ok(());
    };
    Err(JobError::Conflict { field: "method", sentence })
}

/// Refuses choices for corners on a machine that does not say how they are cut.
fn corners(sheet: &Sheet, machine: &Profile) -> Result<(), FieldError> {
    let asks = sheet.choices.iter().find(|c| c.corners.is_some_and(|kind| kind != CornerKind::Stop));
    match asks.filter(|_| machine.levers.corners.is_none()) {
        None => Ok(()),
        Some(choice) => {
            let message = format!(
                "The corners of contour {} are to be cut without a stop, but the machine {} has no \"levers.corners\". Give it, or leave out the choice.",
                choice.contour, machine.name
            );
            Err(FieldError::new(Fault::Contradiction, "machine.levers", message))
        }
    }
}

/// Refuses what cannot be asked for together with bridges.
fn bridges(sheet: &Sheet, machine: &Profile) -> Result<(), JobError> {
    let Some(bridges) = machine.levers.bridges.filter(|_| PLANS_ALL_LEVERS) else { return Ok(()) };
    if let Some((field, value, range)) = bridges.numbers().into_iter().find(|n| !n.2.holds(n.1)) {
        return Err(FieldError::out_of_range("The machine's field", field, value, &range).into());
    }
    if sheet.part_by_part {
        let sentence = "Parts that bridges connect are finished together. Leave out \"levers.bridges\", or do not cut part by part.";
        return Err(JobError::Conflict { field: "machine.levers", sentence });
    }
    if bridges.cut_later && machine.levers.corners.is_some_and(|corners| corners.outer == CornerKind::Round) {
        let message = "The machine has levers.bridges.cut_later and levers.corners.outer, but rounded corners leave the ends of the strips uncut: give one of them.";
        return Err(FieldError::new(Fault::Contradiction, "machine.levers", message.to_owned()).into());
    }
    let others =
        [("pre_cut_time", machine.pre_cut_time.is_some()), ("levers.fly", machine.levers.fly.is_some())];
    match others.into_iter().find(|other| other.1) {
        None => Ok(()),
        Some((other, _)) => {
            let message = format!(
                "The machine has levers.bridges and {other}. Outlines that bridges connect are cut in one go: give one of them."
            );
            Err(FieldError::new(Fault::Contradiction, "machine.levers", message).into())
        }
    }
}
