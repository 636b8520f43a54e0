//! Repairs a tour that ignores nesting: each contour around others waits for the last of them.
//!
//! An unconstrained tour that is repaired and then improved ends far lower than a search that stays feasible from the start:
//! `docs/internals/tuning.md`, `FREE_SHARE`.

use super::kept::Kept;
use super::space::Space;

/// The tour `free`, and the tour run backwards, with every outer item delayed until all inside it is done.
pub(super) fn repaired(space: &Space, free: &Kept) -> [Kept; 2] {
    let mut back = free.clone();
    // Ranks keep their order: each is turned round by itself.
    back.order[1..]
        .chunk_by_mut(|&a, &b| space.rank[a as usize] == space.rank[b as usize])
        .for_each(<[u32]>::reverse);
    for item in (0..space.home).filter(|&i| space.two_ends(i)) {
        back.at[item as usize] ^= 1;
    }
    [delayed(space, free), delayed(space, &back)]
}

fn delayed(space: &Space, tour: &Kept) -> Kept {
    let mut waits_for: Vec<usize> = (0..=space.home).map(|i| space.precedence.before(i).len()).collect();
    let mut met = vec![false; tour.at.len()];
    let mut order = Vec::with_capacity(tour.order.len());
    for &item in &tour.order {
        met[item as usize] = true;
        // Done items let those that wait for them follow at once, if they were met and now wait for nothing.
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
    Kept { order, at: tour.at.clone() }
}
