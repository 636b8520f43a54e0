//! The three methods of the paper as solvers.

use super::element_ends::AtElementEnds;
use super::framework::Framework;
use super::graph::Graph;
use super::parameters::{PartitionTree, TreeNodes};
use super::single::Single;
use crate::problem::Problem;
use crate::solve::papers::piecewise::PiecewiseSearch;
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};

const SOURCE: &str = "Dewil, Vansteenwegen, Cattrysse, Laguna, Vossen: An improvement heuristic framework for the laser \
                      cutting tool path problem. International Journal of Production Research (2014)";

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
        match self.nodes {
            TreeNodes::Entries => self.on_entries(problem, seed),
            TreeNodes::ElementEnds => {
                let method = *self;
                Box::new(AtElementEnds::new(problem, move |p| method.on_entries(p, seed)))
            }
        }
    }
}

impl PartitionTree {
    /// Starts a search on the nodes of a problem as they are.
    pub(super) fn on_entries<'p>(&self, problem: &'p Problem, seed: u64) -> Box<dyn Search + 'p> {
        if Graph::is_one_tree(problem) {
            Box::new(PiecewiseSearch(Framework::new(problem, *self, seed)))
        } else {
            Box::new(PiecewiseSearch(Single::new(problem, seed, self.gtsp_moves)))
        }
    }
}

/// The construction heuristic alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
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
        if Graph::is_one_tree(problem) {
            Box::new(PiecewiseSearch(Framework::construction(problem)))
        } else {
            Box::new(PiecewiseSearch(Single::new(problem, seed, 0)))
        }
    }
}

/// All contours in one partition, each cut whole: the kind of path that CAM programs make.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct GtspLk {
    /// Number of moves of the search for each contour.
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
        Box::new(PiecewiseSearch(Single::new(problem, seed, self.gtsp_moves)))
    }
}
