//! The three methods of the paper as solvers.

use super::element_ends::AtElementEnds;
use super::framework::Framework;
use super::graph::Graph;
use super::parameters::{PartitionTree, TourRepair, TreeNodes};
use super::single::Single;
use crate::problem::Problem;
use crate::solve::papers::piecewise::PiecewiseSearch;
use crate::solve::{Search, Solution, Solver, SolverInfo};
use serde::{Deserialize, Serialize};

const SOURCE: &str = "Dewil, Vansteenwegen, Cattrysse, Laguna, Vossen: An improvement heuristic framework for the laser \
                      cutting tool path problem. International Journal of Production Research (2014)";

/// Starts a search on some nodes of a problem; its solutions are those of the problem as it is given.
fn on<'p>(
    nodes: TreeNodes,
    problem: &'p Problem,
    search: impl for<'s> FnOnce(&'s Problem) -> Box<dyn Search + 's>,
) -> Box<dyn Search + 'p> {
    match nodes {
        TreeNodes::Entries => search(problem),
        TreeNodes::ElementEnds => Box::new(AtElementEnds::new(problem, search)),
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
        on(self.nodes, problem, |p| self.on_nodes(p, seed))
    }
}

impl PartitionTree {
    /// Starts a search on the nodes of a problem as they are.
    pub(super) fn on_nodes<'p>(&self, problem: &'p Problem, seed: u64) -> Box<dyn Search + 'p> {
        if Graph::is_one_tree(problem) {
            Box::new(PiecewiseSearch(Framework::new(problem, *self, seed)))
        } else {
            Box::new(PiecewiseSearch(Single::new(problem, seed, self.gtsp_moves, GtspLk::default().repair)))
        }
    }
}

/// The construction heuristic alone.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pfr {
    /// The nodes of contours.
    pub nodes: TreeNodes,
}

impl Default for Pfr {
    fn default() -> Self {
        Self { nodes: PartitionTree::default().nodes }
    }
}

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
        on(self.nodes, problem, |p| {
            if Graph::is_one_tree(p) {
                Box::new(PiecewiseSearch(Framework::construction(p)))
            } else {
                Box::new(PiecewiseSearch(Single::new(p, seed, 0, GtspLk::default().repair)))
            }
        })
    }
}

/// All contours in one partition, each cut whole: the kind of path that CAM programs make.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct GtspLk {
    /// The nodes of contours.
    pub nodes: TreeNodes,
    /// Number of moves of the search for each contour.
    pub gtsp_moves: u64,
    /// How the tour is repaired.
    pub repair: TourRepair,
}

impl Default for GtspLk {
    fn default() -> Self {
        let PartitionTree { nodes, gtsp_moves, .. } = PartitionTree::default();
        Self { nodes, gtsp_moves, repair: TourRepair::InnerForward }
    }
}

impl Solver for GtspLk {
    fn info(&self) -> SolverInfo {
        SolverInfo {
            name: "gtsp-lk",
            title: "GTSP tour",
            about: "A tour over all contours, each cut in one go, found without precedence and then repaired: the kind \
                    of path that CAM programs make.",
            source: Some(SOURCE),
        }
    }

    fn start<'p>(&self, problem: &'p Problem, seed: u64, _warm: Option<&Solution>) -> Box<dyn Search + 'p> {
        on(self.nodes, problem, |p| {
            Box::new(PiecewiseSearch(Single::new(p, seed, self.gtsp_moves, self.repair)))
        })
    }
}
