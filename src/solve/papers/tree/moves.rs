//! Moves of repartitioning: what they change in the tree.

use super::forest::{Forest, NONE};
use super::ground::Ground;
use crate::problem::NodeId;
use std::ops::Range;

/// A change of the tree.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Move {
    /// A partition hangs at another node; its ring is broken before a place.
    Reattach { route: u32, first: usize, node: NodeId, enter: Option<NodeId> },
    /// Partitions of one contour each, every one the child of the one before, become one at a node: in the order of these
    /// nodes, at which their contours are entered.
    Merge { route: u32, nodes: Vec<NodeId>, node: NodeId },
    /// Contours of a route become a partition at a node.
    Own { route: u32, places: Range<usize>, node: NodeId, enter: Option<NodeId> },
    /// Contours of a route go into a gap, before a place.
    Into { route: u32, places: Range<usize>, to: u32, pos: usize, enter: Option<NodeId> },
}

/// Moves that gain, with how many seconds; and how many were priced.
#[derive(Default)]
pub(super) struct Found {
    pub(super) moves: Vec<(f64, Move)>,
    pub(super) priced: u64,
}

impl Move {
    /// Makes it.
    pub(super) fn apply(&self, g: &Ground, forest: &mut Forest) {
        match *self {
            Self::Reattach { route, first, node, enter } => {
                forest.unhang(g, route);
                forest.rotate(route, first);
                enter.into_iter().for_each(|n| forest.enter(g.item(n), n));
                forest.hang(g, route, node);
            }
            Self::Merge { route, ref nodes, node } => {
                forest.take(g, route, 0..1);
                for &n in nodes {
                    let own = forest.route_of(g.item(n));
                    if own != NONE {
                        forest.take(g, own, 0..1);
                    }
                }
                nodes.iter().for_each(|&n| forest.enter(g.item(n), n));
                let route = forest.open(nodes.iter().map(|&n| g.item(n)).collect());
                forest.hang(g, route, node);
            }
            Self::Own { route, ref places, node, enter } => {
                let items = forest.take(g, route, places.clone());
                enter.into_iter().for_each(|n| forest.enter(g.item(n), n));
                let route = forest.open(items);
                forest.hang(g, route, node);
            }
            Self::Into { route, ref places, to, pos, enter } => {
                let items = forest.take(g, route, places.clone());
                enter.into_iter().for_each(|n| forest.enter(g.item(n), n));
                let behind = to == route && pos >= places.end;
                forest.splice(to, if behind { pos - places.len() } else { pos }, items);
            }
        }
    }
}
