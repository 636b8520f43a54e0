//! Repartitioning (section 4.5): local moves on the partition-tree, those that gain, the best of a contour first. In the
//! version with precedence, a move is made only where everything is still finished before what is around it.
//!
//! Moves are looked for where they can gain: at the near nodes of the contours whose neighbours change.

use super::forest::Forest;
use super::ground::Ground;
use super::moves::Found;
use super::walk::keeps_precedence;
use super::{partitions, sequences};
use crate::order::{real, sort_by};
use crate::problem::ItemId;
use serde::{Deserialize, Serialize};

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
