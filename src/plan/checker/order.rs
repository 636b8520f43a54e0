//! Checks the order of contours: inner before outer, by layer, and marks before cuts.

use super::groups::Groups;
use super::nesting;
use super::violation::Violation;
use super::visits::Visits;
use crate::sheet::{Operation, Pin, Sheet};

/// `visits` knows when each contour is cut. Within a pierce group, `groups.rs` follows element by element what is held.
pub(super) fn check(sheet: &Sheet, visits: &Visits, groups: &Groups, found: &mut Vec<Violation>) {
    // By pinning first, then by layer, then by pass, then marks before cuts.
    let own: Vec<(Pin, u32, u32, bool)> = sheet
        .contours
        .iter()
        .map(|c| {
            let layer = sheet.layers.get(c.layer as usize).map_or(0, |l| l.rank);
            (c.pin, layer, c.pass, c.operation == Operation::Cut)
        })
        .collect();
    let mut rank = own.clone();
    for (inner, outer) in nesting::pairs(sheet) {
        let (i, o) = (inner as usize, outer as usize);
        // An outer contour waits for what lies inside it, whatever its layer.
        rank[o] = rank[o].max(own[i]);
        if let (Some(inside), Some(around)) = (visits.ends(inner), visits.ends(outer))
            && around < inside
            && !groups.same(inner, outer)
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
    if sheet.part_by_part {
        part_by_part(sheet, visits, &rank, found);
    }
}

/// Checks that all contours of a part that have the same rank, including those inside its holes, are cut with nothing else
/// of that rank in between.
fn part_by_part<R: Copy + PartialEq>(sheet: &Sheet, visits: &Visits, rank: &[R], found: &mut Vec<Violation>) {
    let mut parts: Vec<Vec<u32>> = vec![Vec::new(); sheet.contours.len()];
    for (part, p) in (0..).zip(&sheet.parts) {
        for contour in p.holes.iter().chain([&p.outer]) {
            let around = |&k: &u32| sheet.parts.get(k as usize).and_then(|p| p.inside);
            parts[*contour as usize] = std::iter::successors(Some(part), around).collect();
        }
    }
    // For each part, the position of its last contour so far among those of its rank.
    let mut last: Vec<Option<(usize, u32)>> = vec![None; sheet.parts.len()];
    for (k, &contour) in visits.order.iter().enumerate() {
        for &part in &parts[contour as usize] {
            let seen = last[part as usize].replace((k, contour));
            if let Some((before, earlier)) = seen
                && before + 1 != k
                && rank[earlier as usize] == rank[contour as usize]
            {
                found.push(Violation::Torn { part, contour });
            }
        }
    }
}
