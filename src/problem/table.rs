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
    /// Most nodes of a table: at 8 bytes for each pair it then takes 128 MB, which a browser can still allocate.
    pub const MOST: usize = 4000;

    /// A table with these costs, row by row; `None` unless there is one finite cost for every pair of `nodes`.
    pub fn new(nodes: usize, costs: Vec<f64>) -> Option<Self> {
        let fits = nodes <= Self::MOST && costs.len() == nodes * nodes;
        (fits && costs.iter().all(|c| c.is_finite())).then_some(Self { nodes, costs })
    }

    /// Number of nodes.
    pub fn nodes(&self) -> usize {
        self.nodes
    }

    /// All costs, row by row.
    pub fn costs(&self) -> &[f64] {
        &self.costs
    }

    /// The cost from one node to another; both must be nodes of this table.
    pub fn cost(&self, from: NodeId, to: NodeId) -> f64 {
        self.costs[from as usize * self.nodes + to as usize]
    }

    /// The costs from one node to `count` successive nodes; all must be nodes of this table.
    pub(crate) fn row(&self, from: NodeId, first: NodeId, count: usize) -> &[f64] {
        let first = from as usize * self.nodes + first as usize;
        &self.costs[first..first + count]
    }

    /// The cost of a cycle of nodes.
    pub fn around(&self, cycle: &[NodeId]) -> f64 {
        let next = cycle.iter().cycle().skip(1);
        cycle.iter().zip(next).map(|(&a, &b)| self.cost(a, b)).sum()
    }

    /// Whether every leg costs the same as the leg back.
    pub fn is_symmetric(&self) -> bool {
        (0..self.nodes).all(|a| {
            (0..a).all(|b| self.costs[a * self.nodes + b].total_cmp(&self.costs[b * self.nodes + a]).is_eq())
        })
    }
}
