//! What a plan says about pieces that may have tipped.

use crate::finding::{Code, Finding, Severity};
use crate::geometry::DVec2;
use crate::plan::{Move, Plan, Way};

/// The moves with the head down over pieces that may have tipped, as one finding at the first of them. `head`: where the plan
/// begins.
pub(super) fn finding(plan: &Plan, mut head: DVec2) -> Option<Finding> {
    let mut first = None;
    for step in &plan.moves {
        let to = step.end().unwrap_or(head);
        if matches!(step, Move::Air { way: Way::Crosses, .. }) {
            first = first.or(Some((head + to) * 0.5));
        }
        head = to;
    }
    let (place, count) = (first?, plan.summary.crossings);
    let moves = if count == 1 { "1 move crosses".to_owned() } else { format!("{count} moves cross") };
    let message = format!(
        "{moves} a piece that may have tipped up, with the head down. Let the machine avoid them, or hold the pieces with micro-joints."
    );
    Some(Finding::new(Code::RiskyMoves, Severity::Warning, message).at(place))
}
