//! Findings on joints: every contour that has not the joints that are asked for, with its place.

use super::outcome::{Outcome, Refusal};
use super::planner::Planner;
use crate::finding::{Code, Finding, Findings, Severity};
use crate::geometry::DVec2;
use crate::sheet::Sheet;

/// The findings on the joints of a sheet. `outcomes` says how well the joints of contours fit.
pub fn findings<'o>(
    sheet: &Sheet,
    planner: &Planner,
    outcomes: impl IntoIterator<Item = (u32, &'o Outcome)>,
) -> Vec<Finding> {
    let mut all = Findings::default();
    for (contour, outcome) in outcomes {
        of_contour(contour, outcome, &mut all);
    }
    let mut refused: Vec<(Refusal, DVec2, u32)> = Vec::new();
    for (id, contour) in (0..).zip(&sheet.contours) {
        let Some(why) = planner.refused(id) else { continue };
        match refused.iter_mut().find(|r| r.0 == why) {
            Some(known) => known.2 = known.2.saturating_add(1),
            None => refused.push((why, contour.path.start().unwrap_or_default(), 1)),
        }
    }
    for (why, at, count) in refused {
        let message = match why {
            Refusal::Passes => "Contours that are cut in several passes have no micro-joints.",
            Refusal::Group => {
                "Contours that share cuts are planned together and have no micro-joints. Set common cuts to off to have some."
            }
            Refusal::Open => "Contours that are open, or share sides with others, have no micro-joints.",
            Refusal::CrossesItself => "A contour that crosses itself has no micro-joints.",
        };
        all.push(Finding::new(Code::JointMissing, Severity::Warning, message).at(at).times(count));
    }
    all.into_list()
}

fn of_contour(contour: u32, outcome: &Outcome, all: &mut Findings) {
    let Outcome { wanted, found, too_long, moved, left_out, at } = outcome;
    let mut push = |code, severity, message: String, at: DVec2| {
        all.push(Finding::new(code, severity, message).at(at));
    };
    if left_out.is_empty() && found < wanted {
        let message = format!(
            "Contour {contour} has {found} of {wanted} micro-joints: there is no room for more. Allow narrower joints or less distance from corners."
        );
        let code = if *found == 0 { Code::JointMissing } else { Code::JointAdjusted };
        push(code, Severity::Warning, message, *at);
    }
    if let Some([longest, most]) = too_long {
        let message = format!(
            "Contour {contour} has a stretch of {longest:.1} mm without a micro-joint instead of at most {most:.1} mm, because there is no room for one."
        );
        push(Code::JointAdjusted, Severity::Warning, message, *at);
    }
    for (at, by) in moved {
        let message = format!(
            "A micro-joint of contour {contour} was moved by {by:.2} mm, because it was in a corner or too near to another cut."
        );
        push(Code::JointAdjusted, Severity::Info, message, *at);
    }
    for at in left_out {
        let message = format!(
            "A micro-joint of contour {contour} was left out: it is in a corner, at another micro-joint or at another cut. Place it elsewhere."
        );
        push(Code::JointMissing, Severity::Warning, message, *at);
    }
}
