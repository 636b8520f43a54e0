//! The stages of the framework.

use super::connect::Connections;
use super::gtsp::Gtsp;
use super::pfr::Pfr;

/// The next work to do.
pub(super) enum Stage {
    /// Finds near nodes, contour by contour.
    Near,
    /// Runs the construction heuristic (1a).
    Construct(Box<Pfr>),
    /// Solves the GTSP of partitions (1b, 4): the remaining ones, and the current one.
    Gtsp {
        routes: Vec<u32>,
        now: Option<Box<Gtsp>>,
        then: After,
    },
    /// Repartitions (1c, 5, 8): the next contour, and the number of contours in a row without improvement.
    Repartition {
        next: usize,
        idle: usize,
        then: After,
    },
    /// Finds connections to the remaining partitions, then chooses the arborescence and rebuilds the tree (2, 3).
    Connect {
        routes: Vec<u32>,
        found: Box<Connections>,
    },
    /// Restores feasibility (7).
    Repair,
    /// Chooses the entries of the remaining routes (8).
    Entries {
        routes: Vec<u32>,
        then: After,
    },
    End,
}

/// The steps whose shares of the time figure 9 of the paper shows. Near lists belong to the construction, and the choice
/// of entries to the repair, which it follows.
pub(super) const STEPS: [&str; 5] =
    ["construction", "GTSP", "repartitioning", "arborescence", "repair and entries"];

impl Stage {
    /// Its index in [`STEPS`].
    pub(super) fn step(&self) -> usize {
        match self {
            Self::Near | Self::Construct(_) => 0,
            Self::Gtsp { .. } => 1,
            Self::Repartition { .. } => 2,
            Self::Connect { .. } => 3,
            Self::Repair | Self::Entries { .. } | Self::End => 4,
        }
    }
}

/// The purpose of a stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum After {
    /// Improves the initial partitions and keeps precedence.
    Initial,
    /// Is part of a round and ignores precedence.
    Round,
    /// Improves the repaired path and keeps precedence.
    Final,
}
