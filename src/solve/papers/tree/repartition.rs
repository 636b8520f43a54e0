//! Repartitioning (section 4.5): local moves on the partition-tree. For each contour the move that saves most is applied.
//! If precedence is to be kept, a move is applied only if everything is still finished before the contour around it.
//!
//! Moves are searched where they can help: at the near nodes of the contours whose neighbours change.

use super::forest::Forest;
use super::graph::Graph;
use super::moves::{GainfulMoves, Reattach};
use super::visits::keeps_precedence;
use super::{partitions, sequences};
use crate::order::{real, sort_by};
use crate::problem::ItemId;
use serde::{Deserialize, Serialize};

/// The sets of moves that are used.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum RepartitionMoves {
    /// Both sets.
    Both,
    /// The first set: partitions are attached elsewhere, and merged with their children (C-MP of table 3).
    Partitions,
    /// The second set: sub-sequences become partitions or move to others (C-MSP of table 3).
    Sequences,
}

/// Applies the best feasible move of a contour. Returns whether there was one, and the number of moves priced.
pub(super) fn improve(
    g: &Graph,
    forest: &mut Forest,
    item: ItemId,
    (sets, reattach): (RepartitionMoves, Reattach),
    keep: bool,
) -> (bool, u64) {
    let mut found = GainfulMoves { reattach, ..GainfulMoves::default() };
    if sets != RepartitionMoves::Sequences {
        partitions::look(g, forest, item, &mut found);
    }
    if sets != RepartitionMoves::Partitions {
        sequences::look(g, forest, item, &mut found);
    }
    let GainfulMoves { mut moves, mut priced, .. } = found;
    sort_by(&mut moves, |m| [!real(m.0), 0, 0]);
    for (_, change) in moves {
        if !keep || g.inwards.is_empty() {
            change.apply(g, forest);
            return (true, priced);
        }
        let mut next = forest.clone();
        change.apply(g, &mut next);
        // Checking the whole path takes about as much time as pricing this many moves.
        priced += g.problem.items.len() as u64;
        if keeps_precedence(g, &next) {
            *forest = next;
            return (true, priced);
        }
    }
    (false, priced)
}
