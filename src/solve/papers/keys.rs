//! Random keys: how a row of real numbers in [0, 1] stands for a tour (Bean, ORSA Journal on Computing 6, 1994). One
//! key an item for its place in the order, and one for its entry where there are several: the m nodes of an item share
//! [0, 1] evenly.

use crate::order::{real, sort_by};
use crate::problem::{ItemId, NodeId, Problem};

/// What the keys of a problem stand for.
pub(super) struct Keys<'p> {
    problem: &'p Problem,
    /// Items with nodes, what leads the tour first.
    items: Vec<ItemId>,
    /// By item: its place in `items`.
    index: Vec<usize>,
    /// By place in `items`: its key for the entry, if it has one.
    entry: Vec<Option<usize>>,
    /// How many keys there are.
    count: usize,
    /// The first of the items leads every tour.
    pub(super) led: bool,
    /// With this node.
    pub(super) pinned: Option<NodeId>,
}

impl<'p> Keys<'p> {
    /// For a problem; `first`: the node every tour starts with. A cycle by a table of costs starts where the table says.
    pub(super) fn new(problem: &'p Problem, first: Option<NodeId>) -> Self {
        let node = first.and_then(|n| Some((n, problem.nodes.get(n as usize)?.item)));
        let start = problem.start().filter(|&s| !problem.items[s as usize].nodes.is_empty());
        let pinned = node.filter(|&(_, item)| start.is_none_or(|s| s == item)).map(|(n, _)| n);
        let lead = start.or(pinned.and(node).map(|(_, item)| item));
        let others = (0..).zip(&problem.items).filter(|(i, item)| !item.nodes.is_empty() && Some(*i) != lead);
        let items: Vec<ItemId> = lead.into_iter().chain(others.map(|(i, _)| i)).collect();
        let mut index = vec![usize::MAX; problem.items.len()];
        let mut count = items.len();
        let mut entry = vec![None; items.len()];
        for (place, &item) in items.iter().enumerate() {
            index[item as usize] = place;
            if problem.items[item as usize].nodes.len() > 1 && !(place == 0 && pinned.is_some()) {
                entry[place] = Some(count);
                count += 1;
            }
        }
        Self { problem, items, index, entry, count, led: lead.is_some(), pinned }
    }

    /// How many keys there are.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// Items in a tour, what leads it first.
    pub(super) fn items(&self) -> &[ItemId] {
        &self.items
    }

    /// The tour that keys stand for; of equal keys the item named first comes first.
    pub(super) fn tour(&self, keys: &[f64]) -> Vec<NodeId> {
        let mut order: Vec<usize> = (0..self.items.len()).collect();
        sort_by(&mut order, |&k| [u64::from(k > 0 || !self.led), real(keys[k]), 0]);
        order.into_iter().map(|k| self.node(k, keys)).collect()
    }

    /// The node at which the `k`th item is entered.
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

    /// Makes keys stand for a tour: places at even distances, entries in the middle of their share. Keys of entries
    /// that are right stay as they are.
    pub(super) fn set(&self, tour: &[NodeId], keys: &mut [f64]) {
        for (place, &node) in tour.iter().enumerate() {
            let item = self.problem.nodes[node as usize].item;
            let k = self.index[item as usize];
            keys[k] = (place as f64 + 0.5) / tour.len() as f64;
            if let Some(key) = self.entry[k].filter(|_| self.node(k, keys) != node) {
                let nodes = &self.problem.items[item as usize].nodes;
                keys[key] = (f64::from(node - nodes.start) + 0.5) / nodes.len() as f64;
            }
        }
    }
}
