//! The best node to enter each item for a fixed order of items, by dynamic programming from item to item.

use super::super::legs::Legs;
use crate::problem::NodeId;

/// Number of legs priced in one piece: well under a millisecond.
const PIECE: u64 = 20_000;

/// The dynamic programme for one order, under way.
pub(in super::super) struct EntryChoice {
    tour: Vec<NodeId>,
    /// Whether the first node is fixed.
    held: bool,
    /// Length of the shortest way to each node of the current item.
    ways: Vec<f64>,
    /// For each item in the order and each of its nodes, the best node before it, counted from the first node of that item.
    before: Vec<Vec<u32>>,
}

impl EntryChoice {
    /// Starts with an order, given as a tour. `held` fixes its first node; a table of costs requires that, because the
    /// cycle returns to that node.
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

    /// Continues. Returns the number of legs priced, or `None` when the entries are chosen.
    pub(in super::super) fn piece(&mut self, legs: &Legs) -> Option<u64> {
        let first = *self.tour.first()?;
        let mut priced = 0;
        while priced < PIECE && self.before.len() < self.tour.len() {
            let place = self.before.len();
            let nodes = self.nodes(legs, place);
            if place == 0 {
                self.ways = nodes.clone().map(|n| legs.from_home(n)).collect();
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
            let cost = way + legs.to_end(node, first);
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

    /// The tour with the chosen entries.
    pub(in super::super) fn tour(&mut self) -> Vec<NodeId> {
        std::mem::take(&mut self.tour)
    }
}
