//! The moves of repartitioning, and how they change the tree.

use super::forest::{Forest, NONE};
use super::graph::Graph;
use crate::problem::NodeId;
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// A change of the tree.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum TreeMove {
    /// Attaches a partition to another node and opens its ring before a position.
    Reattach { route: u32, first: usize, node: NodeId, enter: Option<NodeId> },
    /// Merges partitions of one contour each, every one the child of the one before, into one partition attached to a node.
    /// Its contours are entered at `nodes`, in that order.
    Merge { route: u32, nodes: Vec<NodeId>, node: NodeId },
    /// Makes contours of a route a partition attached to a node.
    Own { route: u32, places: Range<usize>, node: NodeId, enter: Option<NodeId> },
    /// Moves contours of a route into a gap, before a position.
    Into { route: u32, places: Range<usize>, to: u32, pos: usize, enter: Option<NodeId> },
}

/// How contours that a move attaches elsewhere are entered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reattach {
    /// The ring of a partition may be opened at another contour, and a single contour entered at another node.
    #[default]
    Reopened,
    /// Order and entries stay: "simply the reattachment of a partition" (section 4.5).
    AsItIs,
}

/// Moves that save time, with the seconds they save; and the number of moves priced.
#[derive(Default)]
pub(super) struct GainfulMoves {
    /// How contours are entered that a move attaches elsewhere.
    pub(super) reattach: Reattach,
    pub(super) moves: Vec<(f64, TreeMove)>,
    pub(super) priced: u64,
}

impl TreeMove {
    /// Applies the move.
    pub(super) fn apply(&self, g: &Graph, forest: &mut Forest) {
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
