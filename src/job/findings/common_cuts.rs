//! Findings on common cuts: what is saved by cutting a pierce group as one, and which are too large for the heuristic of a paper.

use crate::finding::{Code, Finding, Severity};
use crate::machine::PLANS_ALL_LEVERS;
use crate::number::fixed;
use crate::problem::{Item, Problem};
use crate::sheet::{CommonCuts, PierceGroup, Sheet};
use crate::solve::pierce_group::MOST_BY_INSERTION;

/// One finding for each pierce group that is cut as one, and one for each that the insertion heuristic is not used for.
pub(super) fn findings(sheet: &Sheet, problem: &Problem) -> Vec<Finding> {
    let joined = |g: &&PierceGroup| {
        let first = g.contours.first().and_then(|&c| problem.items.get(c as usize));
        first.is_some_and(Item::is_pierce_group)
    };
    let by_insertion = PLANS_ALL_LEVERS && sheet.common_cuts == CommonCuts::Insertion;
    let mut found = Vec::new();
    for group in sheet.pierce_groups().iter().filter(joined) {
        found.push(saved(group));
        if by_insertion && group.elements.len() > MOST_BY_INSERTION {
            found.push(too_large(group));
        }
    }
    found
}

fn too_large(group: &PierceGroup) -> Finding {
    let message = format!(
        "The insertion heuristic takes at most {MOST_BY_INSERTION} cuts between the corners of contours that share cuts, and these have {}: their path is the best that the search finds.",
        group.elements.len()
    );
    let finding = Finding::new(Code::CommonCut, Severity::Warning, message);
    finding.at(group.nodes.first().copied().unwrap_or_default())
}

fn saved(group: &PierceGroup) -> Finding {
    let shared: f64 = group.between_parts().map(|e| group.path(e).length()).sum();
    let contours = group.contours.len();
    let message = format!(
        "{contours} contours share cuts and are cut as one, with 1 piercing instead of {contours}: {} m are cut once instead of twice.",
        fixed(shared / 1000.0, 3),
    );
    let finding = Finding::new(Code::CommonCut, Severity::Info, message);
    let count = u32::try_from(contours).unwrap_or(u32::MAX);
    finding.at(group.nodes.first().copied().unwrap_or_default()).times(count)
}
