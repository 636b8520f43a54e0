//! What a plan says about corners that are to be cut in loops or rounded.

use crate::finding::{Code, Finding, Findings, Severity};
use crate::machine::{CornerKind, PLANS_ALL_LEVERS, Profile};
use crate::problem::Problem;

/// Every corner that has no room for a loop or an arc, with its place.
pub(super) fn findings(machine: &Profile, problem: &Problem) -> Vec<Finding> {
    let Some(lever) = machine.levers.corners.filter(|_| PLANS_ALL_LEVERS) else { return Vec::new() };
    let mut all = Findings::default();
    for (contour, leads) in (0_u32..).zip(&problem.items).filter_map(|(id, i)| Some((id, i.leads.as_ref()?)))
    {
        for &(kind, at) in &leads.corners.without_room {
            let message = if kind == CornerKind::Loop {
                format!(
                    "The beam turns in a corner of contour {contour}: there is no room for a loop of {} mm. Allow a smaller one or less clearance.",
                    lever.loop_radius
                )
            } else {
                format!(
                    "The beam turns in a corner of contour {contour}: only corners between straight sides are rounded."
                )
            };
            all.push(Finding::new(Code::CornerStopped, Severity::Info, message).at(at));
        }
    }
    all.into_list()
}
