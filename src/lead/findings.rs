//! Findings on leads: every contour whose lead is not what the rule asks for, with its place.

use super::ladder::{Fit, Outcome};
use crate::finding::{Code, Finding, Findings, Severity};

/// The findings on the leads of some contours.
pub fn findings<'o>(outcomes: impl IntoIterator<Item = (u32, &'o Outcome)>) -> Vec<Finding> {
    let mut all = Findings::default();
    for (contour, outcome) in outcomes {
        if let Some(f) = finding(contour, outcome) {
            all.push(f);
        }
    }
    all.into_list()
}

fn finding(contour: u32, outcome: &Outcome) -> Option<Finding> {
    let [wanted, longest] = outcome.length;
    let what = match (outcome.lead_in, outcome.lead_out) {
        (Fit::Wanted, Fit::Wanted) => return None,
        (Fit::Wanted, Fit::None) => "has no lead-out, because there is no room for one".to_owned(),
        (Fit::Wanted, Fit::Shortened) => "has a shorter lead-out, because the wanted one does not fit".to_owned(),
        (Fit::Wanted, Fit::Line) => "has a line as its lead-out, because the wanted arc does not fit".to_owned(),
        (Fit::Wanted, _) => "has its lead-out turned, because the wanted one does not fit".to_owned(),
        (Fit::Turned, _) => "has its lead-in turned, because the wanted one does not fit".to_owned(),
        (Fit::Moved, _) => {
            "has its lead-in at another position, because the wanted one has no room for it".to_owned()
        }
        (Fit::Shortened, _) => {
            format!("has a lead-in of {longest:.2} mm instead of {wanted:.2} mm, because that does not fit")
        }
        (Fit::Line, _) => {
            format!("has a line of {longest:.2} mm as its lead-in, because the wanted arc does not fit")
        }
        (Fit::None, _) => {
            "has no lead-in: there is no room for one, so it is pierced on its outline. Move the parts apart, or allow \
             shorter leads or less clearance"
                .to_owned()
        }
    };
    let missing = outcome.lead_in == Fit::None;
    let changed = outcome.lead_in >= Fit::Shortened || outcome.lead_out >= Fit::Shortened;
    let severity = if changed { Severity::Warning } else { Severity::Info };
    let code = if missing { Code::LeadMissing } else { Code::LeadAdjusted };
    let name = format!("Contour {contour} {what}.");
    Some(Finding::new(code, severity, name).at(outcome.at))
}
