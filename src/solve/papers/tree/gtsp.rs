//! A partition as a generalized travelling salesman problem (GTSP): its order and entries are solved again while its parent
//! node stays fixed.
//!
//! The paper transforms the GTSP by Noon and Bean (1991) into an asymmetric travelling salesman problem and solves that
//! with LKH (Helsgaun 2000). Here the partition becomes a problem of its own, with its parent node as home, and the default
//! search solves it: Or-opt, 2-opt and Or-3opt with other entries over neighbour lists, with kicks and annealing
//! (`tour_tree`). For up to three contours all orders are tried. Precedence is ignored, as in the paper.

use super::entries::{MOST_ORDERED, cheapest, orders};
use super::forest::Forest;
use super::graph::Graph;
use crate::problem::{Groups, Item, ItemId, Node, NodeId, Problem};
use crate::solve::epsilon::EPSILON;
use crate::solve::tour_tree::TourTree;
use crate::solve::{Running, Solution, Solver, Status, Stop};

/// Number of moves in one piece: about a millisecond.
const SLICE: u64 = 1_000;

/// The search on one partition.
pub(super) struct Gtsp {
    route: u32,
    running: Running,
    /// The contour and node that each contour and node of the smaller problem represents.
    items: Vec<ItemId>,
    nodes: Vec<NodeId>,
    left: u64,
}

impl Gtsp {
    /// Starts with a partition; `each` is the number of moves for each contour. Small partitions are solved at once and
    /// return `None`. The work is added to `moves`.
    pub(super) fn new(
        g: &Graph,
        forest: &mut Forest,
        route: u32,
        (seed, each): (u64, u64),
        moves: &mut u64,
    ) -> Option<Self> {
        let items = forest.items(route).to_vec();
        if items.len() <= MOST_ORDERED {
            *moves += best_of_all_orders(g, forest, route);
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
                // The two ends of an open contour are adjacent, because nothing is attached to them.
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

    /// The partition that is solved.
    pub(super) fn route(&self) -> u32 {
        self.route
    }

    /// Continues. Returns the cost in moves, or `None` at the end.
    pub(super) fn piece(&mut self) -> Option<u64> {
        let work = SLICE.min(self.left);
        self.left -= work;
        let step = self.running.with_dependent_mut(|_, search| search.step(work.max(1)));
        (work > 0 && step.status == Status::Running).then_some(work)
    }

    /// Applies the order and entries found, if they are better.
    pub(super) fn take(&self, g: &Graph, forest: &mut Forest) {
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

/// Sets the order and entries of a route by its nodes, if that is better.
fn set(g: &Graph, forest: &mut Forest, route: u32, nodes: &[NodeId]) {
    let before = forest.route_seconds(g, route);
    let old: Vec<NodeId> = forest.items(route).iter().map(|&i| forest.entry(i)).collect();
    forest.order(g, route, nodes);
    if forest.route_seconds(g, route) > before - EPSILON {
        forest.order(g, route, &old);
    }
}

/// Tries every order of a few contours with the best entries of each. Returns the cost in moves.
fn best_of_all_orders(g: &Graph, forest: &mut Forest, route: u32) -> u64 {
    let orders = orders(forest.items(route).len());
    let layer = |&k: &usize| g.nodes(forest.items(route)[k]).filter(|&n| forest.may_enter(n)).collect();
    let tried = orders.iter().map(|order| {
        let layers: Vec<Vec<NodeId>> = order.iter().map(layer).collect();
        cheapest(g, &layers, forest.ends(g, route))
    });
    if let Some((_, nodes)) = tried.reduce(|a, b| if b.0 < a.0 { b } else { a }) {
        set(g, forest, route, &nodes);
    }
    // A handful of entries for every pair of neighbours.
    100 * orders.len() as u64
}
