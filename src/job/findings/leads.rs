//! Findings on the leads of a run.

use crate::finding::{Code, Finding, Severity};
use crate::lead;
use crate::machine::Profile;
use crate::problem::{Item, Problem};
use crate::sheet::{Contour, Operation, Sheet};

/// What became of the leads of every contour, and which contours have none because they are cut as one.
pub(super) fn findings(sheet: &Sheet, machine: &Profile, problem: &Problem) -> Vec<Finding> {
    if !sheet.asks_for_leads(machine) {
        return Vec::new();
    }
    let outcomes = (0..).zip(&problem.items).filter_map(|(id, i)| Some((id, &i.leads.as_ref()?.outcome)));
    let mut all = lead::findings(outcomes);
    let groups = sheet.cut_as_one(machine.cuts_as_one()).iter();
    let as_one = groups.filter(|g| {
        g.contours.first().and_then(|&c| problem.items.get(c as usize)).is_some_and(Item::is_pierce_group)
    });
    for group in as_one {
        let count = group.contours.len();
        let item = group.contours.first().and_then(|&c| problem.items.get(c as usize));
        let led = item.is_some_and(|i| i.paths.iter().any(|path| path.lead_in.is_some()));
        let (code, severity, message) = if led {
            let message =
                format!("{count} contours that share cuts have one straight lead-in for all of them.");
            (Code::LeadAdjusted, Severity::Info, message)
        } else {
            let message =
                format!("{count} contours that share cuts have no leads: they are pierced on their outline.");
            (Code::LeadMissing, Severity::Warning, message)
        };
        let finding = Finding::new(code, severity, message);
        let at = group.nodes.first().copied().unwrap_or_default();
        all.push(finding.at(at).times(u32::try_from(count).unwrap_or(u32::MAX)));
    }
    let repeated = |c: &&Contour| {
        c.path.closed
            && c.operation == Operation::Cut
            && c.pass == 0
            && sheet.process_of(c, machine).passes > 1
    };
    let several: Vec<&Contour> = sheet.contours.iter().filter(repeated).collect();
    if let Some(first) = several.first() {
        let message =
            "Contours that are cut in several passes have no leads: they are pierced on their outline.";
        let finding = Finding::new(Code::LeadMissing, Severity::Warning, message);
        let count = u32::try_from(several.len()).unwrap_or(u32::MAX);
        all.push(finding.at(first.path.start().unwrap_or_default()).times(count));
    }
    let crossing = sheet.contours.iter().filter(|c| c.is_processed() && c.path.closed && c.self_crossing);
    for contour in crossing {
        let message = "A contour that crosses itself has no lead, because its scrap side is in doubt.";
        let finding = Finding::new(Code::LeadMissing, Severity::Warning, message);
        all.push(finding.at(contour.path.start().unwrap_or_default()));
    }
    if machine.pre_cut_time.is_some() {
        let message = "With leads, contours are not left unfinished for others: each is cut in one go.";
        all.push(Finding::new(Code::LeadAdjusted, Severity::Info, message));
    }
    all
}
