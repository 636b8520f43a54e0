//! What a person decided for single contours: the number of micro-joints, the lead, and the corners.

use super::model::{ContourChoice, Sheet};
use crate::machine::{CornerKind, LeadKind, Profile};
use crate::order::sort_by;

/// Least distance of leads from what is not scrap, mm, on a machine that says none: as the rules of the package have it.
const CLEARANCE: f64 = 0.5;

/// The choices in the order of the contours, each contour once; of several choices for it the last one counts.
pub(super) fn by_contour(choices: &[ContourChoice]) -> Vec<ContourChoice> {
    let mut all: Vec<ContourChoice> = choices.iter().rev().copied().collect();
    sort_by(&mut all, |c| [c.contour.into(), 0, 0]);
    all.dedup_by_key(|c| c.contour);
    all
}

impl Sheet {
    fn choice(&self, contour: u32) -> Option<&ContourChoice> {
        let at = self.choices.binary_search_by_key(&contour, |c| c.contour).ok()?;
        self.choices.get(at)
    }

    /// The number of micro-joints that a person asks for on a contour.
    pub(crate) fn chosen_joints(&self, contour: u32) -> Option<u32> {
        self.choice(contour)?.joints
    }

    /// The form of the lead-in that a person asks for on a contour.
    pub(crate) fn chosen_lead(&self, contour: u32) -> Option<LeadKind> {
        self.choice(contour)?.lead
    }

    /// Whether a person asks for loops at corners, or for rounded ones.
    pub(crate) fn asks_for_corners(&self) -> bool {
        self.choices.iter().any(|c| c.corners.is_some_and(|kind| kind != CornerKind::Stop))
    }

    /// What a person asks for at the corners of a contour.
    pub(crate) fn chosen_corners(&self, contour: u32) -> Option<CornerKind> {
        self.choice(contour)?.corners
    }

    /// Whether anything asks for micro-joints: a rule of the machine, or a person.
    pub(crate) fn asks_for_joints(&self, machine: &Profile) -> bool {
        machine.joints.as_ref().is_some_and(|j| !j.rules.is_empty())
            || !self.joints.is_empty()
            || self.choices.iter().any(|c| c.joints.is_some_and(|n| n > 0))
    }

    /// Whether anything asks for leads: a rule of the machine, or a person.
    pub(crate) fn asks_for_leads(&self, machine: &Profile) -> bool {
        machine.leads.as_ref().is_some_and(|l| !l.rules.is_empty())
            || self.choices.iter().any(|c| c.lead.is_some_and(|kind| kind != LeadKind::None))
    }

    /// Least distance of leads from what is not scrap, mm.
    pub(crate) fn lead_clearance(machine: &Profile) -> f64 {
        machine.leads.as_ref().map_or(CLEARANCE, |l| l.clearance)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_choice_for_a_contour_counts() {
        let choice =
            |contour, joints| ContourChoice { contour, joints: Some(joints), lead: None, corners: None };
        let all = by_contour(&[choice(3, 1), choice(1, 2), choice(3, 4)]);
        assert_eq!(all, [choice(1, 2), choice(3, 4)]);
    }
}
