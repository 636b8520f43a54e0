//! Bridges between parts, and what is reported of them.

use crate::finding::{Code, Finding, Severity};
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::sheet::{Sheet, plural};

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
