//! Which rule for leads a contour has, for the checks of leads and of joints.

use crate::machine::{LeadKind, LeadRule, LeadSide, Profile};
use crate::sheet::{Contour, Operation, Sheet};

/// The rule of a contour that may have leads. Where a person chose its lead and no rule fits it, the first rule gives its sizes.
pub(super) fn rule(sheet: &Sheet, machine: &Profile, id: u32, contour: &Contour) -> Option<Option<LeadRule>> {
    let once = sheet.process_of(contour, machine).passes == 1;
    let may = once && contour.path.closed && contour.operation == Operation::Cut && !contour.self_crossing;
    let side = if contour.depth % 2 == 1 { LeadSide::Hole } else { LeadSide::Outer };
    let size = contour.path.bounds().size();
    let fitting = || machine.leads.as_ref()?.rule(side, size.x.max(size.y), contour.path.length()).cloned();
    let first = || machine.leads.as_ref()?.rules.first().cloned();
    let chosen = sheet.chosen_lead(id).is_some();
    let rule =
        || if chosen { fitting().or_else(first).or_else(|| Some(LeadRule::default())) } else { fitting() };
    may.then(rule)
}

/// Whether a rule or a person asks for a lead-in of a part or hole, of which only a rest may be left to be cut.
pub(super) fn asked_of_outline(sheet: &Sheet, machine: &Profile, id: u32, contour: &Contour) -> bool {
    let Some(outline) = contour.boundary() else { return false };
    let side = if contour.depth % 2 == 1 { LeadSide::Hole } else { LeadSide::Outer };
    let size = outline.bounds().size();
    let rule = machine.leads.as_ref().and_then(|l| l.rule(side, size.x.max(size.y), outline.length()));
    sheet
        .chosen_lead(id)
        .map_or_else(|| rule.is_some_and(|r| r.lead_in.kind != LeadKind::None), |kind| kind != LeadKind::None)
}

/// Whether a rule or a person asks for the lead of a contour.
pub(super) fn asked(sheet: &Sheet, machine: &Profile, id: u32, contour: &Contour) -> bool {
    sheet.chosen_lead(id).is_some() || rule(sheet, machine, id, contour).flatten().is_some()
}
