//! Repairs a tour that ignores nesting: each outer contour waits for the last contour inside it.
//!
//! An unconstrained tour that is repaired and then improved ends far lower than a search that is feasible from the start,
//! see `docs/internals/tuning.md`, `cycle.free_percent`.

use super::snapshot::TourSnapshot;
use super::space::Space;

/// A tour and its reverse, each repaired.
pub(super) fn repaired(space: &Space, free: &TourSnapshot) -> [TourSnapshot; 2] {
    let mut back = free.clone();
    // Ranks keep their order: each is reversed by itself.
    back.order[1..]
        .chunk_by_mut(|&a, &b| space.rank[a as usize] == space.rank[b as usize])
        .for_each(<[u32]>::reverse);
    for item in (0..space.home).filter(|&i| space.two_ends(i)) {
        back.at[item as usize] ^= 1;
    }
    [delayed(space, free), delayed(space, &back)]
}

/// A tour in which every item is delayed until all that must come before it is done.
pub(super) fn delayed(space: &Space, tour: &TourSnapshot) -> TourSnapshot {
    let mut waits_for: Vec<usize> = (0..=space.home).map(|i| space.precedence.before(i).len()).collect();
    let mut met = vec![false; tour.at.len()];
    let mut order = Vec::with_capacity(tour.order.len());
    for &item in &tour.order {
        met[item as usize] = true;
        // An item that is done releases the items that were met before and waited for it alone.
        let mut next = vec![item];
        while let Some(done) = next.pop().filter(|&i| waits_for[i as usize] == 0) {
            order.push(done);
            for &after in space.precedence.after(done) {
                waits_for[after as usize] -= 1;
                if met[after as usize] && waits_for[after as usize] == 0 {
                    next.push(after);
                }
            }
        }
    }
    TourSnapshot { order, at: tour.at.clone() }
}
