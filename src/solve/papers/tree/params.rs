//! What may be set of the partition-tree framework. The defaults are the paper's.

use super::repartition::RepartitionMoves;
use serde::{Deserialize, Serialize};

/// The partitions to start from (section 4.1, table 2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum InitialPartitions {
    /// Those of the construction heuristic PFr, improved with precedence kept.
    Pfr,
    /// One: a GTSP tour.
    Single,
    /// Each contour its own: an arborescence.
    Each,
}

/// Of which initial partitions the GTSP is solved (step 1b).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum InitialTours {
    /// Of those without precedence between their contours, and what hangs from these.
    Free,
    /// Of all of them; what that breaks is repaired (C-LKH-FR of table 3).
    All,
    /// Of none (C-FR, C-MP, C-MSP of table 3).
    None,
}

/// The partition-tree framework.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartitionTree {
    /// Initial partitions.
    pub start: InitialPartitions,
    /// Rounds of steps 2 to 5 without gain after which they end; 0: none of them (PFr-I of table 1).
    pub stall: u32,
    /// GTSP of the initial partitions, when they are PFr's.
    pub first: InitialTours,
    /// Repartitioning moves.
    pub repartition: RepartitionMoves,
    /// Moves of the search that solves a partition, a contour. The paper gives LKH its defaults.
    pub gtsp_moves: u64,
}

impl Default for PartitionTree {
    fn default() -> Self {
        Self {
            start: InitialPartitions::Pfr,
            stall: 10,
            first: InitialTours::Free,
            repartition: RepartitionMoves::Both,
            // From 1,000 to 10,000 a contour the tours of the bench's sheets of small parts gain 0.3 % of all seconds.
            gtsp_moves: 10_000,
        }
    }
}
