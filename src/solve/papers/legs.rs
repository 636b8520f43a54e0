//! What the papers measure: the length of the air moves (legs) between nodes.

use crate::machine::AirTime;
use crate::problem::{NodeId, Problem};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// How the length of an air move is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// Euclidean distance, mm: Qu & Du eq. (3), and eq. (1) of the hull parts.
    Euclidean,
    /// The longer of the distances along the two axes, mm: Yang's eq. (1), for axes of equal speed.
    Chebyshev,
    /// Seconds that the machine takes for the air move.
    Seconds,
}

/// Lengths between the nodes of a problem. Where the problem has a table of costs, the table gives them, whatever the
/// measure.
pub struct Legs<'p> {
    problem: &'p Problem,
    measure: Measure,
    air: AirTime,
}

impl<'p> Legs<'p> {
    /// Measures a problem's air moves.
    pub fn new(problem: &'p Problem, measure: Measure) -> Self {
        Self { problem, measure, air: AirTime::new(&problem.machine) }
    }

    /// The problem that is measured.
    pub fn problem(&self) -> &'p Problem {
        self.problem
    }

    /// Length between two points.
    pub fn between(&self, a: DVec2, b: DVec2) -> f64 {
        match self.measure {
            Measure::Euclidean => a.distance(b),
            Measure::Chebyshev => (a - b).abs().max_element(),
            Measure::Seconds => self.air.seconds(a, b),
        }
    }

    /// A lower bound of the length between points that are at least `d` mm apart along x or along y.
    pub fn lower_bound(&self, d: f64) -> f64 {
        match self.measure {
            Measure::Euclidean | Measure::Chebyshev => d,
            Measure::Seconds => self.air.seconds_at_least(d),
        }
    }

    /// Length from the exit of one node to the entry of the next.
    pub fn leg(&self, from: NodeId, to: NodeId) -> f64 {
        match self.problem.table() {
            Some(table) => table.cost(from, to),
            None => {
                let nodes = &self.problem.nodes;
                self.between(nodes[from as usize].exit, nodes[to as usize].entry)
            }
        }
    }

    /// Length from home to the first node; 0 where a table of costs is given.
    pub fn from_home(&self, to: NodeId) -> f64 {
        match self.problem.table() {
            Some(_) => 0.0,
            None => self.between(self.problem.home, self.problem.nodes[to as usize].entry),
        }
    }

    /// Length from the last node to the end of the tour: to home if the machine returns there, otherwise 0. With a table of
    /// costs, the cost of the way back to the first node.
    pub fn to_end(&self, from: NodeId, first: NodeId) -> f64 {
        match self.problem.table() {
            Some(table) => table.cost(from, first),
            None if self.problem.closed => {
                self.between(self.problem.nodes[from as usize].exit, self.problem.home)
            }
            None => 0.0,
        }
    }

    /// Length between two neighbours in a tour that starts with `first`; `None` is the start or the end of the tour.
    pub fn link(&self, from: Option<NodeId>, to: Option<NodeId>, first: NodeId) -> f64 {
        match (from, to) {
            (Some(from), Some(to)) => self.leg(from, to),
            (None, Some(to)) => self.from_home(to),
            (Some(from), None) => self.to_end(from, first),
            (None, None) => 0.0,
        }
    }

    /// The length of a path without the legs from home and to the end.
    pub fn between_items(&self, nodes: &[NodeId]) -> f64 {
        nodes.windows(2).map(|w| self.leg(w[0], w[1])).sum()
    }

    /// Length of a whole tour.
    pub fn tour_length(&self, nodes: &[NodeId]) -> f64 {
        let (Some(&first), Some(&last)) = (nodes.first(), nodes.last()) else { return 0.0 };
        let between = self.between_items(nodes);
        self.from_home(first) + between + self.to_end(last, first)
    }
}
