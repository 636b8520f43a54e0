//! The near items of each item, by the distance of their nearest nodes.

use super::super::legs::Legs;
use super::super::unvisited::Unvisited;
use crate::problem::ItemId;

/// The near items of each item, the nearest first. The lists are filled item by item.
pub(in super::super) struct NearItems {
    of: Vec<Vec<(f64, ItemId)>>,
    /// Largest number of near items of an item.
    most: usize,
}

impl NearItems {
    /// Empty lists with room for at most this number of near items.
    pub(in super::super) fn new(most: u32) -> Self {
        Self { of: Vec::new(), most: most.max(1) as usize }
    }

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
        let mut found = NearestItems { most: self.most, found: Vec::new() };
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
        self.of.push(found.found);
        Some(priced)
    }
}

/// The nearest items so far, in ascending order of their distance.
struct NearestItems {
    most: usize,
    found: Vec<(f64, ItemId)>,
}

impl NearestItems {
    fn is_full_below(&self, cost: f64) -> bool {
        self.found.len() == self.most && self.found[self.most - 1].0 < cost
    }

    fn offer(&mut self, item: ItemId, cost: f64, other: ItemId) {
        if other == item || self.is_full_below(cost) {
            return;
        }
        match self.found.iter().position(|f| f.1 == other) {
            Some(known) if self.found[known].0 <= cost => return,
            Some(known) => drop(self.found.remove(known)),
            None => {}
        }
        let place = self.found.partition_point(|f| (f.0, f.1) < (cost, other));
        self.found.insert(place, (cost, other));
        self.found.truncate(self.most);
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::Measure;
    use super::super::super::test_sheet::sheet;
    use super::*;

    #[test]
    fn as_many_near_items_as_asked_for_and_all_where_the_lists_are_off() {
        // Points at 0, 1, 3, 7 and 15.
        let at = [0.0, 1.0, 3.0, 7.0, 15.0].map(|x| [[x, 0.0]]);
        let contours: Vec<&[[f64; 2]]> = at.iter().map(<[_; 1]>::as_slice).collect();
        let problem = sheet(&contours, None, "length");
        let of = |most: u32, item: ItemId| -> Vec<ItemId> {
            let (legs, all) = (Legs::new(&problem, Measure::Euclidean), Unvisited::all(&problem));
            let mut near = NearItems::new(most);
            while near.piece(&legs, &all).is_some() {}
            near.of(item).iter().map(|n| n.1).collect()
        };
        assert_eq!((of(2, 2), of(1, 4)), (vec![1, 0], vec![3]));
        assert_eq!(of(5, 2), [1, 0, 3, 4]);
    }
}
