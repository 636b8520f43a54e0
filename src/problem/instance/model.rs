//! An instance: its problem, and what its file says beside it.

use super::costs::Plane;
use crate::problem::{NodeId, Problem};

/// An instance and the numbers its file gives its nodes.
#[derive(Clone, Debug)]
pub struct Instance {
    /// What the file calls itself.
    pub name: String,
    /// To be solved.
    pub problem: Problem,
    /// Number in the file, by node.
    pub(super) numbers: Vec<u32>,
    /// Edges that every tour must take, in the numbers of the file. Their own length does not count (so is the
    /// published optimum of linhp318: a path between the ends of its fixed edge); in the table each earns
    /// [`Instance::lowered`], which is more than any other change of two edges can save.
    pub(super) fixed: Vec<[u32; 2]>,
    pub(super) lowered: f64,
    pub(super) whole: bool,
    /// The coordinates by node, where the problem has no table of costs.
    pub(super) plane: Option<Plane>,
}

impl Instance {
    /// Whether every tour must take certain edges.
    pub fn has_fixed_edges(&self) -> bool {
        !self.fixed.is_empty()
    }

    /// Whether all costs are whole numbers, so all lengths are.
    pub fn is_whole(&self) -> bool {
        self.whole
    }

    /// Whether the problem's costs are real distances while lengths are sums of rounded ones. A bound of one is none of the
    /// other.
    pub fn is_large(&self) -> bool {
        self.plane.is_some()
    }

    /// The tour that visits these nodes of the problem, in the numbers of the file.
    pub fn tour(&self, nodes: impl IntoIterator<Item = NodeId>) -> Vec<u32> {
        let nodes: Vec<usize> = nodes.into_iter().map(|node| node as usize).collect();
        let start = self.start_between(&nodes);
        start.into_iter().chain(nodes).filter_map(|node| self.numbers.get(node).copied()).collect()
    }

    /// The cost from one node to another, by their places in `numbers`.
    pub(super) fn cost(&self, from: usize, to: usize) -> f64 {
        match (&self.plane, self.problem.table()) {
            (Some(plane), _) => plane.cost(from, to),
            (None, Some(table)) => table.costs().get(from * table.nodes() + to).copied().unwrap_or(0.0),
            (None, None) => 0.0,
        }
    }

    /// The best node of the start for a cycle through these nodes, where the start is no item of the problem.
    pub(super) fn start_between(&self, nodes: &[usize]) -> Option<usize> {
        self.plane.as_ref()?;
        let (first, last) = (*nodes.first()?, *nodes.last()?);
        let through = |s: usize| self.cost(last, s) + self.cost(s, first);
        (self.problem.nodes.len()..self.numbers.len())
            .reduce(|best, s| if through(s) < through(best) { s } else { best })
    }

    /// How many sets there are.
    pub(super) fn sets(&self) -> usize {
        self.problem.items.len() + usize::from(self.is_large())
    }

    /// The set of the node at a place in `numbers`, in the order of the problem's items; the start of a large instance is the last.
    pub(super) fn set_of(&self, node: usize) -> usize {
        self.problem.nodes.get(node).map_or(self.problem.items.len(), |n| n.item as usize)
    }
}
