//! The cut of a contour with joints: its stretches in order, and what stays uncut between them.

use crate::geometry::{Path, Segment};
use crate::lead::Lead;

/// A length of a contour that stays uncut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// Arc length at which it begins, from the contour's start, mm.
    pub from: f64,
    /// Arc length at which it ends, mm: below `from` where it runs across the contour's start.
    pub to: f64,
    /// Its length, mm: the width of the material that holds, and the width of the cut.
    pub length: f64,
}

/// A stretch that is cut in one go. The elements of leads and overcut are counted as in [`crate::lead::Run`].
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Stretch {
    /// Its elements.
    pub path: Vec<Segment>,
    /// Number of elements of the lead-in, which only the first stretch has.
    pub lead_in: usize,
    /// Number of elements of the overcut, which only the last stretch has.
    pub overcut: usize,
    /// Number of elements of the lead-out, which only the last stretch has.
    pub lead_out: usize,
}

impl Stretch {
    /// The elements of the contour itself.
    pub fn on(&self) -> std::ops::Range<usize> {
        self.lead_in..self.path.len().saturating_sub(self.overcut + self.lead_out)
    }
}

/// A contour divided by its joints.
#[derive(Clone, Debug, PartialEq, Default)]
pub struct Divided {
    /// The stretches in order.
    pub stretches: Vec<Stretch>,
    /// The elements of the joint after each stretch but the last.
    pub joints: Vec<Vec<Segment>>,
}

/// A joint this near to an entry is where the contour begins, mm.
const SAME: f64 = 1e-7;

/// The cut of a closed contour that is entered `along` mm from its start. If that is the end of a joint, `lead.overcut` is
/// minus the joint's length, so that the cut ends where the joint begins.
pub fn divided(lead: &Lead, contour: &Path, along: f64, joints: &[Joint]) -> Divided {
    let whole = contour.length();
    let end = whole + lead.overcut.min(0.0);
    // The joints on the way, as seen from the entry.
    let mut ahead: Vec<(f64, &Joint)> = joints
        .iter()
        .map(|j| ((j.from - along).rem_euclid(whole), j))
        .filter(|(d, _)| *d < end - SAME)
        .collect();
    ahead.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut divided = Divided::default();
    let mut from = along;
    for (_, joint) in ahead {
        divided.stretches.push(Stretch { path: contour.between(from, joint.from), ..Stretch::default() });
        divided.joints.push(contour.between(joint.from, joint.to));
        from = joint.to;
    }
    let last = (along + end).rem_euclid(whole);
    let mut path = if divided.stretches.is_empty() && end >= whole {
        contour.starting_at(along).segments
    } else {
        contour.between(from, last)
    };
    let mut overcut = 0;
    if lead.overcut > 0.0 {
        let again = contour.between(along, (along + lead.overcut).rem_euclid(whole));
        overcut = again.len();
        path.extend(again);
    }
    path.extend(&lead.lead_out);
    divided.stretches.push(Stretch { path, lead_in: 0, overcut, lead_out: lead.lead_out.len() });
    if let Some(first) = divided.stretches.first_mut() {
        first.lead_in = lead.lead_in.len();
        first.path.splice(0..0, lead.lead_in.iter().copied());
    }
    divided
}
