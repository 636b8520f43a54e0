//! Parameters of the partition-tree framework. The defaults are those of the paper, except for `nodes`, `neighbourhood`,
//! `reattach` and `entries`.

use super::graph::Neighbourhood;
use super::moves::Reattach;
use super::repartition::RepartitionMoves;
use serde::{Deserialize, Serialize};

/// The initial partitions (section 4.1, table 2).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum InitialPartitions {
    /// Those of the construction heuristic PFr, improved while keeping precedence.
    Pfr,
    /// One partition: a GTSP tour.
    Single,
    /// One partition for each contour: an arborescence.
    Each,
}

/// The initial partitions whose GTSP is solved (step 1b).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum InitialTours {
    /// Those in which neither their contours nor what is attached to them have precedence.
    Free,
    /// All of them; violated precedence is repaired. The paper does not do that: its C-LKH-FR of table 3 is `Free`.
    All,
    /// None (C-FR, C-MP, C-MSP of table 3).
    None,
}

/// The nodes at which closed contours are entered and left.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TreeNodes {
    /// The entries of the problem: ends of elements, a choice of them on contours of many elements, and places between them.
    Entries,
    /// The ends of all elements, as in the paper.
    ElementEnds,
}

/// Whose entries are chosen again after the repair (section 4.6).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FinalEntries {
    /// Those of all contours.
    All,
    /// Those of the contours that the repair moved, as in the paper.
    Moved,
}

/// How a tour that breaks precedence is repaired.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TourRepair {
    /// Inner contours move to just before the contour around them, because CAM programs cut holes first.
    InnerForward,
    /// The outer contour moves to just after the last contour inside it, as in the paper (section 4.6). Problems with ranks,
    /// groups, pairs or tables of costs, which the paper does not have, are repaired forwards all the same.
    OuterBack,
}

/// The partition-tree framework.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PartitionTree {
    /// The initial partitions.
    pub start: InitialPartitions,
    /// Number of rounds of steps 2 to 5 without improvement after which they end; 0 skips these steps (PFr-I of table 1).
    pub stall: u32,
    /// Which of PFr's initial partitions are solved as a GTSP.
    pub first: InitialTours,
    /// The nodes of contours.
    pub nodes: TreeNodes,
    /// Where moves and connections lead.
    pub neighbourhood: Neighbourhood,
    /// The repartitioning moves.
    pub repartition: RepartitionMoves,
    /// How contours that a repartitioning move attaches elsewhere are entered.
    pub reattach: Reattach,
    /// Whose entries are chosen again after the repair.
    pub entries: FinalEntries,
    /// Number of moves of the GTSP search for each contour. The paper uses LKH with its defaults.
    pub gtsp_moves: u64,
}

impl Default for PartitionTree {
    fn default() -> Self {
        Self {
            start: InitialPartitions::Pfr,
            stall: 10,
            first: InitialTours::Free,
            nodes: TreeNodes::Entries,
            neighbourhood: Neighbourhood::Near,
            repartition: RepartitionMoves::Both,
            reattach: Reattach::Reopened,
            entries: FinalEntries::All,
            // From 1,000 to 10,000 moves for each contour, the tours of the benchmark's sheets of small parts improve by
            // 0.3 % of all seconds.
            gtsp_moves: 10_000,
        }
    }
}
