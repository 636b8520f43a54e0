//! Findings on common cuts: what is saved by cutting a pierce group as one.

use crate::finding::{Code, Finding, Severity};
use crate::number::fixed;
use crate::problem::{Item, Problem};
use crate::sheet::{PierceGroup, Sheet};

/// One finding for each pierce group that is cut as one.
pub(super) fn findings(sheet: &Sheet, problem: &Problem) -> Vec<Finding> {
    let joined = |g: &&PierceGroup| {
        let first = g.contours.first().and_then(|&c| problem.items.get(c as usize));
        first.is_some_and(Item::is_pierce_group)
    };
    sheet.pierce_groups().iter().filter(joined).map(finding).collect()
}

fn finding(group: &PierceGroup) -> Finding {
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
