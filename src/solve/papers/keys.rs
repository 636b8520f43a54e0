//! Random keys (Bean, ORSA Journal on Computing 6, 1994): a vector of real numbers in [0, 1] represents a tour. Each item
//! has a key that sorts it into the order. An item with several nodes has a second key that selects the node where it is
//! entered: its m nodes share [0, 1] evenly.

use super::legs::Legs;
use crate::order::{real, sort_by};
use crate::problem::{ItemId, NodeId, Problem};
use serde::{Deserialize, Serialize};

/// How a particle becomes a tour. Qu & Du do not say it; their published sequences support [`Decode::OrderNearest`]: 39 of
/// 42 steps of LPSPSO enter the feature point that is nearest to the previous one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Decode {
    /// A key orders each item, and a second key selects the node where it is entered.
    #[default]
    Keys,
    /// A key orders each item, and it is entered at the node nearest to the previous exit.
    OrderNearest,
    /// The particle is a permutation of the items (keys that are always evenly spaced), moved by exchanges, and each item
    /// is entered at the node nearest to the previous exit.
    Permutation,
}

/// The tours of a problem as random keys.
pub(super) struct Keys<'p> {
    problem: &'p Problem,
    /// Items that have nodes; the item that is fixed at the start of the tour, if any, comes first.
    items: Vec<ItemId>,
    /// For each item, its position in `items`.
    index: Vec<usize>,
    /// For each position in `items`, the index of the key that selects its entry; `None` if it has one node or a fixed one.
    entry: Vec<Option<usize>>,
    /// Number of keys.
    count: usize,
    /// Whether some item has several nodes to choose from.
    entries: bool,
    decode: Decode,
    /// Whether the first of `items` starts every tour.
    pub(super) led: bool,
    /// The node at which every tour starts, if it is fixed.
    pub(super) pinned: Option<NodeId>,
}

impl<'p> Keys<'p> {
    /// The keys of a problem. `first` fixes the node at which every tour starts. A cycle given by a table of costs starts
    /// at the item that the table names.
    pub(super) fn new(problem: &'p Problem, first: Option<NodeId>, decode: Decode) -> Self {
        let node = first.and_then(|n| Some((n, problem.nodes.get(n as usize)?.item)));
        let start = problem.start().filter(|&s| !problem.items[s as usize].nodes.is_empty());
        let pinned = node.filter(|&(_, item)| start.is_none_or(|s| s == item)).map(|(n, _)| n);
        let lead = start.or(pinned.and(node).map(|(_, item)| item));
        let others = (0..).zip(&problem.items).filter(|(i, item)| !item.nodes.is_empty() && Some(*i) != lead);
        let items: Vec<ItemId> = lead.into_iter().chain(others.map(|(i, _)| i)).collect();
        let mut index = vec![usize::MAX; problem.items.len()];
        let mut count = items.len();
        let mut entries = false;
        let mut entry = vec![None; items.len()];
        for (place, &item) in items.iter().enumerate() {
            index[item as usize] = place;
            if problem.items[item as usize].nodes.len() > 1 && !(place == 0 && pinned.is_some()) {
                entries = true;
                if decode == Decode::Keys {
                    entry[place] = Some(count);
                    count += 1;
                }
            }
        }
        Self { problem, items, index, entry, count, entries, decode, led: lead.is_some(), pinned }
    }

    /// Number of keys.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// Whether some item has several nodes to choose from.
    pub(super) fn has_entries(&self) -> bool {
        self.entries
    }

    /// Whether particles are permutations.
    pub(super) fn permutes(&self) -> bool {
        self.decode == Decode::Permutation
    }

    /// Number of legs that are priced to decode a tour.
    pub(super) fn priced(&self) -> u64 {
        if self.decode == Decode::Keys { 0 } else { self.problem.nodes.len() as u64 }
    }

    /// The items of a tour, the fixed first one (if any) at the front.
    pub(super) fn items(&self) -> &[ItemId] {
        &self.items
    }

