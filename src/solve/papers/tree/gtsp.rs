//! A partition as a generalized travelling salesman problem: its order and entries anew, its parent node fixed.
//!
//! The paper transforms it by Noon and Bean (1991) into an asymmetric one and has LKH (Helsgaun 2000) solve that. Here
//! the partition is a problem of its own, home at its parent node, and the moves of our default search solve it: Or-opt,
//! 2-opt, Or-3opt with re-entry over neighbour lists, kicked and annealed (`tour_tree`). Up to three contours are tried in
//! every order. Precedence is left out, as in the paper.

use super::entries::{MOST_ORDERED, cheapest, orders};
use super::forest::Forest;
use super::ground::Ground;
use crate::problem::{Groups, Item, ItemId, Node, NodeId, Problem};
use crate::solve::epsilon::EPSILON;
use crate::solve::tour_tree::TourTree;
use crate::solve::{Running, Solution, Solver, Status, Stop};

/// Moves to a piece: about a millisecond.
const SLICE: u64 = 1_000;

/// The work on one partition.
pub(super) struct Gtsp {
    route: u32,
    running: Running,
    /// The contour and nodes that each contour and node of the smaller problem stands for.
    items: Vec<ItemId>,
    nodes: Vec<NodeId>,
    left: u64,
}

impl Gtsp {
    /// Begins with a partition, for so many moves a contour; nothing is left to do for small ones, which are solved at
    /// once. `moves` counts what that took.
    pub(super) fn new(
        g: &Ground,
        forest: &mut Forest,
        route: u32,
        (seed, each): (u64, u64),
        moves: &mut u64,
    ) -> Option<Self> {
        let items = forest.items(route).to_vec();
        if items.len() <= MOST_ORDERED {
            *moves += few(g, forest, route);
            return None;
        }
        let mut nodes = Vec::new();
        let mut problem = Problem {
            items: Vec::new(),
            nodes: Vec::new(),
            home: forest.ends(g, route).0,
            closed: forest.ends(g, route).1.is_some(),
            machine: g.problem.machine.clone(),
            pairs: Vec::new(),
            groups: Groups::default(),
            table: None,
        };
        let mut stops = Vec::new();
        for (id, &item) in (0..).zip(&items) {
            let count = |nodes: &Vec<NodeId>| NodeId::try_from(nodes.len()).unwrap_or(NodeId::MAX);
            let first = count(&nodes);
            let all = g.nodes(item);
            for node in all.clone().filter(|&n| forest.may_enter(n)) {
                let own = &g.problem.nodes[node as usize];
                // Two ends stand side by side, as nothing hangs there.
                let twin = count(&nodes) + own.twin - node;
                if forest.entry(item) == node {
                    stops.push(count(&nodes));
                }
                problem.nodes.push(Node { item: id, twin, ..*own });
                nodes.push(node);
            }
            let bare = Item {
                before: None,
                rank: 0,
                leave: None,
                track: None,
                ..g.problem.items[item as usize].clone()
            };
            problem.items.push(Item { nodes: first..count(&nodes), ..bare });
        }
        let warm = Solution::new(&problem, stops.into_iter().map(|n| Stop::at(&problem, n)).collect());
        let left = each * items.len() as u64;
        let running = Running::new(problem, |p| TourTree.start(p, seed, Some(&warm)));
        Some(Self { route, running, items, nodes, left })
    }

    /// The partition.
    pub(super) fn route(&self) -> u32 {
        self.route
    }

    /// Works on; what that cost in moves, or nothing at the end.
    pub(super) fn piece(&mut self) -> Option<u64> {
        let work = SLICE.min(self.left);
        self.left -= work;
        let step = self.running.with_dependent_mut(|_, search| search.step(work.max(1)));
        (work > 0 && step.status == Status::Running).then_some(work)
    }

    /// Puts the order and entries found into the partition, if they are better.
    pub(super) fn take(&self, g: &Ground, forest: &mut Forest) {
        let found: Vec<NodeId> = self
            .running
            .borrow_dependent()
            .best()
            .stops
            .iter()
            .map(|s| self.nodes[s.node as usize])
            .collect();
        debug_assert_eq!(found.len(), self.items.len(), "every contour of a partition is visited");
        set(g, forest, self.route, &found);
    }
}

/// A route by the nodes of its contours, if it is better so.
fn set(g: &Ground, forest: &mut Forest, route: u32, nodes: &[NodeId]) {
    let before = forest.route_seconds(g, route);
    let old: Vec<NodeId> = forest.items(route).iter().map(|&i| forest.entry(i)).collect();
    forest.order(g, route, nodes);
    if forest.route_seconds(g, route) > before - EPSILON {
        forest.order(g, route, &old);
    }
}

/// Every order of a few contours, with the best entries of each; how many orders.
fn few(g: &Ground, forest: &mut Forest, route: u32) -> u64 {
    let orders = orders(forest.items(route).len());
    let layer = |&k: &usize| g.nodes(forest.items(route)[k]).filter(|&n| forest.may_enter(n)).collect();
    let tried = orders.iter().map(|order| {
        let layers: Vec<Vec<NodeId>> = order.iter().map(layer).collect();
        cheapest(g, &layers, forest.ends(g, route))
    });
    if let Some((_, nodes)) = tried.reduce(|a, b| if b.0 < a.0 { b } else { a }) {
        set(g, forest, route, &nodes);
    }
    // A handful of entries each way for every pair of neighbours.
    100 * orders.len() as u64
}
