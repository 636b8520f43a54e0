//! Cuts through bridges begin on the kerf of the cut around the connected parts, which comes before them.

use super::model::Item;
use crate::machine::Profile;
use crate::sheet::{Contour, Sheet};

/// Whether a cut begins on a kerf that is there by then, whatever the order, so that nothing is pierced for it. Where the cut around the
/// parts leaves gaps or micro-joints, cuts through bridges are pierced. `items`: those of the contours up to this one.
pub(crate) fn begins_on_kerf(sheet: &Sheet, machine: &Profile, items: &[Item], contour: &Contour) -> bool {
    let around = contour.completes().and_then(|outline| sheet.contours.get(outline as usize)?.bridged);
    let Some(item) = around.and_then(|id| items.get(id as usize)) else { return false };
    let no_gaps = machine.leads.as_ref().is_none_or(|l| l.rules.iter().all(|r| r.overcut >= 0.0));
    let held = item.joints.as_ref().is_some_and(|j| !j.joints.is_empty());
    no_gaps && !held
}