    /// The tour that these keys represent. Items with equal keys stay in the order of `items`.
    pub(super) fn tour(&self, legs: &Legs, keys: &[f64]) -> Vec<NodeId> {
        let order = self.order(keys);
        if self.decode == Decode::Keys {
            return order.into_iter().map(|k| self.node(k, keys)).collect();
        }
        let mut tour: Vec<NodeId> = Vec::with_capacity(order.len());
        for k in order {
            let nodes = self.problem.items[self.items[k] as usize].nodes.clone();
            let leg = |n: NodeId| tour.last().map_or_else(|| legs.from_home(n), |&from| legs.leg(from, n));
            let nearest = nodes.clone().map(|n| (leg(n), n)).min_by(|a, b| a.0.total_cmp(&b.0));
            let pinned = self.pinned.filter(|_| k == 0);
            tour.push(pinned.or(nearest.map(|(_, n)| n)).unwrap_or(nodes.start));
        }
        tour
    }

    /// Positions among the items in the order of their keys.
    fn order(&self, keys: &[f64]) -> Vec<usize> {
        let mut order: Vec<usize> = (0..self.items.len()).collect();
        sort_by(&mut order, |&k| [u64::from(k > 0 || !self.led), real(keys[k]), 0]);
        order
    }

    /// Spaces the order keys evenly. They represent the same order afterwards.
    pub(super) fn rank(&self, keys: &mut [f64]) {
        let order = self.order(keys);
        space_evenly(&order, keys);
    }

    /// Takes one item out of the order and inserts it `step` places later (earlier if negative), as far as there are
    /// places. The fixed first item stays.
    pub(super) fn insert(&self, keys: &mut [f64], k: usize, step: f64) {
        let mut order = self.order(keys);
        let first = usize::from(self.led);
        let Some(from) = order.iter().position(|&o| o == k).filter(|&from| from >= first) else { return };
        let last = order.len() - 1;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "held between two positions"
        )]
        let to = (from as f64 + step).round().clamp(first as f64, last as f64) as usize;
        let moved = order.remove(from);
        order.insert(to, moved);
        space_evenly(&order, keys);
    }

    /// The exchanges that lead from one permutation to another: pairs of item positions that trade their places, in this
    /// order.
    pub(super) fn exchanges(&self, from: &[f64], to: &[f64]) -> Vec<(u32, u32)> {
        let (mut now, goal) = (self.order(from), self.order(to));
        let mut place = vec![0; now.len()];
        now.iter().enumerate().for_each(|(at, &k)| place[k] = at);
        let mut swaps = Vec::new();
        for (at, &wanted) in goal.iter().enumerate() {
            let here = now[at];
            if here != wanted {
                let other = place[wanted];
                now.swap(at, other);
                (place[wanted], place[here]) = (at, other);
                swaps.extend(u32::try_from(here).ok().zip(u32::try_from(wanted).ok()));
            }
        }
        swaps
    }

    /// The node at which the `k`th of `items` is entered.
    fn node(&self, k: usize, keys: &[f64]) -> NodeId {
        let nodes = &self.problem.items[self.items[k] as usize].nodes;
        let Some(key) = self.entry[k] else { return self.pinned.filter(|_| k == 0).unwrap_or(nodes.start) };
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates; held in range"
        )]
        let step = (keys[key] * nodes.len() as f64) as u32;
        nodes.start + step.min(nodes.end - nodes.start - 1)
    }

    /// Changes keys so that they represent a tour: order keys are evenly spaced, entry keys lie in the middle of their
    /// node's share. Entry keys that already select the right node stay unchanged.
    pub(super) fn set(&self, tour: &[NodeId], keys: &mut [f64]) {
        for (place, &node) in tour.iter().enumerate() {
            let item = self.problem.nodes[node as usize].item;
            let k = self.index[item as usize];
            keys[k] = spaced(place, tour.len());
            if let Some(key) = self.entry[k].filter(|_| self.node(k, keys) != node) {
                let nodes = &self.problem.items[item as usize].nodes;
                keys[key] = (f64::from(node - nodes.start) + 0.5) / nodes.len() as f64;
            }
        }
    }
}

/// The key of a place in an evenly spaced order.
fn spaced(place: usize, places: usize) -> f64 {
    (place as f64 + 0.5) / places as f64
}

/// Gives the items of an order evenly spaced keys.
fn space_evenly(order: &[usize], keys: &mut [f64]) {
    for (place, &k) in order.iter().enumerate() {
        keys[k] = spaced(place, order.len());
    }
}

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "the numbers of the examples are exact")]
mod tests {
    use super::super::Measure;
    use super::super::test_sheet::sheet;
    use super::*;

