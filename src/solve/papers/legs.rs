//! What the papers measure: the way between nodes.

use crate::machine::AirTime;
use crate::problem::{NodeId, Problem};
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// How a way is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// The straight line, mm: Qu & Du eq. (3), the hull parts' eq. (1).
    Euclidean,
    /// The longer of the two axes, mm: Yang's eq. (1), for equal speeds.
    Chebyshev,
    /// Seconds of the machine's air moves.
    Seconds,
}

/// Ways between the nodes of a problem; with a table of costs they are the table's, whatever the measure.
pub struct Legs<'p> {
    problem: &'p Problem,
    measure: Measure,
    air: AirTime,
}

impl<'p> Legs<'p> {
    /// By that measure.
    pub fn new(problem: &'p Problem, measure: Measure) -> Self {
        Self { problem, measure, air: AirTime::new(&problem.machine) }
    }

    /// The problem.
    pub fn problem(&self) -> &'p Problem {
        self.problem
    }

    /// Between two places.
    pub fn between(&self, a: DVec2, b: DVec2) -> f64 {
        match self.measure {
            Measure::Euclidean => a.distance(b),
            Measure::Chebyshev => (a - b).abs().max_element(),
            Measure::Seconds => self.air.seconds(a, b),
        }
    }

    /// Between places that are at least `d` mm apart along x or along y, at least.
    pub fn at_least(&self, d: f64) -> f64 {
        match self.measure {
            Measure::Euclidean | Measure::Chebyshev => d,
            Measure::Seconds => self.air.seconds_at_least(d),
        }
    }

    /// From leaving at one node to entering at the next.
    pub fn leg(&self, from: NodeId, to: NodeId) -> f64 {
        match self.problem.table() {
            Some(table) => table.cost(from, to),
            None => {
                let nodes = &self.problem.nodes;
                self.between(nodes[from as usize].exit, nodes[to as usize].entry)
            }
        }
    }

    /// From the start to the first node; with a table there is no way before it.
    pub fn out(&self, to: NodeId) -> f64 {
        match self.problem.table() {
            Some(_) => 0.0,
            None => self.between(self.problem.home, self.problem.nodes[to as usize].entry),
        }
    }

    /// From the last node to the end: home, if the machine goes back there. With a table, round to the first.
    pub fn back(&self, from: NodeId, first: NodeId) -> f64 {
        match self.problem.table() {
            Some(table) => table.cost(from, first),
            None if self.problem.closed => {
                self.between(self.problem.nodes[from as usize].exit, self.problem.home)
            }
            None => 0.0,
        }
    }

    /// Between neighbours in a tour that begins with `first`: nothing before its first node and after its last one.
    pub fn link(&self, from: Option<NodeId>, to: Option<NodeId>, first: NodeId) -> f64 {
        match (from, to) {
            (Some(from), Some(to)) => self.leg(from, to),
            (None, Some(to)) => self.out(to),
            (Some(from), None) => self.back(from, first),
            (None, None) => 0.0,
        }
    }

    /// All the way.
    pub fn around(&self, nodes: &[NodeId]) -> f64 {
        let (Some(&first), Some(&last)) = (nodes.first(), nodes.last()) else { return 0.0 };
        let between: f64 = nodes.windows(2).map(|w| self.leg(w[0], w[1])).sum();
        self.out(first) + between + self.back(last, first)
    }
}
