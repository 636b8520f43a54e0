//! Costs of travel from node to node, as benchmark instances give them.

use super::ids::NodeId;

/// A cost for every ordered pair of nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    nodes: usize,
    /// Row by row: from the node of the row to that of the column.
    costs: Vec<f64>,
}

impl Table {
    /// Nodes of a table at most: its 8 bytes a pair are then 128 MB, which a browser still gives.
    pub const MOST: usize = 4000;

    /// The table with these rows; `None` unless there is one finite cost for every pair of `nodes`.
    pub fn new(nodes: usize, costs: Vec<f64>) -> Option<Self> {
        let fits = nodes <= Self::MOST && costs.len() == nodes * nodes;
        (fits && costs.iter().all(|c| c.is_finite())).then_some(Self { nodes, costs })
    }

    /// How many nodes there are.
    pub fn nodes(&self) -> usize {
        self.nodes
    }

    /// All costs, row by row.
    pub fn costs(&self) -> &[f64] {
        &self.costs
    }

    /// From one node to another; both are nodes of this table.
    pub fn cost(&self, from: NodeId, to: NodeId) -> f64 {
        self.costs[from as usize * self.nodes + to as usize]
    }

    /// From one node to `count` nodes that follow one another; all are nodes of this table.
    pub(crate) fn row(&self, from: NodeId, first: NodeId, count: usize) -> &[f64] {
        let first = from as usize * self.nodes + first as usize;
        &self.costs[first..first + count]
    }

    /// Around a cycle of nodes.
    pub fn around(&self, cycle: &[NodeId]) -> f64 {
        let next = cycle.iter().cycle().skip(1);
        cycle.iter().zip(next).map(|(&a, &b)| self.cost(a, b)).sum()
    }

    /// Whether every way costs the same as the way back.
    pub fn is_symmetric(&self) -> bool {
        (0..self.nodes).all(|a| {
            (0..a).all(|b| self.costs[a * self.nodes + b].total_cmp(&self.costs[b * self.nodes + a]).is_eq())
        })
    }
}
