//! The nodes not yet visited by a tour, and which of them is nearest. Nodes are in a grid, or in a list where a table gives
//! the costs.

use super::legs::Legs;
use crate::geometry::{Aabb, Buckets};
use crate::problem::{ItemId, NodeId, Problem};

/// Nodes of the items not yet visited.
#[derive(Clone)]
pub(super) enum Unvisited {
    /// By coordinates.
    Grid(Buckets),
    /// In the order of their indices: nodes of a table of costs have no coordinates.
    List(Vec<NodeId>),
}

impl Unvisited {
    /// All nodes of a problem.
    pub(super) fn all(problem: &Problem) -> Self {
        if problem.table().is_some() {
            return Self::List((0..).zip(&problem.nodes).map(|(n, _)| n).collect());
        }
        let bounds = problem.nodes.iter().fold(Aabb::EMPTY, |b, n| b.with(n.entry));
        let mut grid = Buckets::new(bounds, problem.nodes.len());
        for (node, n) in (0..).zip(&problem.nodes) {
            grid.insert(node, n.entry);
        }
        Self::Grid(grid)
    }

    /// Removes the nodes of an item.
    pub(super) fn visit(&mut self, problem: &Problem, item: ItemId) {
        match self {
            Self::List(nodes) => nodes.retain(|&n| problem.nodes[n as usize].item != item),
            Self::Grid(grid) => {
                for node in problem.items[item as usize].nodes.clone() {
                    grid.remove(node, problem.nodes[node as usize].entry);
                }
            }
        }
    }

    /// The nearest node after `from`, or after home. Of equally near nodes the one with the lower index is returned. The
    /// second value is the number of legs priced.
    pub(super) fn nearest(&self, legs: &Legs, from: Option<NodeId>) -> (Option<NodeId>, u64) {
        let mut best: Option<(f64, NodeId)> = None;
        let mut priced = 0;
        let mut price = |node: NodeId, best: &mut Option<(f64, NodeId)>| {
            priced += 1;
            let cost = from.map_or_else(|| legs.from_home(node), |from| legs.leg(from, node));
            if best.is_none_or(|b| (cost, node) < b) {
                *best = Some((cost, node));
            }
        };
        match self {
            Self::List(nodes) => nodes.iter().for_each(|&n| price(n, &mut best)),
            Self::Grid(grid) => {
                let problem = legs.problem();
                let head = from.map_or(problem.home, |n| problem.nodes[n as usize].exit);
                for r in 0..grid.rings(head) {
                    let least = legs.lower_bound(grid.distance_of_ring(r));
                    if best.is_some_and(|(cost, _)| least > cost) {
                        break;
                    }
                    grid.ring(head, r).for_each(|n| price(n, &mut best));
                }
            }
        }
        (best.map(|b| b.1), priced)
    }
}

/// A nearest-neighbour tour under construction.
pub(super) struct NearestNeighbour {
    left: Unvisited,
    /// For each item, whether it is not yet in the tour.
    open: Vec<bool>,
    /// The tour so far.
    pub(super) tour: Vec<NodeId>,
}

impl NearestNeighbour {
    /// Starts a tour with these nodes.
    pub(super) fn new(mut left: Unvisited, problem: &Problem, begun: &[NodeId]) -> Self {
        let mut open = vec![true; problem.items.len()];
        for &node in begun {
            let item = problem.nodes[node as usize].item;
            left.visit(problem, item);
            open[item as usize] = false;
        }
        Self { left, open, tour: begun.to_vec() }
    }

    /// Appends the nearest unvisited node. Returns the number of legs priced, or `None` when the tour is complete.
    pub(super) fn step(&mut self, legs: &Legs) -> Option<u64> {
        let (node, priced) = self.left.nearest(legs, self.tour.last().copied());
        self.go(legs.problem(), node?);
        Some(priced)
    }

    /// Whether an item is not yet in the tour.
    pub(super) fn is_left(&self, item: ItemId) -> bool {
        self.open[item as usize]
    }

    /// Appends a node.
    pub(super) fn go(&mut self, problem: &Problem, node: NodeId) {
        let item = problem.nodes[node as usize].item;
        self.left.visit(problem, item);
        self.open[item as usize] = false;
        self.tour.push(node);
    }
}
