//! Whether contours are worked in an allowed order: inner before outer, by layer, marks before cuts.

use super::nesting;
use super::violation::Violation;
use super::visits::Visits;
use crate::sheet::{Operation, Sheet};

/// `visits`: when each contour is worked.
pub(super) fn check(sheet: &Sheet, visits: &Visits, found: &mut Vec<Violation>) {
    // By layer first, then marks before cuts.
    let own: Vec<(u32, bool)> = sheet
        .contours
        .iter()
        .map(|c| {
            let layer = sheet.layers.get(c.layer as usize).map_or(0, |l| l.rank);
            (layer, c.operation == Operation::Cut)
        })
        .collect();
    let mut rank = own.clone();
    for (inner, outer) in nesting::pairs(sheet) {
        let (i, o) = (inner as usize, outer as usize);
        // An outer contour waits for what is inside it, whatever its layer.
        rank[o] = rank[o].max(own[i]);
        if let (Some(inside), Some(around)) = (visits.ends(inner), visits.ends(outer))
            && around < inside
        {
            found.push(Violation::CutFree { outer, inner });
        }
    }

    let mut highest: Option<u32> = None;
    for &contour in &visits.order {
        match highest {
            Some(h) if rank[contour as usize] < rank[h as usize] => {
                found.push(Violation::Rank { earlier: h, later: contour });
            }
            _ => highest = Some(contour),
        }
    }
}
