//! The best entries for an order: layer by layer, the least way to each node of an item (dynamic programming).

use super::super::legs::Legs;
use crate::problem::NodeId;

/// Legs priced in one piece: well under a millisecond.
const PIECE: u64 = 20_000;

/// The search for the best entries of an order, under way.
pub(in super::super) struct Choose {
    tour: Vec<NodeId>,
    /// The first node stays as it is.
    held: bool,
    /// Least ways to the nodes of the item now reached.
    ways: Vec<f64>,
    /// By item in the order: for each of its nodes the one before it, counted from its item's first.
    before: Vec<Vec<u32>>,
}

impl Choose {
    /// For an order, given as a tour; `held`: its first node is not to change. With a table of costs it must be, as the
    /// way back goes there.
    pub(in super::super) fn new(tour: Vec<NodeId>, held: bool) -> Self {
        Self { tour, held, ways: Vec::new(), before: Vec::new() }
    }

    fn nodes(&self, legs: &Legs, place: usize) -> std::ops::Range<NodeId> {
        let node = self.tour[place];
        let problem = legs.problem();
        if place == 0 && self.held {
            return node..node + 1;
        }
        problem.items[problem.nodes[node as usize].item as usize].nodes.clone()
    }

    /// Works on; how many legs were priced, or nothing when the entries are chosen.
    pub(in super::super) fn piece(&mut self, legs: &Legs) -> Option<u64> {
        let first = *self.tour.first()?;
        let mut priced = 0;
        while priced < PIECE && self.before.len() < self.tour.len() {
            let place = self.before.len();
            let nodes = self.nodes(legs, place);
            if place == 0 {
                self.ways = nodes.clone().map(|n| legs.out(n)).collect();
                self.before.push(Vec::new());
                continue;
            }
            let last = self.nodes(legs, place - 1);
            let (mut ways, mut before) = (Vec::with_capacity(nodes.len()), Vec::with_capacity(nodes.len()));
            for node in nodes {
                let mut least = (f64::INFINITY, 0);
                for ((from, way), k) in last.clone().zip(&self.ways).zip(0..) {
                    let cost = way + legs.leg(from, node);
                    if cost < least.0 {
                        least = (cost, k);
                    }
                }
                priced += last.len() as u64;
                ways.push(least.0);
                before.push(least.1);
            }
            self.ways = ways;
            self.before.push(before);
        }
        if priced > 0 || self.before.len() < self.tour.len() {
            return Some(priced);
        }
        let last = self.tour.len() - 1;
        let mut least = (f64::INFINITY, 0);
        for ((node, way), k) in self.nodes(legs, last).zip(&self.ways).zip(0_u32..) {
            let cost = way + legs.back(node, first);
            if cost < least.0 {
                least = (cost, k);
            }
        }
        let mut pick = least.1;
        for place in (0..=last).rev() {
            let node = self.nodes(legs, place).start + pick;
            pick = self.before[place].get(pick as usize).copied().unwrap_or(0);
            self.tour[place] = node;
        }
        None
    }

    /// The tour.
    pub(in super::super) fn tour(&mut self) -> Vec<NodeId> {
        std::mem::take(&mut self.tour)
    }
}
