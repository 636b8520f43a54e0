//! The cheapest connection from one partition to another: what the arborescence chooses from.
//!
//! The paper: "a simple preprocessing phase identifying the cheapest connection between two partitions". So it is the air
//! there and back alone; a pre-cut, and what a ring saves where it is broken, are left to the moves after it. With both
//! counted, the arborescence gives back the tree it was made from sooner, and rounds come to a halt at worse paths.
//!
//! The paper compares all nodes of two partitions. Here a node is compared with its near nodes in other partitions, and
//! each partition besides with home and with its parent node, so that the root reaches all of them.

use super::edmonds::Arc;
use super::forest::{Forest, ROOT};
use super::ground::Ground;
use crate::problem::NodeId;
use rustc_hash::FxHashMap;

/// A connection: from a node of the parent partition (none: home) to one of the child.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Connection {
    pub(super) arc: Arc,
    pub(super) from: Option<NodeId>,
    pub(super) to: NodeId,
}

/// The cheapest connections found, one for a pair of partitions.
#[derive(Default)]
pub(super) struct Connections {
    pub(super) all: Vec<Connection>,
    /// Where that of a pair stands. Only looked up, never gone through.
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

    /// Looks for connections to a partition; how many were priced.
    pub(super) fn look(&mut self, g: &Ground, forest: &Forest, route: u32) -> u64 {
        if route == ROOT {
            return 0;
        }
        let mut priced = 0;
        for &item in forest.items(route) {
            for to in g.nodes(item).filter(|&n| may_arrive(g, forest, n)) {
                self.price(g, forest, None, to);
                for &from in forest.at(route).iter().chain(g.near(to)) {
                    let own = forest.entry(g.item(from)) == from;
                    if forest.route_of(g.item(from)) != route && (own || g.may_leave(g.item(from))) {
                        self.price(g, forest, Some(from), to);
                    }
                }
                priced += 2 + g.near(to).len() as u64;
            }
        }
        priced
    }

    fn price(&mut self, g: &Ground, forest: &Forest, from: Option<NodeId>, to: NodeId) {
        let (parent, out, home) = match from {
            None => (ROOT, g.problem.home, g.problem.home),
            Some(node) => (forest.route_of(g.item(node)), g.exit(node), g.entry(node)),
        };
        let child = forest.route_of(g.item(to));
        let cost = g.air(out, g.entry(to)) + g.air(g.exit(to), home);
        let arc = Arc { from: parent as usize, to: child as usize, cost };
        self.offer(parent, child, Connection { arc, from, to });
    }
}

/// Whether a connection may arrive at a node of a partition: its contour is entered there; or it can be, and then what
/// else the partition has hangs at its old entry.
fn may_arrive(g: &Ground, forest: &Forest, to: NodeId) -> bool {
    let item = g.item(to);
    let alone = forest.items(forest.route_of(item)).len() == 1;
    forest.entry(item) == to || (forest.may_enter(to) && (alone || g.may_leave(item)))
}
