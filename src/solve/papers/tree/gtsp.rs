//! A partition as a generalized travelling salesman problem (GTSP): its order and entries are solved again while its parent
//! node stays fixed.
//!
//! The paper transforms the GTSP by Noon and Bean (1991) into an asymmetric travelling salesman problem and solves that
//! with LKH (Helsgaun 2000). Here the partition becomes a problem of its own, with its parent node as home, and the default
//! search solves it: Or-opt, 2-opt and Or-3opt with other entries over neighbour lists, with kicks and annealing
//! (`tour_tree`). For up to three contours all orders are tried. Precedence is ignored, as in the paper. So are partitions
//! that hang from pierce groups: they stay at their nodes, while the path of the group may change, and what they cost then is
//! part of the seconds of each path. The result is taken only if it is better.

use super::entries::{MOST_ORDERED, cheapest, orders};
use super::forest::Forest;
use super::graph::Graph;
use crate::problem::{Item, ItemId, Node, NodeId, Problem};
use crate::solve::epsilon::EPSILON;
use crate::solve::tour_tree::TourTree;
use crate::solve::{Running, Solution, Solver, Status, Stop};
use glam::DVec2;

/// Number of moves in one piece: about a millisecond.
const SLICE: u64 = 1_000;

/// Seconds of a path that must not be taken: more than any partition takes, and small enough that sums stay exact.
const NEVER: f64 = 1e6;

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
            ..Problem::empty(g.problem.machine.clone())
        };
        let mut stops = Vec::new();
        for (id, &item) in (0..).zip(&items) {
            let count = |nodes: &Vec<NodeId>| NodeId::try_from(nodes.len()).unwrap_or(NodeId::MAX);
            let first = count(&nodes);
            let all = g.nodes(item);
            for node in all.clone().filter(|&n| forest.child(n).is_none()) {
                let own = &g.problem.nodes[node as usize];
                // The two ends of an open contour are adjacent, because nothing is attached to them.
                let twin = count(&nodes) + own.twin - node;
                if forest.entry(item) == node {
                    stops.push(count(&nodes));
                }
                problem.nodes.push(Node { item: id, twin, ..*own });
                nodes.push(node);
            }
            let mut whole = g.problem.items[item as usize].in_one_go();
            for (path, node) in whole.paths.iter_mut().zip(all) {
                path.seconds += forest.hung_seconds(g, node).min(NEVER);
            }
            problem.items.push(Item {
                before: None,
                rank: 0,
                track: None,
                nodes: first..count(&nodes),
                ..whole
            });
        }
        let (out, back) = forest.ends(g, route);
        let ends_elsewhere = back.filter(|&back| back != out);
        if let Some(back) = ends_elsewhere {
            stops.push(end_at(&mut problem, back));
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
            .filter_map(|s| self.nodes.get(s.node as usize).copied())
            .collect();
        debug_assert_eq!(found.len(), self.items.len(), "every contour of a partition is visited");
        set(g, forest, self.route, &found);
    }
}

/// Makes the path of a problem end at a point: the head goes there last and not home.
fn end_at(problem: &mut Problem, place: DVec2) -> NodeId {
    let node = NodeId::try_from(problem.nodes.len()).unwrap_or(NodeId::MAX);
    let item = ItemId::try_from(problem.items.len()).unwrap_or(ItemId::MAX);
    problem.nodes.push(Node { item, entry: place, exit: place, along: 0.0, reversed: false, twin: node });
    problem.items.push(Item { nodes: node..node + 1, rank: 1, ..Item::default() });
    problem.closed = false;
    node
}

/// Sets the order and entries of a route by its nodes, if that is better: with other paths through pierce groups, or else
/// with the paths that partitions hang from.
fn set(g: &Graph, forest: &mut Forest, route: u32, nodes: &[NodeId]) {
    let before = seconds(g, forest, route);
    let old: Vec<NodeId> = forest.items(route).iter().map(|&i| forest.entry(i)).collect();
    let fixed = |n: NodeId| g.is_group(g.item(n)) && forest.children(g.item(n)) > 0;
    let kept = |&n: &NodeId| if fixed(n) { forest.entry(g.item(n)) } else { n };
    let kept: Vec<NodeId> = nodes.iter().map(kept).collect();
    for order in [nodes, &kept] {
        forest.order(g, route, order);
        if seconds(g, forest, route) <= before - EPSILON {
            return;
        }
    }
    forest.order(g, route, &old);
}

/// Seconds of a route and of the partitions that hang from its pierce groups.
fn seconds(g: &Graph, forest: &Forest, route: u32) -> f64 {
    let groups = forest.items(route).iter().filter(|&&i| g.is_group(i));
    let hanging = groups.flat_map(|&i| forest.hanging(g, i)).filter_map(|n| forest.child(n));
    forest.route_seconds(g, route) + hanging.map(|r| forest.route_seconds(g, r)).sum::<f64>()
}

/// Tries every order of a few contours with the best entries of each. Returns the cost in moves.
fn best_of_all_orders(g: &Graph, forest: &mut Forest, route: u32) -> u64 {
    let orders = orders(forest.items(route).len());
    let layer = |&k: &usize| g.nodes(forest.items(route)[k]).filter(|&n| forest.may_enter(g, n)).collect();
    let tried = orders.iter().map(|order| {
        let layers: Vec<Vec<NodeId>> = order.iter().map(layer).collect();
        cheapest(g, &layers, forest.ends(g, route), |n| forest.extra(g, n))
    });
    if let Some((_, nodes)) = tried.reduce(|a, b| if b.0 < a.0 { b } else { a }) {
        set(g, forest, route, &nodes);
    }
    // A handful of entries for every pair of neighbours.
    100 * orders.len() as u64
}
