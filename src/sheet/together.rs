//! Contours that a person keeps together. A contour is in the group of the innermost contour around it that is listed.
//!
//! Nothing outside a group comes between its contours, and nothing in it waits for anything outside: a search that has begun
//! a group can always finish it. Groups and sequences for which that does not hold are refused.

use super::model::{Contour, Sheet};
use crate::order::sort_by;

/// Gives each listed contour, and what lies inside it, the number of its group.
pub(super) fn assign(contours: &mut [Contour], groups: &[Vec<u32>]) {
    if groups.is_empty() {
        return;
    }
    for (group, listed) in (0..).zip(groups) {
        for &id in listed {
            if let Some(contour) = contours.get_mut(id as usize) {
                contour.together = Some(group);
            }
        }
    }
    let mut inwards: Vec<usize> = (0..contours.len()).collect();
    sort_by(&mut inwards, |&c| [contours[c].depth.into(), 0, 0]);
    for c in inwards {
        let around = contours[c].inside.and_then(|o| contours.get(o as usize)).and_then(|o| o.together);
        contours[c].together = contours[c].together.or(around);
    }
}

impl Sheet {
    /// Number of the groups that are kept together.
    pub(crate) fn groups_together(&self) -> u32 {
        self.contours.iter().filter_map(|c| c.together).max().map_or(0, |last| last + 1)
    }

    /// Whether some contours are kept together, as parts or as groups of a person. Nothing is left unfinished then.
    pub(crate) fn keeps_together(&self) -> bool {
        self.part_by_part || self.contours.iter().any(|c| c.together.is_some())
    }

    /// Why a group cannot be kept together, as the end of a sentence; `None` if all can.
    pub(crate) fn torn_group(&self) -> Option<String> {
        if self.contours.iter().all(|c| c.together.is_none()) {
            return None;
        }
        for (id, contour) in (0..).zip(&self.contours) {
            let Some(group) = contour.together else { continue };
            let Some(outer) = contour.inside.filter(|&o| o != id) else { continue };
            let around = self.contours.get(outer as usize).and_then(|o| o.together);
            if around.is_some_and(|g| g != group) {
                return Some(format!("contour {id} lies inside contour {outer}, which is in another group"));
            }
            if self.part_by_part && around.is_none() {
                return Some(format!(
                    "part by part, contour {id} is cut with contour {outer}, which is not in its group"
                ));
            }
        }
        // In each sequence, the group of the first contour that has its turn in it.
        let mut of_list: Vec<Option<(u32, Option<u32>)>> = Vec::new();
        for (id, contour) in (0..).zip(&self.contours).filter(|(_, c)| c.is_processed()) {
            for list in self.sequences_of(id) {
                let list = list as usize;
                if of_list.len() <= list {
                    of_list.resize(list + 1, None);
                }
                let known = of_list.get_mut(list)?;
                let (other, group) = *known.get_or_insert((id, contour.together));
                if group != contour.together {
                    return Some(format!(
                        "contours {other} and {id} are in one sequence, but not in the same group"
                    ));
                }
            }
        }
        None
    }
}
