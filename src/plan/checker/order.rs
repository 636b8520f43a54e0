//! Whether contours are worked in an allowed order: inner before outer, by layer, marks before cuts.

use super::nesting;
use super::violation::Violation;
use crate::order::sort_by;
use crate::sheet::{Operation, Sheet};

/// `visits`: when each contour is worked.
pub(super) fn check(sheet: &Sheet, visits: &[Option<usize>], found: &mut Vec<Violation>) {
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
        if let (Some(inside), Some(around)) = (visits[i], visits[o])
            && around < inside
        {
            found.push(Violation::CutFree { outer, inner });
        }
    }

    let mut worked: Vec<(usize, u32)> =
        (0..).zip(visits).filter_map(|(contour, visit): (u32, _)| Some(((*visit)?, contour))).collect();
    sort_by(&mut worked, |w| [w.0 as u64, w.1.into(), 0]);
    let mut highest: Option<u32> = None;
    for (_, contour) in worked {
        match highest {
            Some(h) if rank[contour as usize] < rank[h as usize] => {
                found.push(Violation::Rank { earlier: h, later: contour });
            }
            _ => highest = Some(contour),
        }
    }
}
