//! What a round prepares for the next: what walks must remember, and which pieces of contours are halved.

use super::super::net::Item;
use super::super::walks::{Ground, Visit};
use super::Strong;
use crate::geometry::DVec2;
use crate::order::sort_by;

/// Largest company of an item: its states may double with each member.
const MOST_COMPANY: usize = 16;
/// Most stops of a cycle or precedence fault that is removed: every item on it must remember more.
const LONGEST: usize = 12;

impl Strong {
    /// Excludes the shortest faults of the walks, which are cycles and stops out of order: the items between the two stops
    /// will remember both. A round adds no more members than there are items, because each may double the states of one.
    pub(super) fn remember(&mut self) -> bool {
        let order = &self.ground.order;
        let mut faults: Vec<[usize; 3]> = Vec::new();
        for (w, walk) in self.walks.iter().enumerate() {
            for (i, v) in walk.iter().enumerate() {
                let wrong = |other: &Visit| other.item == v.item || order.forbids(v.item, other.item, false);
                let length = walk[i + 1..].iter().take(LONGEST).position(wrong);
                faults.extend(length.map(|length| [length, w, i]));
            }
        }
        sort_by(&mut faults, |c| c.map(|x| x as u64));
        let mut added = 0;
        for [length, w, i] in faults {
            let (walk, last) = (&self.walks[w], i + 1 + length);
            for between in &walk[i + 1..last] {
                for fault in [walk[i].item, walk[last].item] {
                    let company = &mut self.ground.company[between.item];
                    if company.len() < MOST_COMPANY && between.item != fault && !company.contains(&fault) {
                        company.push(fault);
                        added += 1;
                    }
                }
            }
            if added >= self.ground.count() {
                break;
            }
        }
        added > 0
    }

    /// Halves the pieces at knots whose legs in the walks are priced below their real cost.
    pub(super) fn refine(&mut self, upper: f64) -> bool {
        let ground = &self.ground;
        if !ground.items.iter().any(Item::can_halve) {
            return false;
        }
        // The loss of a leg that does not matter.
        let little = 0.1 * (upper - self.best).max(0.0) / ground.count() as f64;
        let mut marks: Vec<Vec<bool>> = ground.items.iter().map(|i| vec![false; i.pieces.len()]).collect();
        let mut any = false;
        let home = Visit { item: 0, knot: 0 };
        for walk in &self.walks {
            let mut last = home;
            for &v in walk.iter().chain(ground.first.eq(&1).then_some(&home)) {
                let (a, b) = (&ground.items[last.item], &ground.items[v.item]);
                let left = if a.paired { last.knot ^ 1 } else { last.knot };
                if lost(ground, last.item, left, v) > little {
                    for (item, knot, i) in [(a, left, last.item), (b, v.knot, v.item)] {
                        for (mark, piece) in marks[i].iter_mut().zip(&item.pieces) {
                            if item.can_halve() && piece.knots.contains(&knot) {
                                *mark = true;
                                any = true;
                            }
                        }
                    }
                }
                last = v;
            }
        }
        if any {
            for (item, marked) in self.ground.items.iter_mut().zip(&marks) {
                if marked.contains(&true)
                    && let Some(finer) = item.halved(marked)
                {
                    *item = finer;
                }
            }
        }
        any
    }
}

/// How far a leg between two knots is priced below its real cost, s.
fn lost(ground: &Ground, item: usize, knot: usize, to: Visit) -> f64 {
    let pair =
        ground.pairs.of[item].iter().find(|&&(e, side)| ground.pairs.list[e].items[1 - side] == to.item);
    let Some(&(e, side)) = pair else { return 0.0 };
    let (a, b) = (&ground.items[item], &ground.items[to.item]);
    let table = ground.pairs.table(&ground.pairs.list[e], a.knots * b.knots);
    let seconds = if side == 0 { table[knot * b.knots + to.knot] } else { table[to.knot * a.knots + knot] };
    ground.prices.minorant.air().seconds(place(a, knot), place(b, to.knot)) - seconds
}

fn place(item: &Item, knot: usize) -> DVec2 {
    let piece = item.pieces.iter().find(|p| p.knots[0] == knot);
    piece.map_or(DVec2::ZERO, |p| p.ends[0])
}
