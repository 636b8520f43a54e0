//! Where a plan leaves micro-joints: those that the head leaves and goes on behind, and the one at which a contour begins and ends.

use super::joints;
use super::tolerance::SAME;
use crate::geometry::DVec2;
use crate::machine::Profile;
use crate::plan::model::{Move, Plan};
use crate::sheet::Sheet;
use rustc_hash::FxHashMap;

/// By contour: a place on each of its micro-joints.
pub(super) fn joints_left(sheet: &Sheet, machine: &Profile, plan: &Plan) -> FxHashMap<u32, Vec<DVec2>> {
    let mut left: FxHashMap<u32, Vec<DVec2>> = FxHashMap::default();
    // Where each contour that may have joints begins and ends.
    let mut ends: FxHashMap<u32, [DVec2; 2]> = FxHashMap::default();
    for m in &plan.moves {
        match m {
            Move::Joint { contour, path, .. } => {
                let middle = path.get(path.len() / 2).map(|s| s.at(0.5));
                left.entry(*contour).or_default().extend(middle);
            }
            Move::Cut { contour, path, leads, mark: false, .. } => {
                let [_, on, ..] = leads.divide(path);
                if let Some((first, last)) = on.first().zip(on.last())
                    && joints::length(sheet, machine, *contour) > 0.0
                {
                    ends.entry(*contour).or_insert([first.start(), last.end()])[1] = last.end();
                }
            }
            _ => {}
        }
    }
    for (contour, [begins, ends]) in ends.into_iter().filter(|(_, [a, b])| a.distance(*b) > SAME) {
        let Some(path) = sheet.contours.get(contour as usize).map(|c| &c.path) else { continue };
        let along = |p| path.nearest(p).map_or(0.0, |n| n.0);
        let gap = (along(begins) - along(ends)).rem_euclid(path.length());
        left.entry(contour).or_default().extend(path.at((along(ends) + 0.5 * gap) % path.length()));
    }
    left
}
