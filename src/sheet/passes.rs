//! Several passes over a contour: all at once, or sheet by sheet.
//!
//! Deep cuts are made in several passes. All at once, a contour is run several times before the head goes on. Sheet by
//! sheet, all contours are run once, then all of them again, so that each cools in between. For that, every pass but
//! the last becomes a contour of its own, after all others, with the number of its pass. What falls out falls out in its
//! last pass, which keeps the contour's id: only this pass has to wait for the contours inside it, and the earlier
//! passes have to come before it.

use super::model::{Contour, Sheet};
use crate::machine::{Process, Profile};

impl Sheet {
    /// What a machine works a contour with: the settings of its layer over the process of the machine.
    pub fn process_of(&self, contour: &Contour, machine: &Profile) -> Process {
        let process = machine.process(contour.is_mark());
        self.layers.get(contour.layer as usize).map_or(*process, |layer| layer.settings.over(process))
    }

    /// The process of a contour by its id; that of a cut if there is no such contour.
    pub fn process_by_id(&self, contour: u32, machine: &Profile) -> Process {
        self.contours.get(contour as usize).map_or(machine.cut, |c| self.process_of(c, machine))
    }

    /// Whether a contour is cut in one pass, by its id.
    pub(crate) fn is_cut_once(&self, contour: u32, machine: &Profile) -> bool {
        self.process_by_id(contour, machine).passes == 1
    }

    /// How often a contour is run before the head goes on.
    pub fn passes_at_once(&self, contour: &Contour, machine: &Profile) -> u32 {
        if self.pass_order.is_by_contour() { self.process_of(contour, machine).passes } else { 1 }
    }

    /// The layer that lowers the head, if one does and has contours.
    pub fn lowers_head(&self, machine: &Profile) -> Option<&str> {
        self.layer_with(machine, |process| process.passes > 1 && process.z_step > 0.0)
    }

    /// The layer of the first contour whose process is such.
    pub fn layer_with(&self, machine: &Profile, is_such: impl Fn(&Process) -> bool) -> Option<&str> {
        self.contour_with(machine, is_such).map(|id| self.layer_name(id))
    }

    /// The first contour whose process is such.
    pub fn contour_with(&self, machine: &Profile, is_such: impl Fn(&Process) -> bool) -> Option<u32> {
        let found = |c: &Contour| c.is_processed() && is_such(&self.process_of(c, machine));
        (0..).zip(&self.contours).find(|(_, c)| found(c)).map(|(id, _)| id)
    }

    /// The sheet with every pass as a contour of its own, if passes are run sheet by sheet and there are several.
    pub(crate) fn sheet_by_sheet(&self, machine: &Profile) -> Option<Self> {
        let passes = |c: &Contour| self.process_of(c, machine).passes;
        let several = |c: &Contour| c.is_processed() && passes(c) > 1;
        if self.pass_order.is_by_contour() || !self.contours.iter().any(several) {
            return None;
        }
        let mut sheet = self.clone();
        for (id, contour) in (0..).zip(&self.contours).filter(|(_, c)| several(c)) {
            let last = passes(contour) - 1;
            let mut next: u32 = id;
            // From the last but one to the first, so that each knows the one after it.
            for pass in (0..last).rev() {
                let Ok(new) = u32::try_from(sheet.contours.len()) else { break };
                sheet.contours.push(Contour {
                    pass,
                    next_pass: Some(next),
                    inside: Some(next),
                    ..contour.clone()
                });
                next = new;
            }
            if let Some(contour) = sheet.contours.get_mut(id as usize) {
                contour.pass = last;
            }
        }
        Some(sheet)
    }
}
