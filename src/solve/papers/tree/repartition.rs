//! Repartitioning (section 4.5): local moves on the partition-tree, those that gain, the best of a contour first. In the
//! version with precedence, a move is made only where everything is still finished before what is around it.
//!
//! Moves are looked for where they can gain: at the near nodes of the contours whose neighbours change.

use super::forest::Forest;
use super::ground::Ground;
use super::walk::keeps_precedence;
use super::{partitions, sequences};
use crate::order::{real, sort_by};
use crate::problem::{ItemId, NodeId};
use serde::{Deserialize, Serialize};
use std::ops::Range;

/// Which moves are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RepartitionMoves {
    /// Both sets.
    Both,
    /// The first: partitions are hung up elsewhere, also merged with their children (C-MP of table 3).
    Partitions,
    /// The second: sub-sequences become partitions or go into others (C-MSP of table 3).
    Sequences,
}

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

/// Makes the best move of a contour that is allowed; whether there was one, and how many were priced.
pub(super) fn improve(
    g: &Ground,
    forest: &mut Forest,
    item: ItemId,
    sets: RepartitionMoves,
    keep: bool,
) -> (bool, u64) {
    let mut found = Found::default();
    if sets != RepartitionMoves::Sequences {
        partitions::look(g, forest, item, &mut found);
    }
    if sets != RepartitionMoves::Partitions {
        sequences::look(g, forest, item, &mut found);
    }
    let Found { mut moves, mut priced } = found;
    sort_by(&mut moves, |m| [!real(m.0), 0, 0]);
    for (_, change) in moves {
        if !keep || g.inwards.is_empty() {
            change.apply(g, forest);
            return (true, priced);
        }
        let mut next = forest.clone();
        change.apply(g, &mut next);
        // The path is walked once, about as much work as that many prices.
        priced += g.problem.items.len() as u64;
        if keeps_precedence(g, &next) {
            *forest = next;
            return (true, priced);
        }
    }
    (false, priced)
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
                    if own != super::forest::NONE {
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
