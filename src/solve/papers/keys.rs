//! Random keys (Bean, ORSA Journal on Computing 6, 1994): a vector of real numbers in [0, 1] represents a tour. Each item
//! has a key that sorts it into the order. An item with several nodes has a second key that selects the node where it is
//! entered: its m nodes share [0, 1] evenly.

use crate::order::{real, sort_by};
use crate::problem::{ItemId, NodeId, Problem};

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
    /// Whether the first of `items` starts every tour.
    pub(super) led: bool,
    /// The node at which every tour starts, if it is fixed.
    pub(super) pinned: Option<NodeId>,
}

impl<'p> Keys<'p> {
    /// The keys of a problem. `first` fixes the node at which every tour starts. A cycle given by a table of costs starts
    /// at the item that the table names.
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

    /// Number of keys.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    /// The items of a tour, the fixed first one (if any) at the front.
    pub(super) fn items(&self) -> &[ItemId] {
        &self.items
    }

    /// The tour that these keys represent. Items with equal keys stay in the order of `items`.
    pub(super) fn tour(&self, keys: &[f64]) -> Vec<NodeId> {
        let mut order: Vec<usize> = (0..self.items.len()).collect();
        sort_by(&mut order, |&k| [u64::from(k > 0 || !self.led), real(keys[k]), 0]);
        order.into_iter().map(|k| self.node(k, keys)).collect()
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
            keys[k] = (place as f64 + 0.5) / tour.len() as f64;
            if let Some(key) = self.entry[k].filter(|_| self.node(k, keys) != node) {
                let nodes = &self.problem.items[item as usize].nodes;
                keys[key] = (f64::from(node - nodes.start) + 0.5) / nodes.len() as f64;
            }
        }
    }
}
