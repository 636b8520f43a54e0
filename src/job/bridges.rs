//! Bridges between parts, and what is reported of them.

use super::JobError;
use crate::fields::{Fault, FieldError};
use crate::finding::{Code, Finding, Severity};
use crate::machine::{CornerKind, PLANS_ALL_LEVERS, Profile};
use crate::sheet::{Sheet, plural};

/// Refuses what cannot be asked for together with bridges.
pub(super) fn check(sheet: &Sheet, machine: &Profile) -> Result<(), JobError> {
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

/// The sheet with the bridges that the machine asks for; `None` if there are none. A finding says how many.
pub(super) fn bridged(sheet: &Sheet, machine: &Profile, findings: &mut Vec<Finding>) -> Option<Sheet> {
    machine.levers.bridges.filter(|_| PLANS_ALL_LEVERS)?;
    let bridged = sheet.with_bridges(machine);
    let all = bridged.as_ref().map_or(&[][..], |sheet| &sheet.bridged);
    let (strips, parts) = all.iter().fold((0, 0), |(s, p), b| (s + b.strips.len(), p + b.outlines.len()));
    let lies = machine.levers.tips.is_some() && machine.levers.bridges.is_some_and(|b| b.cut_later);
    let message = if all.is_empty() && lies {
        "No bridge saves time and leads to a part that stays on the slats by itself. What drops or tips cannot be cut through later: leave out \"levers.bridges.cut_later\", and a person separates the parts.".to_owned()
    } else if all.is_empty() {
        "No bridge saves time: no two parts face each other within reach with room for one, or piercing takes less than its sides.".to_owned()
    } else {
        let (bridges, pieces) = (plural(strips, "bridge", "bridges"), plural(all.len(), "piece", "pieces"));
        let who = if machine.levers.bridges.is_some_and(|b| b.cut_later) {
            "which the machine separates later"
        } else {
            "which a person separates"
        };
        format!("{parts} parts are connected by {bridges} to {pieces}, {who}.")
    };
    let finding = Finding::new(Code::Bridges, Severity::Info, message);
    let at = all.first().and_then(|b| b.strips.first()).map(|s| s.sides[0][0]);
    findings.push(match at {
        Some(at) => finding.at(at).times(u32::try_from(strips).unwrap_or(u32::MAX)),
        None => finding,
    });
    bridged
}
