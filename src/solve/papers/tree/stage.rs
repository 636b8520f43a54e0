//! What the frame does, one after the other.

use super::connect::Connections;
use super::gtsp::Gtsp;
use super::pfr::Pfr;

/// What is done next.
pub(super) enum Stage {
    /// Near nodes, contour by contour.
    Near,
    /// The construction heuristic (1a).
    Construct(Box<Pfr>),
    /// GTSP of partitions (1b, 4): those still to be solved, and the one under way.
    Gtsp {
        routes: Vec<u32>,
        now: Option<Box<Gtsp>>,
        then: After,
    },
    /// Repartition (1c, 5, 8): the contour looked at next, and how many were in a row without gain.
    Repartition {
        next: usize,
        idle: usize,
        then: After,
    },
    /// Connections between partitions, those of the next one; then arborescence and resolution (2, 3).
    Connect {
        routes: Vec<u32>,
        found: Box<Connections>,
    },
    /// Restored feasibility (7).
    Repair,
    /// Entries of the routes chosen anew (8).
    Entries {
        routes: Vec<u32>,
        then: After,
    },
    End,
}

/// What a stage is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum After {
    /// The initial partitions; precedence is kept.
    Initial,
    /// A round of the frame; precedence is left out.
    Round,
    /// The repaired path; precedence is kept.
    Final,
}
