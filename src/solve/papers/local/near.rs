//! Which items are near to which: by their nearest nodes.

use super::super::left::Left;
use super::super::legs::Legs;
use crate::problem::ItemId;

/// Near ones of an item: 10 are what 2-opt needs on even distributions (Johnson & McGeoch 1997, section 3.3).
const MOST: usize = 10;

/// The near items of each item, the nearest first; filled item by item.
#[derive(Default)]
pub(in super::super) struct Near {
    of: Vec<Vec<(f64, ItemId)>>,
}

impl Near {
    /// The near ones of an item, with the shortest way between any of their nodes.
    pub(in super::super) fn of(&self, item: ItemId) -> &[(f64, ItemId)] {
        self.of.get(item as usize).map_or(&[], Vec::as_slice)
    }

    /// Looks for those of the next item; how many nodes were priced, or nothing when all are found. `all` holds all nodes.
    pub(in super::super) fn piece(&mut self, legs: &Legs, all: &Left) -> Option<u64> {
        let problem = legs.problem();
        let item = ItemId::try_from(self.of.len()).ok()?;
        let nodes = problem.items.get(item as usize)?.nodes.clone();
        let mut found = Found::default();
        let mut priced = 1;
        for from in nodes {
            match all {
                Left::List(others) => {
                    for &to in others {
                        let cost = legs.leg(from, to).min(legs.leg(to, from));
                        found.offer(item, cost, problem.nodes[to as usize].item);
                    }
                    priced += others.len() as u64;
                }
                Left::Grid(grid) => {
                    let head = problem.nodes[from as usize].exit;
                    for r in 0..grid.rings(head) {
                        if found.is_full_below(legs.at_least(grid.distance_of_ring(r))) {
                            break;
                        }
                        for to in grid.ring(head, r) {
                            priced += 1;
                            found.offer(item, legs.leg(from, to), problem.nodes[to as usize].item);
                        }
                    }
                }
            }
        }
        self.of.push(found.0);
        Some(priced)
    }
}

/// The nearest so far, in order.
#[derive(Default)]
struct Found(Vec<(f64, ItemId)>);

impl Found {
    fn is_full_below(&self, cost: f64) -> bool {
        self.0.len() == MOST && self.0[MOST - 1].0 < cost
    }

    fn offer(&mut self, item: ItemId, cost: f64, other: ItemId) {
        if other == item || self.is_full_below(cost) {
            return;
        }
        match self.0.iter().position(|f| f.1 == other) {
            Some(known) if self.0[known].0 <= cost => return,
            Some(known) => drop(self.0.remove(known)),
            None => {}
        }
        let place = self.0.partition_point(|f| (f.0, f.1) < (cost, other));
        self.0.insert(place, (cost, other));
        self.0.truncate(MOST);
    }
}
