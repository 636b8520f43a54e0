//! The near items of each item, by the distance of their nearest nodes.

use super::super::legs::Legs;
use super::super::unvisited::Unvisited;
use crate::problem::ItemId;

/// Number of near items of an item. Ten are enough for 2-opt on uniform instances (Johnson & McGeoch 1997, section 3.3).
const NEIGHBOURS: usize = 10;

/// The near items of each item, the nearest first. The lists are filled item by item.
#[derive(Default)]
pub(in super::super) struct NearItems {
    of: Vec<Vec<(f64, ItemId)>>,
}

impl NearItems {
    /// The near items of an item, each with the shortest leg between any of their nodes.
    pub(in super::super) fn of(&self, item: ItemId) -> &[(f64, ItemId)] {
        self.of.get(item as usize).map_or(&[], Vec::as_slice)
    }

    /// Finds the near items of the next item. Returns the number of legs priced, or `None` when all lists are filled. `all`
    /// contains all nodes.
    pub(in super::super) fn piece(&mut self, legs: &Legs, all: &Unvisited) -> Option<u64> {
        let problem = legs.problem();
        let item = ItemId::try_from(self.of.len()).ok()?;
        let nodes = problem.items.get(item as usize)?.nodes.clone();
        let mut found = NearestItems::default();
        let mut priced = 1;
        for from in nodes {
            match all {
                Unvisited::List(others) => {
                    for &to in others {
                        let cost = legs.leg(from, to).min(legs.leg(to, from));
                        found.offer(item, cost, problem.nodes[to as usize].item);
                    }
                    priced += others.len() as u64;
                }
                Unvisited::Grid(grid) => {
                    let head = problem.nodes[from as usize].exit;
                    for r in 0..grid.rings(head) {
                        if found.is_full_below(legs.lower_bound(grid.distance_of_ring(r))) {
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

/// The nearest items so far, in ascending order of their distance.
#[derive(Default)]
struct NearestItems(Vec<(f64, ItemId)>);

impl NearestItems {
    fn is_full_below(&self, cost: f64) -> bool {
        self.0.len() == NEIGHBOURS && self.0[NEIGHBOURS - 1].0 < cost
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
        self.0.truncate(NEIGHBOURS);
    }
}
