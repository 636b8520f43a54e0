//! Minimum spanning trees over all items except home: over the known pairs by Kruskal's method, and over all possible pairs by
//! Prim's method, row by row.

use super::net::Item;
use super::pairs::{Pairs, box_seconds};
use super::prices::Prices;
use crate::geometry::Union;
use crate::order::{real, sort_by};

/// The minimum tree over the known pairs without home, or a forest if they do not connect all items.
pub(super) fn over_pairs(pairs: &Pairs, first: usize, cost: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..pairs.list.len()).filter(|&e| pairs.list[e].items[0] >= first).collect();
    sort_by(&mut order, |&e| [real(cost[e]), e as u64, 0]);
    let mut joined = Union::new(pairs.of.len());
    order.retain(|&e| {
        let [a, b] = pairs.list[e].items.map(|i| u32::try_from(i).unwrap_or(u32::MAX));
        joined.join(a, b)
    });
    order
}

/// The two cheapest legs of home, or one of each end of an open path. They go to different items unless there is only one
/// item or `same` allows one item.
pub(super) fn home_legs(pairs: &Pairs, first: usize, cost: &[f64], same: bool) -> Vec<usize> {
    let best = |home: usize, but: Option<usize>| {
        let legs = pairs.of[home].iter().map(|l| l.0).filter(|&e| Some(pairs.list[e].items[1]) != but);
        legs.fold(None, |m: Option<usize>, e| if m.is_none_or(|b| cost[e] < cost[b]) { Some(e) } else { m })
    };
    let other = first - 1;
    let (Some(a), Some(b)) = (best(0, None), best(other, None)) else { return Vec::new() };
    let item = |e: usize| Some(pairs.list[e].items[1]);
    if same || item(a) != item(b) {
        return vec![a, b];
    }
    let choices = [best(other, item(a)).map(|c| [a, c]), best(0, item(b)).map(|c| [c, b])];
    let cheapest = choices.into_iter().flatten().reduce(|x, y| {
        let sum = |l: [usize; 2]| cost[l[0]] + cost[l[1]];
        if sum(y) < sum(x) { y } else { x }
    });
    cheapest.map_or(vec![a, b], |l| l.to_vec())
}

/// Prim's method over all pairs of items except home, row by row. A known pair has its price; any other is priced by the
/// seconds between the boxes of its items and their charges.
#[derive(Clone, Debug)]
pub(super) struct Whole {
    /// Least cost of joining each item to the tree, and the item it would be joined to.
    join: Vec<(f64, usize)>,
    left: Vec<usize>,
    /// The last row in which an item was in a known pair.
    seen: Vec<usize>,
    next: usize,
    /// Cost of the tree so far.
    pub(super) cost: f64,
    /// Legs of the tree that are not known pairs.
    pub(super) missing: Vec<(usize, usize)>,
}

impl Whole {
    pub(super) fn new(first: usize, count: usize) -> Self {
        Self {
            join: vec![(f64::INFINITY, 0); count],
            left: (first + 1..count).collect(),
            seen: vec![0; count],
            next: first,
            cost: 0.0,
            missing: Vec::new(),
        }
    }

    /// Does one row; returns whether it was the last.
    pub(super) fn row(
        &mut self,
        items: &[Item],
        prices: &Prices,
        pairs: &Pairs,
        cost: &[f64],
        pay: &[f64],
    ) -> bool {
        let a = self.next;
        // Known pairs are marked first, because their prices may be above or below those of their boxes.
        for &(e, side) in &pairs.of[a] {
            let b = pairs.list[e].items[1 - side];
            self.seen[b] = a;
            if cost[e] < self.join[b].0 {
                self.join[b] = (cost[e], a);
            }
        }
        let near = items[a].around;
        let mut best: Option<(f64, usize)> = None;
        for (place, &b) in self.left.iter().enumerate() {
            let far = items[b].around;
            let base = pay[a] + pay[b];
            // Most boxes are too far: their seconds are looked at only when the item is not already nearer.
            if base < self.join[b].0 && self.seen[b] != a {
                let seconds = base + box_seconds(prices, near.min, near.max, far.min, far.max);
                if seconds < self.join[b].0 {
                    self.join[b] = (seconds, a | FAR);
                }
            }
            if best.is_none_or(|(c, _)| self.join[b].0 < c) {
                best = Some((self.join[b].0, place));
            }
        }
        let Some((seconds, place)) = best else { return true };
        let b = self.left.swap_remove(place);
        self.cost += seconds;
        if self.join[b].1 & FAR != 0 {
            self.missing.push((self.join[b].1 & !FAR, b));
        }
        self.next = b;
        false
    }
}

/// Marks an item joined by a leg that is not a known pair.
const FAR: usize = 1 << (usize::BITS - 1);