    /// Two contours with two nodes each and one with one: at 0 and 10, at 4 and 20, at 30.
    fn three() -> Problem {
        sheet(&[&[[0.0, 0.0], [10.0, 0.0]], &[[4.0, 0.0], [20.0, 0.0]], &[[30.0, 0.0]]], None, "length")
    }

    #[test]
    fn keys_decode_by_hand() {
        let problem = three();
        let legs = Legs::new(&problem, Measure::Euclidean);
        let keys = Keys::new(&problem, None, Decode::Keys);
        // Order keys 0.5, 0.1, 0.9: contours 1, 0, 2. Entry key 0.7 of two nodes is the second, 0.2 the first.
        assert_eq!(keys.count(), 5);
        assert_eq!(keys.tour(&legs, &[0.5, 0.1, 0.9, 0.7, 0.2]), [2, 1, 4]);
        // A key of 1 is the last node, not one beyond it; equal order keys keep the order of the contours.
        assert_eq!(keys.tour(&legs, &[0.5, 0.5, 0.5, 1.0, 0.5]), [1, 3, 4]);
        let mut own = vec![0.0; 5];
        keys.set(&[4, 1, 2], &mut own);
        assert_eq!(keys.tour(&legs, &own), [4, 1, 2]);
        // Evenly spaced: (place + 0.5) / 3; node 1 of two lies at 0.75, node 0 was selected already.
        assert_eq!(own, [0.5, 2.5 / 3.0, 0.5 / 3.0, 0.75, 0.0]);
    }

    #[test]
    fn an_order_is_entered_at_the_node_nearest_to_the_previous_exit() {
        let problem = three();
        let legs = Legs::new(&problem, Measure::Euclidean);
        for decode in [Decode::OrderNearest, Decode::Permutation] {
            let keys = Keys::new(&problem, None, decode);
            assert_eq!((keys.count(), keys.has_entries()), (3, true));
            // Contour 2 at 30 first; from there 20 is nearer than 4, and then 10 is nearer than 0.
            assert_eq!(keys.tour(&legs, &[0.9, 0.5, 0.1]), [4, 3, 1]);
            // From home, 4 is nearer than 20; then 0 is as far as 8 would be, 4 against 6.
            assert_eq!(keys.tour(&legs, &[0.5, 0.1, 0.9]), [2, 0, 4]);
            // A fixed start stays, although the other node is nearer to home.
            let fixed = Keys::new(&problem, Some(1), decode);
            assert_eq!(fixed.tour(&legs, &[0.9, 0.5, 0.1]), [1, 4, 3]);
        }
    }

    #[test]
    fn exchanges_and_insertions_by_hand() {
        let problem = sheet(&[&[[0.0, 0.0]], &[[1.0, 0.0]], &[[2.0, 0.0]], &[[3.0, 0.0]]], None, "length");
        let keys = Keys::new(&problem, None, Decode::Permutation);
        // From the order 0 1 2 3 to 2 0 1 3: exchange 0 and 2 (2 1 0 3), then 1 and 0.
        let (from, to) = ([0.125, 0.375, 0.625, 0.875], [0.375, 0.625, 0.125, 0.875]);
        assert_eq!(keys.exchanges(&from, &to), [(0, 2), (1, 0)]);
        assert!(keys.exchanges(&to, &to).is_empty());
        // Contour 0 goes two places on: 1 2 0 3; by more than there are places, to the end.
        let mut moved = from;
        keys.insert(&mut moved, 0, 2.0);
        assert_eq!(moved, [0.625, 0.125, 0.375, 0.875]);
        keys.insert(&mut moved, 1, 99.0);
        assert_eq!(moved, [0.375, 0.875, 0.125, 0.625]);
        // A fixed first contour stays where it is, and nothing gets before it.
        let led = Keys::new(&problem, Some(0), Decode::Permutation);
        let mut held = from;
        led.insert(&mut held, 0, 2.0);
        led.insert(&mut held, 3, -99.0);
        assert_eq!(held, [0.125, 0.625, 0.875, 0.375]);
        let mut loose = [0.3, 0.9, 0.1, 0.2];
        keys.rank(&mut loose);
        assert_eq!(loose, [0.625, 0.875, 0.125, 0.375]);
    }
}
