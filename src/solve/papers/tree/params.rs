//! The three methods and what may be set of them. The defaults are the paper's.

use super::frame::Frame;
use super::ground::Ground;
use super::repartition::RepartitionMoves;
use super::single::Single;
use crate::problem::Problem;
use crate::solve::papers::lead::Running;
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};

const SOURCE: &str = "Dewil, Vansteenwegen, Cattrysse, Laguna, Vossen: An improvement heuristic framework for the laser \
                      cutting tool path problem. International Journal of Production Research (2014)";

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
#[serde(default, deny_unknown_fields)]
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

impl Solver for PartitionTree {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "partition-tree",
            title: "Partition tree",
            about: "Contours in partitions that hang from each other: a tour within each, an arborescence between them, \
                    and contours left unfinished for others.",
            source: Some(SOURCE),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        if Ground::is_one_tree(problem) {
            Box::new(Running(Frame::new(problem, *self, seed)))
        } else {
            Box::new(Running(Single::new(problem, seed, self.gtsp_moves)))
        }
    }
}

/// The construction heuristic alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Pfr {}

impl Solver for Pfr {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "pfr",
            title: "PFr",
            about: "Builds a path by nearest insertion, outermost contours first, and leaves contours unfinished where \
                    that is cheaper.",
            source: Some(SOURCE),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        if Ground::is_one_tree(problem) {
            Box::new(Running(Frame::construction(problem)))
        } else {
            Box::new(Running(Single::new(problem, seed, 0)))
        }
    }
}

/// All contours in one partition, each cut in one go: what CAM programs make.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct GtspLk {
    /// Moves of the search, a contour.
    pub gtsp_moves: u64,
}

impl Default for GtspLk {
    fn default() -> Self {
        Self { gtsp_moves: PartitionTree::default().gtsp_moves }
    }
}

impl Solver for GtspLk {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "gtsp-lk",
            title: "GTSP tour",
            about: "A tour over all contours, each cut in one go, found without precedence and then repaired: what CAM \
                    programs make at best.",
            source: Some(SOURCE),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        Box::new(Running(Single::new(problem, seed, self.gtsp_moves)))
    }
}
