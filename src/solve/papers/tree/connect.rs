//! The cheapest connections between partitions, from which the arborescence is chosen.
//!
//! The paper describes "a simple preprocessing phase identifying the cheapest connection between two partitions". So a
//! connection costs only the air moves there and back. The pre-cut, and what is saved where the ring of a partition is
//! opened, are left to the later moves. With both included, the arborescence reproduces the previous tree sooner, and the
//! rounds stagnate at worse paths.
//!
//! The paper compares all nodes of two partitions. Here a node is compared with its near nodes in other partitions. Each
//! partition is also compared with home and with its parent node, so that the root reaches all of them.

use super::edmonds::Arc;
use super::forest::{Forest, ROOT};
use super::graph::Graph;
use crate::problem::NodeId;
use rustc_hash::FxHashMap;

/// A connection from a node of the parent partition (`None`: home) to a node of the child.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Connection {
    pub(super) arc: Arc,
    pub(super) from: Option<NodeId>,
    pub(super) to: NodeId,
}

/// The cheapest connection found for each pair of partitions.
#[derive(Default)]
pub(super) struct Connections {
    pub(super) all: Vec<Connection>,
    /// Index of the connection of a pair. The map is only used for lookups, never iterated.
    known: FxHashMap<(u32, u32), usize>,
}

impl Connections {
    fn offer(&mut self, from: u32, to: u32, new: Connection) {
        let next = self.all.len();
        let at = *self.known.entry((from, to)).or_insert(next);
        if at == next {
            self.all.push(new);
        } else if new.arc.cost < self.all[at].arc.cost {
            self.all[at] = new;
        }
    }

    /// Finds connections to a partition. Returns the number of them that were priced.
    pub(super) fn look(&mut self, g: &Graph, forest: &Forest, route: u32) -> u64 {
        if route == ROOT {
            return 0;
        }
        let mut priced = 0;
        for &item in forest.items(route) {
            for to in g.nodes(item).filter(|&n| may_arrive(g, forest, n)) {
                self.price(g, forest, None, to);
                for &from in forest.at(route).iter().chain(g.near(to)) {
                    let own = forest.entry(g.item(from)) == from;
                    if forest.route_of(g.item(from)) != route && (own || forest.may_leave(g, from)) {
                        self.price(g, forest, Some(from), to);
                    }
                }
                priced += 2 + g.near(to).len() as u64;
            }
        }
        priced
    }

    fn price(&mut self, g: &Graph, forest: &Forest, from: Option<NodeId>, to: NodeId) {
        let (parent, out, home) = match from {
            None => (ROOT, g.problem.home, g.problem.home),
            Some(node) => {
                let hook = forest.hook(g, node);
                (forest.route_of(g.item(node)), hook.out, hook.back)
            }
        };
        let child = forest.route_of(g.item(to));
        let cost = g.air(out, g.entry(to)) + g.air(g.exit(to), home);
        let arc = Arc { from: parent as usize, to: child as usize, cost };
        self.offer(parent, child, Connection { arc, from, to });
    }
}

/// Whether a connection may lead to a node of a partition: either its contour is entered there, or it can be entered there
/// and the rest of the partition can be attached to its old entry.
fn may_arrive(g: &Graph, forest: &Forest, to: NodeId) -> bool {
    let item = g.item(to);
    let alone = forest.items(forest.route_of(item)).len() == 1;
    forest.entry(item) == to || (forest.may_enter(g, to) && (alone || g.may_leave(item)))
}
