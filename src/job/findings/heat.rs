//! What a plan says about cuts that heat each other.

use crate::finding::{Code, Finding, Severity};
use crate::machine::Profile;
use crate::plan::Plan;

/// How many pairs of cuts follow each other too soon.
pub(super) fn finding(plan: &Plan, machine: &Profile) -> Option<Finding> {
    let (heat, count) = (machine.levers.heat?, plan.summary.hot_pairs);
    if count == 0 {
        return None;
    }
    let pairs = if count == 1 { "1 pair of cuts".to_owned() } else { format!("{count} pairs of cuts") };
    let message = format!(
        "{pairs} nearer to each other than {} mm follow each other within {} s. Raise the charge, or let the machine wait.",
        heat.distance, heat.seconds
    );
    Some(Finding::new(Code::HotPairs, Severity::Warning, message).times(count))
}
