//! Shifts of parts to one kerf from a neighbour: offered in findings, and made if the machine says so.

use crate::finding::{Code, Finding, Severity};
use crate::machine::{PLANS_ALL_LEVERS, Profile};
use crate::sheet::{self, Sheet, SheetOptions, Shift};

/// The sheet with parts moved, if they are, and a finding for each part that is or could be.
pub(super) fn shifted(
    sheet: &Sheet,
    options: &SheetOptions,
    machine: &Profile,
) -> (Option<Sheet>, Vec<Finding>) {
    let lever =
        machine.levers.common_cuts.filter(|l| PLANS_ALL_LEVERS && l.shift > 0.0 && machine.kerf_width > 0.0);
    let Some(lever) = lever else { return (None, Vec::new()) };
    let shifts = sheet::shifts(sheet, machine.kerf_width, lever.shift, options.copy_tolerance);
    let findings = shifts.iter().map(|shift| finding(sheet, shift, lever.shift_parts)).collect();
    let moved = lever.shift_parts && !shifts.is_empty();
    (moved.then(|| sheet.shifted(&shifts)), findings)
}

fn finding(sheet: &Sheet, shift: &Shift, moved: bool) -> Finding {
    let by = format!("({:.3}, {:.3}) mm", shift.by.x, shift.by.y);
    let message = if moved {
        format!("This part is shifted by {by}, so that it stands one kerf from a neighbour.")
    } else {
        format!(
            "Shifted by {by}, this part would stand one kerf from a neighbour. It stays where it is drawn."
        )
    };
    let outer = sheet.contours.get(shift.contour as usize);
    let at = outer.and_then(|c| c.path.start()).unwrap_or_default();
    Finding::new(Code::PartShift, Severity::Info, message).at(at)
}
